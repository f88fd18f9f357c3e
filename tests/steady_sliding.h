// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_steady_sliding_h
#define stickslip_tests_steady_sliding_h

#include <deal.II/lac/full_matrix.h>

#include <stickslip/friction/rate_and_state.h>
#include <stickslip/mechanics/material.h>

#include <array>
#include <complex>
#include <vector>

namespace StickSlip::Tests
{
  using namespace dealii;

  /**
   * Linear stability of two endless layers between rigid plates that slide
   * along each other steadily, as doc/stability.md derives it. Nothing here
   * comes from the program but the parameters.
   *
   * Perturbations are u_x = Re[X(y) exp(st)] cos kx,
   * u_y = Re[Y(y) exp(st)] sin kx; the fault is y = 0, and the plates are at
   * y = -thickness of the lower layer and y = thickness of the upper one.
   *
   * Where the normal stress follows the contact pressure, waves travel:
   * u_x = Re[X(y) exp(ikx + st)], u_y = Re[-i Y(y) exp(ikx + st)].
   */
  class SteadySliding
  {
  public:
    using Complex = std::complex<double>;

    /** Lower and upper layer. */
    std::array<Material, 2> material;
    std::array<double, 2>   thickness = {{0.5, 0.5}};

    RateAndStateParameters friction;
    double                 normal_stress = 0;
    double                 slip_rate     = 0;
    double                 wave_number   = 0;
    bool                   with_inertia  = true;
    /** Pa s/m. */
    double radiation_damping = 0;
    /** True if u_y is zero at the upper plate, not the normal traction. */
    bool top_is_held = true;
    /** True if the normal stress of friction follows the contact pressure, at
     * the reference friction coefficient. */
    bool normal_stress_follows = false;

    /** A perturbation at one point: X, Y and the traction components
     * sigma_xy / cos kx and sigma_yy / sin kx. */
    struct Field
    {
      Complex X, Y, shear, normal;
    };

    /** Shear traction on the fault for a slip of 1 m, Pa/m, with the opposite
     * sign. */
    Complex
    stiffness(const Complex s) const
    {
      const std::vector<Complex> c = coefficients(s);
      return -field(1, 0., s, c).shear;
    }

    /** Perturbation of ln(theta) for a slip of 1 m. */
    Complex
    state(const Complex s) const
    {
      const double rate = slip_rate / friction.characteristic_slip;
      return -(s / friction.characteristic_slip) / (s + rate);
    }

    /** Zero for the growth rates. */
    Complex
    characteristic_function(const Complex s) const
    {
      const Complex balance =
        stiffness(s) + radiation_damping * s +
        normal_stress * (friction.a * s / slip_rate + friction.b * state(s));
      if (!normal_stress_follows)
        return balance;
      // The contact pressure is i times this.
      return balance + Complex(0., friction.reference_friction) *
                         field(1, 0., s, coefficients(s)).normal;
    }

    /** Below this stiffness steady sliding is unstable without inertia and
     * viscosity: with s purely imaginary, the terms in s cancel. */
    double
    critical_stiffness() const
    {
      return (normal_stress * (friction.b - friction.a) -
              radiation_damping * slip_rate) /
             friction.characteristic_slip;
    }

    /** The growth rate next to that of a stiffness that does not depend on it,
     * in the upper half of the plane. */
    Complex
    growth_rate() const
    {
      const double L = friction.characteristic_slip, V = slip_rate,
                   a = friction.a * normal_stress / V + radiation_damping;
      // With inertia the two kinds of waves are the same at s = 0.
      SteadySliding slow = *this;
      slow.with_inertia  = false;
      const Complex K    = slow.stiffness(0.);
      const Complex p    = K - critical_stiffness();
      Complex       s = (-p + std::sqrt(p * p - 4. * a * K * V / L)) / (2. * a);
      if (s.imag() < 0)
        s = std::conj(s);
      Complex before   = s * Complex(1.001, 0.001);
      Complex F_before = characteristic_function(before);
      for (unsigned int i = 0; i < 100; ++i)
        {
          const Complex F    = characteristic_function(s);
          const Complex step = -F * (s - before) / (F - F_before);
          before             = s;
          F_before           = F;
          s += step;
          if (std::abs(step) < 1e-12 * std::abs(s))
            return s;
        }
      AssertThrow(false, ExcMessage("The growth rate was not found."));
      return s;
    }

