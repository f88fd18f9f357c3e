// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// The part of SpatialProblem that depends on the contact mapping: jump bases,
// transfers, masks and Galerkin operators of all levels.

#include <stickslip/algebra/make_set.h>
#include <stickslip/parameters/agreed_failure.h>
#include <stickslip/time/spatial_problem.h>

#include <algorithm>
#include <iterator>

namespace StickSlip
{
  namespace
  {
    /** The components that never take part: prescribed ones, those of hanging
     * nodes, the normal jumps, which are zero, and the jumps at the nodes where
     * the slip is prescribed. Over the global numbers of all nodes. */
    template <int dim>
    NodeMask
    fixed_components(
      const MeshLevel<dim>                       &level,
      const NodeMask                             &dirichlet,
      const JumpBasis<dim>                       &basis,
      const std::vector<types::global_dof_index> &prescribed_slip)
    {
      NodeMask mask = dirichlet;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
          mask.mask_node(level.global_node(b, line.index));
      for (const auto p : basis.contact_nodes())
        if (std::binary_search(prescribed_slip.begin(),
                               prescribed_slip.end(),
                               p))
          mask.mask_node(p);
        else
          mask.mask(p, dim - 1);
      return mask;
    }



    /** Global numbers, in ascending order. */
    template <int dim>
    std::vector<unsigned int>
    slave_nodes_of_all_faults(const JumpBasis<dim> &basis)
    {
      std::vector<unsigned int> nodes;
      for (const FaultContact<dim> &fault : basis.faults())
        nodes.insert(nodes.end(),
                     fault.slave_nodes.begin(),
                     fault.slave_nodes.end());
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }



    /** The results of @p row for all nodes with a local index. */
    template <typename Row>
    std::vector<GlobalRow>
    local_rows(const NodePartition &nodes, const Row &row)
    {
      std::vector<GlobalRow> rows;
      rows.reserve(nodes.n_local());
      for (unsigned int i = 0; i < nodes.n_local(); ++i)
        rows.push_back(row(nodes.global_index(i)));
      return rows;
    }
  } // namespace



  template <int dim>
  void
  SpatialProblem<dim>::build_contact(const NodalVector &displacement)
  {
    ++builds;
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();

    std::vector<JumpBasis<dim>>         bases;
    std::vector<FaultDisplacement<dim>> displacements =
      gather_fault_displacements(finest, sides, displacement);
    for (unsigned int l = n_levels; l-- > 0;)
      {
        const MeshLevel<dim> &level = mesh_hierarchy.level(l);
        if (l + 1 < n_levels)
          displacements =
            inject(level, mesh_hierarchy.level(l + 1), sides, displacements);
        bases.emplace_back(level, sides, displacements, dirichlet_masks[l]);
      }
    std::reverse(bases.begin(), bases.end());
    for (unsigned int i = 0; i < bases.back().faults().size(); ++i)
      if (!(bases.back().faults()[i].coupling.covered_area > 0.))
        throw AgreedFailure("The two sides of fault " + std::to_string(i + 1) +
                            " (counted from below) do not touch.");

    if (levels &&
        Utilities::MPI::n_mpi_processes(finest.nodes.communicator()) == 1)
      update(bases);
    else
      build(bases);
    finest_basis = std::make_unique<JumpBasis<dim>>(std::move(bases.back()));
  }



  template <int dim>
  void
  SpatialProblem<dim>::build(const std::vector<JumpBasis<dim>> &bases)
  {
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();

    // The memory is needed for the new ones.
    levels.reset();

    // From the nodal basis to jumps, and from there down the levels. Each
    // product tells the ghosts and the sparsity on its coarse side.
    to_jump_basis = std::make_unique<GalerkinProduct<dim>>(
      finest.nodes,
      nodal_terms.front().sparsity(),
      local_rows(finest.nodes,
                 [&](const types::global_dof_index node) {
                   return bases.back().to_nodal(node);
                 }),
      finest.nodes.owned());
    std::vector<LevelDescription<dim>> descriptions(n_levels);
    descriptions.back().nodes     = to_jump_basis->coarse_nodes();
    const BlockSparsity *sparsity = to_jump_basis->coarse_sparsity().get();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        LevelDescription<dim> &fine = descriptions[l];
        fine.to_coarser             = std::make_shared<GalerkinProduct<dim>>(
          fine.nodes,
          *sparsity,
          local_rows(fine.nodes,
                     [&](const types::global_dof_index node) {
                       return jump_prolongation(bases[l - 1],
                                                bases[l],
                                                mesh_hierarchy.prolongation(l),
                                                node);
                     }),
          mesh_hierarchy.level(l - 1).nodes.owned());
        descriptions[l - 1].nodes = fine.to_coarser->coarse_nodes();
        sparsity                  = fine.to_coarser->coarse_sparsity().get();
      }
    describe(descriptions, bases);

