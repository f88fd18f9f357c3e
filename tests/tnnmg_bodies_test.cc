// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <algorithm>
#include <functional>

#include "friction_chain.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  using Alpha = std::function<double(const double, const unsigned int)>;

  const std::vector<std::pair<const char *, Alpha>> states = {
    {"stuck", [](const double, const unsigned int) { return 12.; }},
    {"slipping", [](const double, const unsigned int) { return -9.; }},
    {"half and half",
     [](const double x, const unsigned int) { return x < 0 ? -9. : 9.; }},
    {"random", [](const double, const unsigned int k) {
       return 8. * std::sin(12.9898 * (k + 1.));
     }}};



  /** A stack that begins and ends with 1 m, with layers of 0.3 m and 0.09 m in
   * between; cells nearly square, meshes that do not match. */
  std::vector<BodyGeometry<2>>
  layers(const unsigned int n_bodies)
  {
    const BodyGeometry<2> kinds[] = {make_body<2>(1., {{10, 2}}, 3),
                                     make_body<2>(0.3, {{16, 1}}, 2),
                                     make_body<2>(0.09, {{55, 1}}, 1),
                                     make_body<2>(0.3, {{16, 1}}, 2)};

    std::vector<BodyGeometry<2>> bodies;
    for (unsigned int i = 0; i + 1 < n_bodies; ++i)
      bodies.push_back(kinds[i % 4]);
    bodies.push_back(kinds[0]);
    return stack<2>(bodies);
  }



  /**
   * Iterations from zero for a Newmark step from uniform shear, in the order of
   * the step sizes and states.
   */
  std::vector<unsigned int>
  iterations(const unsigned int n_bodies, const std::vector<double> &taus)
  {
    constexpr double traction = 2.5e4, normal_stress = 4.9e4,
                     loading_rate             = 2e-4;
    const std::vector<BodyGeometry<2>> bodies = layers(n_bodies);
    const double   height   = bodies.back().base + bodies.back().thickness;
    const Material material = Material();
    const MeshHierarchy<2> meshes(bodies, MPI_COMM_WORLD);

    std::vector<std::string> names;
    for (unsigned int i = 0; i < n_bodies; ++i)
      names.push_back("body " + std::to_string(i));
    BoundaryCondition<2> bottom, top;
    bottom.body       = names.front();
    bottom.side       = BodyMesh<2>::lower_side;
    bottom.type       = {{BoundaryType::fixed, BoundaryType::fixed}};
    top.body          = names.back();
    top.side          = BodyMesh<2>::upper_side;
    top.type          = {{BoundaryType::velocity, BoundaryType::free}};
    top.expression[0] = "2e-4";
    BoundaryValues<2> boundary(meshes, {bottom, top}, names);
    SpatialProblem<2> problem(meshes,
                              std::vector<Material>(n_bodies, material),
                              boundary,
                              0.);

    SystemState<2> state;
    state.time                 = 10.;
    state.velocity             = problem.make_nodal_vector();
    state.acceleration         = problem.make_nodal_vector();
    state.displacement         = problem.make_nodal_vector();
    const MeshLevel<2> &finest = meshes.finest();
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        const std::vector<Point<2>> points = finest.bodies[b]->node_positions();
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            const unsigned int x = 2 * finest.node(b, i);
            state.displacement.local_element(x) =
              traction / material.shear_modulus() * points[i][1];
            state.velocity.local_element(x) =
              loading_rate * points[i][1] / height;
          }
      }

    // All faults with the same normal stress.
    const LevelDescription<2> &level = problem.hierarchy().finest();
    std::vector<double>        weights(level.nonsmooth_nodes.size()),
      places(level.nonsmooth_nodes.size());
    for (const FaultContact<2> &fault : problem.jump_basis().faults())
      for (unsigned int k = 0; k < fault.slave_nodes.size(); ++k)
        {
          const auto term =
            std::lower_bound(level.nonsmooth_nodes.begin(),
                             level.nonsmooth_nodes.end(),
                             level.nodes.local_index(fault.slave_nodes[k]));
          if (term == level.nonsmooth_nodes.end() ||
              *term != level.nodes.local_index(fault.slave_nodes[k]))
            continue;
          const unsigned int position = term - level.nonsmooth_nodes.begin();
          weights[position]           = fault.coupling.weight[k];
          places[position]            = fault.slave_surface.points[k][0];
        }

    std::vector<unsigned int> result;
    for (const double tau : taus)
      {
        problem.hierarchy().combine(Newmark::operator_coefficients(tau));
        const NodalVector rhs = Newmark::right_hand_side(problem, state, tau);
        for (const auto &[name, alpha] : states)
          {
            std::vector<double> alphas;
            for (unsigned int k = 0; k < places.size(); ++k)
              alphas.push_back(alpha(places[k], k));
            const Friction<2>     friction = make_friction<2>(Kind::truncated,
                                                          level.nonsmooth_nodes,
                                                          weights,
                                                          normal_stress,
                                                          alphas);
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
} // namespace



TEST(TNNMG, IterationsDoNotGrowWithTheNumberOfBodies)
{
  const std::vector<double>              taus = {1e-5, 1e-3, 1e-2};
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_bodies : {2, 3, 5, 9, 17, 33})
    counts.push_back(iterations(n_bodies, taus));
  for (unsigned int k = 0; k < counts.front().size(); ++k)
    {
      std::string  text;
      unsigned int least = 1000, most = 0;
      for (const auto &of_bodies : counts)
        {
          least = std::min(least, of_bodies[k]);
          most  = std::max(most, of_bodies[k]);
          text += ' ' + std::to_string(of_bodies[k]);
        }
      const std::string name =
        std::string(states[k % states.size()].first) +
        ", tau = " + std::to_string(taus[k / states.size()]) + ":" + text;
      std::cout << name << '\n';
      EXPECT_LE(most - least, 2u) << name;
      EXPECT_LE(most, 12u) << name;
    }
}
