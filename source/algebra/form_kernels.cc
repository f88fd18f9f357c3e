// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/form_kernels.h>

namespace StickSlip
{
  namespace Kernels
  {
    template <int n_components>
    double
    quadratic_form(const BlockRows<double> &A,
                   const unsigned int      *diagonal,
                   const unsigned int       n_rows,
                   const double            *x)
    {
      constexpr int n_entries = n_components * n_components;
      // Sums over all rows of each entry of a block, added up at the end.
      double sum[n_entries] = {};
      // Products of a block are independent of each other and vectorise: s +=
      // the block at a position times the part of x that it belongs to.
      const auto add_to = [&](const unsigned int position, double *s) {
        const double *a =
          A.values + static_cast<unsigned long>(position) * n_entries;
        const double *y =
          x + static_cast<unsigned long>(A.column[position]) * n_components;
        for (int c = 0; c < n_components; ++c)
          for (int d = 0; d < n_components; ++d)
            s[c * n_components + d] += a[c * n_components + d] * y[d];
      };
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          // Blocks that count once: the diagonal and those of ghosts.
          double once[n_entries] = {}, twice[n_entries] = {};
          add_to(diagonal[i], once);
          unsigned int end = A.row_start[i + 1];
          for (; A.column[end - 1] >= n_rows; --end)
            add_to(end - 1, once);
          for (unsigned int position = diagonal[i] + 1; position < end;
               ++position)
            add_to(position, twice);
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