    /** Solution of the equations of both layers and the conditions at plates
     * and fault for a slip of 1 m: four coefficients a layer. */
    std::vector<Complex>
    coefficients(const Complex s) const
    {
      FullMatrix<Complex>  matrix(8, 8);
      std::vector<Complex> rhs(8);
      // Scales the rows of tractions.
      const double G = material[0].shear_modulus() * wave_number;
      for (unsigned int layer = 0; layer < 2; ++layer)
        for (unsigned int j = 0; j < 4; ++j)
          {
            std::vector<Complex> unit(8);
            unit[4 * layer + j] = 1.;
            const double sign   = layer == 0 ? -1. : 1.;
            const Field  plate = field(layer, sign * thickness[layer], s, unit);
            const Field  fault = field(layer, 0., s, unit);
            matrix(2 * layer, 4 * layer + j) = plate.X;
            matrix(2 * layer + 1, 4 * layer + j) =
              layer == 0 || top_is_held ? plate.Y : plate.normal / G;
            matrix(4, 4 * layer + j) = sign * fault.X;
            matrix(5, 4 * layer + j) = sign * fault.Y;
            matrix(6, 4 * layer + j) = sign * fault.shear / G;
            matrix(7, 4 * layer + j) = sign * fault.normal / G;
          }
      rhs[4] = 1.;
      matrix.gauss_jordan();
      std::vector<Complex> result(8);
      for (unsigned int i = 0; i < 8; ++i)
        for (unsigned int j = 0; j < 8; ++j)
          result[i] += matrix(i, j) * rhs[j];
      return result;
    }

    Field
    field(const unsigned int          layer,
          const double                y,
          const Complex               s,
          const std::vector<Complex> &coefficients) const
    {
      const Material &solid = material[layer];
      const double    k     = wave_number;
      // Kelvin and Voigt: moduli that depend on the growth rate.
      const Complex mu = solid.shear_modulus() + s * solid.shear_viscosity;
      const Complex lambda =
        solid.lame_lambda() +
        s * (solid.bulk_viscosity - 2. / 3. * solid.shear_viscosity);

      Field sum = {};
      for (unsigned int j = 0; j < 4; ++j)
        {
          // Growing towards the plate or towards the fault.
          const double towards = j % 2 == 0 ? 1. : -1.;
          const double from    = towards == (layer == 0 ? -1. : 1.) ?
                                   towards * thickness[layer] :
                                   0.;
          Complex      X, dX, Y, dY;
          if (with_inertia)
            {
              const Complex inertia     = solid.density * s * s;
              const bool    is_gradient = j < 2;
              const Complex q =
                towards *
                std::sqrt(k * k +
                          inertia / (is_gradient ? lambda + 2. * mu : mu));
              // Of size one at the end that it grows to.
              const Complex e = std::exp(q * (y - from));
              X               = (is_gradient ? k : q) * e / k;
              Y               = (is_gradient ? q : Complex(k)) * e / k;
              dX              = q * X;
              dY              = q * Y;
            }
          else
            {
              const Complex kappa = (lambda + 3. * mu) / (lambda + mu);
              const Complex e     = std::exp(towards * k * (y - from));
              if (j < 2)
                {
                  X  = e;
                  Y  = towards * e;
                  dX = towards * k * X;
                  dY = towards * k * Y;
                }
              else
                {
                  X  = towards * k * y * e;
                  Y  = (k * y - towards * kappa) * e;
                  dX = towards * k * (e + X);
                  dY = k * e + towards * k * Y;
                }
            }
          const Complex c = coefficients[4 * layer + j];
          sum.X += c * X;
          sum.Y += c * Y;
          sum.shear += c * mu * (dX + k * Y);
          sum.normal += c * ((lambda + 2. * mu) * dY - lambda * k * X);
        }
      return sum;
    }
  };
} // namespace StickSlip::Tests

#endif
