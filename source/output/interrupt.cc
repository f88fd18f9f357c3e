// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/interrupt.h>

#include <csignal>
#include <ctime>

namespace StickSlip
{
  namespace
  {
    volatile std::sig_atomic_t signal_received = 0;
    volatile std::sig_atomic_t pipe_is_closed  = 0;
    volatile std::time_t       time_of_signal  = 0;

    // A terminal and mpirun may both tell the same, s.
    constexpr std::time_t same_occasion = 2;



    extern "C" void
    note_signal(int signal)
    {
      const std::time_t now = std::time(nullptr);
      if (signal_received == 0)
        {
          signal_received = 1;
          time_of_signal  = now;
        }
      else if (now - time_of_signal > same_occasion)
        {
          std::signal(signal, SIG_DFL);
          std::raise(signal);
        }
    }



    /** Each line of progress brings this signal anew. */
    extern "C" void
    note_closed_pipe(int)
    {
      pipe_is_closed  = 1;
      signal_received = 1;
    }
  } // namespace



  Interrupt::Interrupt()
  {
    signal_received = 0;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1})
      previous.emplace_back(signal, std::signal(signal, note_signal));
    previous.emplace_back(SIGPIPE, std::signal(SIGPIPE, note_closed_pipe));
    // Programs that nohup has started stay as they are.
    for (const auto &[signal, handler] : previous)
      if (signal == SIGHUP && handler == SIG_IGN)
        std::signal(signal, handler);
  }



  Interrupt::~Interrupt()
  {
    // Nobody reads what is still to be printed.
    for (const auto &[signal, handler] : previous)
      std::signal(signal,
                  signal == SIGPIPE && pipe_is_closed != 0 ? SIG_IGN : handler);
  }



  bool
  Interrupt::is_requested(const MPI_Comm communicator) const
  {
    int requested = signal_received;
    MPI_Allreduce(MPI_IN_PLACE, &requested, 1, MPI_INT, MPI_MAX, communicator);
    return requested != 0;
  }
} // namespace StickSlip
