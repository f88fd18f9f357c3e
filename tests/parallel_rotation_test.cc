// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/algebra/galerkin_product.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/rotation_coupling.h>

#include <memory>

#include "serial_matrices.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Two bodies side by side whose upper sides rise towards each other, like a
   * roof, and a body upon them, of different meshes. The sides are not plane,
   * and there is a gap between them. Nodes are distributed along x. */
  template <int dim>
  struct Roof
  {
    FaultTopology           topology;
    MeshLevel<dim>          level;
    std::vector<FaultSides> sides;
    MPI_Comm                communicator = MPI_COMM_WORLD;

    Roof()
      : topology(
          {"left", "right", "over"},
          {{"main",
            {{{{0, BodyMesh<dim>::upper_side}, {1, BodyMesh<dim>::upper_side}},
              {{2, BodyMesh<dim>::lower_side}}}}}})
      , sides(1)
    {
      BodyMeshes<dim>          bodies;
      std::vector<NodeNumbers> numbers;
      const unsigned int n = Utilities::MPI::n_mpi_processes(communicator);
      for (unsigned int b = 0; b < 3; ++b)
        {
          std::array<unsigned int, dim> cells;
          cells.fill(b + 2);
          BodyGeometry<dim> body = make_body<dim>(1., cells, 1);
          body.lateral_lower[0]  = b == 1 ? 0.2 : -2.5;
          body.lateral_upper[0]  = b == 0 ? 0.2 : 2.5;
          body.base              = b == 2 ? 1.05 : 0.;
          body.upper_slope[0]    = b == 0 ? 0.03 : b == 1 ? -0.03 : 0.;
          if (b == 1)
            body.thickness = 1.08;
          bodies.push_back(
            std::make_shared<BodyMesh<dim>>(body, topology.sides_at_faults(b)));
          std::vector<unsigned int> owners;
          for (const Point<dim> &x : bodies.back()->node_positions())
            owners.push_back(
              std::min<unsigned int>((x[0] + 2.5) / 5. * n, n - 1));
          numbers.push_back(number_whole_mesh(owners, n));
        }
      level = MeshLevel<dim>(bodies, topology, numbers, communicator);
    }
  };



  /** The owned values of a rigid motion, zero at hanging nodes. */
  template <int dim>
  void
  set_values(const MeshLevel<dim>                            &level,
             const NodePartition                             &nodes,
             const std::pair<Tensor<1, dim>, Tensor<2, dim>> &motion,
             NodalVector                                     &u)
  {
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      {
        const auto positions = level.bodies[b]->node_positions();
        for (unsigned int dof = 0; dof < positions.size(); ++dof)
          {
            const auto node = level.global_node(b, dof);
            if (!nodes.owned().is_element(node) ||
                level.bodies[b]->bound_nodes().is_constrained(dof))
              continue;
            const Tensor<1, dim> value =
              motion.first + motion.second * positions[dof];
            for (unsigned int d = 0; d < dim; ++d)
              u.local_element(nodes.local_index(node) * dim + d) = value[d];
          }
      }
  }



  template <int dim>
  void
  rotate_jumps(const NodeFrames<dim> &frames,
               const NodePartition   &nodes,
               NodalVector           &w)
  {
    for (const auto &[node, axes] : frames)
      if (nodes.owned().is_element(node))
        {
          const unsigned int p = nodes.local_index(node);
          Tensor<1, dim>     value;
          for (unsigned int d = 0; d < dim; ++d)
            value[d] = w.local_element(p * dim + d);
          value = transpose(axes) * value;
          for (unsigned int d = 0; d < dim; ++d)
            w.local_element(p * dim + d) = value[d];
        }
  }



  template <int dim>
  void
  expect_rotation_free_basis()
  {
    const Roof<dim>       roof;
    const MeshLevel<dim> &level = roof.level;
    for (const bool slave_is_second : {true, false})
      {
        const std::vector<FaultSides> sides(1,
                                            {slave_is_second ? 1u : 0u,
                                             slave_is_second ? 0u : 1u});
        // Slave nodes at the ridge are two, and next to each other.
        const JumpBasis<dim> basis =
          undeformed_basis(level, sides, NodeMask(level.n_nodes(), dim));
        const NodeFrames<dim> frames = basis.frames();
        const Material        material;
        const auto            stiffness =
          assemble_elastic_matrices<dim>(level,
                                         {material, material, material},
                                         false)
            .stiffness;
        std::vector<GlobalRow> rows;
        for (unsigned int i = 0; i < level.nodes.n_local(); ++i)
          rows.push_back(basis.to_nodal(level.nodes.global_index(i)));
        GalerkinProduct<dim>        product(level.nodes,
                                     stiffness.sparsity(),
                                     rows,
                                     level.nodes.owned());
        const NodePartition        &nodes = product.coarse_nodes();
        const RotationCoupling<dim> rotation(basis,
                                             frames,
                                             nodes,
                                             *product.coarse_sparsity());
        ASSERT_FALSE(rotation.empty());

        // Rigid motions have no jumps, but with the rows alone they have.
        std::vector<GlobalRow> inverse_rows;
        for (unsigned int i = 0; i < level.nodes.n_owned(); ++i)
          inverse_rows.push_back(basis.to_jumps(level.nodes.global_index(i)));
        const TransferMatrix to_jumps(inverse_rows, level.nodes, nodes);
        double               largest_without = 0.;
        for (const auto &motion : rigid_motions<dim>())
          {
            NodalVector w = nodes.make_vector(), values = w;
            set_values(level, nodes, motion, values);
            to_jumps.prolongate(w, values, dim);
            rotate_jumps(frames, nodes, w);
            const auto largest = [&]() {
              double result = 0.;
              for (const unsigned int p : basis.owned_contact_nodes(nodes))
                for (unsigned int d = 0; d < dim; ++d)
                  result =
                    std::max(result, std::abs(w.local_element(p * dim + d)));
              return Utilities::MPI::max(result, MPI_COMM_WORLD);
            };
            largest_without = std::max(largest_without, largest());
            rotation.add(1., w);
            EXPECT_LT(largest(), 1e-13);
          }
        EXPECT_GT(largest_without, 1e-2);

        // The matrix is what the steps one after the other are.
        BlockMatrix<dim> A(product.coarse_sparsity());
        product.compute(stiffness, NodeMask(level.nodes.n_local(), dim), A);
        const auto value = [](const types::global_dof_index i) {
          return std::sin(1. + 7. * i);
        };
        NodalVector w = nodes.make_vector();
        for (unsigned int i = 0; i < w.locally_owned_size(); ++i)
          w.local_element(i) = value(w.get_partitioner()->local_to_global(i));
        NodalVector expected = nodes.make_vector(), result = expected;
        NodalVector step = w;
        rotation.add(-1., step);
        A.vmult(expected, step);
        rotation.add_transpose(-1., expected);
        rotation.transform(A);
        A.vmult(result, w);
        result -= expected;
        EXPECT_LT(result.linfty_norm(), 1e-13 * expected.linfty_norm());
        EXPECT_GT(expected.linfty_norm(), 1e3);
      }
  }
} // namespace



TEST(RotationCoupling, MakesJumpsFreeOfRotations)
{
  expect_rotation_free_basis<2>();
}



TEST(RotationCoupling, MakesJumpsFreeOfRotationsInThreeDimensions)
{
  expect_rotation_free_basis<3>();
}
