// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/sweep_kernels.h>

namespace StickSlip
{
  namespace Kernels
  {
    namespace
    {
      /** Four numbers in one register, with the alignment of one of them. (An
       * extension of GCC and Clang.) */
      template <typename Number>
      struct Four
      {
        using type __attribute__((vector_size(4 * sizeof(Number)),
                                  aligned(sizeof(Number)))) = Number;
      };



      /** (y0, y1, y0, y1), by one instruction where the compiler is told that
       * two numbers are one of twice the size. */
      template <typename Number>
      inline typename Four<Number>::type
      twice(const Number *y)
      {
        using Pair __attribute__((vector_size(2 * sizeof(Number)),
                                  aligned(sizeof(Number)))) = Number;
        const Pair pair = *reinterpret_cast<const Pair *>(y);
        return __builtin_shufflevector(pair, pair, 0, 1, 0, 1);
      }



      /** A sum of products of blocks and vectors of one node. */
      template <int n_components, typename Number>
      class RowSum;



      template <typename Number>
      class RowSum<1, Number>
      {
      public:
        inline void
        add(const Number *block, const Number *y)
        {
          sum += *block * *y;
        }

        inline void
        get(Number *s) const
        {
          *s = sum;
        }

      private:
        Number sum = 0;
      };



      template <typename Number>
      class RowSum<2, Number>
      {
      public:
        inline void
        add(const Number *block, const Number *y)
        {
          sum += *reinterpret_cast<const Vector *>(block) * twice(y);
        }

        inline void
        get(Number *s) const
        {
          s[0] = sum[0] + sum[1];
          s[1] = sum[2] + sum[3];
        }

      private:
        using Vector = typename Four<Number>::type;
        Vector sum   = {};
      };



      template <typename Number>
      class RowSum<3, Number>
      {
      public:
        inline void
        add(const Number *block, const Number *y)
        {
          // The fourth entry belongs to the next column, or to nothing.
          sum_0 += *reinterpret_cast<const Vector *>(block) * y[0];
          sum_1 += *reinterpret_cast<const Vector *>(block + 3) * y[1];
          sum_2 += *reinterpret_cast<const Vector *>(block + 6) * y[2];
        }

        inline void
        get(Number *s) const
        {
          const Vector sum = sum_0 + sum_1 + sum_2;
          for (int c = 0; c < 3; ++c)
            s[c] = sum[c];
        }

      private:
        using Vector = typename Four<Number>::type;
        Vector sum_0 = {}, sum_1 = {}, sum_2 = {};
      };



      template <int n_components, typename Number>
      inline void
      add_row(RowSum<n_components, Number> &sum,
              const Triangle<Number>       &A,
              const unsigned int            row,
              const Number                 *x)
      {
        const unsigned int *column = A.column + A.column_start[row];
        for (unsigned int k = A.row_start[row]; k < A.row_start[row + 1];
             ++k, ++column)
          sum.add(A.values +
                    static_cast<unsigned long>(k) * n_components * n_components,
                  x + static_cast<unsigned long>(*column) * n_components);
      }



      /** The sum from the last entry to the first, as memory is read
       * backward. */
      template <int n_components, typename Number>
      inline void
      add_row_backward(RowSum<n_components, Number> &sum,
                       const Triangle<Number>       &A,
                       const unsigned int            row,
                       const Number                 *x)
      {
        const unsigned int *column = A.column + A.column_start[row] +
                                     (A.row_start[row + 1] - A.row_start[row]);
        for (unsigned int k = A.row_start[row + 1]; k > A.row_start[row]; --k)
          sum.add(A.values + static_cast<unsigned long>(k - 1) * n_components *
                               n_components,
                  x + static_cast<unsigned long>(*--column) * n_components);
      }



      /** x_i = D_i (b_i - sum) for one row i. */
      template <int n_components, typename Number>
      inline void
      relax(const RowSum<n_components, Number> &sum,
            const Number                       *inverse_diagonal,
            const unsigned int                  i,
            const Number                       *b,
            Number                             *x)
      {
        const unsigned long first =
          static_cast<unsigned long>(i) * n_components;
        Number s[n_components];
        sum.get(s);
        for (int c = 0; c < n_components; ++c)
          s[c] = b[first + c] - s[c];
        RowSum<n_components, Number> result;
        result.add(inverse_diagonal + first * n_components, s);
        result.get(s);
        for (int c = 0; c < n_components; ++c)
          x[first + c] = s[c];
      }



      /** s = b_i - sum for one row i. */
      template <int n_components, typename Number>
      inline void
      subtract(const RowSum<n_components, Number> &sum,
               const unsigned int                  i,
               const Number                       *b,
               Number                             *s)
      {
        Number values[n_components];
        sum.get(values);
        for (int c = 0; c < n_components; ++c)
          s[c] =
            b[static_cast<unsigned long>(i) * n_components + c] - values[c];
      }
    } // namespace



