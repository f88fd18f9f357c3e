// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_stepping_scene_h
#define stickslip_tests_stepping_scene_h

#include <stickslip/friction/rate_and_state.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/initial_state.h>
#include <stickslip/simulation/node_laws.h>
#include <stickslip/time/step_size_control.h>

#include <cstring>

#include "creeping_scene.h"
#include "temporary_folder.h"

namespace StickSlip::Tests
{
  inline SceneParameters<2>
  read_scene(const std::string              &text,
             const std::vector<std::string> &overrides = {})
  {
    const TemporaryFolder folder;
    return SceneReader(folder.write("scene.prm", text), overrides).read<2>();
  }



  /** Settings of entries. */
  using Settings = std::vector<std::string>;



  /** Settings, and more of them, which count where both set an entry. */
  inline Settings
  operator+(Settings overrides, const Settings &more)
  {
    overrides.insert(overrides.end(), more.begin(), more.end());
    return overrides;
  }



  /** The creeping bodies at a thousandfold speed: they slide by half a metre,
   * several faces and, on several processes, past the parts of others. */
  inline SceneParameters<2>
  fast_sliding_scene(const Settings &more)
  {
    const Settings fast = {"Boundary conditions/upper top/x value=0.25",
                           "Boundary conditions/upper top/Ramp length=0.2",
                           "Faults/fault/Reference slip rate=0.25",
                           "Faults/fault/Characteristic slip=0.25",
                           "Faults/fault/Normal stress function=1e3",
                           "Time/End time=2.1",
                           "Time/Largest step=0.05",
                           "Time/Tolerance=1e-3"};
    return read_scene(creeping_bodies, fast + more);
  }



  /** The parameters of a node with rate-and-state friction. */
  inline const RateAndStateParameters &
  friction_parameters(const FaultLaw &law)
  {
    return dynamic_cast<const RateAndStateLaw &>(*law.friction)
      .get_parameters();
  }



  /**
   * A scene set up for time stepping without any output. Its time parameters
   * may be changed at any moment.
   */
  struct SteppingScene
  {
    explicit SteppingScene(const SceneParameters<2> &parameters)
      : scene(parameters)
      , meshes(scene.coarse_bodies(), scene.topology, MPI_COMM_WORLD)
      , boundary_values(meshes,
                        scene.boundary_conditions,
                        scene.topology.body_names())
      , problem(meshes,
                members_of(scene.bodies, &BodyParameters<2>::material),
                boundary_values,
                scene.gravity_vector(),
                scene.time.inertia == Inertia::dynamic)
    {
      const InitialEquilibrium<2> equilibrium =
        solve_initial_equilibrium(problem);
      laws = make_node_laws(scene, problem.jump_basis());
      state =
        make_initial_state(scene, problem.jump_basis(), equilibrium).system;
      prepare();
    }

    SteppingScene(const std::string              &text,
                  const std::vector<std::string> &overrides = {})
      : SteppingScene(read_scene(text, overrides))
    {}

    /** Everything that depends on the contact mapping; normal stresses follow
     * if they are asked to. */
    void
    prepare(const FollowingStress<2> &following = {})
    {
      faults =
        FaultNodes<2>(problem.jump_basis(), problem.hierarchy().finest().nodes);
      step = std::make_unique<RateStateStep<2>>(
        problem, faults, laws, scene.time, scene.tnnmg, following);
      controller =
        make_step_size_controller(*step, scene.time, boundary_values);
    }

    /** One advance; returns the steps without their states but the last. */
    std::vector<StepResult<2>>
    advance()
    {
      std::vector<StepResult<2>> accepted = controller->advance(state, memory);
      state                               = accepted.back().state;
      return accepted;
    }

    /** Advance as long as the time is before @p time. */
    void
    advance_until(const double time)
    {
      while (state.time < time)
        advance();
    }

    SceneParameters<2>                     scene;
    MeshHierarchy<2>                       meshes;
    BoundaryValues<2>                      boundary_values;
    SpatialProblem<2>                      problem;
    NodeLaws                               laws;
    FaultNodes<2>                          faults;
    SystemState<2>                         state;
    StepMemory<2>                          memory;
    std::unique_ptr<RateStateStep<2>>      step;
    std::unique_ptr<StepSizeController<2>> controller;
  };



  inline bool
  same_bits(const NodalVector &a, const NodalVector &b)
  {
    return a.locally_owned_size() == b.locally_owned_size() &&
           std::memcmp(a.begin(),
                       b.begin(),
                       a.locally_owned_size() * sizeof(double)) == 0;
  }



  template <typename T>
  bool
  same_bits(const std::vector<T> &a, const std::vector<T> &b)
  {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
  }



  /** True if two states agree in every bit. */
  inline bool
  same_bits(const SystemState<2> &a, const SystemState<2> &b)
  {
    return std::memcmp(&a.time, &b.time, sizeof(double)) == 0 &&
           same_bits(a.displacement, b.displacement) &&
           same_bits(a.velocity, b.velocity) &&
           same_bits(a.acceleration, b.acceleration) &&
           same_bits(a.mean_velocity, b.mean_velocity) &&
           same_bits(a.alpha, b.alpha) && same_bits(a.slip, b.slip) &&
           same_bits(a.slip_rate, b.slip_rate) &&
           same_bits(a.normal_stress, b.normal_stress);
  }
} // namespace StickSlip::Tests

#endif
