// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_friction_parameters_h
#define stickslip_friction_friction_parameters_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <stickslip/friction/rate_and_state_fields.h>
#include <stickslip/friction/state_evolution.h>

#include <array>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * What resists the slip.
   */
  enum class FrictionKind
  {
    /** mu0 + a ln(V/V0) + b ln(V0 theta/L) */
    rate_and_state,
    /** The same without the state, mu0 + a ln(V/V0). */
    velocity_strengthening,
    /** The same without either, mu0: a threshold. */
    coulomb,
    /** Nothing. */
    frictionless,
    /** There is no slip. */
    welded,
    /** The slip rate is given. */
    prescribed_slip_rate
  };

  /**
   * What a scene says of the friction of one fault or one region of a fault.
   * Each kind of friction uses those of the parameters that it has.
   */
  struct FrictionParameters
  {
    FrictionKind kind = FrictionKind::rate_and_state;

    /** a, b, mu0, V0, L. */
    RateAndStateFields rate_and_state;
    Regularisation     regularisation = Regularisation::truncated;
    StateLaw           state_law      = StateLaw::aging;

    /** Initial state theta, s. */
    SpatialField initial_state = 1.;

    /** Of the upper side relative to the lower one, along each horizontal axis,
     * m/s. */
    std::array<SpatialField, 2> slip_rate;

    /** Time in which it grows from zero, s. */
    double slip_rate_ramp_length = 0;

    /** Whether friction depends on a state that evolves. */
    bool
    has_state() const;

    /** Whether the slip rate is known, so that no friction acts. */
    bool
    has_prescribed_slip() const;

    /** The slip rates at some points, where they are prescribed; zero where the
     * fault is welded. Throws InputError, see SpatialField::function(). */
    template <int dim>
    std::vector<Tensor<1, dim - 1>>
    prescribed_slip_rates(const std::vector<Point<dim>> &points,
                          const std::string             &section) const;

    /** Throws InputError unless all that this kind of friction uses has a value
     * at some points. */
    template <int dim>
    void
    check(const std::vector<Point<dim>> &points,
          const std::string             &section) const;

    /** Declare the entries in the current subsection of @p prm, those of a
     * scene in @p dim dimensions. */
    void
    add_parameters(ParameterHandler &prm, const unsigned int dim);
  };



  inline bool
  FrictionParameters::has_prescribed_slip() const
  {
    return kind == FrictionKind::welded ||
           kind == FrictionKind::prescribed_slip_rate;
  }
} // namespace StickSlip

#endif
