// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "message_count.h"

#include <mpi.h>

namespace
{
  Measure::MessageCount total;

  std::uint64_t
  n_bytes(const int count, MPI_Datatype type)
  {
    int size = 0;
    MPI_Type_size(type, &size);
    return std::uint64_t(count) * size;
  }
} // namespace

// PETSc has macros of these names.
#undef MPI_Allreduce
#undef MPI_Isend

extern "C"
{
  int
  MPI_Allreduce(const void  *send,
                void        *receive,
                int          count,
                MPI_Datatype type,
                MPI_Op       operation,
                MPI_Comm     communicator)
  {
    ++total.sums;
    total.sum_bytes += n_bytes(count, type);
    return PMPI_Allreduce(send, receive, count, type, operation, communicator);
  }

  int
  MPI_Isend(const void  *data,
            int          count,
            MPI_Datatype type,
            int          destination,
            int          tag,
            MPI_Comm     communicator,
            MPI_Request *request)
  {
    ++total.messages;
    total.message_bytes += n_bytes(count, type);
    return PMPI_Isend(
      data, count, type, destination, tag, communicator, request);
  }
}

namespace Measure
{
  void
  reset_message_count()
  {
    total = MessageCount();
  }

  MessageCount
  message_count()
  {
    return total;
  }
} // namespace Measure
