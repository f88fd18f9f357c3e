// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/time/newmark.h>

#include <cmath>
#include <iostream>

#include "linear_iterations.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Steps of conjugate gradients for two operators, the fault not stuck. */
  std::vector<unsigned int>
  steps(const double poissons_ratio, const MPI_Comm communicator)
  {
    Material material;
    material.poissons_ratio    = poissons_ratio;
    material.volumetric_strain = VolumetricStrain::patch_mean;
    SpatialScene<2> scene(
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
    LevelHierarchy<2>        &hierarchy = scene.problem.hierarchy();
    std::vector<unsigned int> result;
    for (const std::vector<double> &coefficients :
         {std::vector<double>{0., 0., 1.},
          Newmark<2>().operator_coefficients(1e-3)})
      {
        scene.problem.combine(coefficients);
        const LevelDescription<2> &finest = hierarchy.finest();
        hierarchy.linearise(std::vector<Tensor<2, 2>>(
                              finest.nonsmooth_nodes.size()),
                            finest.fixed);
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



TEST(ParallelIncompressible, StepsGrowWithTheCuts)
{
  // Cells and middle nodes end where the nodes of a process do. Node by node
  // 0.49 takes 42 and 49 steps on one process, 58 to 89 on two and four.
  for (const double nu : {0.3, 0.49})
    {
      const std::vector<unsigned int> alone  = steps(nu, MPI_COMM_SELF);
      const std::vector<unsigned int> shared = steps(nu, MPI_COMM_WORLD);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << "nu = " << nu << ": " << alone[0] << ", " << alone[1]
                  << "; shared " << shared[0] << ", " << shared[1] << std::endl;
      for (unsigned int k = 0; k < alone.size(); ++k)
        {
          EXPECT_LE(alone[k], 14u) << nu << ' ' << k;
          EXPECT_LE(shared[k], nu == 0.3 ? 20u : 45u) << nu << ' ' << k;
        }
    }
}
