// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/halving_error.h>
#include <stickslip/mechanics/strain_energy.h>
#include <stickslip/mesh/refined_cells.h>
#include <stickslip/scene/members_of.h>
#include <stickslip/scene/mesh_estimate.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/mesh_adaptation.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/simulation/test_displacements.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "error_message.h"
#include "project_directories.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double no_limit = std::numeric_limits<double>::max();



  template <int dim>
  SceneParameters<dim>
  read_scene(const std::string &text)
  {
    const TemporaryFolder folder;
    return SceneReader(folder.write("scene.prm", text), {}).read<dim>();
  }



  /** Two blocks that are sheared along the first of the axes, along all of
   * which the bottom is held, with more entries for both. */
  std::string
  two_blocks(const std::string &of_body,
             const std::string &rest,
             const std::string &axes = "xy")
  {
    std::string text = "subsection Bodies\n set Names = lower, upper\n";
    for (const std::string body : {"lower", "upper"})
      text += " subsection " + body + "\n" + of_body + " end\n";
    text += "end\nsubsection Faults\n set Names = fault\nend\n"
            "subsection Boundary conditions\n"
            " set Sides = lower bottom, upper top\n"
            " subsection lower bottom\n";
    for (const char axis : axes)
      text += std::string("  set ") + axis + " condition = fixed\n";
    const std::string driven(1, axes[0]);
    return text + " end\n subsection upper top\n  set " + driven +
           " condition = velocity\n  set " + driven +
           " value = 2e-4\n end\nend\n" + rest;
  }



  std::string
  refinements(const unsigned int uniform)
  {
    return "  set Uniform refinements = " + std::to_string(uniform) +
           "\n  set Refinement passes = 0\n";
  }



  /** The displacements of a scene on its mesh. */
  template <int dim, int n_components = dim>
  struct Solved
  {
    Simulation<dim, n_components> simulation;
    std::vector<TestDisplacement> displacements;

    explicit Solved(const SceneParameters<dim>          &scene,
                    const std::vector<SlipPattern<dim>> &patterns = {})
      : simulation(scene, MPI_COMM_SELF)
      , displacements(test_displacements(simulation.spatial_problem(),
                                         scene.time.end_time,
                                         patterns))
    {}

    const MeshLevel<dim> &
    level() const
    {
      return simulation.meshes().finest();
    }

    /** Half of u K u, with the matrix of the program. */
    double
    energy_of_matrix(const unsigned int i)
    {
      auto       &problem = simulation.spatial_problem();
      NodalVector w = problem.make_vector(), Kw = w, zero = w;
      problem.to_jumps(w, displacements[i].values);
      problem.term(SpatialProblem<dim, n_components>::stiffness)
        .residual(Kw, zero, w);
      return -0.5 * (w * Kw);
    }

    /** The sum of the energies of all cells. */
    double
    energy_of_cells(const unsigned int                 i,
                    const std::vector<MaterialFields> &materials)
    {
      StrainEnergy<dim, n_components> energy(level(), materials);
      double                          sum = 0.;
      for (unsigned int b = 0; b < level().bodies.size(); ++b)
        level().bodies[b]->patches().for_each(
          level().bodies[b]->dof_handler(), [&](const auto &cells) {
            std::vector<std::vector<Tensor<1, n_components>>> values;
            for (const auto &cell : cells)
              {
                values.emplace_back(cell->n_vertices());
                for (const auto v : cell->vertex_indices())
                  for (const auto &[node, weight] :
                       level().resolve(b, cell->vertex_dof_index(v, 0)))
                    for (unsigned int c = 0; c < n_components; ++c)
                      values.back()[v][c] +=
                        weight *
                        displacements[i].values.local_element(
                          level().nodes.local_index(node) * n_components + c);
              }
            sum += energy(b, {cells.begin(), cells.end()}, values);
          });
      return sum;
    }
  };



  template <int dim, int n_components = dim>
  void
  expect_energy_of_cells(const std::string &text)
  {
    const SceneParameters<dim> scene = read_scene<dim>(text);
    Solved<dim, n_components>  solved(scene);
    ASSERT_FALSE(solved.displacements.empty());
    for (unsigned int i = 0; i < solved.displacements.size(); ++i)
      {
        const double expected = solved.energy_of_matrix(i);
        EXPECT_GT(expected, 0.);
        EXPECT_NEAR(solved.energy_of_cells(
                      i,
                      members_of(scene.bodies, &BodyParameters<dim>::material)),
                    expected,
                    1e-10 * expected);
      }
  }
} // namespace



TEST(AdaptiveMeshes, EnergiesOfCellsAddUpToThatOfTheMatrix)
{
  const std::string hanging  = "  set Refinement passes = 1\n",
                    material = " subsection Material\n"
                               "  set Poisson ratio = 0.4\n"
                               "  set Young modulus = 4e7*(1 + 0.1*x)\n"
                               "  set Volumetric strain = patch mean\n end\n";
  expect_energy_of_cells<2>(two_blocks(hanging, ""));
  expect_energy_of_cells<2>(two_blocks(hanging + material, ""));
  expect_energy_of_cells<2, 1>(
    two_blocks(hanging,
               "set Deformation = antiplane\n"
               "subsection Faults\n subsection fault\n"
               "  set Normal stress = function\n"
               "  set Normal stress function = 1e5\n end\nend\n"
               "subsection Gravity\n set Acceleration = 0\nend\n",
               "z"));
  expect_energy_of_cells<3>(
    "set Dimension = 3\n" +
    two_blocks("  set Coarse cells = 3, 3, 1\n" + refinements(0), "", "xyz"));
}



