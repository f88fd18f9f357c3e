// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "parallel_comparison.h"
#include "sliding_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // The bodies on all processes and on one. Coarse levels are shared as far as
  // a small number of nodes allows.
  template <int dim>
  struct Pair
  {
    SpatialScene<dim> shared, alone;

    explicit Pair(const std::vector<BodyGeometry<dim>> &bodies,
                  const unsigned int                    min_nodes_per_process)
      : shared(make(bodies, MPI_COMM_WORLD, min_nodes_per_process))
      , alone(make(bodies, MPI_COMM_SELF, min_nodes_per_process))
    {}

    static SpatialScene<dim>
    make(const std::vector<BodyGeometry<dim>> &bodies,
         const MPI_Comm                        communicator,
         const unsigned int                    min_nodes_per_process)
    {
      std::vector<Material> materials(bodies.size());
      for (unsigned int i = 0; i < materials.size(); ++i)
        materials[i].youngs_modulus *= 1. + i;
      std::array<BoundaryType, dim> fixed;
      fixed.fill(BoundaryType::fixed);
      BoundaryCondition<dim> pull =
        make_side<dim>(std::to_string(bodies.size() - 1),
                       BodyMesh<dim>::upper_side,
                       {{BoundaryType::traction}},
                       {{"1e3 * (1 + x)"}});
      pull.type[dim - 1] = BoundaryType::free;
      return SpatialScene<dim>(
        bodies,
        {make_side<dim>("0", BodyMesh<dim>::lower_side, fixed), pull},
        materials,
        9.81,
        communicator,
        min_nodes_per_process);
    }

    void
    expect_equal_matrices() const
    {
      const auto &ours = shared.problem.hierarchy();
      const auto &one  = alone.problem.hierarchy();
      ASSERT_EQ(ours.n_levels(), one.n_levels());
      for (unsigned int l = 0; l < ours.n_levels(); ++l)
        EXPECT_LT(difference(ours.level_matrix(l),
                             ours.description(l).nodes,
                             one.level_matrix(l),
                             numbers_on_one(shared.meshes.level(l))),
                  1e-12)
          << "level " << l << " of " << ours.n_levels();
    }
  };



  template <int dim>
  BodyGeometry<dim>
  uniform(const std::array<unsigned int, dim> &coarse_cells,
          const unsigned int                   refinements)
  {
    BodyGeometry<dim> body   = make_body<dim>(1., coarse_cells, 0);
    body.uniform_refinements = refinements;
    return body;
  }



  template <int dim>
  void
  expect_equal_problems(const std::vector<BodyGeometry<dim>> &bodies,
                        const unsigned int min_nodes_per_process)
  {
    Pair<dim>  pair(bodies, min_nodes_per_process);
    const auto numbers = numbers_on_one(pair.shared.meshes.finest());
    const auto compare = [&](const std::string &what) {
      SCOPED_TRACE(what);
      const auto &ours = pair.shared.problem.hierarchy();
      const auto &one  = pair.alone.problem.hierarchy();
      for (unsigned int term = 0; term < 3; ++term)
        EXPECT_LT(difference(ours.operators().terms()[term],
                             ours.finest().nodes,
                             one.operators().terms()[term],
                             numbers),
                  1e-12)
          << "term " << term;
      EXPECT_LT(difference(pair.shared.problem.load(3.),
                           ours.finest().nodes,
                           pair.alone.problem.load(3.),
                           numbers),
                1e-12);
      combine_without_friction(pair.shared);
      combine_without_friction(pair.alone);
      pair.expect_equal_matrices();
      linearise_along_faults(pair.shared);
      linearise_along_faults(pair.alone);
      pair.expect_equal_matrices();
    };
    compare("as built");
    // Partners on the other side now belong to other processes, and the ends
    // are off contact.
    slide(pair.shared, 0.7);
    slide(pair.alone, 0.7);
    compare("slid by 0.7 m");
  }
} // namespace



TEST(ParallelMatrices, EqualThoseOfOneProcessInTwoDimensions)
{
  for (const unsigned int min_nodes_per_process : {1, 500})
    {
      expect_equal_problems<2>(spring_slider_bodies(), min_nodes_per_process);
      expect_equal_problems<2>(layered_bodies(), min_nodes_per_process);
      expect_equal_problems<2>(nonmatching_bodies(), min_nodes_per_process);
    }
}



/** Cells of one size, which no process has all of if few are divided. */
TEST(ParallelMatrices, OfSharesInUniformMeshesEqualThoseOfOneProcess)
{
  expect_equal_problems<2>(
    stack<2>({uniform<2>({{5, 1}}, 4), make_body<2>(0.3, {{55, 3}}, 1)}), 1);
  expect_equal_problems<2>(
    stack<2>({uniform<2>({{5, 1}}, 4), uniform<2>({{7, 1}}, 3)}), 1);
  expect_equal_problems<3>(
    stack<3>({uniform<3>({{2, 2, 1}}, 2), uniform<3>({{3, 3, 1}}, 2)}), 1);
}



TEST(ParallelMatrices, EqualThoseOfOneProcessInThreeDimensions)
{
  expect_equal_problems<3>(nonmatching_blocks(), 1);
}



TEST(ParallelMatrices, EveryProcessOwnsAPartOfEachSharedLevel)
{
  const MeshHierarchy<2> meshes(layered_bodies(), MPI_COMM_WORLD, 1);
  for (unsigned int l = 0; l < meshes.n_levels(); ++l)
    {
      const NodePartition &nodes = meshes.level(l).nodes;
      const auto least = Utilities::MPI::min(nodes.n_owned(), MPI_COMM_WORLD);
      const auto most  = Utilities::MPI::max(nodes.n_owned(), MPI_COMM_WORLD);
      EXPECT_EQ(Utilities::MPI::sum(nodes.n_owned(), MPI_COMM_WORLD),
                nodes.n_global());
      if (l == 0)
        {
          EXPECT_EQ(most, nodes.n_global());
        }
      else if (l + 1 == meshes.n_levels())
        {
          EXPECT_GT(least, 0.9 * nodes.n_global() / n_processes());
          EXPECT_LT(most, 1.1 * nodes.n_global() / n_processes());
        }
      else
        {
          EXPECT_GT(least, 0u);
        }
    }
}



TEST(ParallelMatrices, FewNodesAreGatheredOnFewerProcesses)
{
  // 4,057 nodes on the finest level.
  const MeshHierarchy<2> meshes(layered_bodies(), MPI_COMM_WORLD, 500);
  for (unsigned int l = 0; l + 1 < meshes.n_levels(); ++l)
    {
      const NodePartition &nodes = meshes.level(l).nodes;
      const unsigned int   n_sharing =
        Utilities::MPI::sum(nodes.n_owned() > 0 ? 1u : 0u, MPI_COMM_WORLD);
      EXPECT_LE(n_sharing, std::max<unsigned int>(1, nodes.n_global() / 500));
    }
}
