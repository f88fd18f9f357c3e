// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/local_products.h>

extern "C"
{
  double
  ddot_(const int    *n,
        const double *x,
        const int    *stride_of_x,
        const double *y,
        const int    *stride_of_y);
}

namespace StickSlip
{
  double
  local_product(const NodalVector &a, const NodalVector &b)
  {
    AssertDimension(a.locally_owned_size(), b.locally_owned_size());
    const int n = a.locally_owned_size(), one = 1;
    return ddot_(&n, a.begin(), &one, b.begin(), &one);
  }



  template <std::size_t n>
  std::array<double, n>
  sums(const std::array<double, n> &parts, const MPI_Comm communicator)
  {
    std::array<double, n> result = parts;
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      Utilities::MPI::sum(ArrayView<const double>(parts.data(), n),
                          communicator,
                          ArrayView<double>(result.data(), n));
    return result;
  }



  template std::array<double, 2>
  sums<2>(const std::array<double, 2> &, const MPI_Comm);
  template std::array<double, 3>
  sums<3>(const std::array<double, 3> &, const MPI_Comm);
  template std::array<double, 5>
  sums<5>(const std::array<double, 5> &, const MPI_Comm);
  template std::array<double, 7>
  sums<7>(const std::array<double, 7> &, const MPI_Comm);
} // namespace StickSlip
