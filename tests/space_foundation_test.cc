// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/initial_equilibrium.h>

#include <numeric>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  constexpr auto fixed = BoundaryType::fixed;



  /** A wedge whose upper side rises along x. */
  template <int dim>
  BodyGeometry<dim>
  wedge(const unsigned int refinement_passes)
  {
    std::array<unsigned int, dim> cells;
    cells.fill(6);
    cells[dim - 1]         = 1;
    BodyGeometry<dim> body = make_body<dim>(0.4, cells, refinement_passes);
    body.upper_slope[0]    = 0.15;
    if (dim == 3)
      body.upper_slope[dim - 2] = -0.05;
    return body;
  }



  /** A rigid body, larger than the wedge, with mesh settings that mean
   * nothing. */
  template <int dim>
  BodyGeometry<dim>
  foundation()
  {
    BodyGeometry<dim> body = wedge<dim>(3);
    body.upper_slope.fill(0.);
    body.rigid = true;
    body.lateral_lower.fill(-4.);
    body.lateral_upper.fill(3.);
    return body;
  }



  /** Gravity of bodies on a fault that dips by 20 degrees. */
  template <int dim>
  Tensor<1, dim>
  inclined_gravity()
  {
    Tensor<1, dim> g;
    g[0]       = 9.81 * std::sin(numbers::PI / 9.);
    g[dim - 1] = -9.81 * std::cos(numbers::PI / 9.);
    return g;
  }



  template <int dim>
  unsigned int
  n_unknowns(const SpatialProblem<dim> &problem)
  {
    const LevelDescription<dim> &finest = problem.hierarchy().finest();
    return finest.nodes.n_owned() * dim -
           finest.fixed.n_masked(finest.nodes.n_owned());
  }



  template <int dim>
  void
  expect_like_a_fixed_side()
  {
    // Cells of one size, so that the mesh is the same without a fault.
    BodyGeometry<dim> body   = wedge<dim>(0);
    body.uniform_refinements = 2;
    const std::vector<BodyGeometry<dim>> two =
      stack<dim>({foundation<dim>(), body});
    std::array<BoundaryType, dim> all_fixed;
    all_fixed.fill(fixed);
    SpatialScene<dim> founded(two,
                              {},
                              std::vector<Material>(2),
                              inclined_gravity<dim>());
    SpatialScene<dim> held(
      {two[1]},
      {make_side<dim>("0", BodyMesh<dim>::lower_side, all_fixed)},
      {Material()},
      inclined_gravity<dim>());

    const auto on_foundation    = solve_initial_equilibrium(founded.problem);
    const auto on_fixed_side    = solve_initial_equilibrium(held.problem);
    const MeshLevel<dim> &level = founded.meshes.finest();
    const MeshLevel<dim> &held_level = held.meshes.finest();
    const unsigned int    n_nodes    = held_level.n_nodes();
    ASSERT_EQ(level.n_nodes(), n_nodes + (1u << dim));
    const double largest = on_fixed_side.displacement.linfty_norm();
    EXPECT_GT(largest, 1e-5);
    for (types::global_dof_index dof = 0; dof < n_nodes; ++dof)
      for (unsigned int c = 0; c < dim; ++c)
        EXPECT_NEAR(on_foundation.displacement.local_element(
                      level.node(1, dof) * dim + c),
                    on_fixed_side.displacement.local_element(
                      held_level.node(0, dof) * dim + c),
                    1e-9 * largest);

    // The whole weight of the wedge on the fault.
    const FaultContact<dim> &contact = founded.problem.jump_basis().faults()[0];
    EXPECT_TRUE(contact.sides.slave_is_second());
    double volume = 0;
    for (const auto &cell :
         level.bodies[1]->triangulation().active_cell_iterators())
      volume += cell->measure();
    double normal = 0, shear = 0;
    for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
      {
        normal +=
          contact.coupling.weight[k] * on_foundation.contact_pressure[k];
        shear +=
          contact.coupling.weight[k] * on_foundation.shear_traction[k][0];
      }
    const double weight = Material().density * 9.81 * volume;
    EXPECT_NEAR(normal, weight * std::cos(numbers::PI / 9.), 1e-9 * weight);
    EXPECT_NEAR(std::abs(shear),
                weight * std::sin(numbers::PI / 9.),
                1e-9 * weight);

    // Unknowns that the foundation leaves free and the fixed side does not: the
    // slip of each node in contact.
    EXPECT_EQ(n_unknowns(founded.problem) - n_unknowns(held.problem),
              (dim - 1) * founded.problem.jump_basis().contact_nodes().size());
    EXPECT_EQ(level.bodies[0]->triangulation().n_active_cells(), 1u);
  }
} // namespace



TEST(Foundation, HoldsABodyLikeAFixedSide)
{
  expect_like_a_fixed_side<2>();
  expect_like_a_fixed_side<3>();
}



TEST(Foundation, HasNoMatrices)
{
  const SpatialScene<2>    scene(stack<2>({foundation<2>(), wedge<2>(1)}),
                              {},
                              std::vector<Material>(2),
                              inclined_gravity<2>());
  const MeshLevel<2>      &level = scene.meshes.finest();
  const ElasticMatrices<2> matrices =
    assemble_elastic_matrices(level, std::vector<MaterialFields>(2));
  for (types::global_dof_index dof = 0;
       dof < level.bodies[0]->dof_handler().n_dofs();
       ++dof)
    {
      // The diagonal has a place always.
      const unsigned int row      = level.node(0, dof);
      const auto        &sparsity = matrices.stiffness.sparsity();
      ASSERT_EQ(sparsity.row_start[row] + 1, sparsity.row_start[row + 1]);
      EXPECT_EQ(sparsity.column[sparsity.row_start[row]], row);
      for (const TermMatrix<2> *matrix : {&matrices.mass, &matrices.stiffness})
        EXPECT_EQ(matrix->diagonal_block(row).norm(), 0.);
    }
}



TEST(Foundation, MovesAsOneBody)
{
  // A rigid body on top, said to move by one of its sides.
  const std::string velocity = "3*t";
  for (const unsigned int side : {0u, 3u})
    {
      BodyGeometry<2> lid = foundation<2>();
      SpatialScene<2> scene(stack<2>({make_body<2>(1., {{4, 2}}, 1), lid}),
                            {make_side<2>("1",
                                          side,
                                          {{BoundaryType::velocity, fixed}},
                                          {{velocity, ""}})},
                            std::vector<Material>(2),
                            Tensor<1, 2>());
      EXPECT_FALSE(
        scene.problem.jump_basis().faults()[0].sides.slave_is_second());
      NodalVector v = scene.problem.make_nodal_vector();
      scene.boundary.set_velocities(2., v);
      const MeshLevel<2> &level = scene.meshes.finest();
      for (unsigned int b = 0; b < 2; ++b)
        for (types::global_dof_index dof = 0;
             dof < level.bodies[b]->dof_handler().n_dofs();
             ++dof)
          {
            const unsigned int node = level.node(b, dof);
            EXPECT_EQ(v.local_element(2 * node), b == 1 ? 6. : 0.);
            EXPECT_EQ(v.local_element(2 * node + 1), 0.);
          }
    }
}