    template <int n_components, typename Number>
    void
    sweep_from_zero(const Triangle<Number> &lower,
                    const Number           *inverse_diagonal,
                    const unsigned int      begin,
                    const unsigned int      end,
                    const Number           *b,
                    Number                 *x)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          RowSum<n_components, Number> sum;
          add_row(sum, lower, i, x);
          relax(sum, inverse_diagonal, i, b, x);
        }
    }



    template <int n_components, typename Number>
    void
    residual_after_sweep(const Triangle<Number> &upper,
                         const unsigned int      n,
                         const Number           *x,
                         Number                 *r)
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          RowSum<n_components, Number> sum;
          add_row(sum, upper, i, x);
          Number s[n_components];
          sum.get(s);
          for (int c = 0; c < n_components; ++c)
            r[static_cast<unsigned long>(i) * n_components + c] = -s[c];
        }
    }



    template <int n_components, typename Number>
    void
    sweep_forward(const Triangle<Number> &lower,
                  const Triangle<Number> &upper,
                  const Number           *inverse_diagonal,
                  const unsigned int      begin,
                  const unsigned int      end,
                  const Number           *b,
                  Number                 *x)
    {
      for (unsigned int i = begin; i < end; ++i)
        {
          // The part that depends on the row just done comes last.
          RowSum<n_components, Number> sum;
          add_row(sum, upper, i, x);
          add_row(sum, lower, i, x);
          relax(sum, inverse_diagonal, i, b, x);
        }
    }



    template <int n_components, typename Number>
    void
    sweep_backward(const Triangle<Number> &lower,
                   const Triangle<Number> &upper,
                   const Number           *inverse_diagonal,
                   const unsigned int      begin,
                   const unsigned int      end,
                   const Number           *b,
                   Number                 *x)
    {
      for (unsigned int i = end; i-- > begin;)
        {
          RowSum<n_components, Number> sum;
          add_row_backward(sum, lower, i, x);
          add_row_backward(sum, upper, i, x);
          relax(sum, inverse_diagonal, i, b, x);
        }
    }



    template <int n_components, typename Number>
    void
    remainder_below(const Triangle<Number> &lower,
                    const unsigned int     *rows,
                    const unsigned int      n,
                    const Number           *b,
                    const Number           *x,
                    Number                 *s)
    {
      for (unsigned int k = 0; k < n; ++k)
        {
          RowSum<n_components, Number> sum;
          add_row(sum, lower, rows[k], x);
          subtract(sum,
                   rows[k],
                   b,
                   s + static_cast<unsigned long>(k) * n_components);
        }
    }



    template <int n_components, typename Number>
    void
    remainder_beside(const Triangle<Number> &lower,
                     const Triangle<Number> &upper,
                     const unsigned int     *rows,
                     const unsigned int      n,
                     const Number           *b,
                     const Number           *x,
                     Number                 *s)
    {
      for (unsigned int k = 0; k < n; ++k)
        {
          RowSum<n_components, Number> sum;
          add_row(sum, upper, rows[k], x);
          add_row(sum, lower, rows[k], x);
          subtract(sum,
                   rows[k],
                   b,
                   s + static_cast<unsigned long>(k) * n_components);
        }
    }



#define STICKSLIP_INSTANTIATE(n_components, Number)                            \
  template void remainder_below<n_components, Number>(                         \
    const Triangle<Number> &,                                                  \
    const unsigned int *,                                                      \
    const unsigned int,                                                        \
    const Number *,                                                            \
    const Number *,                                                            \
    Number *);                                                                 \
  template void remainder_beside<n_components, Number>(                        \
    const Triangle<Number> &,                                                  \
    const Triangle<Number> &,                                                  \
    const unsigned int *,                                                      \
    const unsigned int,                                                        \
    const Number *,                                                            \
    const Number *,                                                            \
    Number *);                                                                 \
  template void sweep_from_zero<n_components, Number>(                         \
    const Triangle<Number> &,                                                  \
    const Number *,                                                            \
    const unsigned int,                                                        \
    const unsigned int,                                                        \
    const Number *,                                                            \
    Number *);                                                                 \
  template void residual_after_sweep<n_components, Number>(                    \
    const Triangle<Number> &, const unsigned int, const Number *, Number *);   \
  template void sweep_forward<n_components, Number>(const Triangle<Number> &,  \
                                                    const Triangle<Number> &,  \
                                                    const Number *,            \
                                                    const unsigned int,        \
                                                    const unsigned int,        \
                                                    const Number *,            \
                                                    Number *);                 \
  template void sweep_backward<n_components, Number>(const Triangle<Number> &, \
                                                     const Triangle<Number> &, \
                                                     const Number *,           \
                                                     const unsigned int,       \
                                                     const unsigned int,       \
                                                     const Number *,           \
                                                     Number *);

    STICKSLIP_INSTANTIATE(1, float)
    STICKSLIP_INSTANTIATE(2, float)
    STICKSLIP_INSTANTIATE(1, double)
    STICKSLIP_INSTANTIATE(2, double)
    STICKSLIP_INSTANTIATE(3, float)
    STICKSLIP_INSTANTIATE(3, double)
#undef STICKSLIP_INSTANTIATE
  } // namespace Kernels
} // namespace StickSlip
