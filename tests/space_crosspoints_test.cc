// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/mortar/crosspoints.h>

#include <algorithm>
#include <cmath>

#include "serial_matrices.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  constexpr types::boundary_id left_side = 0, right_side = 1;

  /** Two bodies side by side on a third one, with a fault between the two that
   * ends at the fault below them. */
  template <int dim>
  struct Junction
  {
    FaultTopology           topology;
    MeshLevel<dim>          level;
    std::vector<FaultSides> sides;

    explicit Junction(const std::array<unsigned int, 3> &n_cells)
      : topology({"under", "left", "right"},
                 {{"main",
                   {{{{0, BodyMesh<dim>::upper_side}},
                     {{1, BodyMesh<dim>::lower_side},
                      {2, BodyMesh<dim>::lower_side}}}}},
                  {"branch", {{{{1, right_side}}, {{2, left_side}}}}}})
    {
      const std::array<std::array<double, 3>, 3> places = {
        {{{-2.5, 2.5, 0.}}, {{-2.5, 0.5, 1.}}, {{0.5, 2.5, 1.}}}};
      BodyMeshes<dim>          bodies;
      std::vector<NodeNumbers> numbers;
      for (unsigned int b = 0; b < 3; ++b)
        {
          std::array<unsigned int, dim> cells;
          cells.fill(n_cells[b]);
          BodyGeometry<dim> body = make_body<dim>(1., cells, 1);
          body.lateral_lower[0]  = places[b][0];
          body.lateral_upper[0]  = places[b][1];
          body.base              = places[b][2];
          bodies.push_back(
            std::make_shared<BodyMesh<dim>>(body, topology.sides_at_faults(b)));
          numbers.push_back(number_whole_mesh(
            std::vector<unsigned int>(bodies.back()->dof_handler().n_dofs(), 0),
            1));
        }
      level = MeshLevel<dim>(bodies, topology, numbers, MPI_COMM_SELF);
      for (const unsigned int f : {0, 1})
        sides.push_back(choose_fault_sides(level, topology, f));
    }
  };



  template <int dim>
  Point<dim>
  point_of(const MeshLevel<dim> &level, const types::global_dof_index node)
  {
    Point<dim> result;
    for_each_node(level,
                  [&](const unsigned int,
                      const unsigned int,
                      const unsigned int local,
                      const Point<dim>  &x,
                      const bool) {
                    if (local == node)
                      result = x;
                  });
    return result;
  }



  /** A linear displacement has no jumps, and its stresses are in equilibrium at
   * all nodes that are not on the outer sides: those of the bodies, those of
   * the masters, and the nodes at the junction, which have no jumps. */
  template <int dim>
  void
  expect_patch_test(const std::array<unsigned int, 3> &n_cells)
  {
    const Junction<dim>   junction(n_cells);
    const MeshLevel<dim> &level = junction.level;
    // The side that goes through is the master whatever the meshes are.
    EXPECT_TRUE(junction.sides[0].slave_is_second());

    const JumpBasis<dim> basis =
      undeformed_basis(level,
                       junction.sides,
                       NodeMask(level.n_nodes(), dim),
                       Tensor<1, dim>(Point<dim>::unit_vector(1)));
    for (const auto node : crosspoints(level, 2))
      {
        const Point<dim> x = point_of(level, node);
        EXPECT_EQ(x[0], 0.5);
        EXPECT_EQ(x[dim - 1], 1.);
        EXPECT_FALSE(std::binary_search(basis.contact_nodes().begin(),
                                        basis.contact_nodes().end(),
                                        node));
      }
    EXPECT_EQ(crosspoints(level, 1).size(), 0u);
    for (const FaultContact<dim> &contact : basis.faults())
      EXPECT_EQ(contact.coupling.lost_area, 0.);

    // Only the fault between the two bodies is not level.
    const NodeFrames<dim> frames = basis.frames();
    const auto           &branch = basis.faults()[1];
    EXPECT_EQ(frames.size(),
              std::count(branch.coupling.active.begin(),
                         branch.coupling.active.end(),
                         true));
    for (const auto &[node, axes] : frames)
      {
        EXPECT_EQ(point_of(level, node)[0], 0.5);
        EXPECT_EQ(axes[0][dim - 1], 1.);
      }

    NodalVector u =
      interpolate(level, [](const unsigned int, const Point<dim> &x) {
        Tensor<1, dim> value;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            value[c] += std::cos(1. + 2. * c + 3. * d) * x[d];
        return value;
      });
    NodalVector w = level.nodes.make_vector();
    to_jumps_matrix(basis, level.n_nodes()).prolongate(w, u, dim);
    for (const auto p : basis.contact_nodes())
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_NEAR(w.local_element(p * dim + c), 0., 1e-12);

    const Material material;
    const auto     matrices =
      assemble_elastic_matrices<dim>(level,
                                     {material, material, material},
                                     false);
    NodalVector forces = level.nodes.make_vector(), dual = forces;
    matrices.stiffness.vmult(forces, u);
    to_nodal_matrix(basis, level.n_nodes()).restrict_to(dual, forces, dim);
    unsigned int n_checked = 0;
    for_each_node(level,
                  [&](const unsigned int,
                      const unsigned int,
                      const unsigned int node,
                      const Point<dim>  &x,
                      const bool) {
                    if (std::abs(x[0] - 0.5) > 1.1 ||
                        std::abs(x[dim - 1] - 1.) > 0.45 ||
                        (dim == 3 && std::abs(x[1]) > 1.) ||
                        std::binary_search(basis.contact_nodes().begin(),
                                           basis.contact_nodes().end(),
                                           node))
                      return;
                    ++n_checked;
                    for (unsigned int c = 0; c < dim; ++c)
                      EXPECT_NEAR(dual.local_element(node * dim + c),
                                  0.,
                                  1e-12 * forces.linfty_norm())
                        << x;
                  });
    EXPECT_GT(n_checked, 20u);
  }
} // namespace



TEST(Crosspoint, PatchTestAtAJunction)
{
  expect_patch_test<2>({{7, 4, 3}});
  expect_patch_test<2>({{3, 5, 8}});
}



TEST(Crosspoint, PatchTestAtAJunctionInThreeDimensions)
{
  expect_patch_test<3>({{4, 3, 2}});
}
