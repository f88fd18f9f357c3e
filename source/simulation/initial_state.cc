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



    /** The normal stress at all slave nodes, Pa. */
    template <int dim>
    std::vector<double>
    make_normal_stress(const SceneParameters<dim>    &scene,
                       const JumpBasis<dim>          &basis,
                       const InitialEquilibrium<dim> &equilibrium,
                       unsigned int                  &n_in_tension)
    {
      const BackgroundStress<dim> background_stress(scene.faults);
      std::vector<double>         stress = equilibrium.contact_pressure;
      unsigned int                k      = 0;
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const FaultParameters         &fault = scene.faults[f];
          const std::vector<Point<dim>> &points =
            basis.faults()[f].slave_surface.points;
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
                double &sigma = stress[first + i];
                if (!given.empty())
                  sigma = given[i];
                const bool is_needed =
                  part.friction->kind().needs_normal_stress;
                has_friction = has_friction || is_needed;
                if (!background.empty())
                  sigma += background[i];
                if (sigma < 0. && is_needed && !background.empty() &&
                    background[i] < 0.)
                  throw InputError(tension_message(fault, points[i], sigma));
                if (sigma < 0. && is_needed)
                  ++n_in_tension;
                sigma = std::max(sigma, 0.);
                ++k;
              }
          if (has_friction &&
              fault.normal_stress_source != NormalStressSource::function &&
              std::none_of(stress.begin() + first,
                           stress.begin() + k,
                           [](const double sigma) { return sigma > 0.; }))
            throw InputError(
              fault.section() +
              "/Normal stress: nothing presses this fault together; it must be "
              "'function', or there must be gravity, a boundary traction or a "
              "background stress that does.");
        }
      return stress;
    }
  } // namespace



  template <int dim>
  SystemState<dim>
  make_initial_state(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium,
                     unsigned int                  &n_in_tension)
  {
    SystemState<dim> state;
    state.normal_stress =
      make_normal_stress(scene, basis, equilibrium, n_in_tension);
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
        const FaultParameters         &fault = scene.faults[f];
        const std::vector<Point<dim>> &points =
          basis.faults()[f].slave_surface.points;
        const unsigned int first = state.alpha.size();
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
        with_pressure = with_pressure || fault.normal_stress_follows;
      }
    if (with_pressure)
      state.contact_pressure = equilibrium.contact_pressure;
    state.slip.resize(state.alpha.size());
    state.slip_rate.resize(state.alpha.size());
    state.balancing_traction = equilibrium.shear_traction;
    return state;
  }



  template decltype(make_initial_state<2>) make_initial_state<2>;
  template decltype(make_initial_state<3>) make_initial_state<3>;
} // namespace StickSlip
