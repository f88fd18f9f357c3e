// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/row_exchange.h>

#include <algorithm>
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



  template <typename Get>
  std::vector<std::vector<double>>
  RowExchange::exchange(const std::vector<Partner> &to,
                        const std::vector<Partner> &from,
                        const Get                  &get,
                        const unsigned int          block_size) const
  {
    std::vector<std::vector<double>> out(to.size()), in(from.size());
    std::vector<MPI_Request>         requests;
    const auto check = [](const int ierr) { AssertThrowMPI(ierr); };
    for (unsigned int p = 0; p < from.size(); ++p)
      {
        in[p].resize(from[p].entries.size() * block_size);
        requests.emplace_back();
        check(MPI_Irecv(in[p].data(),
                        in[p].size(),
                        MPI_DOUBLE,
                        from[p].rank,
                        message_tag,
                        communicator,
                        &requests.back()));
      }
    for (unsigned int p = 0; p < to.size(); ++p)
      {
        for (const unsigned int k : to[p].entries)
          out[p].insert(out[p].end(), get(k), get(k) + block_size);
        requests.emplace_back();
        check(MPI_Isend(out[p].data(),
                        out[p].size(),
                        MPI_DOUBLE,
                        to[p].rank,
                        message_tag,
                        communicator,
                        &requests.back()));
      }
    check(MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE));
    return in;
  }



  template <typename Number>
  void
  RowExchange::add_to_owners(const AlignedVector<double> &ghost_values,
                             AlignedVector<Number>       &owned_values,
                             const unsigned int           block_size) const
  {
    const auto in = exchange(
      receivers,
      senders,
      [&](const unsigned int k) {
        return ghost_values.data() + std::size_t(k) * block_size;
      },
      block_size);
    // The order is that of the ranks, so that sums are the same in each run.
    for (unsigned int s = 0; s < senders.size(); ++s)
      for (unsigned int k = 0; k < senders[s].entries.size(); ++k)
        for (unsigned int c = 0; c < block_size; ++c)
          owned_values[std::size_t(senders[s].entries[k]) * block_size + c] +=
            in[s][std::size_t(k) * block_size + c];
  }



  template <typename Number>
  void
  RowExchange::fetch_from_owners(AlignedVector<double>       &ghost_values,
                                 const AlignedVector<Number> &owned_values,
                                 const unsigned int           block_size) const
  {
    const auto in = exchange(
      senders,
      receivers,
      [&](const unsigned int k) {
        return owned_values.data() + std::size_t(k) * block_size;
      },
      block_size);
    for (unsigned int r = 0; r < receivers.size(); ++r)
      for (unsigned int k = 0; k < receivers[r].entries.size(); ++k)
        std::copy_n(in[r].begin() + std::size_t(k) * block_size,
                    block_size,
                    ghost_values.begin() +
                      std::size_t(receivers[r].entries[k]) * block_size);
  }



#define STICKSLIP_INSTANTIATE(Number)                   \
  template void RowExchange::add_to_owners<Number>(     \
    const AlignedVector<double> &,                      \
    AlignedVector<Number> &,                            \
    const unsigned int) const;                          \
  template void RowExchange::fetch_from_owners<Number>( \
    AlignedVector<double> &,                            \
    const AlignedVector<Number> &,                      \
    const unsigned int) const;

  STICKSLIP_INSTANTIATE(double)
  STICKSLIP_INSTANTIATE(float)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
