// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/faults/background_stress.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/lithostatic_stress.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    std::string
    tension_message(const FaultParameters &fault,
                    const Point<dim>      &point,
                    const double           normal_stress)
    {
      std::string position;
      for (unsigned int d = 0; d < dim; ++d)
        position += (d == 0 ? "" : ", ") + shortest_form(point[d]);
      return "'" + fault.section() +
             "/Background stress': pulls the fault apart at (" + position +
             ") m, where the normal stress would be " +
             shortest_form(normal_stress) +
             " Pa; compression is negative in this entry, and the sum with "
             "'Normal stress' must not be tension.";
    }



    /** Set the normal stress at all slave nodes of @p start, what of it the
     * bodies do not carry, and the number of nodes in tension. */
    template <int dim>
    void
    set_normal_stress(InitialState<dim>              &start,
                      const SceneParameters<dim>     &scene,
                      const JumpBasis<dim>           &basis,
                      const InitialEquilibrium<dim>  &equilibrium,
                      const std::vector<NodeOpening> &openings)
    {
      const BackgroundStress<dim> background_stress(scene.faults);
      std::vector<double>        &stress = start.system.normal_stress;
      stress                             = equilibrium.contact_pressure;
      start.stress_offset.resize(stress.size());
      unsigned int k = 0;
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const FaultParameters         &fault = scene.faults[f];
          const std::vector<Point<dim>> &points =
            basis.faults()[f].slave.points;
          std::vector<double> given;
          if (fault.normal_stress_source == NormalStressSource::function)
            given = fault.normal_stress.values(points, fault.section());
          else if (fault.normal_stress_source ==
                   NormalStressSource::lithostatic)
            given = lithostatic_stress(scene, f, points);
          const std::vector<double> background =
            background_stress.normal_stress(basis, f);
          const unsigned int first        = k;
          bool               has_friction = false;
          for (const FaultPart &part : fault.parts(points))
            for (const unsigned int i : part.positions)
              {
                double    &sigma  = stress[first + i];
                double    &offset = start.stress_offset[first + i];
                const bool may_open =
                  !openings.empty() && openings[first + i].may_open;
                if (!given.empty())
                  sigma = given[i];
                const bool is_needed =
                  part.friction->kind().needs_normal_stress;
                has_friction = has_friction || is_needed;
                if (!background.empty())
                  sigma += background[i];
                // A fault that may open does so under tension.
                if (sigma < 0. && is_needed && !may_open)
                  {
                    if (!background.empty() && background[i] < 0.)
                      throw InputError(
                        tension_message(fault, points[i], sigma));
                    ++start.n_in_tension;
                  }
                if (may_open)
                  offset = sigma - equilibrium.contact_pressure[first + i];
                sigma = std::max(sigma, 0.);
                if (!may_open)
                  offset = sigma - equilibrium.contact_pressure[first + i];
                ++k;
              }
          if (has_friction && !fault.may_open() &&
              fault.normal_stress_source != NormalStressSource::function &&
              std::none_of(stress.begin() + first,
                           stress.begin() + k,
                           [](const double sigma) { return sigma > 0.; }))
            throw InputError(
              "'" + fault.section() +
              "/Normal stress': nothing presses this fault together; it must be "
              "'function', or there must be gravity, a boundary traction or a "
              "background stress that does.");
        }
    }



    /** Set gaps and bonds of @p state. */
    template <int dim>
    void
    set_gaps(SystemState<dim> &state, const std::vector<NodeOpening> &openings)
    {
      for (unsigned int k = 0; k < openings.size(); ++k)
        {
          const NodeOpening &node = openings[k];
          state.gap.push_back(node.may_open ? node.initial_gap : 0.);
          if (state.gap.back() > 0.)
            state.normal_stress[k] = 0.;
          state.is_bonded.push_back(
            node.may_open && node.initial_gap == 0. &&
            (node.tensile_strength > 0. || node.cohesion > 0.));
        }
      state.opening_rate.assign(openings.size(), 0.);
      state.touching_since.assign(openings.size(), 0.);
    }
  } // namespace



  template <int dim>
  InitialState<dim>
  make_initial_state(const SceneParameters<dim>     &scene,
                     const JumpBasis<dim>           &basis,
                     const InitialEquilibrium<dim>  &equilibrium,
                     const std::vector<NodeOpening> &openings)
  {
    InitialState<dim> start;
    set_normal_stress(start, scene, basis, equilibrium, openings);
    SystemState<dim> &state = start.system;
    set_gaps(state, openings);
    state.displacement = equilibrium.displacement;
    state.velocity     = equilibrium.displacement;
    state.velocity     = 0.;
    if (scene.time.inertia == Inertia::dynamic)
      state.acceleration = state.velocity;
    bool with_pressure =
      has_field(scene.output.fault_fields, FaultField::contact_pressure) &&
      scene.output.write_faults;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const FaultParameters         &fault  = scene.faults[f];
        const std::vector<Point<dim>> &points = basis.faults()[f].slave.points;
        const unsigned int             first  = state.alpha.size();
        state.alpha.resize(first + points.size(), 0.);
        for (const FaultPart &part : fault.parts(points))
          if (part.friction->has_state())
            {
              const std::vector<double> theta =
                part.friction->initial_states(part.select(points),
                                              part.section);
              for (unsigned int i = 0; i < theta.size(); ++i)
                state.alpha[first + part.positions[i]] = std::log(theta[i]);
            }
        with_pressure =
          with_pressure || fault.normal_stress_follows || fault.may_open();
      }
    if (with_pressure)
      state.contact_pressure = equilibrium.contact_pressure;
    // Nothing presses where there is a gap.
    if (with_pressure)
      for (unsigned int k = 0; k < state.gap.size(); ++k)
        if (state.gap[k] > 0.)
          state.contact_pressure[k] = -start.stress_offset[k];
    state.slip.resize(state.alpha.size());
    state.slip_rate.resize(state.alpha.size());
    state.balancing_traction = equilibrium.shear_traction;
    return start;
  }



  template decltype(make_initial_state<2>) make_initial_state<2>;
  template decltype(make_initial_state<3>) make_initial_state<3>;
} // namespace StickSlip