/** With driven sides alone, the solution on nested spaces has the least energy
 * of all, and the energy of the difference is the difference of the energies.
 */
TEST(AdaptiveMeshes, ErrorIsTheDifferenceOfEnergies)
{
  const std::string weightless =
    "subsection Gravity\n set Acceleration = 0\nend\n";
  const SceneParameters<2> scene = read_scene<2>(
                             two_blocks(refinements(1), weightless)),
                           halved = read_scene<2>(
                             two_blocks(refinements(2), weightless));
  Solved<2>          coarse(scene), fine(halved);
  const HalvingError error =
    halving_error(coarse.level(),
                  coarse.displacements[0].values,
                  fine.level(),
                  fine.displacements[0].values,
                  members_of(scene.bodies, &BodyParameters<2>::material));
  const double on_coarse = coarse.energy_of_matrix(0),
               on_fine   = fine.energy_of_matrix(0);
  EXPECT_NEAR(error.energy, on_fine, 1e-9 * on_fine);
  EXPECT_GT(error.sum, 1e-4 * on_fine);
  EXPECT_NEAR(error.sum, on_coarse - on_fine, 1e-9 * on_fine);
}



/** The energy of loading of a spring slider on meshes of its accuracy, beside
 * that on a mesh which is far better: the estimated error is the true one
 * within 40 %, and that falls with the number of nodes as it does for smooth
 * solutions, although there are corners between held and free sides. */
TEST(AdaptiveMeshes, EstimatedErrorIsTheTrueOne)
{
  const auto adapted = [](const double accuracy) {
    SceneParameters<2> scene =
      SceneReader(STICKSLIP_SOURCE_DIR "/parameters/spring_slider.prm",
                  {"Bodies/lower/Refinement passes=0",
                   "Bodies/upper/Refinement passes=0",
                   "Mesh/Accuracy=" + std::to_string(accuracy)})
        .read<2>();
    std::ostringstream report;
    adapt_meshes(scene, no_limit, report);
    // The number behind "loading".
    const std::string text  = report.str();
    const std::size_t place = text.find("loading ");
    EXPECT_NE(place, std::string::npos) << text;
    return std::make_pair(scene, std::stod(text.substr(place + 8)));
  };
  const auto [scene, estimate]    = adapted(1e-2);
  const auto [better, of_better]  = adapted(2.5e-3);
  const auto [reference, ignored] = adapted(4e-4);
  const unsigned int loading      = 1;
  Solved<2>          solved(scene), solved_better(better), exact(reference);
  const double       energy = exact.energy_of_matrix(loading);
  const auto         error  = [&](Solved<2> &of) {
    return of.energy_of_matrix(loading) / energy - 1.;
  };
  EXPECT_LT(estimate, 1e-2);
  EXPECT_LT(of_better, 2.5e-3);
  EXPECT_LT(error(solved), 1.2 * estimate);
  EXPECT_GT(error(solved), 0.6 * estimate);
  EXPECT_LT(error(solved_better), 1.2 * of_better);
  EXPECT_GT(error(solved_better), 0.6 * of_better);
  const double nodes_ratio =
    double(solved_better.level().n_nodes()) / solved.level().n_nodes();
  EXPECT_LT(nodes_ratio, 1.2 * error(solved) / error(solved_better));

  // Far fewer nodes than a uniform mesh takes for the same.
  const MeshEstimate counted = estimate_meshes(scene);
  EXPECT_EQ(counted.nodes, solved.level().n_nodes());
  EXPECT_EQ(counted.levels, solved.simulation.meshes().n_levels());
}



/** Bodies without mass and viscosity, sheared as a whole: what a start has made
 * of its problem is not in the first estimate. */
TEST(AdaptiveMeshes, AStartLeavesNothingInTheEstimate)
{
  SceneParameters<2> scene =
    SceneReader(STICKSLIP_SOURCE_DIR "/parameters/first_on_earth.prm",
                {"Bodies/footwall/Refinement passes=0",
                 "Bodies/hanging_wall/Refinement passes=0",
                 "Mesh/Accuracy=0.2"})
      .read<2>();
  std::ostringstream report;
  adapt_meshes(scene, no_limit, report);
  const std::string text  = report.str();
  const std::size_t place = text.find("loading ");
  EXPECT_NE(text.find("1 round "), std::string::npos) << text;
  ASSERT_NE(place, std::string::npos) << text;
  EXPECT_LT(std::stod(text.substr(place + 8)), 0.02) << text;
}



