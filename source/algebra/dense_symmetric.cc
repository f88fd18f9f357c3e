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
  } // namespace



  void
  multiply_symmetric(std::vector<double>       &y,
                     const double               factor,
                     const std::vector<double> &A,
                     const std::vector<double> &x)
  {
    const int        n    = x.size();
    constexpr double zero = 0.;
    AssertDimension(A.size(), x.size() * x.size());
    y.assign(n, 0.);
    if (n > 0)
      dsymv_(&triangle,
             &n,
             &factor,
             A.data(),
             &n,
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
