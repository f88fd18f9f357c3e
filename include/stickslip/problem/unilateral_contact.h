// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_unilateral_contact_h
#define stickslip_problem_unilateral_contact_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_opening.h>
#include <stickslip/problem/system_state.h>

#include <vector>

namespace StickSlip
{
  /**
   * Coefficients of a step with which a time scheme relates the gap g at its
   * end to the opening rate w that it solves for,
   *
   *   g1 = g0 + of_start rate0 + of_end w,
   *
   * rate0 being SystemState::opening_rate, and the force in the rate problem
   * to the pressure: forces are those of @p n_times times in one.
   */
  struct GapPath
  {
    double of_start = 0, of_end = 0;
    double n_times = 1;
  };

  /**
   * Contact at nodes that may open, in the form of bounds on the opening rate,
   *
   *   g1 >= 0,   p1 >= 0,   g1 p1 = 0,
   *
   * where p is the whole normal stress: the pressure of the bodies, contact_
   * pressures(), and the offset that the bodies do not carry. Both sides touch
   * at the end of a step where the rate is exactly at its bound; the gap is
   * zero there, not merely small. A bond of tensile strength T is a pressure
   * of that size in addition, as long as it is not broken: p1 >= -T.
   *
   * Slave nodes that may not open, and those off contact, have no bound.
   */
  template <int dim>
  class UnilateralContact
  {
  public:
    /** Nothing may open. */
    UnilateralContact() = default;

    /** @p nodes: at each slave node, or empty if none may open; @p offset:
     * normal stress less contact pressure, Pa, see FollowingStress. @p faults
     * must live longer. */
    UnilateralContact(const FaultNodes<dim>          &faults,
                      const std::vector<NodeOpening> &nodes,
                      const std::vector<double>      &offset);

    /** True if any node may open. */
    bool
    is_needed() const
    {
      return !nodes.empty();
    }

    /** True if the k-th slave node is opposite the other side and may part
     * from it. */
    bool
    may_open(const unsigned int k) const
    {
      return is_needed() && nodes[k].may_open && faults->in_contact(k);
    }

    /** True if the sides of the k-th slave node have met in the last step. */
    bool
    has_landed(const SystemState<dim> &state, const unsigned int k) const;

    /** Least opening rate at each slave node, m/s: -(g0 + of_start rate0) over
     * of_end. */
    std::vector<double>
    bounds(const SystemState<dim> &from, const GapPath &path) const;

    /** Shear traction that bonds add to friction at each slave node, Pa. */
    std::vector<double>
    cohesion(const SystemState<dim> &from) const;

    /** Add to @p rhs the forces of offset and bonds, which press the sides
     * together. */
    void
    add_prestress(NodalVector            &rhs,
                  const SystemState<dim> &from,
                  const GapPath          &path) const;

    /** True for each slave node that may open whose opening rate is at its
     * bound. */
    std::vector<bool>
    touching(const std::vector<double> &opening_rates,
             const std::vector<double> &bounds) const;

    /** Add the nodes at which a step ends, at @p time, with the moment of
     * contact, all but a millionth of the way that the sides have come nearer,
     * or of the time that a number can tell: what is left would take no time,
     * but stop them with the force of a step. */
    void
    add_landed(std::vector<bool>         &touching,
               const SystemState<dim>    &from,
               const double               time,
               const std::vector<double> &opening_rates,
               const GapPath             &path) const;

    /** The pressure of the bodies at each slave node, Pa, from the reaction of
     * the rate problem over the weights; where sides do not touch that of no
     * normal stress, less the pull of a bond that breaks in this step. */
    std::vector<double>
    contact_pressure(const SystemState<dim>    &from,
                     const std::vector<double> &reaction,
                     const std::vector<bool>   &touching,
                     const GapPath             &path) const;

    /** Set gaps, their rates and bonds at the end of a step of size @p tau;
     * @p opening_rates: those of the rate problem. The rates are means over
     * the step. */
    void
    complete(SystemState<dim>          &to,
             const SystemState<dim>    &from,
             const double               tau,
             const std::vector<double> &opening_rates,
             const std::vector<bool>   &touching,
             const GapPath             &path) const;

    /** Energy that the step takes and adds along the normal, from pressures
     * and gaps at both ends. */
    ContactEnergy
    energy(const SystemState<dim> &to,
           const SystemState<dim> &from,
           const GapPath          &path) const;

  private:
    /** Offset and bond at a slave node, Pa. */
    double
    prestress(const SystemState<dim> &from, const unsigned int k) const
    {
      return offset[k] + (from.is_bonded[k] ? nodes[k].tensile_strength : 0.);
    }

    const FaultNodes<dim>   *faults = nullptr;
    std::vector<NodeOpening> nodes;
    std::vector<double>      offset;
  };
} // namespace StickSlip

#endif
