// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_serial_order_h
#define stickslip_algebra_serial_order_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Collects what is spread over the processes on the first one, in the order
   * in which one process alone would have it, so that files do not depend on
   * the number of processes.
   */
  class SerialOrder
  {
  public:
    /**
     * @p places of the items of this process among the @p n_items of all. Each
     * item is on one process at least; those that have it have equal values.
     * Collective.
     */
    SerialOrder(const std::vector<types::global_dof_index> &places,
                const types::global_dof_index               n_items,
                const MPI_Comm                             &communicator);

    /**
     * Values of all items on the first process, none on the others;
     * @p n_values for each item. Collective.
     */
    template <typename Number>
    std::vector<Number>
    gather(const std::vector<Number> &values,
           const unsigned int         n_values) const;

  private:
    MPI_Comm                communicator;
    types::global_dof_index n_items;
    /** Of each process, on the first. */
    std::vector<std::vector<types::global_dof_index>> places;
  };
} // namespace StickSlip

#endif
