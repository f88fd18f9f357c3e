// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_interrupt_h
#define stickslip_output_interrupt_h

#include <mpi.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * While an object of this class lives, the signals SIGINT (Ctrl-C), SIGTERM,
   * SIGHUP (a terminal that is closed) and SIGUSR1 (which mpirun passes on, and
   * does nothing else) do not end the program but are noted, so that the run
   * can stop after the current step with all files complete; so is SIGPIPE,
   * where nobody reads the progress any more. A second signal some seconds
   * later ends the program at once; one right after the first is taken for the
   * same, since mpirun passes on what a terminal sends to all by itself.
   */
  class Interrupt
  {
  public:
    Interrupt();

    ~Interrupt();

    Interrupt(const Interrupt &) = delete;
    Interrupt &
    operator=(const Interrupt &) = delete;

    /**
     * True after a signal to any process; the same answer everywhere.
     * Collective.
     */
    bool
    is_requested(const MPI_Comm communicator) const;

  private:
    using Handler = void (*)(int);
    std::vector<std::pair<int, Handler>> previous;
  };
} // namespace StickSlip

#endif
