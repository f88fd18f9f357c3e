// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/interrupt.h>

#include <csignal>

namespace StickSlip
{
  namespace
  {
    volatile std::sig_atomic_t signal_received = 0;



    // Installed for both signals by name, as SIG_DFL must be for both.
    extern "C" void
    note_signal(int)
    {
      signal_received = 1;
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
    }
  } // namespace



  Interrupt::Interrupt()
  {
    signal_received    = 0;
    previous_interrupt = std::signal(SIGINT, note_signal);
    previous_terminate = std::signal(SIGTERM, note_signal);
  }



  Interrupt::~Interrupt()
  {
    std::signal(SIGINT, previous_interrupt);
    std::signal(SIGTERM, previous_terminate);
  }



  bool
  Interrupt::is_requested() const
  {
    return signal_received != 0;
  }



  bool
  Interrupt::is_requested(const MPI_Comm communicator) const
  {
    int requested = is_requested() ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator);
    return requested != 0;
  }
} // namespace StickSlip
