// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/condensed/schur_complement.h>

#include <algorithm>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** Global numbers of the entries of all processes, one after the other. */
    std::vector<types::global_dof_index>
    global_entries(const NodePartition             &nodes,
                   const std::vector<unsigned int> &entries)
    {
      const unsigned int                   n = nodes.n_components();
      std::vector<types::global_dof_index> here, all;
      for (const unsigned int entry : entries)
        here.push_back(nodes.global_index(entry / n) * n + entry % n);
      for (const auto &part :
           Utilities::MPI::all_gather(nodes.communicator(), here))
        all.insert(all.end(), part.begin(), part.end());
      return all;
    }



    std::vector<types::global_dof_index>
    both(std::vector<types::global_dof_index>        first,
         const std::vector<types::global_dof_index> &second)
    {
      first.insert(first.end(), second.begin(), second.end());
      return first;
    }



    std::vector<int>
    sums_before(const std::vector<int> &numbers)
    {
      std::vector<int> result(numbers.size(), 0);
      std::partial_sum(numbers.begin(), numbers.end() - 1, result.begin() + 1);
      return result;
    }



    /** Send each process its rows of a matrix that the first one has, whose
     * rows of all processes follow each other from number @p first_row on.
     * Returns them, with @p n_columns numbers each. */
    std::vector<double>
    scattered_rows(const std::vector<double> &matrix,
                   const unsigned int         size,
                   const unsigned int         first_row,
                   const unsigned int         n_columns,
                   const std::vector<int>    &n_of_process,
                   const MPI_Comm             communicator)
    {
      constexpr int tag = 1710;
      MPI_Datatype  row_type;
      MPI_Type_contiguous(n_columns, MPI_DOUBLE, &row_type);
      MPI_Type_commit(&row_type);
      const auto cut = [&](const unsigned int begin, const unsigned int n) {
        std::vector<double> rows(std::size_t(n) * n_columns);
        for (unsigned int i = 0; i < n; ++i)
          std::copy_n(matrix.data() + std::size_t(first_row + begin + i) * size,
                      n_columns,
                      rows.data() + std::size_t(i) * n_columns);
        return rows;
      };
      const unsigned int  me = Utilities::MPI::this_mpi_process(communicator);
      std::vector<double> mine;
      if (me == 0)
        {
          mine               = cut(0, n_of_process[0]);
          unsigned int begin = n_of_process[0];
          for (unsigned int p = 1; p < n_of_process.size(); ++p)
            {
              const std::vector<double> rows = cut(begin, n_of_process[p]);
              MPI_Send(
                rows.data(), n_of_process[p], row_type, p, tag, communicator);
              begin += n_of_process[p];
            }
        }
      else
        {
          mine.resize(std::size_t(n_of_process[me]) * n_columns);
          MPI_Recv(mine.data(),
                   n_of_process[me],
                   row_type,
                   0,
                   tag,
                   communicator,
                   MPI_STATUS_IGNORE);
        }
      MPI_Type_free(&row_type);
      return mine;
    }
  } // namespace



  template <int n_components>
  SchurComplement<n_components>::SchurComplement(
    const BlockMatrix<n_components> &K,
    const NodePartition             &nodes,
    const NodeMask                  &fixed,
    const std::vector<unsigned int> &free,
    const std::vector<unsigned int> &known)
    : communicator(nodes.communicator())
    , factors(nodes,
              both(global_entries(nodes, free), global_entries(nodes, known)))
    , n_of_process(Utilities::MPI::all_gather(communicator, int(free.size())))
    , first_of_process(sums_before(n_of_process))
    , n_all(std::accumulate(n_of_process.begin(), n_of_process.end(), 0u))
    , n_free(free.size())
  {
    NodeMask kept(nodes.n_local(), n_components);
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        if (!fixed.is_active(i, c) && !std::binary_search(known.begin(),
                                                          known.end(),
                                                          i * n_components + c))
          kept.mask(i, c);
    kept.update_ghosts(nodes);
    factors.set_matrix(K, kept);

    const std::vector<int> known_of_process =
      Utilities::MPI::all_gather(communicator, int(known.size()));
    const unsigned int size =
      n_all +
      std::accumulate(known_of_process.begin(), known_of_process.end(), 0u);
    std::vector<double> matrix = factors.take_schur_complement();
    stride                     = size;
    if (n_of_process.size() > 1)
      {
        stride = n_all;
        rows =
          scattered_rows(matrix, size, 0, n_all, n_of_process, communicator);
        const std::vector<double> rows_of_known = scattered_rows(
          matrix, size, n_all, n_all, known_of_process, communicator);
        rows.insert(rows.end(), rows_of_known.begin(), rows_of_known.end());
      }
    else
      rows = std::move(matrix);
  }



  template <int n_components>
  std::vector<double>
  SchurComplement<n_components>::on_all(const std::vector<double> &here) const
  {
    AssertDimension(here.size(), n_free);
    if (n_of_process.size() == 1)
      return here;
    std::vector<double> all(n_all);
    MPI_Allgatherv(here.data(),
                   n_free,
                   MPI_DOUBLE,
                   all.data(),
                   n_of_process.data(),
                   first_of_process.data(),
                   MPI_DOUBLE,
                   communicator);
    return all;
  }



  template <int n_components>
  void
  SchurComplement<n_components>::multiply(std::vector<double>       &y,
                                          const std::vector<double> &x) const
  {
    AssertDimension(x.size(), n_all);
    if (n_of_process.size() == 1)
      multiply_symmetric_part(y, rows.data(), stride, x);
    else
      multiply_rows(y, n_free, rows.data(), stride, x);
  }



  template <int n_components>
  void
  SchurComplement<n_components>::solve_eliminated(NodalVector       &x,
                                                  const NodalVector &b)
  {
    factors.solve(x, b);
  }



  template class SchurComplement<1>;
  template class SchurComplement<2>;
  template class SchurComplement<3>;
} // namespace StickSlip
