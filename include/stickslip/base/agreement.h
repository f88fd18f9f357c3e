// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_agreement_h
#define stickslip_base_agreement_h

#include <mpi.h>

#include <exception>
#include <functional>
#include <string>

namespace StickSlip
{
  /**
   * Carry out @p action, which may differ between the processes and must not
   * communicate, and throw on all of them if it threw on any: InputError or
   * AgreedFailure with the message of the first that failed. Collective.
   */
  void
  carry_out_agreed(const MPI_Comm               communicator,
                   const std::function<void()> &action);

  /** The message of an exception on one line, without the library's frame of
   * where it was thrown. */
  std::string
  sentence(const std::exception &error);
} // namespace StickSlip

#endif
