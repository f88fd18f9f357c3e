// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/serial_order.h>

#include <algorithm>
#include <cstdint>

namespace StickSlip
{
  namespace
  {
    /** The values of each process, on the first one. */
    template <typename Number>
    std::vector<std::vector<Number>>
    parts_of_all(const MPI_Comm            &communicator,
                 const std::vector<Number> &values)
    {
      // A message to oneself would be compressed and expanded.
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return {values};
      return Utilities::MPI::gather(communicator, values);
    }
  } // namespace



  SerialOrder::SerialOrder(const std::vector<types::global_dof_index> &places,
                           const types::global_dof_index               n_items,
                           const MPI_Comm &communicator)
    : communicator(communicator)
    , n_items(n_items)
    , places(parts_of_all(communicator, places))
  {}



  template <typename Number>
  std::vector<Number>
  SerialOrder::gather(const std::vector<Number> &values,
                      const unsigned int         n_values) const
  {
    const std::vector<std::vector<Number>> parts =
      parts_of_all(communicator, values);
    std::vector<Number> result;
    if (parts.empty())
      return result;
    result.resize(n_items * n_values);
    for (unsigned int p = 0; p < parts.size(); ++p)
      for (std::size_t i = 0; i < places[p].size(); ++i)
        std::copy_n(parts[p].begin() + i * n_values,
                    n_values,
                    result.begin() + places[p][i] * n_values);
    return result;
  }



  template std::vector<double>
  SerialOrder::gather(const std::vector<double> &, const unsigned int) const;
  template std::vector<std::int64_t>
  SerialOrder::gather(const std::vector<std::int64_t> &,
                      const unsigned int) const;
} // namespace StickSlip
