// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/level_hierarchy.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /**
     * The inverse of the block of active components, zero elsewhere.
     */
    template <int dim>
    void
    invert_diagonal_block(const BlockMatrix<dim> &matrix,
                          const unsigned int      row,
                          const NodeMask         &active,
                          double                 *inverse)
    {
      Tensor<2, dim> block = matrix.diagonal_block(row);
      const bool     full  = active.is_fully_active(row);
      if (!full)
        for (unsigned int c = 0; c < dim; ++c)
          if (!active.is_active(row, c))
            {
              for (unsigned int d = 0; d < dim; ++d)
                block[c][d] = block[d][c] = 0.;
              block[c][c] = 1.;
            }
      block = invert(block);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          inverse[c * dim + d] =
            full || (active.is_active(row, c) && active.is_active(row, d)) ?
              block[c][d] :
              0.;
    }
  } // namespace



  template <int dim>
  LevelHierarchy<dim>::LevelHierarchy(
    std::vector<LevelDescription> descriptions)
  {
    levels.resize(descriptions.size());
    for (unsigned int l = 0; l < levels.size(); ++l)
      {
        Level &level      = levels[l];
        level.description = std::move(descriptions[l]);
        level.active      = level.description.fixed;
        level.solution    = level.description.nodes.make_vector();
        level.rhs         = level.solution;
        level.residual    = level.solution;
      }
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_terms(std::vector<BlockMatrix<dim>> terms)
  {
    Assert(!terms.empty(), ExcMessage("At least one term is needed."));
    levels.back().terms = std::move(terms);
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        Level &fine     = levels[l];
        Level &coarse   = levels[l - 1];
        fine.to_coarser = GalerkinProduct<dim>(fine.description.prolongation,
                                               fine.terms.front().sparsity());
        coarse.terms.clear();
        for (const BlockMatrix<dim> &term : fine.terms)
          {
            coarse.terms.emplace_back(fine.to_coarser.coarse_sparsity());
            fine.to_coarser.compute(term,
                                    fine.description.fixed,
                                    coarse.terms.back());
          }
      }
    for (Level &level : levels)
      {
        level.matrix = BlockMatrix<dim>(level.terms.front().shared_sparsity());
        level.inverse_diagonal.resize(level.matrix.n_rows() * dim * dim);
      }
    current_coefficients.clear();
    find_strips();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::find_strips()
  {
    // H and the truncation change the rows of the nonsmooth nodes and of
    // those coupled to them; on a coarser level also the rows that see such a
    // row of the finer one.
    std::vector<bool> in_strip;
    for (unsigned int l = levels.size(); l-- > 0;)
      {
        Level               &level    = levels[l];
        const BlockSparsity &sparsity = level.matrix.sparsity();
        std::vector<bool>    here(sparsity.n_rows(), false);
        for (const unsigned int i : level.description.nonsmooth_nodes)
          for (unsigned int k = sparsity.row_start[i];
               k < sparsity.row_start[i + 1];
               ++k)
            here[sparsity.column[k]] = true;
        if (l + 1 < levels.size())
          {
            const auto &Pt = levels[l + 1].description.prolongation.transpose();
            for (unsigned int I = 0; I < here.size(); ++I)
              for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1];
                   ++k)
                if (in_strip[Pt.column[k]])
                  here[I] = true;
          }
        level.strip.clear();
        for (unsigned int i = 0; i < here.size(); ++i)
          if (here[i])
            level.strip.push_back(i);
        in_strip = std::move(here);
      }
  }



  template <int dim>
  void
  LevelHierarchy<dim>::combine(const std::vector<double> &coefficients)
  {
    if (coefficients == current_coefficients)
      return;
    current_coefficients = coefficients;
    for (Level &level : levels)
      {
        std::vector<const BlockMatrix<dim> *> terms;
        for (const BlockMatrix<dim> &term : level.terms)
          terms.push_back(&term);
        level.matrix.combine(coefficients, terms);
        for (unsigned int i = 0; i < level.matrix.n_rows(); ++i)
          invert_diagonal_block(level.matrix,
                                i,
                                level.description.fixed,
                                &level.inverse_diagonal[i * dim * dim]);
      }
    is_linearised = false;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::linearise(const std::vector<Tensor<2, dim>> &hessians,
                                 const NodeMask                    &active)
  {
    Level &finest = levels.back();
    AssertDimension(hessians.size(), finest.description.nonsmooth_nodes.size());
    if (is_linearised && hessians == current_hessians &&
        active == finest.active)
      return;
    const bool keep_coarse_levels = is_linearised && levels.size() > 1 &&
                                    active == finest.active &&
                                    are_close(hessians, coarse_hessians);
    current_hessians = hessians;
    is_linearised    = false;
    finest.active    = active;

    // The finest matrix keeps the operator A itself: H is added for the time
    // of the product and stays in the inverse of the diagonal only.
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    std::vector<Tensor<2, dim>>      diagonal(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        diagonal[k] = finest.matrix.diagonal_block(nodes[k]);
        finest.matrix.set_diagonal_block(nodes[k], diagonal[k] + hessians[k]);
        invert_diagonal_block(finest.matrix,
                              nodes[k],
                              active,
                              &finest.inverse_diagonal[nodes[k] * dim * dim]);
      }
    const auto remove_hessians = [&]() {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        finest.matrix.set_diagonal_block(nodes[k], diagonal[k]);
    };
    if (!keep_coarse_levels)
      try
        {
          linearise_coarse_levels();
          coarse_hessians = hessians;
        }
      catch (const SingularCoarseMatrix &)
        {
          remove_hessians();
          throw;
        }
    remove_hessians();
    is_linearised = true;
  }



  template <int dim>
  bool
  LevelHierarchy<dim>::are_close(const std::vector<Tensor<2, dim>> &a,
                                 const std::vector<Tensor<2, dim>> &b) const
  {
    // A change far below the diagonal of the matrix is none, whatever it is
    // compared with.
    constexpr double                 negligible = 1e-2;
    const Level                     &finest     = levels.back();
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double size =
          b[k].norm() +
          negligible * finest.matrix.diagonal_block(nodes[k]).norm();
        // Written so that a NaN is not close.
        if (!((a[k] - b[k]).norm() <= coarse_update_threshold * size))
          return false;
      }
    return true;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::linearise_coarse_levels()
  {
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        Level &coarse = levels[l - 1];
        coarse.active = coarsen_mask(l, levels[l].active);
        levels[l].to_coarser.compute_rows(levels[l].matrix,
                                          levels[l].active,
                                          coarse.strip,
                                          coarse.matrix);
        for (const unsigned int i : coarse.strip)
          invert_diagonal_block(coarse.matrix,
                                i,
                                coarse.active,
                                &coarse.inverse_diagonal[i * dim * dim]);
      }
    coarse_solver.factorize(levels.front().matrix, levels.front().active);
  }



  template <int dim>
  NodeMask
  LevelHierarchy<dim>::coarsen_mask(const unsigned int l,
                                    const NodeMask    &fine) const
  {
    const LevelDescription &coarse = levels[l - 1].description;
    const auto             &Pt = levels[l].description.prolongation.transpose();
    const std::vector<unsigned int> &fine_nodes =
      levels[l].description.nonsmooth_nodes;

    NodeMask mask = coarse.fixed;
    for (const unsigned int I : coarse.nonsmooth_nodes)
      for (unsigned int c = 0; c < dim; ++c)
        {
          bool any_active = false;
          for (unsigned int k = Pt.row_start[I]; k < Pt.row_start[I + 1]; ++k)
            any_active |= fine.is_active(Pt.column[k], c) &&
                          std::binary_search(fine_nodes.begin(),
                                             fine_nodes.end(),
                                             Pt.column[k]);
          if (!any_active && mask.is_active(I, c))
            mask.mask(I, c);
        }
    return mask;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::vmult_linearised(NodalVector       &y,
                                        const NodalVector &x) const
  {
    const Level &finest = levels.back();
    finest.matrix.vmult(y, x);
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          y.local_element(nodes[k] * dim + c) +=
            current_hessians[k][c][d] * x.local_element(nodes[k] * dim + d);
    finest.active.apply(y);
  }



  template <int dim>
  void
  LevelHierarchy<dim>::v_cycle(NodalVector &x, const NodalVector &b)
  {
    Assert(is_linearised, ExcMessage("linearise() comes first."));
    ++cycle_count;
    cycle(levels.size() - 1, x, b);
  }



  template <int dim>
  void
  LevelHierarchy<dim>::cycle(const unsigned int l,
                             NodalVector       &x,
                             const NodalVector &b)
  {
    Level &level = levels[l];
    if (l == 0)
      {
        coarse_solver.solve(x, b);
        level.active.apply(x);
        return;
      }

    // On the finest level the diagonal of the matrix lacks H, see linearise().
    // Gauss-Seidel in the form x_i += D_i (b - A x)_i needs the whole
    // diagonal, so H is put there for the time of the cycle.
    const bool                       finest = (l + 1 == levels.size());
    const std::vector<unsigned int> &nodes  = level.description.nonsmooth_nodes;
    std::vector<Tensor<2, dim>>      diagonal;
    if (finest)
      {
        diagonal.resize(nodes.size());
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            diagonal[k] = level.matrix.diagonal_block(nodes[k]);
            level.matrix.set_diagonal_block(nodes[k],
                                            diagonal[k] + current_hessians[k]);
          }
      }

    const Kernels::BlockRows A = level.matrix.rows();
    const unsigned int       n = level.matrix.n_rows();
    x                          = 0.;
    for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
      Kernels::gauss_seidel_forward<dim>(
        A, level.inverse_diagonal.data(), 0, n, b.begin(), x.begin());

    level.matrix.residual(level.residual, b, x);
    level.active.apply(level.residual);
    Level &coarse = levels[l - 1];
    level.description.prolongation.restrict_to(coarse.rhs, level.residual, dim);
    coarse.active.apply(coarse.rhs);
    cycle(l - 1, coarse.solution, coarse.rhs);
    level.description.prolongation.prolongate_add(x, coarse.solution, dim);
    level.active.apply(x);

    for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
      Kernels::gauss_seidel_backward<dim>(
        A, level.inverse_diagonal.data(), 0, n, b.begin(), x.begin());

    if (finest)
      for (unsigned int k = 0; k < nodes.size(); ++k)
        level.matrix.set_diagonal_block(nodes[k], diagonal[k]);
  }



  template <int dim>
  const BlockMatrix<dim> &
  LevelHierarchy<dim>::matrix() const
  {
    return levels.back().matrix;
  }



  template <int dim>
  const BlockMatrix<dim> &
  LevelHierarchy<dim>::term(const unsigned int k) const
  {
    return levels.back().terms[k];
  }



  template <int dim>
  const AlignedVector<double> &
  LevelHierarchy<dim>::inverse_diagonal() const
  {
    return levels.back().inverse_diagonal;
  }



  template <int dim>
  const LevelDescription &
  LevelHierarchy<dim>::finest() const
  {
    return levels.back().description;
  }



  template <int dim>
  unsigned int
  LevelHierarchy<dim>::n_levels() const
  {
    return levels.size();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_coarse_update_threshold(const double threshold)
  {
    coarse_update_threshold = threshold;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_smoothing_sweeps(const unsigned int n)
  {
    sweeps = n;
  }



  template <int dim>
  unsigned long
  LevelHierarchy<dim>::n_cycles() const
  {
    return cycle_count;
  }



  template <int dim>
  std::size_t
  LevelHierarchy<dim>::memory_consumption() const
  {
    std::size_t bytes = 0;
    for (const Level &level : levels)
      {
        bytes += level.matrix.memory_consumption() +
                 level.matrix.sparsity().memory_consumption() +
                 level.description.prolongation.memory_consumption() +
                 sizeof(double) * (level.inverse_diagonal.size() +
                                   3 * level.rhs.locally_owned_size());
        for (const BlockMatrix<dim> &term : level.terms)
          bytes += term.memory_consumption();
      }
    return bytes;
  }



  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
} // namespace StickSlip
