// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/scene/scene_reader.h>

#include <cmath>
#include <sstream>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr double radius = 2.;

  /** A point of an arc of 60 degrees about the origin. */
  Point<2>
  on_arc(const double part)
  {
    const double angle = numbers::PI * (5. - 2. * part) / 6.;
    return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
  }



  std::string
  text(const Point<2> &x)
  {
    std::ostringstream out;
    out.precision(17);
    out << x[0] << ' ' << x[1];
    return out.str();
  }



  /** Two blocks with an arc between them through @p n_pieces + 1 points, and so
   * many cells along it below and above. */
  template <int dim>
  MeshHierarchy<dim>
  blocks(const unsigned int                 n_pieces,
         const std::array<unsigned int, 2> &n,
         const unsigned int                 refinements)
  {
    std::string arc;
    for (unsigned int k = 1; k < n_pieces; ++k)
      arc += (k == 1 ? "" : ", ") + text(on_arc(double(k) / n_pieces));
    const std::string begin = text(on_arc(0.)), end = text(on_arc(1.)),
                      along_y = dim == 3 ? ", 2" : "",
                      refined = "    set Uniform refinements = " +
                                std::to_string(refinements) + "\n  end\n",
                      arc_text =
                        arc.empty() ? "\n" : " polyline = " + arc + "\n";
    const TemporaryFolder folder;
    const std::string     file = folder.write(
      "blocks.prm",
      "set Dimension = " + std::to_string(dim) +
        "\nsubsection Bodies\n  set Names = lower, upper\n"
            "  subsection lower\n    set Corners = -2 0, 2 0, " +
        end + ", " + begin + "\n    set Top" + arc_text +
        "    set Coarse cells = " + std::to_string(n[0]) + along_y + ", 3\n" +
        refined + "  subsection upper\n    set Corners = " + begin + ", " +
        end + ", 2 3, -2 3\n    set Bottom" + arc_text +
        "    set Coarse cells = " + std::to_string(n[1]) + along_y + ", 3\n" +
        refined +
        "end\nsubsection Faults\n  set Names = fault\n  subsection fault\n"
            "    set Between = lower top, upper bottom\n    set Shape = smooth\n"
            "  end\nend\nsubsection Output\n  set Event start slip rate = 1\nend\n"
            "subsection Boundary conditions\n  set Sides = lower bottom\n"
            "  subsection lower bottom\n    set Axes = side\n"
            "    set normal condition = fixed\n    set " +
        (dim == 2 ? "tangential condition = fixed\n" :
                        "first tangential condition = fixed\n"
                        "    set second tangential condition = fixed\n") +
        "  end\nend\n");
    const SceneParameters<dim> scene = SceneReader(file).read<dim>();
    return MeshHierarchy<dim>(scene.coarse_bodies(),
                              scene.topology,
                              MPI_COMM_WORLD);
  }



  /** The largest distance of a node of the fault from the arc, on any level. */
  template <int dim>
  double
  distance_from_arc(const MeshHierarchy<dim> &meshes)
  {
    double largest = 0.;
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      for (const unsigned int side : {0, 1})
        for (const Point<dim> &x : meshes.level(l).surface(0, side).points)
          largest =
            std::max(largest, std::abs(std::hypot(x[0], x[dim - 1]) - radius));
    return largest;
  }
} // namespace



// Vertices that divide a piece are on the curve, whatever their number: on
// chords they would be 8.6e-3 m and 2.1e-3 m off the arc.
TEST(SmoothBlocks, GoThroughThePointsOfThePolylineOnly)
{
  std::vector<double> errors;
  for (const unsigned int n_pieces : {4, 8, 16})
    {
      const std::array<unsigned int, 2> matching = {{n_pieces, n_pieces}},
                                        other    = {
                                             {3 * n_pieces, 2 * n_pieces + 1}};
      const double alone = distance_from_arc(blocks<2>(n_pieces, matching, 3)),
                   divided = distance_from_arc(blocks<2>(n_pieces, other, 2));
      std::cout << n_pieces << " pieces: " << alone << ", divided " << divided
                << '\n';
      EXPECT_LT(divided, 1.1 * alone);
      errors.push_back(divided);
    }
  // Splines are of fourth order.
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2., 3.5);
  EXPECT_LT(errors[0], 1e-3);
}



TEST(SmoothBlocks, InThreeDimensionsAreTheSame)
{
  const std::array<unsigned int, 2> n     = {{9, 6}};
  const MeshHierarchy<2>            plane = blocks<2>(4, n, 1);
  const MeshHierarchy<3>            space = blocks<3>(4, n, 1);
  EXPECT_NEAR(distance_from_arc(space), distance_from_arc(plane), 1e-14);
  for (const unsigned int side : {0, 1})
    for (const Point<3> &x : space.finest().surface(0, side).points)
      {
        double nearest = 1.;
        for (const Point<2> &p : plane.finest().surface(0, side).points)
          nearest = std::min(nearest, std::hypot(x[0] - p[0], x[2] - p[1]));
        EXPECT_LT(nearest, 1e-14);
      }
}
