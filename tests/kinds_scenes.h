// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_kinds_scenes_h
#define stickslip_tests_kinds_scenes_h

#include "simulation_scenes.h"
#include "stepping_scene.h"

namespace StickSlip::Tests
{
  /** Go on to the end of a simulation that is set up. */
  inline void
  finish(Simulation<2> &simulation)
  {
    while (!simulation.is_finished())
      simulation.advance();
  }



  inline void
  run(Simulation<2> &simulation)
  {
    simulation.set_up();
    finish(simulation);
  }



  /** The mean of an array over the nodes of a fault, by their weights. */
  inline double
  mean(const FaultSnapshot<2> &fault, const std::vector<Tensor<1, 1>> &values)
  {
    double sum = 0, weights = 0;
    for (unsigned int k = 0; k < values.size(); ++k)
      {
        sum += fault.weights[k] * values[k][0];
        weights += fault.weights[k];
      }
    return sum / weights;
  }



  /** The creeping bodies as a stiff block of 2 m x 0.5 m on a foundation; 5
   * t/m^3 unless the scene says something else. */
  inline const std::vector<std::string> block_on_foundation = {
    "Bodies/lower/Rigid=true",
    "Bodies/upper/Material/Young modulus=1e9",
    "Bodies/upper/Material/Density=5e3",
    "Bodies/upper/Refinement passes=1",
    "Boundary conditions/upper top/x condition=free",
    "Boundary conditions/upper top/x value=0",
    "Boundary conditions/upper top/Ramp length=0",
    "Faults/fault/Normal stress=lithostatic",
    "Faults/fault/Initial state=1",
    "Gravity/Acceleration=9.81",
    "Output/Event start slip rate=1",
    "Contact/Follow slip=false"};
} // namespace StickSlip::Tests

#endif
