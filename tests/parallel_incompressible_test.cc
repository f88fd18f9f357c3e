// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>

#include <cmath>
#include <iostream>

#include "linear_iterations.h"
#include "random_vectors.h"
#include "stuck_faults.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies whose volumetric strains are means over patches. */
  SpatialScene<2>
  make_scene(const double poissons_ratio, const MPI_Comm communicator)
  {
    Material material;
    material.poissons_ratio    = poissons_ratio;
    material.volumetric_strain = VolumetricStrain::patch_mean;
    return SpatialScene<2>(
      stack<2>(
        {make_body<2>(1., {{10, 2}}, 4), make_body<2>(1., {{10, 2}}, 4)}),
      {make_side<2>("0",
                    BodyMesh<2>::lower_side,
                    {{BoundaryType::fixed, BoundaryType::fixed}}),
       make_side<2>("1",
                    BodyMesh<2>::upper_side,
                    {{BoundaryType::fixed, BoundaryType::free}})},
      {material, material},
      0.,
      communicator,
      1);
  }



  /** Steps of conjugate gradients for two operators, the fault not stuck. */
  std::vector<unsigned int>
  steps(const double poissons_ratio, const MPI_Comm communicator)
  {
    SpatialScene<2>           scene = make_scene(poissons_ratio, communicator);
    LevelHierarchy<2>        &hierarchy = scene.problem.hierarchy();
    std::vector<unsigned int> result;
    for (const std::vector<double> &coefficients :
         {std::vector<double>{0., 0., 1.},
          Newmark<2>().operator_coefficients(1e-3)})
      {
        scene.problem.combine(coefficients);
        const LevelDescription<2> &finest = hierarchy.finest();
        linearise_without_friction(hierarchy, finest.fixed);
        NodalVector b = finest.nodes.make_vector();
        for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
          for (unsigned int c = 0; c < 2; ++c)
            b.local_element(2 * i + c) =
              std::sin(1e3 * (2. * finest.nodes.global_index(i) + c));
        finest.fixed.apply(b);
        result.push_back(cg_iterations(hierarchy, b));
      }
    return result;
  }
} // namespace



TEST(ParallelIncompressible, StepsAreThoseOfOneProcess)
{
  // Node by node 0.49 takes 42 and 49 steps on one process; with patches that
  // end where the nodes of a process do up to 34.
  for (const double nu : {0.3, 0.49, 0.4999})
    {
      const std::vector<unsigned int> alone  = steps(nu, MPI_COMM_SELF);
      const std::vector<unsigned int> shared = steps(nu, MPI_COMM_WORLD);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "nu = " << nu << ": " << alone[0] << ", " << alone[1]
                  << "; shared " << shared[0] << ", " << shared[1] << std::endl;
      for (unsigned int k = 0; k < alone.size(); ++k)
        {
          EXPECT_LE(alone[k], 14u) << nu << ' ' << k;
          EXPECT_LE(shared[k], alone[k] + 1) << nu << ' ' << k;
        }
    }
}



TEST(ParallelIncompressible, CyclesAreSymmetric)
{
  for (const double nu : {0.49, 0.4999})
    {
      SpatialScene<2>    scene     = make_scene(nu, MPI_COMM_WORLD);
      LevelHierarchy<2> &hierarchy = scene.problem.hierarchy();
      hierarchy.set_cycle_precision(CyclePrecision::double_precision);
      scene.problem.combine({0., 0., 1.});
      for (const double probability : {0., 0.5, 1.})
        {
          std::mt19937   engine(5 +
                              Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
          const NodeMask active =
            random_truncation(hierarchy.finest(), probability, engine);
          linearise_without_friction(hierarchy, active);
          for (const unsigned int sweeps : {1, 2})
            {
              hierarchy.set_smoothing_sweeps(sweeps);
              expect_symmetric_cycle(hierarchy, active, 1e-10);
            }
          hierarchy.set_smoothing_sweeps(1);
          EXPECT_LE(cg_iterations(hierarchy,
                                  random_vector(hierarchy.finest(), active, 7)),
                    20u)
            << nu << ' ' << probability;
        }
    }
}



TEST(ParallelIncompressible, PatchesAreWholeWhereverProcessesCutThem)
{
  // The size of the forces of a displacement that changes volumes, and its
  // energy.
  const auto forces = [](const MPI_Comm communicator) {
    SpatialScene<2>     scene = make_scene(0.499, communicator);
    const MeshLevel<2> &level = scene.meshes.finest();
    NodalVector         u     = scene.problem.make_nodal_vector();
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const std::vector<Point<2>> points = level.bodies[b]->node_positions();
        for (unsigned int dof = 0; dof < points.size(); ++dof)
          if (level.nodes.owned().is_element(level.global_node(b, dof)) &&
              !level.bodies[b]->bound_nodes().is_constrained(dof))
            {
              const double x = points[dof][0], y = points[dof][1];
              u.local_element(2 * level.node(b, dof)) = std::sin(3. * x + b);
              u.local_element(2 * level.node(b, dof) + 1) =
                x * y + std::cos(5. * y);
            }
      }
    NodalVector w = scene.problem.make_vector(), Kw = w;
    scene.problem.to_jumps(w, u);
    scene.problem.term(SpatialProblem<2>::stiffness).vmult(Kw, w);
    return std::make_pair(Kw.l2_norm(), w * Kw);
  };
  const auto alone  = forces(MPI_COMM_SELF);
  const auto shared = forces(MPI_COMM_WORLD);
  EXPECT_NEAR(shared.first, alone.first, 1e-12 * alone.first);
  EXPECT_NEAR(shared.second, alone.second, 1e-12 * alone.second);
}
