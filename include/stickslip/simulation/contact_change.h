// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_contact_change_h
#define stickslip_simulation_contact_change_h

#include <stickslip/faults/background_stress.h>
#include <stickslip/faults/fault_nodes.h>
#include <stickslip/mortar/contact_parameters.h>
#include <stickslip/problem/contact_space.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /** Distance, m, that a node of each fault may slide until the faults are
   * coupled anew: its fraction of the smallest face of any fault. */
  template <int dim>
  std::vector<double>
  sliding_distances(const JumpBasis<dim>    &basis,
                    const ContactParameters &parameters);

  /** True if a node has slid farther between two slips, m, than these
   * @p distances, one a fault, allow. */
  template <int dim>
  bool
  has_slid(const FaultNodes<dim>                 &faults,
           const std::vector<Tensor<1, dim - 1>> &slip,
           const std::vector<Tensor<1, dim - 1>> &since,
           const std::vector<double>             &distances);

  /** The number of intervals between contact mappings, as long as the
   * @p distances say, in a slip, m, or in a second of a slip rate, m/s. */
  template <int dim>
  double
  n_intervals(const FaultNodes<dim>                 &faults,
              const std::vector<Tensor<1, dim - 1>> &slip,
              const std::vector<double>             &distances);

  /** The slip of each node until the next contact mapping, m, if it goes on as
   * @p since the last one. */
  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  expected_slip(const FaultNodes<dim>                 &faults,
                const std::vector<Tensor<1, dim - 1>> &slip,
                const std::vector<Tensor<1, dim - 1>> &since,
                const std::vector<double>             &distances);

  /** Slip accelerations with the present contact mapping, m/s^2; empty without
   * inertia. Collective. */
  template <int dim, int n_components = dim>
  std::vector<Tensor<1, dim - 1>>
  slip_accelerations(const ContactSpace<dim, n_components> &space,
                     const FaultNodes<dim>                 &faults,
                     const SystemState<dim>                &state);

  /**
   * The place of a contact mapping, m, at each slave node: the slip at that
   * time, and the slip that was expected until the next mapping, empty for
   * none. Partners are those half way.
   */
  template <int dim>
  struct MappingPlace
  {
    std::vector<Tensor<1, dim - 1>> slip, expected_slip;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &slip &expected_slip;
    }
  };

  /** The way from the place of a mapping, which is half way, to the end of its
   * interval, over the way from the place of the mapping before, as far as the
   * forces of tractions can be foreseen on it: the factor that fits all nodes
   * best, from -1 to 1, and zero where a fault bends. Forces that turn drive
   * the slip, and one that was foreseen from the last interval made slip rates
   * of a rough fault swing from mapping to mapping. */
  template <int dim>
  double
  way_to_end(const JumpBasis<dim>    &basis,
             const MappingPlace<dim> &before,
             const MappingPlace<dim> &now);

  /** The normal stress of the background stress at all slave nodes along their
   * normals, Pa; empty where there is none, or no fault bends. */
  template <int dim>
  std::vector<double>
  background_normal_stress(const BackgroundStress<dim> &background,
                           const JumpBasis<dim>        &basis);

  /** True if the sides of any node are apart. */
  template <int dim>
  bool
  is_any_open(const SystemState<dim> &state);

  /** Distance of the sides along the normal at each slave node after a
   * displacement, m, with the present contact mapping: the mean over the dual
   * function, which is not zero where sides bend that touch. Collective. */
  template <int dim, int n_components = dim>
  std::vector<double>
  side_distances(const ContactSpace<dim, n_components> &space,
                 const NodalVector                     &displacement);

  /** side_distances() of a state; empty where nothing is open or no fault
   * bends: gaps do not change with the mapping then. */
  template <int dim, int n_components = dim>
  std::vector<double>
  distances_of_gaps(const ContactSpace<dim, n_components> &space,
                    const SystemState<dim>                &state);

  /**
   * Carry a state over to a new contact mapping, that of @p space and
   * @p now. Where sides touch, slip rates, and slip_accelerations() before
   * that, belong to the nodes of the fault and stay, along axes that may have
   * turned; those of the slave side follow from them and from the new partners.
   * Velocities of sides that are apart stay, and with them their energy. Nodes
   * that come into contact get the jump of the velocities as they are, and the
   * gap of their nearest neighbour. Sides that touch keep doing so; gaps of
   * others change by as much as their distances_of_gaps() from those with the
   * mapping before. Collective.
   */
  template <int dim, int n_components = dim>
  void
  change_contact(SystemState<dim>                      &state,
                 const ContactSpace<dim, n_components> &space,
                 const FaultNodes<dim>                 &before,
                 const FaultNodes<dim>                 &now,
                 const std::vector<double>             &distances_before,
                 std::vector<Tensor<1, dim - 1>>        slip_acceleration);
} // namespace StickSlip

#endif
