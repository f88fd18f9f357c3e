// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <algorithm>
#include <functional>

#include "crossing_mesh.h"
#include "friction_chain.h"
#include "stacked_bodies.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Alpha = std::function<double(const double, const unsigned int)>;

  const std::vector<std::pair<const char *, Alpha>> states = {
    {"stuck", [](const double, const unsigned int) { return 12.; }},
    {"slipping", [](const double, const unsigned int) { return -9.; }},
    {"half and half",
     [](const double x, const unsigned int) { return x < 0.1 ? -9. : 9.; }},
    {"random", [](const double, const unsigned int k) {
       return 8. * std::sin(12.9898 * (k + 1.));
     }}};

  const std::vector<double> taus = {1e-4, 1e-2, 1e-1};



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

    const LevelDescription<2> &level = problem.hierarchy().finest();
    std::vector<double>        weights(level.nonsmooth_nodes.size()),
      places(level.nonsmooth_nodes.size());
    for (const FaultContact<2> &fault : problem.jump_basis().faults())
      for (unsigned int k = 0; k < fault.slave_nodes.size(); ++k)
        if (fault.coupling.active[k])
          {
            const unsigned int position =
              std::lower_bound(level.nonsmooth_nodes.begin(),
                               level.nonsmooth_nodes.end(),
                               level.nodes.local_index(fault.slave_nodes[k])) -
              level.nonsmooth_nodes.begin();
            weights[position] = fault.coupling.weight[k];
            places[position]  = fault.slave_surface.points[k][0] +
                               fault.slave_surface.points[k][1];
          }

    std::vector<unsigned int> result;
    for (const double tau : taus)
      {
        problem.combine(Newmark<2>().operator_coefficients(tau));
        const NodalVector rhs =
          Newmark<2>().right_hand_side(problem, state, tau);
        for (const auto &[name, alpha] : states)
          {
            std::vector<double> alphas;
            for (unsigned int k = 0; k < places.size(); ++k)
              alphas.push_back(alpha(places[k], k));
            const Friction<2> friction = make_friction<2>(
              Kind::truncated, level.nonsmooth_nodes, weights, 4.9e4, alphas);
            const TNNMGParameters parameters;
            TNNMGSolver<2>        solver(problem.hierarchy(), parameters);
            NodalVector           w = problem.make_vector();
            boundary.set_velocities(10., w);
            const SolveSummary summary =
              solver.solve(*friction.functional, rhs, w);
            EXPECT_TRUE(summary.converged) << name << '\n' << summary;
            result.push_back(summary.iterations.size());
          }
      }
    return result;
  }



  /** Counts of several scenes agree up to two, and are small. */
  void
  expect_alike(const std::vector<std::vector<unsigned int>> &counts)
  {
    for (unsigned int k = 0; k < counts.front().size(); ++k)
      {
        std::string  text;
        unsigned int least = 1000, most = 0;
        for (const auto &of_scene : counts)
          {
            least = std::min(least, of_scene[k]);
            most  = std::max(most, of_scene[k]);
            text += ' ' + std::to_string(of_scene[k]);
          }
        const std::string name =
          std::string(states[k % states.size()].first) +
          ", tau = " + std::to_string(taus[k / states.size()]) + ":" + text;
        std::cout << name << '\n';
        EXPECT_LE(most - least, 2u) << name;
        EXPECT_LE(most, 12u) << name;
      }
  }
} // namespace



TEST(TNNMG, IterationsDoNotGrowWithTheNumberOfCrossingFaults)
{
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_faults : {1, 2, 3, 4, 8})
    counts.push_back(iterations(n_faults, 2));
  expect_alike(counts);
}



TEST(TNNMG, IterationsOfCrossingFaultsDoNotGrowWithRefinement)
{
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_refinements : {1, 2, 3})
    counts.push_back(iterations(4, n_refinements));
  expect_alike(counts);
}
