// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_initial_sliding_h
#define stickslip_friction_initial_sliding_h

#include <deal.II/base/tensor.h>

#include <stickslip/friction/friction_law.h>

#include <optional>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Values given of a point of a fault at the start, with @p n tangential
   * components, upper relative to lower side.
   */
  template <int n>
  struct GivenStart
  {
    /** Logarithm of the state, ln(theta / 1 s). */
    std::optional<double> log_state;

    /** Slip rate, m/s. */
    std::optional<Tensor<1, n>> slip_rate;

    /** Shear stress that drives the slip, Pa. */
    std::optional<Tensor<1, n>> shear_stress;

    /** True if the fault does not merely start at rest under what the bodies
     * carry. */
    bool
    has_motion() const
    {
      return slip_rate.has_value() || shear_stress.has_value();
    }
  };

  /**
   * A point of a fault at the start in equilibrium.
   */
  template <int n>
  struct InitialSliding
  {
    double       log_state = 0.;
    Tensor<1, n> slip_rate, shear_stress;
  };

  /**
   * Complete what is given of the start, slip rate or shear stress or both, so
   * that
   *
   *   tau = (sigma_n mu(V, theta) + eta V) V/|V|,
   *
   * with the @p normal_stress sigma_n >= 0 (Pa) and the @p damping eta (Pa
   * s/m): of slip rate, shear stress and state what is not given follows from
   * the other two. The state is 1 s where it is not given and does not follow,
   * since slip rate and shear stress are not both given, or the law has none
   * (@p has_state).
   *
   * Throws InputError, without the names of entries, where all three are given
   * and differ by more than 1e-4 of the shear stress, where slip rate and shear
   * stress have different directions, where no state fits, and where the shear
   * stress is above the strength, so that the slip rate would be above 1 m/s.
   */
  template <int n>
  InitialSliding<n>
  complete_start(const GivenStart<n> &given,
                 const FrictionLaw   &law,
                 const bool           has_state,
                 const double         normal_stress,
                 const double         damping);
} // namespace StickSlip

#endif
