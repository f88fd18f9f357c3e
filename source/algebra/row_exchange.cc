// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/row_exchange.h>

#include <map>

namespace StickSlip
{
  namespace
  {
    // Any number serves that no other messages of the program have.
    constexpr int message_tag = 7301;
  } // namespace



  RowExchange::RowExchange(const NodePartition     &nodes,
                           const BlockSparsity     &owned_rows,
                           const BlockSparsity     &ghost_rows,
                           const std::vector<bool> &is_sent)
    : communicator(nodes.communicator())
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    const unsigned int n_owned = nodes.n_owned();

    // For each row its global number, the number of its entries and their
    // columns. Ghosts are sorted by owner.
    using Message = std::vector<types::global_dof_index>;
    std::map<unsigned int, Message> to_send;
    unsigned int                    ghost = 0;
    for (const auto &[rank, n_ghosts] : nodes.nodes()->ghost_targets())
      {
        Partner receiver{rank, {}};
        Message message;
        for (const unsigned int end = ghost + n_ghosts; ghost < end; ++ghost)
          if (is_sent[ghost] &&
              ghost_rows.row_start[ghost + 1] > ghost_rows.row_start[ghost])
            {
              message.push_back(nodes.global_index(n_owned + ghost));
              message.push_back(ghost_rows.row_start[ghost + 1] -
                                ghost_rows.row_start[ghost]);
              for (unsigned int k = ghost_rows.row_start[ghost];
                   k < ghost_rows.row_start[ghost + 1];
                   ++k)
                {
                  message.push_back(nodes.global_index(ghost_rows.column[k]));
                  receiver.entries.push_back(k);
                }
            }
        if (!message.empty())
          {
            to_send[rank] = std::move(message);
            receivers.push_back(std::move(receiver));
          }
      }

    for (const auto &[rank, message] :
         Utilities::MPI::some_to_some(communicator, to_send))
      {
        Partner sender{rank, {}};
        for (unsigned int m = 0; m < message.size();)
          {
            const unsigned int row       = nodes.local_index(message[m]);
            const unsigned int n_columns = message[m + 1];
            m += 2;
            for (const unsigned int end = m + n_columns; m < end; ++m)
              sender.entries.push_back(
                owned_rows.position(row, nodes.local_index(message[m])));
          }
        senders.push_back(std::move(sender));
      }
  }



  template <typename Number>
  void
  RowExchange::add_to_owners(const AlignedVector<double> &ghost_values,
                             AlignedVector<Number>       &owned_values,
                             const unsigned int           block_size) const
  {
    std::vector<std::vector<double>> out(receivers.size()), in(senders.size());
    std::vector<MPI_Request>         requests;
    const auto check = [](const int ierr) { AssertThrowMPI(ierr); };
    for (unsigned int s = 0; s < senders.size(); ++s)
      {
        in[s].resize(senders[s].entries.size() * block_size);
        requests.emplace_back();
        check(MPI_Irecv(in[s].data(),
                        in[s].size(),
                        MPI_DOUBLE,
                        senders[s].rank,
                        message_tag,
                        communicator,
                        &requests.back()));
      }
    for (unsigned int r = 0; r < receivers.size(); ++r)
      {
        for (const unsigned int k : receivers[r].entries)
          out[r].insert(out[r].end(),
                        ghost_values.data() + std::size_t(k) * block_size,
                        ghost_values.data() + std::size_t(k + 1) * block_size);
        requests.emplace_back();
        check(MPI_Isend(out[r].data(),
                        out[r].size(),
                        MPI_DOUBLE,
                        receivers[r].rank,
                        message_tag,
                        communicator,
                        &requests.back()));
      }
    check(MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE));
    // The order is that of the ranks, so that sums are the same in each run.
    for (unsigned int s = 0; s < senders.size(); ++s)
      for (unsigned int k = 0; k < senders[s].entries.size(); ++k)
        for (unsigned int c = 0; c < block_size; ++c)
          owned_values[std::size_t(senders[s].entries[k]) * block_size + c] +=
            in[s][std::size_t(k) * block_size + c];
  }



  template void
  RowExchange::add_to_owners<double>(const AlignedVector<double> &,
                                     AlignedVector<double> &,
                                     const unsigned int) const;
  template void
  RowExchange::add_to_owners<float>(const AlignedVector<double> &,
                                    AlignedVector<float> &,
                                    const unsigned int) const;
} // namespace StickSlip
