// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_fault_parameters_h
#define stickslip_friction_fault_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/friction/rate_and_state_fields.h>
#include <stickslip/friction/state_evolution.h>

#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Where the normal stress in the friction law comes from.
   */
  enum class NormalStressSource
  {
    /** Contact force of the static equilibrium with the faults stuck. */
    initial_equilibrium,
    /** Weight of what lies above: sum of rho g times thickness. */
    lithostatic,
    /** A given function of position, Pa, compression positive. */
    function
  };

  /**
   * Everything the scene says of one fault.
   */
  struct FaultParameters
  {
    std::string name;

    /** a, b, mu0, V0, L. */
    RateAndStateFields rate_and_state;
    Regularisation     regularisation = Regularisation::truncated;
    StateLaw           state_law      = StateLaw::aging;

    /** Initial state theta, s. */
    SpatialField initial_state = 1.;

    NormalStressSource normal_stress_source =
      NormalStressSource::initial_equilibrium;

    /** Normal stress, Pa, compression positive. */
    SpatialField normal_stress = 5e4;

    /** The subsection of its entries, for messages. */
    std::string
    section() const;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
