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
      template <int n_components, typename Number>
      inline void
      subtract_row(const BlockRows<Number> &A,
                   const unsigned int       row,
                   const Number            *x,
                   Number                  *s)
      {
        // One accumulator for each entry of a block: the products of a block
        // are independent of each other and vectorise.
        Number sum[n_components * n_components] = {};
        for (unsigned int k = A.row_start[row]; k < A.row_start[row + 1]; ++k)
          {
            const Number *a = A.values + static_cast<unsigned long>(k) *
                                           n_components * n_components;
            const Number *y =
              x + static_cast<unsigned long>(A.column[k]) * n_components;
            for (int c = 0; c < n_components; ++c)
              for (int d = 0; d < n_components; ++d)
                sum[c * n_components + d] += a[c * n_components + d] * y[d];
          }
        for (int c = 0; c < n_components; ++c)
          for (int d = 0; d < n_components; ++d)
            s[c] -= sum[c * n_components + d];
      }
    } // namespace



    template <int n_components, typename Number>
    void
    vmult(const BlockRows<Number> &A,
          const unsigned int       begin,
          const unsigned int       end,
          const Number            *x,
          Number                  *y)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          Number s[n_components] = {};
          subtract_row<n_components>(A, i, x, s);
          for (int c = 0; c < n_components; ++c)
            y[i * n_components + c] = -s[c];
        }
    }



    template <int n_components, typename Number>
    void
    vmult_by_numbers(const BlockRows<Number> &A,
                     const unsigned int       n,
                     const Number            *x,
                     Number                  *y)
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          Number s[n_components] = {};
          for (unsigned int k = A.row_start[i]; k < A.row_start[i + 1]; ++k)
            for (int c = 0; c < n_components; ++c)
              s[c] +=
                A.values[k] *
                x[static_cast<unsigned long>(A.column[k]) * n_components + c];
          for (int c = 0; c < n_components; ++c)
            y[i * n_components + c] = s[c];
        }
    }



    template <int n_components, typename Number>
    void
    residual(const BlockRows<Number> &A,
             const unsigned int       begin,
             const unsigned int       end,
             const Number            *b,
             const Number            *x,
             Number                  *r)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          Number s[n_components];
          for (int c = 0; c < n_components; ++c)
            s[c] = b[i * n_components + c];
          subtract_row<n_components>(A, i, x, s);
          for (int c = 0; c < n_components; ++c)
            r[i * n_components + c] = s[c];
        }
    }



    template <int n_components, typename Number>
    void
    add_numbers(const Number        factor,
                const Number       *numbers,
                const unsigned long n,
                Number             *blocks)
    {
      for (unsigned long k = 0; k < n; ++k)
        {
          const Number value = factor * numbers[k];
          for (int c = 0; c < n_components; ++c)
            blocks[k * n_components * n_components + c * (n_components + 1)] +=
              value;
        }
    }



    template <typename Number>
    void
    linear_combination(const unsigned int   n_terms,
                       const double        *coefficients,
                       const Number *const *terms,
                       const unsigned long  size,
                       Number              *result)
    {
      // The usual cases in one pass: damping and stiffness, and mass as well.
      if (n_terms == 2)
        {
          const Number  c0 = coefficients[0], c1 = coefficients[1];
          const Number *t0 = terms[0], *t1 = terms[1];
          for (unsigned long i = 0; i < size; ++i)
            result[i] = c0 * t0[i] + c1 * t1[i];
          return;
        }
      if (n_terms == 3)
        {
          const Number c0 = coefficients[0], c1 = coefficients[1],
                       c2  = coefficients[2];
          const Number *t0 = terms[0], *t1 = terms[1], *t2 = terms[2];
          for (unsigned long i = 0; i < size; ++i)
            result[i] = c0 * t0[i] + c1 * t1[i] + c2 * t2[i];
          return;
        }
      for (unsigned long i = 0; i < size; ++i)
        result[i] = 0;
      for (unsigned int k = 0; k < n_terms; ++k)
        for (unsigned long i = 0; i < size; ++i)
          result[i] += Number(coefficients[k]) * terms[k][i];
    }



#define STICKSLIP_INSTANTIATE(n_components, Number)                       \
  template void vmult<n_components, Number>(const BlockRows<Number> &,    \
                                            const unsigned int,           \
                                            const unsigned int,           \
                                            const Number *,               \
                                            Number *);                    \
  template void residual<n_components, Number>(const BlockRows<Number> &, \
                                               const unsigned int,        \
                                               const unsigned int,        \
                                               const Number *,            \
                                               const Number *,            \
                                               Number *);

    STICKSLIP_INSTANTIATE(1, float)
    STICKSLIP_INSTANTIATE(2, float)
    STICKSLIP_INSTANTIATE(1, double)
    STICKSLIP_INSTANTIATE(2, double)
    STICKSLIP_INSTANTIATE(3, float)
    STICKSLIP_INSTANTIATE(3, double)
#undef STICKSLIP_INSTANTIATE

#define STICKSLIP_INSTANTIATE(n_components)                            \
  template void add_numbers<n_components, double>(const double,        \
                                                  const double *,      \
                                                  const unsigned long, \
                                                  double *);           \
  template void vmult_by_numbers<n_components, double>(                \
    const BlockRows<double> &, const unsigned int, const double *, double *);

    STICKSLIP_INSTANTIATE(1)
    STICKSLIP_INSTANTIATE(2)
    STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE

    template void
    linear_combination<float>(const unsigned int,
                              const double *,
                              const float *const *,
                              const unsigned long,
                              float *);
    template void
    linear_combination<double>(const unsigned int,
                               const double *,
                               const double *const *,
                               const unsigned long,
                               double *);
  } // namespace Kernels
} // namespace StickSlip
