// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_contact_closed_forms_h
#define stickslip_tests_contact_closed_forms_h

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace StickSlip::Tests
{
  using namespace dealii;

  /**
   * A bar that flies towards a rigid wall, undeformed, bounces off and leaves
   * undeformed; per unit of its cross-section. A wave of compression runs from
   * the end that hits to the free end and comes back as one of tension. Waves
   * by d'Alembert; the same as contrib/experiments/time_schemes/bar.py.
   *
   * x in m from the end that hits, in the reference configuration;
   * displacements in m, away from the wall positive.
   */
  struct FlyingBar
  {
    /** m, Pa, kg/m^3; speed, m/s, towards the wall and distance from it, m, at
     * t = 0. In two dimensions with lateral displacements held the modulus is
     * lambda + 2 mu. */
    double length, modulus, density, speed, gap;

    double
    wave_speed() const
    {
      return std::sqrt(modulus / density);
    }

    /** Time at which the bar touches the wall, and how long it stays, s. */
    double
    impact() const
    {
      return gap / speed;
    }

    double
    duration() const
    {
      return 2 * length / wave_speed();
    }

    double
    displacement(const double x, const double t) const
    {
      const double s = t - impact(), c = wave_speed();
      return -gap - speed * std::min(s, x / c) +
             speed * std::max(0., s - (2 * length - x) / c);
    }

    double
    velocity(const double x, const double t) const
    {
      const double s = t - impact(), c = wave_speed();
      return s < x / c ? -speed : s > (2 * length - x) / c ? speed : 0.;
    }

    /** Pressure on the wall, Pa. */
    double
    pressure(const double t) const
    {
      const double s = t - impact();
      return s > 0 && s < duration() ? density * wave_speed() * speed : 0.;
    }

    /** Energies over the cross-section, J/m^2. */
    double
    elastic_energy(const double t) const
    {
      const double part = (t - impact()) * wave_speed() / length;
      return density * length * speed * speed / 2 *
             std::max(0., 1 - std::abs(part - 1));
    }

    double
    kinetic_energy(const double t) const
    {
      return density * length * speed * speed / 2 - elastic_energy(t);
    }
  };



  /** Modulus of two bodies in contact, Pa, of a plane in two dimensions under
   * plane strain and in three: 1/E* is the sum of (1 - nu^2) / E. */
  inline double
  contact_modulus(const double youngs_modulus,
                  const double poissons_ratio,
                  const double other_youngs_modulus,
                  const double other_poissons_ratio)
  {
    return 1 / ((1 - poissons_ratio * poissons_ratio) / youngs_modulus +
                (1 - other_poissons_ratio * other_poissons_ratio) /
                  other_youngs_modulus);
  }



  /**
   * Two cylinders with parallel axes, without friction; two half-planes with
   * initial distance x^2 / (2 radius) (Johnson 1985, section 4.2).
   */
  struct HertzLine
  {
    /** N/m; 1 / radius is the sum of both curvatures, m; Pa. */
    double load, radius, modulus;

    /** Half width of the contact, m. */
    double
    half_width() const
    {
      return std::sqrt(4 * load * radius / (numbers::PI * modulus));
    }

    /** Pressure at x, Pa. */
    double
    pressure(const double x) const
    {
      const double a = half_width();
      return 2 * load / (numbers::PI * a * a) *
             std::sqrt(std::max(0., a * a - x * x));
    }
  };



  /**
   * Two spheres without friction (Johnson 1985, section 4.2).
   */
  struct HertzSphere
  {
    /** N; 1 / radius is the sum of both curvatures, m; Pa. */
    double load, radius, modulus;

    /** Radius of the contact, m. */
    double
    contact_radius() const
    {
      return std::cbrt(3 * load * radius / (4 * modulus));
    }

    /** Distance by which remote points of both bodies approach, m. */
    double
    approach() const
    {
      return contact_radius() * contact_radius() / radius;
    }

    /** Pressure at the distance r from the axis, Pa. */
    double
    pressure(const double r) const
    {
      const double a = contact_radius();
      return 3 * load / (2 * numbers::PI * a * a * a) *
             std::sqrt(std::max(0., a * a - r * r));
    }
  };



  /**
   * A rigid flat punch of half width a on a half-plane without friction
   * (Johnson 1985, section 2.8): pressure at |x| < a, Pa, from the load, N/m.
   */
  inline double
  flat_punch_pressure(const double load, const double a, const double x)
  {
    return load / (numbers::PI * std::sqrt(a * a - x * x));
  }

  /**
   * A rigid flat punch of radius a on a half-space without friction (Johnson
   * 1985, section 3.4): pressure at r < a, Pa, from the load, N, and how far it
   * sinks in, m.
   */
  inline double
  round_punch_pressure(const double load, const double a, const double r)
  {
    return load / (2 * numbers::PI * a * std::sqrt(a * a - r * r));
  }

  inline double
  round_punch_depth(const double load, const double a, const double modulus)
  {
    return load / (2 * a * modulus);
  }



  /**
   * A long heavy beam on a rigid plane that is lifted at its end, by Euler's
   * and Bernoulli's theory: from where it touches, with neither slope nor
   * moment, to the end without moment. A shear force of half of the weight that
   * is lifted presses the plane at that point. Thick bodies depart from it by
   * their shear, by the square of thickness over lifted length.
   */
  struct LiftedBeam
  {
    /** EI per unit of width, N m; under plane strain E h^3 / (12 (1 - nu^2)).
     * Weight over the area, Pa; displacement of the end, m. */
    double stiffness, weight, lift;

    /** Length that is off the plane, m. */
    double
    length() const
    {
      return std::pow(24 * stiffness * lift / weight, 0.25);
    }

    /** Force that lifts the end, over the width, N/m. */
    double
    force() const
    {
      return weight * length() / 2;
    }

    /** Gap at the distance x from the last point that touches, m. */
    double
    gap(const double x) const
    {
      return x <= 0 ?
               0. :
               weight / (24 * stiffness) * (2 * length() - x) * x * x * x;
    }
  };
} // namespace StickSlip::Tests

#endif