/** Bodies without weight do not move at the start: no error is told of that. */
TEST(AdaptiveMeshes, LoadsThatMoveNothingHaveNoError)
{
  SceneParameters<2> scene =
    SceneReader(STICKSLIP_SOURCE_DIR "/parameters/thrust_sequence.prm",
                {"Mesh/Accuracy=0.99"})
      .read<2>();
  std::ostringstream report;
  adapt_meshes(scene, no_limit, report);
  const std::string text = report.str();
  EXPECT_EQ(text.find("nan"), std::string::npos) << text;
  EXPECT_EQ(text.find("loads at the start"), std::string::npos) << text;
  EXPECT_NE(text.find("loading"), std::string::npos) << text;
}



/** A patch that weakens in bodies without ends: hardly more cells
 * and the same error beside the joint as in the middle. */
TEST(AdaptiveMeshes, BodiesWithoutEndsHaveNoPlaces)
{
  const auto adapted = [](const double centre) {
    const std::string  x     = std::to_string(centre);
    SceneParameters<2> scene = read_scene<2>(two_blocks(
      "  set Coarse cells = 20, 2\n  set Refinement passes = 0\n",
      "subsection Faults\n subsection fault\n  set a = 0.02\n  set b = 0.01\n"
      "  subsection Regions\n   set Names = patch\n   subsection patch\n"
      "    set Where = 0.5 - abs(x - " +
        x +
        ")\n    set b = 0.03\n   end\n  end\n end\nend\n"
        "subsection Boundary conditions\n set Periodic along x = true\nend\n"
        "subsection Mesh\n set Accuracy = 0.03\nend\n"));
    std::ostringstream report;
    adapt_meshes(scene, no_limit, report);
    const Simulation<2> simulation(scene, MPI_COMM_SELF);
    const std::string   text  = report.str();
    const std::size_t   place = text.find("slip of fault ");
    EXPECT_NE(place, std::string::npos) << text;
    unsigned int n_cells = 0;
    for (const auto &body : simulation.meshes().finest().bodies)
      n_cells += body->triangulation().n_active_cells();
    return std::make_pair(n_cells, std::stod(text.substr(place + 14)));
  };
  const auto middle = adapted(0.), right = adapted(1.75), left = adapted(-1.75);
  EXPECT_GT(middle.first, 400u);
  // Cells on both sides of the joint are refined if one is.
  EXPECT_GE(right.first, middle.first);
  EXPECT_LT(right.first, 1.03 * middle.first);
  EXPECT_EQ(left.first, right.first);
  EXPECT_NEAR(right.second, middle.second, 0.02 * middle.second);
  EXPECT_NEAR(left.second, right.second, 1e-6 * right.second);
}



TEST(AdaptiveMeshes, AMeshIsWrittenAndReadAgain)
{
  const TemporaryFolder folder;
  const std::string     text = two_blocks("",
                                      "subsection Mesh\n set Accuracy = 0.05\n"
                                          "end\nsubsection Time\n"
                                          " set End time = 0.01\nend\n"
                                          "subsection Output\n"
                                          " set Output directory = " +
                                        folder.file("run") + "\nend\n");
  SceneParameters<2>    scene =
    SceneReader(folder.write("scene.prm", text), {}).read<2>();
  ASSERT_TRUE(scene.mesh_accuracy.is_wanted());
  std::ostringstream report;
  adapt_meshes(scene, no_limit, report);
  ASSERT_FALSE(scene.mesh_accuracy.is_wanted());
  Simulation<2> simulation(scene, MPI_COMM_SELF);
  ASSERT_TRUE(simulation.run());

  const SceneParameters<2> again =
    SceneReader(folder.file("run/parameters.prm"), {}).read<2>();
  EXPECT_FALSE(again.mesh_accuracy.is_wanted());
  EXPECT_EQ(again.mesh_accuracy.refined_cells,
            scene.mesh_accuracy.refined_cells);
  const Simulation<2> repeated(again, MPI_COMM_SELF);
  EXPECT_EQ(repeated.meshes().finest().n_nodes(),
            simulation.meshes().finest().n_nodes());

  for (const std::string line : {"middle 0_0:",
                                 "lower 0_1:",
                                 "lower 0_1:03",
                                 "lower 0_1:8",
                                 "lower",
                                 "lower 0_0: 3",
                                 "lower -1_0:"})
    expect_one_sentence_with(message_of([&]() {
                               read_refined_cells(folder.write("cells.txt",
                                                               line + "\n"),
                                                  {"lower", "upper"});
                             }),
                             {"cells.txt", "line 1"});
  expect_one_sentence_with(message_of([&]() {
                             read_refined_cells(folder.file("none.txt"),
                                                {"lower"});
                           }),
                           {"none.txt", "cannot be read"});
}



TEST(AdaptiveMeshes, MoreMemoryThanThereIsIsRefused)
{
  SceneParameters<2> scene = read_scene<2>(
    two_blocks("", "subsection Mesh\n set Accuracy = 1e-6\nend\n"));
  std::ostringstream report;
  expect_one_sentence_with(message_of([&]() {
                             adapt_meshes(scene, 250. * 1048576., report);
                           }),
                           {"'Mesh/Accuracy'", "memory"});
}
