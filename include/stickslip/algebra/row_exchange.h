// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_row_exchange_h
#define stickslip_algebra_row_exchange_h

#include <stickslip/algebra/block_matrix.h>

#include <vector>

namespace StickSlip
{
  /**
   * Sends what this process has computed of rows of ghost nodes to the owners
   * of these, where it is added to their rows of a matrix, or fetches entries
   * of such rows. Who sends what to whom is found once; after that only values
   * travel.
   */
  class RowExchange
  {
  public:
    RowExchange() = default;

    /**
     * @p ghost_rows has a row for each ghost of @p nodes, possibly empty, with
     * local indices of columns; of these the rows with @p is_sent true (by
     * position among the ghosts) are sent. Every entry must exist in
     * @p owned_rows of the owner. Collective.
     */
    RowExchange(const NodePartition     &nodes,
                const BlockSparsity     &owned_rows,
                const BlockSparsity     &ghost_rows,
                const std::vector<bool> &is_sent);

    /**
     * Add the values of the ghost rows, @p block_size numbers an entry, to
     * those of the owners. Collective among neighbours.
     */
    template <typename Number>
    void
    add_to_owners(const AlignedVector<double> &ghost_values,
                  AlignedVector<Number>       &owned_values,
                  const unsigned int           block_size) const;

    /**
     * Set the values of the ghost rows to those of the owners. Collective among
     * neighbours.
     */
    template <typename Number>
    void
    fetch_from_owners(AlignedVector<double>       &ghost_values,
                      const AlignedVector<Number> &owned_values,
                      const unsigned int           block_size) const;

  private:
    /** Another process, and the positions of entries in the order in which
     * they travel. */
    struct Partner
    {
      unsigned int              rank;
      std::vector<unsigned int> entries;
    };

    /** Send values to the partners @p to, and return those that come from the
     * partners @p from, one list for each; @p get(entry) points to the numbers
     * of an entry. */
    template <typename Get>
    std::vector<std::vector<double>>
    exchange(const std::vector<Partner> &to,
             const std::vector<Partner> &from,
             const Get                  &get,
             const unsigned int          block_size) const;

    MPI_Comm             communicator = MPI_COMM_SELF;
    std::vector<Partner> receivers, senders;
  };
} // namespace StickSlip

#endif
