// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_free_vibration_h
#define stickslip_tests_free_vibration_h

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "stuck_faults.h"

namespace StickSlip::Tests
{
  /** An eigenvector of K u = omega^2 M u on a free body, with a largest
   * component of one, and its omega. @p number counts from the lowest one; the
   * three rigid motions come first. */
  inline std::pair<NodalVector, double>
  free_vibration(const SpatialProblem<2> &problem, const unsigned int number)
  {
    NodalVector              shape = problem.make_vector();
    const unsigned int       n     = shape.size();
    LAPACKFullMatrix<double> K(n), M(n);
    const auto               expand = [](LAPACKFullMatrix<double> &full,
                           const TermMatrix<2>      &A) {
      for (unsigned int i = 0; i < A.n_rows(); ++i)
        for (unsigned int k = A.sparsity().row_start[i];
             k < A.sparsity().row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              full(i * 2 + c, A.sparsity().column[k] * 2 + d) =
                A.entry(i, k)[c][d];
    };
    expand(K, problem.term(SpatialProblem<2>::stiffness));
    expand(M, problem.term(SpatialProblem<2>::mass));
    std::vector<Vector<double>> modes(number + 1, Vector<double>(n));
    K.compute_generalized_eigenvalues_symmetric(M, modes);
    for (unsigned int i = 0; i < n; ++i)
      shape.local_element(i) = modes[number][i];
    shape /= shape.linfty_norm();

    const double omega_square = K.eigenvalue(number).real();
    // Three rigid motions, then elasticity.
    EXPECT_LT(std::abs(K.eigenvalue(2).real()), 1e-8 * omega_square);
    return {shape, std::sqrt(omega_square)};
  }
} // namespace StickSlip::Tests

#endif
