// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/cycle_operators.h>

#include <algorithm>

namespace StickSlip
{
  template <int n_components, typename Number>
  CycleOperators<n_components, Number>::CycleOperators(
    const std::vector<LevelDescription<n_components>> &descriptions,
    const std::vector<TermMatrix<n_components>>       &terms)
    : descriptions(descriptions)
    , is_shared(Utilities::MPI::n_mpi_processes(
                  descriptions.back().nodes.communicator()) > 1)
    , levels(descriptions.size())
  {
    for (unsigned int l = 0; l < levels.size(); ++l)
      levels[l].active = descriptions[l].fixed;
    if (levels.size() > 1)
      levels.back().stiff_volumes = descriptions.back().stiff_volumes;
    has_stiff_volumes =
      Utilities::MPI::max(int(!levels.back().stiff_volumes.empty()),
                          descriptions.back().nodes.communicator()) > 0;
    set_up_level(levels.size() - 1, terms);
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        if (l + 1 == levels.size())
          compute_coarser_terms(l, terms);
        else
          compute_coarser_terms(l, levels[l].terms);
        Level &coarse = levels[l - 1];
        coarse.matrix = BlockMatrix<n_components, Number>(
          descriptions[l].to_coarser->coarse_sparsity());
        if (has_stiff_volumes)
          coarse.stiff_volumes =
            coarsen_stiff_volumes(levels[l].stiff_volumes,
                                  descriptions[l].to_coarser->prolongation(),
                                  descriptions[l].to_coarser->coarse_nodes(),
                                  terms.size());
        if (l > 1)
          set_up_level(l - 1, coarse.terms);
      }
    if (levels.size() == 1)
      levels.front().matrix =
        BlockMatrix<n_components, Number>(terms.front().shared_sparsity());
    if (is_shared)
      find_strips(terms.front().sparsity());
  }



  template <int n_components, typename Number>
  template <typename Matrix>
  void
  CycleOperators<n_components, Number>::set_up_level(
    const unsigned int         l,
    const std::vector<Matrix> &terms)
  {
    const LevelDescription<n_components> &description = descriptions[l];
    const BlockSparsity                  &sparsity = terms.front().sparsity();
    Level                                &level    = levels[l];
    std::vector<NodePatch>                patches =
      find_stiff_cells(sparsity, description.fixed, level.stiff_volumes);
    if (is_shared && has_stiff_volumes && l > 0)
      {
        level.cuts = CutPatches<n_components, Number>(description.nodes,
                                                      sparsity,
                                                      description.fixed,
                                                      level.stiff_volumes);
        // All processes act on patches then, of one node if need be.
        if (!level.cuts.are_empty() && patches.empty() && sparsity.n_rows() > 0)
          patches.push_back({0});
      }
    level.smoother = BlockGaussSeidel<n_components, Number>(
      terms.front().shared_sparsity(),
      patches.empty() ? find_strong_lines(sparsity,
                                          terms,
                                          description.fixed,
                                          description.nonsmooth_nodes) :
                        std::vector<NodeLine>(),
      patches,
      description.nodes);
    // Coarse cells keep the volumes of the patches on the finest level.
    if (has_stiff_volumes && l > 0 && l + 1 < levels.size())
      level.middles =
        MiddleNodes<n_components>(description.to_coarser->prolongation(),
                                  description.to_coarser->coarse_nodes(),
                                  *description.to_coarser->coarse_sparsity(),
                                  terms,
                                  level.stiff_volumes,
                                  description.fixed,
                                  description.nonsmooth_nodes);
  }



  template <int n_components, typename Number>
  template <typename FineMatrix>
  void
  CycleOperators<n_components, Number>::compute_coarser_terms(
    const unsigned int             l,
    const std::vector<FineMatrix> &fine_terms)
  {
    GalerkinProduct<n_components> &product = *descriptions[l].to_coarser;
    for (const FineMatrix &term : fine_terms)
      {
        levels[l - 1].terms.emplace_back(product.coarse_sparsity());
        product.compute(term,
                        descriptions[l].fixed,
                        levels[l - 1].terms.back());
        levels[l].middles.add_to_product(product.prolongation(),
                                         term,
                                         descriptions[l].fixed,
                                         levels[l - 1].terms.back());
      }
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::find_strips(
    const BlockSparsity &sparsity)
  {
    std::vector<bool> strip = find_strip(descriptions.back(), sparsity);
    for (unsigned int l = levels.size() - 1; l-- > 0;)
      {
        const LevelDescription<n_components> &finer = descriptions[l + 1];
        strip = find_strip(descriptions[l],
                           levels[l].matrix.sparsity(),
                           finer,
                           strip);
        finer.to_coarser->select_rows(strip);
        levels[l + 1].middles.select_rows(finer.to_coarser->coarse_nodes(),
                                          levels[l].matrix.sparsity(),
                                          strip);
        levels[l].strip.clear();
        for (unsigned int i = 0; i < levels[l].matrix.n_rows(); ++i)
          if (strip[i])
            levels[l].strip.push_back(i);
      }
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::set_operator(
    const OperatorSum<n_components> &A)
  {
    for (unsigned int l = 0; l + 1 < levels.size(); ++l)
      {
        Level             &level = levels[l];
        const unsigned int n     = level.matrix.n_rows();
        combine_coarse(l, A.coefficients(), level.matrix);
        level.active = descriptions[l].fixed;
        if (!is_shared)
          level.formed.assign(n, false);
        if (l > 0)
          for (unsigned int i = 0; i < n; ++i)
            {
              level.smoother.set_row(i, level.matrix);
              level.smoother.set_diagonal(i,
                                          level.matrix.diagonal_block(i),
                                          descriptions[l].fixed);
            }
      }
    BlockGaussSeidel<n_components, Number> &finest = levels.back().smoother;
    for (unsigned int i = 0; i < A.matrix().n_rows(); ++i)
      {
        finest.set_row(i, A.matrix());
        finest.set_diagonal(i,
                            A.matrix().diagonal_block(i),
                            descriptions.back().fixed);
      }
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::combine_coarse(
    const unsigned int                 l,
    const std::vector<double>         &coefficients,
    BlockMatrix<n_components, Number> &sum) const
  {
    std::vector<std::pair<double, const BlockMatrix<n_components, Number> *>>
      terms;
    for (unsigned int t = 0; t < levels[l].terms.size(); ++t)
      terms.emplace_back(coefficients[t], &levels[l].terms[t]);
    sum.combine(terms, 0, sum.n_rows());
  }



  template <int n_components, typename Number>
  Tensor<2, n_components>
  CycleOperators<n_components, Number>::combine_coarse_diagonal(
    const unsigned int         l,
    const std::vector<double> &coefficients,
    const unsigned int         row) const
  {
    Tensor<2, n_components> sum;
    for (unsigned int t = 0; t < levels[l].terms.size(); ++t)
      sum += coefficients[t] * levels[l].terms[t].diagonal_block(row);
    return sum;
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::factorise_smoothers()
  {
    for (Level &level : levels)
      level.smoother.factorise();
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::set_finest_diagonal(
    const unsigned int             i,
    const Tensor<2, n_components> &block,
    const NodeMask                &active)
  {
    levels.back().smoother.set_diagonal(i, block, active);
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::set_coarse_levels(
    const BlockMatrix<n_components> &A,
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
    levels.back().cuts.set_matrix(A, active);
    for (unsigned int l = 1; l + 1 < levels.size(); ++l)
      levels[l].cuts.set_matrix(levels[l].matrix, levels[l].active);
  }



  template <int n_components, typename Number>
  template <typename FineNumber>
  void
  CycleOperators<n_components, Number>::set_coarser_level(
    const unsigned int                           l,
    const BlockMatrix<n_components, FineNumber> &matrix,
    const NodeMask                              &active,
    std::vector<unsigned int>                   &changed)
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
    set_smoother(l - 1, changed);
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::set_smoother(
    const unsigned int               l,
    const std::vector<unsigned int> &rows)
  {
    Level &level = levels[l];
    if (l > 0)
      for (const unsigned int i : rows)
        {
          level.smoother.set_row(i, level.matrix);
          level.smoother.set_diagonal(i,
                                      level.matrix.diagonal_block(i),
                                      level.active);
        }
  }



  template <int n_components, typename Number>
  std::vector<std::vector<unsigned int>>
  CycleOperators<n_components, Number>::formed_rows() const
  {
    std::vector<std::vector<unsigned int>> result(levels.size() - 1);
    for (unsigned int l = 0; l < result.size(); ++l)
      for (unsigned int i = 0; i < levels[l].formed.size(); ++i)
        if (levels[l].formed[i])
          result[l].push_back(i);
    return result;
  }



  template <int n_components, typename Number>
  void
  CycleOperators<n_components, Number>::recall_coarse_levels(
    const BlockMatrix<n_components>              &A,
    const NodeMask                               &active,
    const std::vector<std::vector<unsigned int>> &formed)
  {
    if (is_shared || levels.size() == 1)
      {
        set_coarse_levels(A, active, {});
        return;
      }
    AssertDimension(formed.size(), levels.size() - 1);
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        const bool      is_finest   = (l + 1 == levels.size());
        const NodeMask &active_here = is_finest ? active : levels[l].active;
        Level          &coarse      = levels[l - 1];
        GalerkinProduct<n_components> &product = *descriptions[l].to_coarser;
        const auto                     compute_rows = [&](const auto &matrix) {
          product.compute_rows(matrix,
                               active_here,
                               formed[l - 1],
                               coarse.matrix);
          levels[l].middles.add_to_rows(product.prolongation(),
                                        matrix,
                                        active_here,
                                        formed[l - 1],
                                        coarse.matrix);
        };
        if (is_finest)
          compute_rows(A);
        else
          compute_rows(levels[l].matrix);
        for (const unsigned int i : formed[l - 1])
          coarse.formed[i] = true;
        coarse.active =
          coarsen_mask(descriptions[l - 1], descriptions[l], active_here);
        set_smoother(l - 1, formed[l - 1]);
      }
  }



  template <int n_components, typename Number>
  template <typename FineNumber>
  std::vector<unsigned int>
  CycleOperators<n_components, Number>::form_coarse_rows(
    const unsigned int                           l,
    const BlockMatrix<n_components, FineNumber> &matrix,
    const NodeMask                              &active,
    const std::vector<unsigned int>             &changed)
  {
    GalerkinProduct<n_components> &product = *descriptions[l].to_coarser;
    Level                         &coarse  = levels[l - 1];
    if (is_shared)
      {
        // To agree on rows takes longer than to form them.
        product.compute_selected_rows(matrix, active, coarse.matrix);
        levels[l].middles.add_to_selected_rows(product.prolongation(),
                                               matrix,
                                               active,
                                               coarse.matrix);
        return coarse.strip;
      }
    std::vector<unsigned int> rows = product.rows_from(changed);
    product.compute_rows(matrix, active, rows, coarse.matrix);
    levels[l].middles.add_to_rows(
      product.prolongation(), matrix, active, rows, coarse.matrix);
    for (const unsigned int i : rows)
      coarse.formed[i] = true;
    return rows;
  }



  template <int n_components, typename Number>
  const BlockGaussSeidel<n_components, Number> &
  CycleOperators<n_components, Number>::smoother(const unsigned int l) const
  {
    Assert(l > 0, ExcMessage("The coarsest level is solved, not smoothed."));
    return levels[l].smoother;
  }



  template <int n_components, typename Number>
  const CutPatches<n_components, Number> &
  CycleOperators<n_components, Number>::cut_patches(const unsigned int l) const
  {
    return levels[l].cuts;
  }



  template <int n_components, typename Number>
  const MiddleNodes<n_components> &
  CycleOperators<n_components, Number>::middle_nodes(const unsigned int l) const
  {
    return levels[l].middles;
  }



  template <int n_components, typename Number>
  const BlockMatrix<n_components, Number> &
  CycleOperators<n_components, Number>::coarse_matrix(
    const unsigned int l) const
  {
    return levels[l].matrix;
  }



  template <int n_components, typename Number>
  const NodeMask &
  CycleOperators<n_components, Number>::active(const unsigned int l) const
  {
    return levels[l].active;
  }



  template <int n_components, typename Number>
  std::size_t
  CycleOperators<n_components, Number>::memory_consumption() const
  {
    std::size_t bytes = 0;
    for (const Level &level : levels)
      {
        bytes += level.smoother.memory_consumption() +
                 level.matrix.memory_consumption() +
                 level.cuts.memory_consumption() +
                 level.middles.memory_consumption() +
                 sizeof(unsigned int) * level.stiff_volumes.capacity();
        if (!level.terms.empty())
          bytes +=
            level.terms.size() * level.terms.front().memory_consumption() +
            level.matrix.sparsity().memory_consumption();
      }
    return bytes;
  }



  template class CycleOperators<1, float>;
  template class CycleOperators<2, float>;
  template class CycleOperators<1, double>;
  template class CycleOperators<2, double>;
  template class CycleOperators<3, float>;
  template class CycleOperators<3, double>;
} // namespace StickSlip
