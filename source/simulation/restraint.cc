// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/scene/side_points.h>
#include <stickslip/simulation/restraint.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

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



    /** For each body the first one of those that can be reached from it across
     * faults that resist slip. */
    template <int dim>
    std::vector<unsigned int>
    first_in_reach(const FaultTopology    &topology,
                   const FaultNodes<dim>  &faults,
                   const NodeLaws         &laws,
                   const SystemState<dim> &state)
    {
      std::vector<unsigned int> first(topology.body_names().size());
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
      return first;
    }



    template <int dim>
    bool
    is_held_by_a_side(const SceneParameters<dim> &scene,
                      const unsigned int          body,
                      const unsigned int          axis)
    {
      if (scene.bodies[body].geometry.rigid)
        return true;
      for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
        {
          if (condition.body != scene.bodies[body].name)
            continue;
          for (const Tensor<2, dim> &axes : side_directions(scene, condition))
            for (unsigned int c = 0; c < dim; ++c)
              if ((condition.type[c] == BoundaryType::fixed ||
                   condition.type[c] == BoundaryType::velocity) &&
                  std::abs(axes[axis][c]) > 1e-3)
                return true;
        }
      return false;
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
    const std::vector<unsigned int> first =
      first_in_reach(scene.topology, faults, laws, state);
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      for (unsigned int k = 0; k < first.size(); ++k)
        {
          bool is_held = first[k] != k;
          for (unsigned int b = k; b < first.size(); ++b)
            is_held |= first[b] == k && is_held_by_a_side(scene, b, axis);
          if (!is_held)
            throw InputError(
              "'Time/Inertia' = 'quasi-static': nothing holds the body '" +
              scene.bodies[k].name + "' along " + scene.axis_name(axis) +
              ", neither a side with '" + scene.axis_name(axis) +
              " condition' = 'fixed' or 'velocity' nor friction that grows with the "
              "slip rate, "
              "so that without inertia its velocity is not determined; hold "
              "it, press its faults together, or choose quasi-dynamic or "
              "dynamic.");
        }
  }



  template <int dim>
  std::string
  explain_failure(const SceneParameters<dim> &scene,
                  const FaultNodes<dim>      &faults,
                  const SystemState<dim>     &state)
  {
    constexpr double most_of_it = 0.5;

    if (scene.time.inertia == Inertia::dynamic)
      return "";
    for (unsigned int f = 0; f < scene.faults.size() && !state.gap.empty(); ++f)
      {
        double open = 0., area = 0.;
        for (unsigned int k = faults.first_of_fault()[f];
             k < faults.first_of_fault()[f + 1];
             ++k)
          {
            area += faults.weights()[k];
            if (state.gap[k] > 0.)
              open += faults.weights()[k];
          }
        if (open > most_of_it * area)
          {
            std::ostringstream text;
            text.precision(3);
            text << " The fault '" << scene.faults[f].name << "' is open over "
                 << 100. * open / area
                 << " % of its area: without mass the place of a body that "
                    "nothing else holds is not determined once it has come "
                    "off; hold it, or choose 'Time/Inertia' = 'dynamic'.";
            return text.str();
          }
      }
    if (scene.time.inertia == Inertia::quasi_static)
      return " With Time/Inertia = quasi-static slip rates can grow without "
             "bound where a fault becomes unstable; with quasi-dynamic and "
             "dynamic they do not.";
    return "";
  }



  template decltype(explain_failure<2>) explain_failure<2>;
  template decltype(explain_failure<3>) explain_failure<3>;
  template decltype(check_restraint<2>) check_restraint<2>;
  template decltype(check_restraint<3>) check_restraint<3>;
} // namespace StickSlip
