// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>

#include "crossing_mesh.h"
#include "iteration_counts.h"
#include "stacked_bodies.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const NamedStates         states = stuck_and_slipping(0.1);
  const std::vector<double> taus   = {1e-4, 1e-2, 1e-1};



  SceneParameters<2>
  crossing_scene(const unsigned int n_faults, const unsigned int n_refinements)
  {
    const TemporaryFolder folder;
    folder.write("block.msh", crossing_faults_mesh(n_faults).text());
    std::string names = "1";
    for (unsigned int f = 2; f <= n_faults; ++f)
      names += ", " + std::to_string(f);
    return SceneReader(folder.write("scene.prm",
                                    R"(
subsection Bodies
  set Names     = block
  set Mesh file = block.msh
end
subsection Boundary conditions
  set Sides = block sides
  subsection block sides
    set x condition = velocity
    set x value     = 5e-5 * y
    set y condition = velocity
    set y value     = 5e-5 * x
  end
end
)"),
                       {"Faults/Names=" + names,
                        "Bodies/block/Uniform refinements=" +
                          std::to_string(n_refinements)})
      .read<2>();
  }



  /** Iterations from zero for a Newmark step of a block under shear, in the
   * order of the step sizes and states. */
  std::vector<unsigned int>
  iterations(const unsigned int n_faults, const unsigned int n_refinements)
  {
    const SceneParameters<2> scene = crossing_scene(n_faults, n_refinements);
    const MeshHierarchy<2>   meshes(scene.coarse_bodies(),
                                  scene.topology,
                                  MPI_COMM_WORLD);
    BoundaryValues<2> boundary(meshes, scene.boundary_conditions, {"block"});
    const Material    material;
    SpatialProblem<2> problem(meshes, {material}, boundary, Tensor<1, 2>());

    // Loaded and moving by pure shear, which all faults feel alike.
    const auto shear = [&](const double size) {
      return interpolate(meshes.finest(),
                         [&](const unsigned int, const Point<2> &x) {
                           return Tensor<1, 2>({size * x[1], size * x[0]});
                         });
    };
    SystemState<2> state;
    state.time         = 10.;
    state.displacement = shear(2.5e4 / (2. * material.shear_modulus()));
    state.velocity     = shear(5e-5);
    state.acceleration = problem.make_nodal_vector();

    return iterations_from_zero(
      problem,
      boundary,
      state,
      4.9e4,
      [](const Point<2> &x) { return x[0] + x[1]; },
      states,
      taus);
  }
} // namespace



TEST(TNNMG, IterationsDoNotGrowWithTheNumberOfCrossingFaults)
{
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_faults : {1, 2, 3, 4, 8})
    counts.push_back(iterations(n_faults, 2));
  expect_alike(counts, states, taus);
}



TEST(TNNMG, IterationsOfCrossingFaultsDoNotGrowWithRefinement)
{
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_refinements : {1, 2, 3})
    counts.push_back(iterations(4, n_refinements));
  expect_alike(counts, states, taus);
}
