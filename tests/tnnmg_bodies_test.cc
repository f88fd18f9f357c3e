// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <algorithm>

#include "iteration_counts.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const NamedStates states = stuck_and_slipping(0.);



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



  /** Forces that set the bodies in motion. */
  struct Load
  {
    /** Pa; of uniform shear at first, and on all faults. */
    double shear_stress, normal_stress;
    /** In x, at the top: the velocity, m/s, or the traction, Pa. */
    BoundaryType type;
    std::string  value;
  };



  /**
   * Iterations from zero for a Newmark step, in the order of the step sizes and
   * states.
   */
  std::vector<unsigned int>
  iterations(const std::vector<BodyGeometry<2>> &bodies,
             const Load                         &load,
             const std::vector<double>          &taus)
  {
    constexpr double   loading_rate = 2e-4;
    const unsigned int n_bodies     = bodies.size();
    const double       height   = bodies.back().base + bodies.back().thickness;
    const Material     material = Material();
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
    top.type          = {{load.type, BoundaryType::free}};
    top.expression[0] = load.value;
    BoundaryValues<2> boundary(meshes, {bottom, top}, names);
    SpatialProblem<2> problem(meshes,
                              std::vector<MaterialFields>(n_bodies, material),
                              boundary,
                              Tensor<1, 2>());

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
              load.shear_stress / material.shear_modulus() * points[i][1];
            state.velocity.local_element(x) =
              loading_rate * points[i][1] / height;
          }
      }

    return iterations_from_zero(
      problem,
      boundary,
      state,
      load.normal_stress,
      [](const Point<2> &x) { return x[0]; },
      states,
      taus);
  }
} // namespace



TEST(TNNMG, IterationsDoNotGrowWithTheNumberOfBodies)
{
  const std::vector<double>              taus = {1e-5, 1e-3, 1e-2, 1e-1};
  std::vector<std::vector<unsigned int>> counts;
  for (const unsigned int n_bodies : {2, 3, 5, 9, 17, 33})
    counts.push_back(iterations(layers(n_bodies),
                                {2.5e4, 4.9e4, BoundaryType::velocity, "2e-4"},
                                taus));
  expect_alike(counts, states, taus);
}



TEST(TNNMG, AThinLayerMayFlyOff)
{
  // On top lie 0.09 m whose weight is a tenth of what pulls at them. Newton's
  // method for the logarithm of the slip rate then goes far too fast, and back
  // beyond zero; it took 17 or 18 iterations here, 30 on finer meshes.
  const std::vector<BodyGeometry<2>> bodies =
    stack<2>({make_body<2>(1., {{10, 2}}, 4),
              make_body<2>(0.3, {{16, 1}}, 3),
              make_body<2>(0.09, {{55, 1}}, 2)});
  const std::vector<unsigned int> counts =
    iterations(halved<2>(bodies, 2),
               {0., 2.3e3, BoundaryType::traction, "2.8e4"},
               {1e-3, 1e-2, 1e-1});
  for (unsigned int k = 0; k < counts.size(); ++k)
    {
      std::cout << states[k % states.size()].first << ": " << counts[k] << '\n';
      EXPECT_LE(counts[k], 15u);
    }
}
