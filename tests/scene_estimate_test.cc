// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/scene/scene_reader.h>

#include <array>
#include <string>

#include "box_layers.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies with the same entries. */
  template <int dim>
  std::string
  two_bodies_with(const std::string &entries)
  {
    return "set Dimension = " + std::to_string(dim) +
           "\nsubsection Bodies\n"
           "set Names = lower, upper\n"
           "subsection lower\n" +
           entries + "end\nsubsection upper\n" + entries +
           "end\nend\n"
           "subsection Faults\nset Names = fault\nend\n"
           "subsection Output\nset Event start slip rate = 1e-3\nend\n"
           "subsection Boundary conditions\nset Sides = lower bottom\n"
           "subsection lower bottom\nset x condition = fixed\n"
           "set y condition = fixed\n" +
           (dim == 3 ? "set z condition = fixed\n" : "") + "end\nend\n";
  }



  /** Compare the estimate with the meshes that are made. */
  template <int dim>
  void
  expect_counts(const std::string &scene_text,
                const double       accuracy,
                const double       accuracy_of_nodes,
                const std::string &mesh_text = "")
  {
    SCOPED_TRACE(scene_text);
    const TemporaryFolder folder;
    if (!mesh_text.empty())
      folder.write("layers.msh", mesh_text);
    const SceneParameters<dim> scene =
      SceneReader(folder.write("scene.prm", scene_text)).read<dim>();
    const MeshEstimate       estimate = estimate_meshes(scene);
    const MeshHierarchy<dim> meshes(scene.coarse_bodies(),
                                    scene.topology,
                                    MPI_COMM_WORLD);
    double                   cells = 0.;
    for (const auto &body : meshes.finest().bodies)
      cells += body->triangulation().n_active_cells();
    const double nodes = meshes.finest().n_nodes(),
                 faces = meshes.finest().surface(0, 0).faces.size();
    EXPECT_NEAR(estimate.cells, cells, accuracy * cells);
    EXPECT_NEAR(estimate.nodes, nodes, accuracy_of_nodes * nodes);
    EXPECT_NEAR(estimate.faults[0].faces, faces, accuracy * faces);
    EXPECT_EQ(estimate.levels, meshes.n_levels());
  }
} // namespace



TEST(MeshEstimate, EqualsTheMeshesOfBricks)
{
  expect_counts<2>(two_bodies_with<2>("set Refinement passes = 4\n"),
                   1e-12,
                   0.01);
  expect_counts<2>(two_bodies_with<2>("set Uniform refinements = 2\n"
                                      "set Refinement passes = 0\n"),
                   1e-12,
                   1e-12);
  expect_counts<3>(two_bodies_with<3>("set Uniform refinements = 2\n"
                                      "set Refinement passes = 0\n"),
                   1e-12,
                   1e-12);
  expect_counts<3>(two_bodies_with<3>("set Refinement passes = 2\n"), 0.1, 0.2);
}



TEST(MeshEstimate, EqualsMeshesOfTetrahedra)
{
  const std::string refined = "set Uniform refinements = 2\nend\n";
  expect_counts<3>(
    "set Dimension = 3\n"
    "subsection Bodies\nset Names = lower, upper\n"
    "set Mesh file = layers.msh\n"
    "subsection lower\n" +
      refined + "subsection upper\n" + refined +
      "end\n"
      "subsection Faults\nset Names = fault\n"
      "subsection fault\nset Between = lower, upper\n"
      "set Normal stress = function\n"
      "set Normal stress function = 1e4\nend\nend\n"
      "subsection Output\nset Event start slip rate = 1e-3\nend\n"
      "subsection Boundary conditions\nset Sides = lower bottom\n"
      "subsection lower bottom\nset x condition = fixed\n"
      "set y condition = fixed\nset z condition = fixed\nend\nend\n",
    1e-12,
    1e-12,
    box_layers(SolidCells::tetrahedra,
               [](const double x, const double y, const double z)
                 -> std::array<double, 3> {
                 return {{x, y, z}};
               })
      .text());
}



// Meshes that each process makes as a whole take memory for each of them.
TEST(MeshEstimate, MemoryOfManyProcesses)
{
  const auto beyond_program = [](const std::string &entries) {
    const TemporaryFolder folder;
    const MeshEstimate    estimate = estimate_meshes(
      SceneReader(folder.write("scene.prm", two_bodies_with<3>(entries)))
        .read<3>());
    EXPECT_GT(estimate.nodes, 1e6);
    std::array<double, 2> bytes;
    for (const unsigned int k : {0, 1})
      {
        const unsigned int n_processes = k == 0 ? 1 : 64;
        bytes[k] =
          estimate.memory(3, n_processes) - 175. * 1048576. * n_processes;
      }
    return bytes[1] / bytes[0];
  };
  const std::string uniform = "set Coarse cells = 10, 10, 2\n"
                              "set Uniform refinements = 5\n"
                              "set Refinement passes = 0\n";
  const std::string rows    = "set Coarse cells = 20, 20, 4\n"
                              "set Refinement passes = 5\n"
                              "set Refinement rows = 2\n";
  EXPECT_LT(beyond_program(uniform), 2.);
  EXPECT_GT(beyond_program(rows), 6.);
}



TEST(MeshEstimate, CountsWherePassesRefine)
{
  const std::string some = "set Refinement passes = 8\n"
                           "set Refine where = 0.3 - x\n";
  expect_counts<2>(two_bodies_with<2>(some), 0.2, 0.2);
  // Cells that double with the distance from a small part of the fault.
  const std::string graded = "set Lower lateral corner = 0\n"
                             "set Upper lateral corner = 6553.6e3\n"
                             "set Thickness = 6553.6e3\n"
                             "set Coarse cells = 4, 4\n"
                             "set Refine where = 43e3 - x\n"
                             "set Refinement passes = 12\n";
  expect_counts<2>(two_bodies_with<2>(graded), 0.3, 0.3);
  expect_counts<2>(two_bodies_with<2>(graded + "set Refinement rows = 2\n"),
                   0.3,
                   0.3);
  expect_counts<3>(two_bodies_with<3>("set Refinement passes = 4\n"
                                      "set Refine where = 0.2 - x\n"),
                   0.3,
                   0.3);
}
