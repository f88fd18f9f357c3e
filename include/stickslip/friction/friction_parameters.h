// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_friction_parameters_h
#define stickslip_friction_friction_parameters_h

#include <deal.II/base/tensor.h>

#include <stickslip/friction/initial_sliding.h>
#include <stickslip/friction/law_registry.h>
#include <stickslip/friction/opening_parameters.h>

#include <map>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Friction of one fault or one region of a fault, as a scene says it: a kind,
   * and all parameters of all kinds, of which each kind uses its own.
   */
  class FrictionParameters
  {
  public:
    /** Rate and state, the first kind of the registry, with the default values
     * of all parameters. */
    FrictionParameters();

    /** Freedom of the sides along the normal. */
    OpeningParameters opening;

    /** Kind of friction, the entry 'Friction'. */
    const LawKind &
    kind() const
    {
      return *chosen_kind;
    }

    /** Parameter that an entry sets; a choice is the position of its word. */
    SpatialField &
    operator[](const std::string &entry)
    {
      return parameters.at(entry);
    }

    const SpatialField &
    operator[](const std::string &entry) const
    {
      return parameters.at(entry);
    }

    /** True if friction depends on a state that evolves. */
    bool
    has_state() const
    {
      return chosen_kind->has_state;
    }

    /** True if the slip rate is known, so that no friction acts. */
    bool
    has_prescribed_slip() const
    {
      return !chosen_kind->make_law;
    }

    /** Values of all parameters of the kind at some points. Throws InputError,
     * see SpatialField::function(). */
    template <int dim>
    std::vector<LawValues>
    law_values(const std::vector<Point<dim>> &points,
               const std::string             &section) const;

    /** State theta at the start at some points, s. Throws InputError, see
     * SpatialField::function(). */
    template <int dim>
    std::vector<double>
    initial_states(const std::vector<Point<dim>> &points,
                   const std::string             &section) const;

    /** Values given of the start at some points; nothing where the slip rate
     * is prescribed. Throws InputError, see SpatialField::function(). */
    template <int dim>
    std::vector<GivenStart<dim - 1>>
    given_starts(const std::vector<Point<dim>> &points,
                 const std::string             &section) const;

    /** Slip rates at some points, where they are prescribed: of the upper side
     * relative to the lower one, m/s; zero where the fault is welded. Throws
     * InputError, see SpatialField::function(). */
    template <int dim>
    std::vector<Tensor<1, dim - 1>>
    prescribed_slip_rates(const std::vector<Point<dim>> &points,
                          const std::string             &section) const;

    /** Time in which a prescribed slip rate grows from zero, s. */
    double
    slip_rate_ramp_length() const;

    /** Names of the entries whose tables say nothing of any of some points. */
    template <int dim>
    std::vector<std::string>
    tables_elsewhere(const std::vector<Point<dim>> &points) const;

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

  private:
    const LawKind                      *chosen_kind;
    std::map<std::string, SpatialField> parameters;
  };
} // namespace StickSlip

#endif
