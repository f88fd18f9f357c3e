// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/block_kernels.h>

namespace StickSlip
{
  namespace Kernels
  {
    namespace
    {
      /** s_c -= (sum_j A_ij x_j)_c for one row i. */
      template <int dim>
      inline void
      subtract_row(const BlockRows   &A,
                   const unsigned int row,
                   const double      *x,
                   double            *s)
      {
        // One accumulator for each entry of a block: the products of a block
        // are independent of each other and vectorise.
        double sum[dim * dim] = {};
        for (unsigned int k = A.row_start[row]; k < A.row_start[row + 1]; ++k)
          {
            const double *a =
              A.values + static_cast<unsigned long>(k) * dim * dim;
            const double *y = x + static_cast<unsigned long>(A.column[k]) * dim;
            for (int c = 0; c < dim; ++c)
              for (int d = 0; d < dim; ++d)
                sum[c * dim + d] += a[c * dim + d] * y[d];
          }
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            s[c] -= sum[c * dim + d];
      }



      template <int dim>
      inline void
      relax_row(const BlockRows   &A,
                const double      *inverse_diagonal,
                const unsigned int i,
                const double      *b,
                double            *x)
      {
        double s[dim];
        for (int c = 0; c < dim; ++c)
          s[c] = b[i * dim + c];
        subtract_row<dim>(A, i, x, s);
        const double *D =
          inverse_diagonal + static_cast<unsigned long>(i) * dim * dim;
        for (int c = 0; c < dim; ++c)
          for (int d = 0; d < dim; ++d)
            x[i * dim + c] += D[c * dim + d] * s[d];
      }
    } // namespace



    template <int dim>
    void
    vmult(const BlockRows   &A,
          const unsigned int begin,
          const unsigned int end,
          const double      *x,
          double            *y)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          double s[dim] = {};
          subtract_row<dim>(A, i, x, s);
          for (int c = 0; c < dim; ++c)
            y[i * dim + c] = -s[c];
        }
    }



    template <int dim>
    void
    residual(const BlockRows   &A,
             const unsigned int begin,
             const unsigned int end,
             const double      *b,
             const double      *x,
             double            *r)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          double s[dim];
          for (int c = 0; c < dim; ++c)
            s[c] = b[i * dim + c];
          subtract_row<dim>(A, i, x, s);
          for (int c = 0; c < dim; ++c)
            r[i * dim + c] = s[c];
        }
    }



    template <int dim>
    void
    gauss_seidel_forward(const BlockRows   &A,
                         const double      *inverse_diagonal,
                         const unsigned int begin,
                         const unsigned int end,
                         const double      *b,
                         double            *x)
    {
      for (unsigned int i = begin; i < end; ++i)
        relax_row<dim>(A, inverse_diagonal, i, b, x);
    }



    template <int dim>
    void
    gauss_seidel_backward(const BlockRows   &A,
                          const double      *inverse_diagonal,
                          const unsigned int begin,
                          const unsigned int end,
                          const double      *b,
                          double            *x)
    {
      for (unsigned int i = end; i > begin; --i)
        relax_row<dim>(A, inverse_diagonal, i - 1, b, x);
    }



    void
    linear_combination(const unsigned int   n_terms,
                       const double        *coefficients,
                       const double *const *terms,
                       const unsigned long  size,
                       double              *result)
    {
      // The usual case, mass, damping and stiffness, in one pass.
      if (n_terms == 3)
        {
          const double c0 = coefficients[0], c1 = coefficients[1],
                       c2  = coefficients[2];
          const double *t0 = terms[0], *t1 = terms[1], *t2 = terms[2];
          for (unsigned long i = 0; i < size; ++i)
            result[i] = c0 * t0[i] + c1 * t1[i] + c2 * t2[i];
          return;
        }
      for (unsigned long i = 0; i < size; ++i)
        result[i] = 0;
      for (unsigned int k = 0; k < n_terms; ++k)
        for (unsigned long i = 0; i < size; ++i)
          result[i] += coefficients[k] * terms[k][i];
    }



#define STICKSLIP_INSTANTIATE(dim)                             \
  template void vmult<dim>(const BlockRows &,                  \
                           const unsigned int,                 \
                           const unsigned int,                 \
                           const double *,                     \
                           double *);                          \
  template void residual<dim>(const BlockRows &,               \
                              const unsigned int,              \
                              const unsigned int,              \
                              const double *,                  \
                              const double *,                  \
                              double *);                       \
  template void gauss_seidel_forward<dim>(const BlockRows &,   \
                                          const double *,      \
                                          const unsigned int,  \
                                          const unsigned int,  \
                                          const double *,      \
                                          double *);           \
  template void gauss_seidel_backward<dim>(const BlockRows &,  \
                                           const double *,     \
                                           const unsigned int, \
                                           const unsigned int, \
                                           const double *,     \
                                           double *);

    STICKSLIP_INSTANTIATE(2)
    STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE
  } // namespace Kernels
} // namespace StickSlip
