// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/cycle_operators.h>

#include <algorithm>

namespace StickSlip
{
  template <int dim, typename Number>
  CycleOperators<dim, Number>::CycleOperators(
    const std::vector<LevelDescription<dim>> &descriptions)
    : descriptions(descriptions)
    , is_shared(Utilities::MPI::n_mpi_processes(
                  descriptions.back().nodes.communicator()) > 1)
    , levels(descriptions.size())
  {}



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::set_terms(
    const std::vector<BlockMatrix<dim>> &finest)
  {
    for (unsigned int l = 0; l < levels.size(); ++l)
      levels[l].active = descriptions[l].fixed;
    levels.back().smoother =
      BlockGaussSeidel<dim, Number>(finest.front().sparsity());
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        if (l + 1 == levels.size())
          compute_coarser_terms(l, finest);
        else
          compute_coarser_terms(l, levels[l].terms);
        Level &coarse = levels[l - 1];
        coarse.matrix = BlockMatrix<dim, Number>(
          descriptions[l].to_coarser->coarse_sparsity());
        if (l > 1)
          coarse.smoother =
            BlockGaussSeidel<dim, Number>(coarse.matrix.sparsity());
      }
    if (levels.size() == 1)
      levels.front().matrix =
        BlockMatrix<dim, Number>(finest.front().shared_sparsity());
    if (is_shared)
      find_strips(finest.front().sparsity());
  }



  template <int dim, typename Number>
  template <typename FineNumber>
  void
  CycleOperators<dim, Number>::compute_coarser_terms(
    const unsigned int                               l,
    const std::vector<BlockMatrix<dim, FineNumber>> &fine_terms)
  {
    GalerkinProduct<dim> &product = *descriptions[l].to_coarser;
    Level                &coarse  = levels[l - 1];
    const std::vector<BlockMatrix<dim, Number>> before =
      std::move(coarse.terms);
    coarse.terms.clear();
    for (unsigned int k = 0; k < fine_terms.size(); ++k)
      {
        const BlockMatrix<dim, FineNumber> &term = fine_terms[k];
        coarse.terms.emplace_back(product.coarse_sparsity());
        if (product.is_update() && !before.empty())
          product.update(term,
                         descriptions[l].fixed,
                         before[k],
                         coarse.terms.back());
        else
          product.compute(term, descriptions[l].fixed, coarse.terms.back());
      }
  }



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::find_strips(const BlockSparsity &sparsity)
  {
    std::vector<bool> strip = find_strip(descriptions.back(), sparsity);
    for (unsigned int l = levels.size() - 1; l-- > 0;)
      {
        const LevelDescription<dim> &finer = descriptions[l + 1];
        strip                              = find_strip(descriptions[l],
                           levels[l].matrix.sparsity(),
                           finer,
                           strip);
        finer.to_coarser->select_rows(strip);
        levels[l].strip.clear();
        for (unsigned int i = 0; i < levels[l].matrix.n_rows(); ++i)
          if (strip[i])
            levels[l].strip.push_back(i);
      }
  }



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::combine_coarse_levels(
    const std::vector<double> &coefficients)
  {
    for (unsigned int l = 0; l + 1 < levels.size(); ++l)
      {
        Level             &level = levels[l];
        const unsigned int n     = level.matrix.n_rows();
        level.matrix.combine(coefficients, level.terms, 0, n);
        level.active = descriptions[l].fixed;
        if (l > 0)
          for (unsigned int i = 0; i < n; ++i)
            {
              level.smoother.set_row(i, level.matrix);
              level.smoother.set_diagonal(i,
                                          level.matrix.diagonal_block(i),
                                          descriptions[l].fixed);
            }
      }
  }



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::set_finest_row(
    const BlockMatrix<dim> &A,
    const unsigned int      i,
    const Tensor<2, dim>   &inverse_diagonal)
  {
    levels.back().smoother.set_row(i, A);
    levels.back().smoother.set_inverse_diagonal(i, inverse_diagonal);
  }



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::set_finest_diagonal(const unsigned int    i,
                                                   const Tensor<2, dim> &block,
                                                   const NodeMask       &active)
  {
    levels.back().smoother.set_diagonal(i, block, active);
  }



  template <int dim, typename Number>
  void
  CycleOperators<dim, Number>::set_coarse_levels(
    const BlockMatrix<dim>          &A,
    const NodeMask                  &active,
    const std::vector<unsigned int> &changed)
  {
    if (levels.size() == 1)
      {
        // The coarsest level is the finest one.
        std::copy(A.values().begin(),
                  A.values().end(),
                  levels.front().matrix.values().begin());
        levels.front().active = active;
      }
    std::vector<unsigned int> changed_on_level = changed;
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      if (l + 1 == levels.size())
        set_coarser_level(l, A, active, changed_on_level);
      else
        set_coarser_level(l,
                          levels[l].matrix,
                          levels[l].active,
                          changed_on_level);
  }



  template <int dim, typename Number>
  template <typename FineNumber>
  void
  CycleOperators<dim, Number>::set_coarser_level(
    const unsigned int                  l,
    const BlockMatrix<dim, FineNumber> &matrix,
    const NodeMask                     &active,
    std::vector<unsigned int>          &changed)
  {
    Level                    &coarse = levels[l - 1];
    std::vector<unsigned int> rows =
      form_coarse_rows(l, matrix, active, changed);

    const NodeMask before = std::move(coarse.active);
    coarse.active = coarsen_mask(descriptions[l - 1], descriptions[l], active);
    if (!is_shared)
      {
        // A mask also counts in the rows that are coupled to its node.
        std::vector<unsigned int> masked;
        for (const unsigned int i : descriptions[l - 1].nonsmooth_nodes)
          if (!coarse.active.is_equal_at(before, i))
            masked.push_back(i);
        if (!masked.empty())
          {
            masked = coarse.matrix.sparsity().coupled_to(masked);
            rows.insert(rows.end(), masked.begin(), masked.end());
            make_set(rows);
          }
      }
    changed = std::move(rows);

    if (l > 1)
      for (const unsigned int i : changed)
        {
          coarse.smoother.set_row(i, coarse.matrix);
          coarse.smoother.set_diagonal(i,
                                       coarse.matrix.diagonal_block(i),
                                       coarse.active);
        }
  }



  template <int dim, typename Number>
  template <typename FineNumber>
  std::vector<unsigned int>
  CycleOperators<dim, Number>::form_coarse_rows(
    const unsigned int                  l,
    const BlockMatrix<dim, FineNumber> &matrix,
    const NodeMask                     &active,
    const std::vector<unsigned int>    &changed)
  {
    GalerkinProduct<dim> &product = *descriptions[l].to_coarser;
    Level                &coarse  = levels[l - 1];
    if (is_shared)
      {
        // To agree on rows takes longer than to form them.
        product.compute_selected_rows(matrix, active, coarse.matrix);
        return coarse.strip;
      }
    std::vector<unsigned int> rows = product.rows_from(changed);
    product.compute_rows(matrix, active, rows, coarse.matrix);
    return rows;
  }



  template <int dim, typename Number>
  const BlockGaussSeidel<dim, Number> &
  CycleOperators<dim, Number>::smoother(const unsigned int l) const
  {
    Assert(l > 0, ExcMessage("The coarsest level is solved, not smoothed."));
    return levels[l].smoother;
  }



  template <int dim, typename Number>
  const BlockMatrix<dim, Number> &
  CycleOperators<dim, Number>::coarse_matrix(const unsigned int l) const
  {
    return levels[l].matrix;
  }



  template <int dim, typename Number>
  const NodeMask &
  CycleOperators<dim, Number>::active(const unsigned int l) const
  {
    return levels[l].active;
  }



  template <int dim, typename Number>
  std::size_t
  CycleOperators<dim, Number>::memory_consumption() const
  {
    std::size_t bytes = 0;
    for (const Level &level : levels)
      {
        bytes += level.smoother.memory_consumption() +
                 level.matrix.memory_consumption();
        if (!level.terms.empty())
          bytes +=
            level.terms.size() * level.terms.front().memory_consumption() +
            level.matrix.sparsity().memory_consumption();
      }
    return bytes;
  }



  template class CycleOperators<2, float>;
  template class CycleOperators<2, double>;
  template class CycleOperators<3, float>;
  template class CycleOperators<3, double>;
} // namespace StickSlip
