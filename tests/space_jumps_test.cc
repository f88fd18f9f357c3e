// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/algebra/galerkin_product.h>

#include <algorithm>
#include <map>

#include "serial_matrices.h"
#include "stuck_faults.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The jump bases of all levels, the left ends of all bodies held or not. */
  template <int dim>
  struct Bases
  {
    MeshHierarchy<dim>                           meshes;
    std::vector<FaultSides>                      sides;
    std::vector<std::unique_ptr<JumpBasis<dim>>> bases;

    Bases(const std::vector<BodyGeometry<dim>> &bodies, const bool held)
      : meshes(bodies, MPI_COMM_WORLD)
    {
      for (unsigned int b = 0; b + 1 < bodies.size(); ++b)
        sides.push_back(
          choose_fault_sides(meshes.finest(), meshes.topology(), b));
      for (unsigned int l = 0; l < meshes.n_levels(); ++l)
        {
          NodeMask dirichlet(meshes.level(l).nodes.n_local(), dim);
          if (held)
            for_each_node(meshes.level(l),
                          [&](const unsigned int,
                              const unsigned int,
                              const unsigned int node,
                              const Point<dim>  &x,
                              const bool) {
                            if (x[0] == -2.5)
                              dirichlet.mask(node, 0);
                          });
          bases.push_back(std::make_unique<JumpBasis<dim>>(
            undeformed_basis(meshes.level(l), sides, dirichlet)));
        }
    }

    TransferMatrix
    prolongation(const unsigned int l) const
    {
      return serial_matrix(prolongation_rows(l),
                           meshes.level(l - 1).n_nodes(),
                           dim);
    }

    std::vector<GlobalRow>
    prolongation_rows(const unsigned int l) const
    {
      return jump_prolongation_rows(*bases[l - 1], *bases[l], meshes, l);
    }

    TransferMatrix
    to_jumps(const unsigned int l) const
    {
      return to_jumps_matrix(*bases[l], meshes.level(l).n_nodes());
    }
  };



  /** Call @p check on all scenes, with and without held ends. */
  template <int dim>
  void
  for_each_scene(void (*check)(const Bases<dim> &))
  {
    for (const auto &bodies : scenes<dim>())
      for (const bool held : {false, true})
        check(Bases<dim>(bodies, held));
  }



  template <int dim>
  void
  expect_inverse(const Bases<dim> &bases)
  {
    for (unsigned int l = 0; l < bases.meshes.n_levels(); ++l)
      for (unsigned int i = 0; i < bases.meshes.level(l).n_nodes(); ++i)
        {
          const auto &basis = bases.bases[l];
          // Row i of B B^-1 and of B^-1 B.
          std::map<types::global_dof_index, double> left, right;
          for (const auto &outer : basis->to_nodal(i))
            for (const auto &inner : basis->to_jumps(outer.first))
              left[inner.first] += outer.second * inner.second;
          for (const auto &outer : basis->to_jumps(i))
            for (const auto &inner : basis->to_nodal(outer.first))
              right[inner.first] += outer.second * inner.second;
          for (const auto &row : {left, right})
            for (const auto &entry : row)
              EXPECT_NEAR(entry.second, entry.first == i ? 1. : 0., 1e-14);
        }
  }



  /** Each body's own linear function: its jumps are linear too. */
  template <int dim>
  void
  expect_linear_functions_reproduced(const Bases<dim> &bases)
  {
    const auto function = [](const unsigned int body, const Point<dim> &x) {
      Tensor<1, dim> value;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          value[c] +=
            0.05 * std::cos(1. + body + 2. * c + 3. * d) * (1. + x[d]);
      return value;
    };
    for (unsigned int l = 1; l < bases.meshes.n_levels(); ++l)
      {
        const NodalVector u_coarse =
          interpolate(bases.meshes.level(l - 1), function);
        const NodalVector u_fine = interpolate(bases.meshes.level(l), function);
        NodalVector       coarse = u_coarse, fine = u_fine, expected = u_fine;
        bases.to_jumps(l - 1).prolongate(coarse, u_coarse, dim);
        bases.prolongation(l).prolongate(fine, coarse, dim);
        bases.to_jumps(l).prolongate(expected, u_fine, dim);
        EXPECT_GT(expected.linfty_norm(), 0.1);
        fine -= expected;
        EXPECT_LT(fine.linfty_norm(), 1e-13) << "on level " << l;
      }
  }



  /**
   * A jump by which one body moves off the others as a whole is the same jump
   * on the finer level. Without jumps the finer level has none either, if the
   * meshes match.
   */
  template <int dim>
  void
  expect_jumps_stay_jumps(const Bases<dim> &bases)
  {
    for (unsigned int l = 1; l < bases.meshes.n_levels(); ++l)
      {
        const TransferMatrix P = bases.prolongation(l);
        NodalVector coarse     = bases.meshes.level(l - 1).nodes.make_vector();
        NodalVector fine       = bases.meshes.level(l).nodes.make_vector();
        for (const unsigned int p : bases.bases[l - 1]->contact_nodes())
          coarse.local_element(p * dim) = 1.;
        P.prolongate(fine, coarse, dim);
        for (const FaultContact<dim> &fault : bases.bases[l]->faults())
          {
            const auto all = fault.coupling.averaging_factor;
            // Held ends have no jump, and the mean next to them is smaller.
            if (*std::min_element(all.begin(), all.end()) < 1. - 1e-10)
              continue;
            for (const unsigned int p : fault.slave.nodes)
              EXPECT_NEAR(fine.local_element(p * dim), 1., 1e-13);
            // Jumps have no influence on the masters.
            for (const unsigned int q : fault.master.nodes)
              EXPECT_EQ(fine.local_element(q * dim), 0.);
          }
      }
  }



  template <int dim>
  void
  expect_rigid_motion_free_of_energy(
    const std::vector<BodyGeometry<dim>> &bodies)
  {
    SpatialScene<dim> scene(bodies,
                            {},
                            std::vector<Material>(bodies.size()),
                            9.81);
    const Bases<dim>  bases(bodies, /*held=*/false);
    for (const auto term :
         {SpatialProblem<dim>::stiffness, SpatialProblem<dim>::damping})
      {
        BlockMatrix<dim> A = scene.problem.term(term).block_matrix();
        for (unsigned int l = scene.meshes.n_levels(); l-- > 0;)
          {
            double scale = 0.;
            for (const double value : A.values())
              scale = std::max(scale, std::abs(value));
            for (const auto &motion : rigid_motions<dim>())
              {
                NodalVector w =
                  interpolate(scene.meshes.level(l),
                              [&](const unsigned int, const Point<dim> &x) {
                                return motion.first + motion.second * x;
                              });
                const NodalVector u     = w;
                NodalVector       force = w;
                bases.to_jumps(l).prolongate(w, u, dim);
                for (const unsigned int p : bases.bases[l]->contact_nodes())
                  for (unsigned int c = 0; c < dim; ++c)
                    EXPECT_LT(std::abs(w.local_element(p * dim + c)), 1e-13);
                A.vmult(force, w);
                EXPECT_LT(force.linfty_norm(), 1e-12 * scale)
                  << "on level " << l;
                EXPECT_LT(std::abs(w * force), 1e-11 * scale)
                  << "on level " << l;
              }
            if (l == 0)
              break;
            GalerkinProduct<dim> product(
              bases.meshes.level(l).nodes,
              A.sparsity(),
              bases.prolongation_rows(l),
              bases.meshes.level(l - 1).nodes.owned());
            BlockMatrix<dim> coarse(product.coarse_sparsity());
            product.compute(A, NodeMask(A.n_rows(), dim), coarse);
            A = coarse;
          }
      }
  }
} // namespace



