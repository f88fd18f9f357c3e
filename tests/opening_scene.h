// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_opening_scene_h
#define stickslip_tests_opening_scene_h

#include <stickslip/faults/background_stress.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/simulation/node_openings.h>
#include <stickslip/time/energy_balance.h>
#include <stickslip/time/step_size_control.h>

#include "temporary_folder.h"

namespace StickSlip::Tests
{
  template <int dim>
  SceneParameters<dim>
  read_opening_scene(const std::string              &text,
                     const std::vector<std::string> &overrides = {})
  {
    const TemporaryFolder folder;
    return SceneReader(folder.write("scene.prm", text), overrides)
      .template read<dim>();
  }



  /**
   * A scene with faults that may open, set up for single steps whose size and
   * start the test chooses.
   */
  template <int dim>
  struct OpeningScene
  {
    explicit OpeningScene(const SceneParameters<dim> &parameters)
      : scene(parameters)
      , meshes(scene.coarse_bodies(), scene.topology, MPI_COMM_WORLD)
      , boundary_values(meshes,
                        scene.boundary_conditions,
                        names_of(scene.bodies))
      , problem(meshes,
                members_of(scene.bodies, &BodyParameters<dim>::material),
                boundary_values,
                scene.gravity_vector(),
                scene.time.inertia == Inertia::dynamic,
                make_slip_rates(scene),
                BackgroundStress<dim>(scene.faults),
                make_opening_parts(scene))
      , laws(make_node_laws(scene, problem.jump_basis()))
      , openings(make_node_openings(scene, problem))
    {
      InitialState<dim> start =
        make_initial_state(scene,
                           problem.jump_basis(),
                           solve_initial_equilibrium(problem),
                           openings);
      state  = std::move(start.system);
      offset = std::move(start.stress_offset);
      prepare();
    }

    explicit OpeningScene(const std::string              &text,
                          const std::vector<std::string> &overrides = {})
      : OpeningScene(read_opening_scene<dim>(text, overrides))
    {}

    /** Everything that depends on contact mapping, openings and offset. */
    void
    prepare()
    {
      faults  = FaultNodes<dim>(problem.jump_basis(),
                               problem.hierarchy().finest().nodes);
      contact = UnilateralContact<dim>(faults, openings, offset);
      step    = std::make_unique<RateStateStep<dim>>(
        problem,
        faults,
        laws,
        scene.time,
        scene.tnnmg,
        FollowingStress<dim>(
          members_of(scene.faults, &FaultParameters::normal_stress_follows),
          faults,
          offset,
          openings),
        contact);
      energy =
        std::make_unique<EnergyBalance<dim>>(problem, faults, laws, account);
    }

    /** Begin without any stress, at velocities that are a function of the
     * place. */
    void
    start_free(
      const std::function<Tensor<1, dim>(const unsigned int body,
                                         const Point<dim> &)> &velocity)
    {
      state.displacement = 0.;
      state.velocity     = 0.;
      state.acceleration = 0.;
      state.force.reinit(0);
      const MeshLevel<dim> &level = meshes.finest();
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        {
          const auto positions = level.bodies[b]->node_positions();
          for (unsigned int i = 0; i < positions.size(); ++i)
            {
              const auto node = level.global_node(b, i);
              if (!level.nodes.owned().is_element(node))
                continue;
              const Tensor<1, dim> v = velocity(b, positions[i]);
              for (unsigned int d = 0; d < dim; ++d)
                state.velocity.local_element(
                  level.nodes.local_index(node) * dim + d) = v[d];
            }
        }
      NodalVector w = problem.make_vector();
      problem.to_jumps(w, state.velocity);
      state.slip_rate    = faults.tangential_jumps(w);
      state.opening_rate = faults.opening_jumps(w);
      state.balancing_traction.clear();
      std::fill(state.contact_pressure.begin(),
                state.contact_pressure.end(),
                0.);
      std::fill(state.normal_stress.begin(), state.normal_stress.end(), 0.);
      std::fill(offset.begin(), offset.end(), 0.);
      prepare();
    }

    /** One step. */
    StepResult<dim>
    advance(const double tau)
    {
      StepResult<dim> result = step->take(state, tau);
      if (result.converged)
        state = result.state;
      return result;
    }

    double
    total_energy() const
    {
      return energy->kinetic_energy(state) + energy->elastic_energy(state);
    }

    SceneParameters<dim>                scene;
    MeshHierarchy<dim>                  meshes;
    BoundaryValues<dim>                 boundary_values;
    SpatialProblem<dim>                 problem;
    NodeLaws                            laws;
    std::vector<NodeOpening>            openings;
    std::vector<double>                 offset;
    SystemState<dim>                    state;
    FaultNodes<dim>                     faults;
    UnilateralContact<dim>              contact;
    EnergyAccount                       account;
    std::unique_ptr<RateStateStep<dim>> step;
    std::unique_ptr<EnergyBalance<dim>> energy;
  };
} // namespace StickSlip::Tests

#endif
