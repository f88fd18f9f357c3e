// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_examples_refinement_levels_h
#define stickslip_examples_refinement_levels_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/numerics/vector_tools.h>

#include <stickslip/multigrid/level_hierarchy.h>

/**
 * Problems on meshes of deal.II as the solver takes them: a matrix of blocks
 * from a sparse matrix, and the levels of the multigrid method from the
 * refinement of the mesh. To be copied together with an example.
 *
 * The unknowns are n_components values at each node, where the nodes are the
 * degrees of freedom of a DoFHandler with a scalar element. In vectors and
 * matrices of deal.II component c of node i has the number n_components i + c.
 * The mesh is refined globally, so that there are no hanging nodes, and belongs
 * to one process.
 */
namespace StickSlip::Examples
{
  using namespace dealii;

  /** Copy of a matrix in blocks of n_components rows and columns. */
  template <int n_components>
  BlockMatrix<n_components>
  make_block_matrix(const SparseMatrix<double> &matrix)
  {
    const unsigned int                     n_nodes = matrix.m() / n_components;
    std::vector<std::vector<unsigned int>> columns(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (auto entry = matrix.begin(n_components * i);
           entry != matrix.end(n_components * i);
           ++entry)
        if (entry->column() % n_components == 0)
          columns[i].push_back(entry->column() / n_components);

    BlockMatrix<n_components> result(
      std::make_shared<const BlockSparsity>(columns));
    for (unsigned int row = 0; row < matrix.m(); ++row)
      for (auto entry = matrix.begin(row); entry != matrix.end(row); ++entry)
        {
          const unsigned int i = row / n_components,
                             j = entry->column() / n_components;
          result.block(result.sparsity().position(
            i, j))[row % n_components * n_components +
                   entry->column() % n_components] = entry->value();
        }
    return result;
  }



  /**
   * The prolongation from a level of the mesh to the next finer one, a row for
   * each node of that: the values there of the basis functions of the coarse
   * cell around it, which deal.II's elements know for each child of a cell.
   * Level numbers of the nodes, but on the finest level those of the active
   * cells.
   */
  template <int dim>
  std::vector<GlobalRow>
  prolongation_rows(const DoFHandler<dim> &dof_handler,
                    const unsigned int     coarse_level)
  {
    const FiniteElement<dim> &fe = dof_handler.get_fe();
    const bool                is_finest =
      coarse_level + 2 == dof_handler.get_triangulation().n_levels();
    std::vector<GlobalRow> rows(
      is_finest ? dof_handler.n_dofs() : dof_handler.n_dofs(coarse_level + 1));
    std::vector<types::global_dof_index> coarse(fe.dofs_per_cell),
      fine(fe.dofs_per_cell);
    for (const auto &cell : dof_handler.cell_iterators_on_level(coarse_level))
      {
        cell->get_mg_dof_indices(coarse);
        for (unsigned int child = 0; child < cell->n_children(); ++child)
          {
            if (is_finest)
              cell->child(child)->get_dof_indices(fine);
            else
              cell->child(child)->get_mg_dof_indices(fine);
            const FullMatrix<double> &embedding =
              fe.get_prolongation_matrix(child);
            for (unsigned int i = 0; i < fine.size(); ++i)
              if (rows[fine[i]].empty())
                for (unsigned int j = 0; j < coarse.size(); ++j)
                  if (std::abs(embedding(i, j)) > 1e-12)
                    rows[fine[i]].emplace_back(coarse[j], embedding(i, j));
          }
      }
    return rows;
  }



  /**
   * The levels of the multigrid method, the coarsest first.
   *
   * @p dof_handler has a scalar element and level numbers, see
   * DoFHandler::distribute_mg_dofs(), on a mesh that is refined at least once.
   * @p matrix, @p fixed and @p nonsmooth_nodes are those of the finest level:
   * the operator, the components with prescribed values, and the nodes with a
   * nonsmooth term, in ascending order. A coarse node has the properties of the
   * fine node at the same place.
   */
  template <int n_components, int dim>
  std::vector<LevelDescription<n_components>>
  refinement_levels(const DoFHandler<dim>           &dof_handler,
                    const BlockMatrix<n_components> &matrix,
                    const NodeMask                  &fixed,
                    const std::vector<unsigned int> &nonsmooth_nodes)
  {
    const unsigned int n_levels = dof_handler.get_triangulation().n_levels();
    std::vector<LevelDescription<n_components>> levels(n_levels);
    levels.back().nodes =
      NodePartition(complete_index_set(dof_handler.n_dofs()),
                    IndexSet(dof_handler.n_dofs()),
                    n_components,
                    MPI_COMM_SELF);
    levels.back().fixed           = fixed;
    levels.back().nonsmooth_nodes = nonsmooth_nodes;

    std::shared_ptr<const BlockSparsity> sparsity = matrix.shared_sparsity();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        LevelDescription<n_components> &fine   = levels[l],
                                       &coarse = levels[l - 1];
        const unsigned int           n_coarse  = dof_handler.n_dofs(l - 1);
        const std::vector<GlobalRow> rows =
          prolongation_rows(dof_handler, l - 1);
        fine.to_coarser = std::make_shared<GalerkinProduct<n_components>>(
          fine.nodes, *sparsity, rows, complete_index_set(n_coarse));
        sparsity     = fine.to_coarser->coarse_sparsity();
        coarse.nodes = fine.to_coarser->coarse_nodes();

        // A fine node at the place of a coarse one has its value.
        coarse.fixed = NodeMask(n_coarse, n_components);
        std::vector<bool> is_nonsmooth(n_coarse, false);
        for (unsigned int i = 0; i < rows.size(); ++i)
          if (rows[i].size() == 1)
            {
              const unsigned int j = rows[i][0].first;
              for (unsigned int c = 0; c < n_components; ++c)
                if (!fine.fixed.is_active(i, c))
                  coarse.fixed.mask(j, c);
              is_nonsmooth[j] = std::binary_search(fine.nonsmooth_nodes.begin(),
                                                   fine.nonsmooth_nodes.end(),
                                                   i);
            }
        for (unsigned int j = 0; j < n_coarse; ++j)
          if (is_nonsmooth[j])
            coarse.nonsmooth_nodes.push_back(j);
      }
    return levels;
  }



  /** Set @p fine_values to the function with @p coarse_values on a mesh of
   * which the other one is a refinement. */
  template <int n_components, int dim>
  void
  interpolate(const DoFHandler<dim> &coarse,
              const Vector<double>  &coarse_values,
              const DoFHandler<dim> &fine,
              Vector<double>        &fine_values)
  {
    Vector<double> from(coarse.n_dofs()), to(fine.n_dofs());
    for (unsigned int c = 0; c < n_components; ++c)
      {
        for (unsigned int i = 0; i < from.size(); ++i)
          from(i) = coarse_values(n_components * i + c);
        VectorTools::interpolate_to_different_mesh(coarse, from, fine, to);
        for (unsigned int i = 0; i < to.size(); ++i)
          fine_values(n_components * i + c) = to(i);
      }
  }
} // namespace StickSlip::Examples

#endif
