// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <numeric>

#include "parallel_comparison.h"
#include "sliding_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Bodies of different stiffness that stand on their ground.
  template <int dim>
  SpatialScene<dim>
  standing(const std::vector<BodyGeometry<dim>> &bodies)
  {
    std::vector<Material> materials(bodies.size());
    for (unsigned int i = 0; i < materials.size(); ++i)
      materials[i].youngs_modulus *= 1. + i;
    std::array<BoundaryType, dim> fixed;
    fixed.fill(BoundaryType::fixed);
    return SpatialScene<dim>(
      bodies,
      {make_side<dim>("0", BodyMesh<dim>::lower_side, fixed)},
      materials,
      9.81);
  }



  // The bodies with every other one placed where it has slid to.
  template <int dim>
  std::vector<BodyGeometry<dim>>
  moved(std::vector<BodyGeometry<dim>> bodies, const double distance)
  {
    for (unsigned int b = 1; b < bodies.size(); b += 2)
      {
        bodies[b].lateral_lower[0] += distance;
        bodies[b].lateral_upper[0] += distance;
      }
    return bodies;
  }



  template <int dim>
  void
  expect_equal_vectors(const SpatialProblem<dim> &ours,
                       const SpatialProblem<dim> &expected)
  {
    NodalVector nodal = expected.make_nodal_vector();
    for (unsigned int i = 0; i < nodal.locally_owned_size(); ++i)
      nodal.local_element(i) = std::cos(7. * i);
    NodalVector w = ours.make_vector(), w_expected = expected.make_vector();
    ours.to_jumps(w, nodal);
    expected.to_jumps(w_expected, nodal);
    NodalVector back = ours.make_nodal_vector();
    ours.to_nodal(back, w);
    w -= w_expected;
    EXPECT_LT(w.linfty_norm(), 1e-12 * w_expected.linfty_norm());
    back -= nodal;
    EXPECT_LT(back.linfty_norm(), 1e-12);
  }



  // A contact mapping that follows others, against the same one made first.
  template <int dim>
  void
  expect_history_leaves_no_trace(const std::vector<BodyGeometry<dim>> &bodies,
                                 const std::vector<double> &distances)
  {
    SpatialScene<dim> sliding = standing(bodies);
    // The first linearisation makes what the next ones use again.
    combine_without_friction(sliding);
    linearise_along_faults(sliding);
    std::vector<types::global_dof_index> numbers(
      sliding.meshes.finest().n_nodes());
    std::iota(numbers.begin(), numbers.end(), 0);
    for (const double distance : distances)
      {
        SCOPED_TRACE("slid by " + std::to_string(distance) + " m");
        SpatialScene<dim> placed = standing(moved(bodies, distance));
        slide(sliding, distance);
        const auto &ours     = sliding.problem.hierarchy();
        const auto &expected = placed.problem.hierarchy();
        EXPECT_EQ(ours.finest().nonsmooth_nodes,
                  expected.finest().nonsmooth_nodes);
        expect_equal_vectors(sliding.problem, placed.problem);
        for (unsigned int k = 0; k < 3; ++k)
          EXPECT_LT(difference(ours.operators().terms()[k],
                               ours.finest().nodes,
                               expected.operators().terms()[k],
                               numbers),
                    1e-12);
        const auto expect_equal_levels = [&]() {
          for (unsigned int l = 0; l < ours.n_levels(); ++l)
            EXPECT_LT(difference(ours.level_matrix(l),
                                 ours.description(l).nodes,
                                 expected.level_matrix(l),
                                 numbers),
                      1e-12)
              << "level " << l << " of " << ours.n_levels();
        };
        combine_without_friction(sliding);
        combine_without_friction(placed);
        expect_equal_levels();
        linearise_along_faults(sliding);
        linearise_along_faults(placed);
        expect_equal_levels();
      }
  }
} // namespace



TEST(SpaceSliding, HistoryLeavesNoTraceInTwoDimensions)
{
  // Partners change a little and much, meshes match and do not, ends lose
  // contact and find it again.
  const std::vector<double> distances = {0.01, 0.7, 0.72, -1.3, 0.};
  expect_history_leaves_no_trace<2>(spring_slider_bodies(), distances);
  expect_history_leaves_no_trace<2>(layered_bodies(), distances);
  expect_history_leaves_no_trace<2>(nonmatching_bodies(), distances);
}



TEST(SpaceSliding, HistoryLeavesNoTraceInThreeDimensions)
{
  expect_history_leaves_no_trace<3>(nonmatching_blocks(), {0.1, -0.3, 0.});
}
