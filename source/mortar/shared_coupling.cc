// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreement.h>
#include <stickslip/mortar/shared_coupling.h>

namespace StickSlip
{
  namespace
  {
    using Message = std::vector<double>;



    /** The part of this process of the slave nodes. */
    SlaveRange
    own_range(const std::uint64_t n_nodes, const MPI_Comm &communicator)
    {
      const std::uint64_t n_processes =
        Utilities::MPI::n_mpi_processes(communicator);
      const std::uint64_t process =
        Utilities::MPI::this_mpi_process(communicator);
      return {static_cast<unsigned int>(n_nodes * process / n_processes),
              static_cast<unsigned int>(n_nodes * (process + 1) / n_processes)};
    }



    void
    write_row(const SparseRow &row, Message &message)
    {
      message.push_back(row.size());
      for (const auto &[column, value] : row)
        message.insert(message.end(), {double(column), value});
    }



    void
    read_row(Message::const_iterator &next, PackedRows<unsigned int> &rows)
    {
      for (unsigned int n = *next++; n > 0; --n, next += 2)
        rows.add_entry(*next, *(next + 1));
      rows.end_row();
    }



    template <int dim>
    Message
    write_nodes(const MortarCoupling<dim> &coupling, const SlaveRange &range)
    {
      Message message;
      for (unsigned int p = range.begin; p < range.end; ++p)
        {
          message.insert(message.end(),
                         {double(coupling.active[p]),
                          coupling.weight[p],
                          coupling.averaging_factor[p]});
          write_row(coupling.master_rows[p], message);
          write_row(coupling.inactive_slave_rows[p], message);
          if (coupling.rotation_rows.empty())
            continue;
          message.push_back(coupling.rotation_rows[p].size());
          for (const auto &[column, matrix] : coupling.rotation_rows[p])
            {
              message.push_back(column);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  message.push_back(matrix[i][j]);
            }
        }
      return message;
    }



    /** Append the nodes of a message. */
    template <int dim>
    void
    read_nodes(const Message       &message,
               const bool           has_rotations,
               MortarCoupling<dim> &coupling)
    {
      for (auto next = message.begin(); next != message.end();)
        {
          coupling.active.push_back(*next++ != 0.);
          coupling.weight.push_back(*next++);
          coupling.averaging_factor.push_back(*next++);
          read_row(next, coupling.master_rows);
          read_row(next, coupling.inactive_slave_rows);
          if (!has_rotations)
            continue;
          coupling.rotation_rows.emplace_back();
          for (unsigned int n = *next++; n > 0; --n)
            {
              const unsigned int column = *next++;
              Tensor<2, dim>     matrix;
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  matrix[i][j] = *next++;
              coupling.rotation_rows.back().emplace_back(column, matrix);
            }
        }
    }
  } // namespace



  template <int dim>
  MortarCoupling<dim>
  build_shared_coupling(const FaultSurface<dim>       &slave,
                        const std::vector<Point<dim>> &slave_positions,
                        const FaultSurface<dim>       &master,
                        const std::vector<Point<dim>> &master_positions,
                        const std::vector<bool>       &excluded,
                        const MPI_Comm                &communicator)
  {
    using namespace Utilities::MPI;
    const unsigned int n_nodes = slave_positions.size();
    const SlaveRange   range   = own_range(n_nodes, communicator);

    MortarCoupling<dim> own;
    carry_out_agreed(communicator, [&]() {
      own = build_mortar_coupling(
        slave, slave_positions, master, master_positions, excluded, range);
    });
    if (n_mpi_processes(communicator) == 1)
      return own;

    MortarCoupling<dim> result;
    result.covered_area = sum(own.covered_area, communicator);
    result.lost_area    = sum(own.lost_area, communicator);
    result.active.reserve(n_nodes);
    result.weight.reserve(n_nodes);
    result.averaging_factor.reserve(n_nodes);
    const bool has_rotations = !slave.is_plane() || !master.is_plane();
    for (const Message &message :
         all_gather(communicator, write_nodes(own, range)))
      read_nodes(message, has_rotations, result);
    result.master_rows.close();
    result.inactive_slave_rows.close();
    return result;
  }



  template <int dim>
  std::vector<double>
  find_shared_gaps(const FaultSurface<dim>       &slave,
                   const std::vector<Point<dim>> &slave_positions,
                   const FaultSurface<dim>       &master,
                   const std::vector<Point<dim>> &master_positions,
                   const MPI_Comm                &communicator)
  {
    const SlaveRange range = own_range(slave_positions.size(), communicator);
    Message          own;
    carry_out_agreed(communicator, [&]() {
      own = side_gaps(slave, slave_positions, master, master_positions, range);
    });
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return own;
    own = Message(own.begin() + range.begin, own.begin() + range.end);
    std::vector<double> gaps;
    for (const Message &message : Utilities::MPI::all_gather(communicator, own))
      gaps.insert(gaps.end(), message.begin(), message.end());
    return gaps;
  }



  template decltype(build_shared_coupling<2>) build_shared_coupling<2>;
  template decltype(build_shared_coupling<3>) build_shared_coupling<3>;
  template decltype(find_shared_gaps<2>)      find_shared_gaps<2>;
  template decltype(find_shared_gaps<3>)      find_shared_gaps<3>;
} // namespace StickSlip