TEST(JumpBasis, HasItsInverse)
{
  for_each_scene<2>(expect_inverse<2>);
  for_each_scene<3>(expect_inverse<3>);
}



TEST(JumpBasis, ProlongationReproducesLinearFunctions)
{
  for_each_scene<2>(expect_linear_functions_reproduced<2>);
  for_each_scene<3>(expect_linear_functions_reproduced<3>);
}



TEST(JumpBasis, JumpsStayJumps)
{
  for_each_scene<2>(expect_jumps_stay_jumps<2>);
  for_each_scene<3>(expect_jumps_stay_jumps<3>);
}



TEST(JumpBasis, NoJumpStaysNoneOnMatchingMeshes)
{
  const Bases<2> bases(spring_slider_bodies(), /*held=*/false);
  std::mt19937   random(17);
  for (unsigned int l = 1; l < bases.meshes.n_levels(); ++l)
    {
      NodalVector coarse = random_values(bases.meshes.level(l - 1), random);
      NodalVector fine   = bases.meshes.level(l).nodes.make_vector();
      for (const unsigned int p : bases.bases[l - 1]->contact_nodes())
        for (unsigned int c = 0; c < 2; ++c)
          coarse.local_element(p * 2 + c) = 0.;
      bases.prolongation(l).prolongate(fine, coarse, 2);
      EXPECT_EQ(bases.bases[l]->contact_nodes().size(), 10u * (1u << l) + 1u);
      for (const unsigned int p : bases.bases[l]->contact_nodes())
        for (unsigned int c = 0; c < 2; ++c)
          EXPECT_NEAR(fine.local_element(p * 2 + c), 0., 1e-14);
    }
}



TEST(JumpBasis, RigidMotionCostsNoEnergyOnAnyLevel)
{
  for (const auto &bodies : scenes<2>())
    expect_rigid_motion_free_of_energy<2>(bodies);
  expect_rigid_motion_free_of_energy<3>(nonmatching_blocks());
}



TEST(JumpBasis, SlaveIsTheFinerSide)
{
  const auto sides_of = [](const unsigned int below, const unsigned int above) {
    const MeshHierarchy<2> meshes(stack<2>({make_body<2>(1., {{below, 2}}, 2),
                                            make_body<2>(1., {{above, 2}}, 2)}),
                                  MPI_COMM_WORLD);
    const FaultSides       sides =
      choose_fault_sides(meshes.finest(), meshes.topology(), 0);
    EXPECT_EQ(sides.slave + sides.master, 1u);
    EXPECT_EQ(sides.sign(), sides.slave_is_second() ? 1. : -1.);
    return sides;
  };
  EXPECT_TRUE(sides_of(10, 11).slave_is_second());
  EXPECT_FALSE(sides_of(11, 10).slave_is_second());
  EXPECT_TRUE(sides_of(10, 40).slave_is_second());
  EXPECT_FALSE(sides_of(40, 10).slave_is_second());
  EXPECT_TRUE(sides_of(10, 10).slave_is_second());

  // The problem in space chooses them that way.
  for (const bool finer_above : {true, false})
    {
      SpatialScene<2> scene(
        stack<2>({make_body<2>(1., {{finer_above ? 6u : 9u, 1}}, 1),
                  make_body<2>(1., {{finer_above ? 9u : 6u, 1}}, 1)}),
        {},
        std::vector<Material>(2),
        0.);
      EXPECT_EQ(scene.problem.jump_basis().faults()[0].sides.slave_is_second(),
                finer_above);
      EXPECT_EQ(scene.problem.jump_basis().contact_nodes().size(), 19u);
    }
}