    const NodeMask                all(finest.nodes.n_local(), dim);
    std::vector<BlockMatrix<dim>> terms;
    for (const BlockMatrix<dim> &term : nodal_terms)
      {
        terms.emplace_back(to_jump_basis->coarse_sparsity());
        to_jump_basis->compute(term, all, terms.back());
      }
    std::vector<GlobalRow> inverse_rows;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      inverse_rows.push_back(
        bases.back().to_jumps(finest.nodes.global_index(i)));
    B_inverse =
      TransferMatrix(inverse_rows, finest.nodes, to_jump_basis->coarse_nodes());
    levels = std::make_unique<LevelHierarchy<dim>>(std::move(descriptions));
    levels->set_terms(std::move(terms));
  }



  template <int dim>
  void
  SpatialProblem<dim>::update(const std::vector<JumpBasis<dim>> &bases)
  {
    // On one process local and global numbers are the same.
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();
    if (near_faults.empty())
      for (unsigned int l = 0; l < n_levels; ++l)
        near_faults.push_back(rows_near_faults(l, bases));

    const std::vector<unsigned int> slave_nodes =
      slave_nodes_of_all_faults(bases.back());
    std::vector<GlobalRow> rows, inverse_rows;
    for (const unsigned int node : slave_nodes)
      {
        rows.push_back(bases.back().to_nodal(node));
        inverse_rows.push_back(bases.back().to_jumps(node));
      }
    to_jump_basis = std::make_unique<GalerkinProduct<dim>>(
      *to_jump_basis, nodal_terms.front().sparsity(), slave_nodes, rows);
    B_inverse = TransferMatrix(B_inverse,
                               slave_nodes,
                               inverse_rows,
                               to_jump_basis->coarse_nodes());

    std::vector<LevelDescription<dim>> descriptions(n_levels);
    descriptions.back().nodes            = to_jump_basis->coarse_nodes();
    const GalerkinProduct<dim> *to_level = to_jump_basis.get();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        // Where the matrix has changed on this level, or the transfer may have.
        std::vector<unsigned int> changed;
        std::set_union(near_faults[l].begin(),
                       near_faults[l].end(),
                       to_level->updated_rows().begin(),
                       to_level->updated_rows().end(),
                       std::back_inserter(changed));
        rows.clear();
        for (const unsigned int node : changed)
          rows.push_back(jump_prolongation(
            bases[l - 1], bases[l], mesh_hierarchy.prolongation(l), node));
        LevelDescription<dim> &fine = descriptions[l];
        fine.to_coarser             = std::make_shared<GalerkinProduct<dim>>(
          *levels->description(l).to_coarser,
          *to_level->coarse_sparsity(),
          changed,
          rows);
        descriptions[l - 1].nodes = fine.to_coarser->coarse_nodes();
        to_level                  = fine.to_coarser.get();
      }
    describe(descriptions, bases);

    const NodeMask                all(finest.nodes.n_local(), dim);
    std::vector<BlockMatrix<dim>> terms;
    for (unsigned int k = 0; k < nodal_terms.size(); ++k)
      {
        const BlockMatrix<dim> before = levels->release_term(k);
        terms.emplace_back(to_jump_basis->coarse_sparsity());
        to_jump_basis->update(nodal_terms[k], all, before, terms.back());
      }
    levels->update(std::move(descriptions), std::move(terms));
  }



  template <int dim>
  void
  SpatialProblem<dim>::describe(
    std::vector<LevelDescription<dim>> &descriptions,
    const std::vector<JumpBasis<dim>>  &bases) const
  {
    const std::vector<types::global_dof_index> no_nodes;
    for (unsigned int l = 0; l < descriptions.size(); ++l)
      {
        LevelDescription<dim> &level = descriptions[l];
        level.nonsmooth_nodes = bases[l].owned_contact_nodes(level.nodes);
        level.fixed =
          fixed_components(mesh_hierarchy.level(l),
                           dirichlet_masks[l],
                           bases[l],
                           prescribed_slip ? prescribed_slip->nodes(l) :
                                             no_nodes)
            .local_part(level.nodes);
      }
  }



  template <int dim>
  std::vector<unsigned int>
  SpatialProblem<dim>::rows_near_faults(
    const unsigned int                 l,
    const std::vector<JumpBasis<dim>> &bases) const
  {
    // B_l^-1 P B_{l-1} differs from P in the rows of slave nodes, and in those
    // that see slave nodes of the coarser level.
    std::vector<unsigned int> result = slave_nodes_of_all_faults(bases[l]);
    if (l > 0)
      {
        const std::vector<unsigned int> coarse =
          slave_nodes_of_all_faults(bases[l - 1]);
        for (unsigned int i = 0; i < mesh_hierarchy.level(l).nodes.n_owned();
             ++i)
          for (const auto &entry : mesh_hierarchy.prolongation(l).row(i))
            if (std::binary_search(coarse.begin(), coarse.end(), entry.first))
              {
                result.push_back(i);
                break;
              }
        make_set(result);
      }
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                             \
  template void SpatialProblem<dim>::build_contact(const NodalVector &);       \
  template void SpatialProblem<dim>::build(                                    \
    const std::vector<JumpBasis<dim>> &);                                      \
  template void SpatialProblem<dim>::update(                                   \
    const std::vector<JumpBasis<dim>> &);                                      \
  template void SpatialProblem<dim>::describe(                                 \
    std::vector<LevelDescription<dim>> &, const std::vector<JumpBasis<dim>> &) \
    const;                                                                     \
  template std::vector<unsigned int> SpatialProblem<dim>::rows_near_faults(    \
    const unsigned int, const std::vector<JumpBasis<dim>> &) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
