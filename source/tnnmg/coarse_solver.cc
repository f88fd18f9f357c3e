// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <stickslip/tnnmg/coarse_solver.h>

namespace StickSlip
{
  template <int dim>
  struct CoarseSolver<dim>::Implementation
  {
    /** The library's matrix, and whose sparsity it was made from. */
    const BlockSparsity *source = nullptr;
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;

    SparseDirectUMFPACK lu;
    Vector<double>      solution;

    void
    reinit(const BlockSparsity &sparsity)
    {
      const unsigned int     n = sparsity.n_rows() * dim;
      DynamicSparsityPattern dsp(n, n);
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              dsp.add(i * dim + c, sparsity.column[k] * dim + d);
      pattern.copy_from(dsp);
      matrix.reinit(pattern);
      solution.reinit(n);
      source = &sparsity;
    }
  };



  template <int dim>
  CoarseSolver<dim>::CoarseSolver()
    : implementation(std::make_unique<Implementation>())
  {}



  template <int dim>
  CoarseSolver<dim>::~CoarseSolver() = default;



  template <int dim>
  CoarseSolver<dim>::CoarseSolver(CoarseSolver &&) noexcept = default;



  template <int dim>
  CoarseSolver<dim> &
  CoarseSolver<dim>::operator=(CoarseSolver &&) noexcept = default;



  template <int dim>
  void
  CoarseSolver<dim>::factorize(const BlockMatrix<dim> &matrix,
                               const NodeMask         &mask)
  {
    const BlockSparsity &sparsity = matrix.sparsity();
    if (implementation->source != &sparsity)
      implementation->reinit(sparsity);
    SparseMatrix<double> &target = implementation->matrix;
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          const unsigned int j = sparsity.column[k];
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              target.set(i * dim + c,
                         j * dim + d,
                         mask.is_active(i, c) && mask.is_active(j, d) ?
                           matrix.block(k)[c * dim + d] :
                           (i == j && c == d ? 1. : 0.));
        }
    try
      {
        implementation->lu.factorize(target);
      }
    catch (const SparseDirectUMFPACK::ExcUMFPACKError &)
      {
        throw SingularCoarseMatrix();
      }
  }



  template <int dim>
  void
  CoarseSolver<dim>::solve(NodalVector &x, const NodalVector &b)
  {
    Vector<double> &solution = implementation->solution;
    std::copy_n(b.begin(), solution.size(), solution.begin());
    implementation->lu.solve(solution);
    std::copy_n(solution.begin(), solution.size(), x.begin());
  }



  template class CoarseSolver<2>;
  template class CoarseSolver<3>;
} // namespace StickSlip
