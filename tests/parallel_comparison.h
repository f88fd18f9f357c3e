// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_parallel_comparison_h
#define stickslip_tests_parallel_comparison_h

#include <deal.II/base/mpi.h>

#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/multigrid/level_hierarchy.h>

#include <map>
#include <vector>

namespace StickSlip::Tests
{
  /*
   * A problem on all processes is compared with the same problem on one, which
   * each process has for itself.
   */

  inline unsigned int
  n_processes()
  {
    return Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }



  /** The number that a node has on one process, for each number on all. */
  template <int dim>
  std::vector<types::global_dof_index>
  numbers_on_one(const MeshLevel<dim> &shared)
  {
    std::vector<types::global_dof_index> numbers;
    for (const auto &of_process :
         Utilities::MPI::all_gather(MPI_COMM_WORLD,
                                    shared.owned_serial_nodes()))
      numbers.insert(numbers.end(), of_process.begin(), of_process.end());
    return numbers;
  }



  template <int dim>
  double
  largest_entry(const Tensor<2, dim> &block)
  {
    double result = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result = std::max(result, std::abs(block[c][d]));
    return result;
  }



  /** The largest difference of any entry of the owned rows, over the largest
   * entry of any row; over all processes. */
  template <int dim>
  double
  difference(const TermMatrix<dim>                      &shared,
             const NodePartition                        &nodes,
             const TermMatrix<dim>                      &alone,
             const std::vector<types::global_dof_index> &numbers)
  {
    double      largest = 0, error = 0;
    const auto &row_start = shared.sparsity().row_start;
    const auto &alone_row = alone.sparsity().row_start;
    for (unsigned int i = 0; i < alone.n_rows(); ++i)
      for (unsigned int k = alone_row[i]; k < alone_row[i + 1]; ++k)
        largest = std::max(largest, largest_entry(alone.entry(i, k)));
    for (unsigned int i = 0; i < shared.n_rows(); ++i)
      {
        std::map<types::global_dof_index, Tensor<2, dim>> row;
        for (unsigned int k = row_start[i]; k < row_start[i + 1]; ++k)
          row[numbers[nodes.global_index(shared.sparsity().column[k])]] =
            shared.entry(i, k);
        const unsigned int I = numbers[nodes.global_index(i)];
        for (unsigned int k = alone_row[I]; k < alone_row[I + 1]; ++k)
          row[alone.sparsity().column[k]] -= alone.entry(I, k);
        for (const auto &entry : row)
          error = std::max(error, largest_entry(entry.second));
      }
    return Utilities::MPI::max(error / largest, MPI_COMM_WORLD);
  }



  template <int dim>
  double
  difference(const BlockMatrix<dim>                     &shared,
             const NodePartition                        &nodes,
             const BlockMatrix<dim>                     &alone,
             const std::vector<types::global_dof_index> &numbers)
  {
    return difference(TermMatrix<dim>(shared),
                      nodes,
                      TermMatrix<dim>(alone),
                      numbers);
  }



  /** Largest difference of vectors, as above. */
  inline double
  difference(const NodalVector                          &shared,
             const NodePartition                        &nodes,
             const NodalVector                          &alone,
             const std::vector<types::global_dof_index> &numbers)
  {
    const unsigned int dim   = nodes.n_components();
    double             error = 0;
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        error = std::max(error,
                         std::abs(shared.local_element(i * dim + c) -
                                  alone.local_element(
                                    numbers[nodes.global_index(i)] * dim + c)));
    return Utilities::MPI::max(error, MPI_COMM_WORLD) / alone.linfty_norm();
  }
} // namespace StickSlip::Tests

#endif
