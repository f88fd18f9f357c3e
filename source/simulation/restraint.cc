// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/simulation/restraint.h>

#include <algorithm>

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
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      // Bodies from first to last hang together.
      for (unsigned int first = 0, last = 0; first < scene.bodies.size();
           first = last + 1)
        {
          last         = first;
          bool is_held = is_held_by_a_side(scene, first, axis);
          while (last + 1 < scene.bodies.size() &&
                 resists_slip(faults, laws, state, last))
            {
              ++last;
              is_held = is_held || is_held_by_a_side(scene, last, axis);
            }
          if (!is_held)
            throw InputError(
              "'Time/Inertia' = 'quasi-static': nothing holds the body '" +
              scene.bodies[first].name + "' along " + "xy"[axis] +
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
