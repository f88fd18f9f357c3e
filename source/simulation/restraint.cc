// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/simulation/restraint.h>

#include <algorithm>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    bool
    resists_slip(const FaultNodes<dim>  &faults,
                 const NodeLaws         &laws,
                 const SystemState<dim> &state,
                 const unsigned int      fault)
    {
      for (unsigned int k = faults.first_of_fault()[fault];
           k < faults.first_of_fault()[fault + 1];
           ++k)
        {
          // A coefficient that does not depend on the slip rate says nothing of
          // how fast a body is that it does not hold.
          const FaultLaw &law = laws[k];
          if (faults.in_contact(k) &&
              (law.is_prescribed || law.radiation_damping > 0. ||
               (state.normal_stress[k] > 0. &&
                law.friction->rate_scale() > 0.)))
            return true;
        }
      return false;
    }



    /** The bodies that can be reached from each other across faults that resist
     * slip, ascending; the groups in the order of their first bodies. */
    template <int dim>
    std::vector<std::vector<unsigned int>>
    bodies_that_hang_together(const FaultTopology    &topology,
                              const FaultNodes<dim>  &faults,
                              const NodeLaws         &laws,
                              const SystemState<dim> &state)
    {
      const unsigned int        n_bodies = topology.body_names().size();
      std::vector<unsigned int> first(n_bodies);
      std::iota(first.begin(), first.end(), 0);
      for (unsigned int f = 0; f < topology.faults().size(); ++f)
        if (resists_slip(faults, laws, state, f))
          {
            const auto &sides = topology.faults()[f].sides;
            for (const BodySide &a : sides[0])
              for (const BodySide &b : sides[1])
                {
                  const auto ends = std::minmax(first[a.body], first[b.body]);
                  const unsigned int kept = ends.first, joined = ends.second;
                  std::replace(first.begin(), first.end(), joined, kept);
                }
          }
      std::vector<std::vector<unsigned int>> groups;
      for (unsigned int k = 0; k < n_bodies; ++k)
        {
          groups.emplace_back();
          for (unsigned int b = k; b < n_bodies; ++b)
            if (first[b] == k)
              groups.back().push_back(b);
          if (groups.back().empty())
            groups.pop_back();
        }
      return groups;
    }



    template <int dim>
    bool
    is_held_by_a_side(const SceneParameters<dim> &scene,
                      const unsigned int          body,
                      const unsigned int          axis)
    {
      if (scene.bodies[body].geometry.rigid)
        return true;
      return std::any_of(scene.boundary_conditions.begin(),
                         scene.boundary_conditions.end(),
                         [&](const BoundaryCondition<dim> &condition) {
                           return condition.body == scene.bodies[body].name &&
                                  (condition.type[axis] ==
                                     BoundaryType::fixed ||
                                   condition.type[axis] ==
                                     BoundaryType::velocity);
                         });
    }
  } // namespace



  template <int dim>
  void
  check_restraint(const SceneParameters<dim> &scene,
                  const FaultNodes<dim>      &faults,
                  const NodeLaws             &laws,
                  const SystemState<dim>     &state)
  {
    if (scene.time.inertia == Inertia::dynamic)
      return;
    const std::vector<std::vector<unsigned int>> groups =
      bodies_that_hang_together(scene.topology, faults, laws, state);
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      for (const std::vector<unsigned int> &group : groups)
        {
          if (std::none_of(group.begin(),
                           group.end(),
                           [&](const unsigned int body) {
                             return is_held_by_a_side(scene, body, axis);
                           }))
            throw InputError(
              "'Time/Inertia' = 'quasi-static': nothing holds the body '" +
              scene.bodies[group.front()].name + "' along " + "xy"[axis] +
              ", neither a side with '" + "xy"[axis] +
              " condition' = 'fixed' or 'velocity' nor friction that grows with the "
              "slip rate, "
              "so that without inertia its velocity is not determined; hold "
              "it, press its faults together, or choose quasi-dynamic or "
              "dynamic.");
        }
  }



#define STICKSLIP_INSTANTIATE(dim)                                 \
  template void check_restraint<dim>(const SceneParameters<dim> &, \
                                     const FaultNodes<dim> &,      \
                                     const NodeLaws &,             \
                                     const SystemState<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
