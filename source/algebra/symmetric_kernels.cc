// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/symmetric_kernels.h>

namespace StickSlip
{
  namespace Kernels
  {
    template <int n_components>
    void
    symmetric_vmult(const UpperTriangle &A, const double *x, double *y)
    {
      constexpr int n_entries = n_components * n_components;
      for (unsigned long k = 0;
           k < static_cast<unsigned long>(A.n_rows) * n_components;
           ++k)
        y[k] = 0.;
      const double *a = A.values;
      for (unsigned int i = 0; i < A.n_rows; ++i)
        {
          double x_i[n_components], y_i[n_components] = {};
          for (int c = 0; c < n_components; ++c)
            x_i[c] = x[static_cast<unsigned long>(i) * n_components + c];
          for (unsigned int k = A.diagonal[i]; k < A.row_start[i + 1];
               ++k, a += n_entries)
            {
              const unsigned int j = A.column[k];
              const double      *x_j =
                x + static_cast<unsigned long>(j) * n_components;
              for (int c = 0; c < n_components; ++c)
                for (int d = 0; d < n_components; ++d)
                  y_i[c] += a[c * n_components + d] * x_j[d];
              if (j == i || j >= A.n_rows)
                continue;
              double *y_j = y + static_cast<unsigned long>(j) * n_components;
              for (int c = 0; c < n_components; ++c)
                for (int d = 0; d < n_components; ++d)
                  y_j[d] += a[c * n_components + d] * x_i[c];
            }
          for (int c = 0; c < n_components; ++c)
            y[static_cast<unsigned long>(i) * n_components + c] += y_i[c];
        }
    }



    template <int n_components>
    double
    quadratic_form(const UpperTriangle &A, const double *x)
    {
      constexpr int n_entries = n_components * n_components;
      // Sums over all rows of each entry of a block, added up at the end.
      double sum[n_entries] = {};
      // Products of a block are independent of each other and vectorise: s +=
      // the block at a position times the part of x that it belongs to.
      const double *a      = A.values;
      const auto    add_to = [&](const unsigned int position, double *s) {
        const double *x_j =
          x + static_cast<unsigned long>(A.column[position]) * n_components;
        for (int c = 0; c < n_components; ++c)
          for (int d = 0; d < n_components; ++d)
            s[c * n_components + d] += a[c * n_components + d] * x_j[d];
        a += n_entries;
      };
      for (unsigned int i = 0; i < A.n_rows; ++i)
        {
          // Blocks that count once: the diagonal and those of ghosts.
          double       once[n_entries] = {}, twice[n_entries] = {};
          unsigned int position = A.diagonal[i];
          add_to(position++, once);
          for (; position < A.row_start[i + 1] && A.column[position] < A.n_rows;
               ++position)
            add_to(position, twice);
          for (; position < A.row_start[i + 1]; ++position)
            add_to(position, once);
          const double *x_i = x + static_cast<unsigned long>(i) * n_components;
          for (int c = 0; c < n_components; ++c)
            for (int d = 0; d < n_components; ++d)
              sum[c * n_components + d] +=
                x_i[c] *
                (once[c * n_components + d] + 2. * twice[c * n_components + d]);
        }
      double total = 0.;
      for (const double of_entry : sum)
        total += of_entry;
      return total;
    }



#define STICKSLIP_INSTANTIATE(n)                            \
  template void   symmetric_vmult<n>(const UpperTriangle &, \
                                   const double *,        \
                                   double *);             \
  template double quadratic_form<n>(const UpperTriangle &, const double *);

    STICKSLIP_INSTANTIATE(1)
    STICKSLIP_INSTANTIATE(2)
    STICKSLIP_INSTANTIATE(3)
  } // namespace Kernels
} // namespace StickSlip
