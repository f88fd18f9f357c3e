// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/form_kernels.h>

namespace StickSlip
{
  namespace Kernels
  {
    namespace
    {
      /** s += the block at a position times the part of x that it belongs to,
       * entry by entry: products of a block are independent of each other and
       * vectorise. */
      template <int n_components>
      inline void
      add_block(const BlockRows<double> &A,
                const unsigned int       position,
                const double            *x,
                double                  *s)
      {
        const double *a = A.values + static_cast<unsigned long>(position) *
                                       n_components * n_components;
        const double *y =
          x + static_cast<unsigned long>(A.column[position]) * n_components;
        for (int c = 0; c < n_components; ++c)
          for (int d = 0; d < n_components; ++d)
            s[c * n_components + d] += a[c * n_components + d] * y[d];
      }
    } // namespace



    template <int n_components>
    double
    quadratic_form(const BlockRows<double> &A,
                   const unsigned int      *diagonal,
                   const unsigned int       n_rows,
                   const double            *x)
    {
      constexpr int n_entries = n_components * n_components;
      double        total     = 0.;
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          // Blocks that count once: the diagonal and those of ghosts.
          double once[n_entries] = {}, twice[n_entries] = {};
          add_block<n_components>(A, diagonal[i], x, once);
          unsigned int       position = diagonal[i] + 1;
          const unsigned int end      = A.row_start[i + 1];
          for (; position < end && A.column[position] < n_rows; ++position)
            add_block<n_components>(A, position, x, twice);
          for (; position < end; ++position)
            add_block<n_components>(A, position, x, once);
          for (int c = 0; c < n_components; ++c)
            {
              double of_row = 0.;
              for (int d = 0; d < n_components; ++d)
                of_row +=
                  once[c * n_components + d] + 2. * twice[c * n_components + d];
              total += x[i * n_components + c] * of_row;
            }
        }
      return total;
    }



    template double
    quadratic_form<1>(const BlockRows<double> &,
                      const unsigned int *,
                      const unsigned int,
                      const double *);
    template double
    quadratic_form<2>(const BlockRows<double> &,
                      const unsigned int *,
                      const unsigned int,
                      const double *);
    template double
    quadratic_form<3>(const BlockRows<double> &,
                      const unsigned int *,
                      const unsigned int,
                      const double *);
  } // namespace Kernels
} // namespace StickSlip
