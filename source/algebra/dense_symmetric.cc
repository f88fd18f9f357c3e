// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/algebra/dense_symmetric.h>

extern "C"
{
  void
  dsymv_(const char   *triangle,
         const int    *n,
         const double *alpha,
         const double *A,
         const int    *stride_of_A,
         const double *x,
         const int    *stride_of_x,
         const double *beta,
         double       *y,
         const int    *stride_of_y);

  void
  dgemv_(const char   *transposition,
         const int    *m,
         const int    *n,
         const double *alpha,
         const double *A,
         const int    *stride_of_A,
         const double *x,
         const int    *stride_of_x,
         const double *beta,
         double       *y,
         const int    *stride_of_y);

  void
  daxpy_(const int    *n,
         const double *alpha,
         const double *x,
         const int    *stride_of_x,
         double       *y,
         const int    *stride_of_y);

  void
  dpotrf_(const char *triangle,
          const int  *n,
          double     *A,
          const int  *stride_of_A,
          int        *info);

  void
  dtrsv_(const char   *triangle,
         const char   *transposition,
         const char   *diagonal,
         const int    *n,
         const double *A,
         const int    *stride_of_A,
         double       *x,
         const int    *stride_of_x);
}

namespace StickSlip
{
  namespace
  {
    constexpr int one = 1;

    // Fortran counts columns first: the upper triangle is its lower one.
    constexpr char triangle = 'L';



    /** y = factor A x, for rows that begin @p stride numbers after each other.
     */
    void
    symmetric_product(std::vector<double>       &y,
                      const double               factor,
                      const double              *A,
                      const std::size_t          stride,
                      const std::vector<double> &x)
    {
      const int        n = x.size(), distance = stride;
      constexpr double zero = 0.;
      y.assign(n, 0.);
      if (n > 0)
        dsymv_(&triangle,
               &n,
               &factor,
               A,
               &distance,
               x.data(),
               &one,
               &zero,
               y.data(),
               &one);
    }
  } // namespace



  void
  multiply_symmetric(std::vector<double>       &y,
                     const double               factor,
                     const std::vector<double> &A,
                     const std::vector<double> &x)
  {
    AssertDimension(A.size(), x.size() * x.size());
    symmetric_product(y, factor, A.data(), x.size(), x);
  }



  void
  multiply_symmetric_part(std::vector<double>       &y,
                          const double              *A,
                          const std::size_t          stride,
                          const std::vector<double> &x)
  {
    symmetric_product(y, 1., A, stride, x);
  }



  void
  multiply_rows(std::vector<double>       &y,
                const unsigned int         n_rows,
                const double              *A,
                const std::size_t          stride,
                const std::vector<double> &x)
  {
    const int        rows = n_rows, columns = x.size(), distance = stride;
    constexpr double factor = 1., zero = 0.;
    y.assign(n_rows, 0.);
    if (rows > 0 && columns > 0)
      dgemv_("T",
             &columns,
             &rows,
             &factor,
             A,
             &distance,
             x.data(),
             &one,
             &zero,
             y.data(),
             &one);
  }



  void
  add_multiple(double            *y,
               const double       factor,
               const double      *x,
               const unsigned int n)
  {
    const int size = n;
    daxpy_(&size, &factor, x, &one, y, &one);
  }



  void
  factorise_symmetric(std::vector<double> &A,
                      const unsigned int   n,
                      const char          *name)
  {
    const int size = n;
    int       info = 0;
    if (n > 0)
      dpotrf_(&triangle, &size, A.data(), &size, &info);
    if (info != 0)
      throw SingularMatrix(name);
  }



  void
  solve_factorised(const std::vector<double> &factors, std::vector<double> &b)
  {
    const int n = b.size();
    AssertDimension(factors.size(), b.size() * b.size());
    if (n == 0)
      return;
    for (const char transposition : {'N', 'T'})
      dtrsv_(
        &triangle, &transposition, "N", &n, factors.data(), &n, b.data(), &one);
  }
} // namespace StickSlip
