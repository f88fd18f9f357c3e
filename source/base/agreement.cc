// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/input_error.h>

#include <new>
#include <sstream>

namespace StickSlip
{
  void
  carry_out_agreed(const MPI_Comm               communicator,
                   const std::function<void()> &action)
  {
    bool        has_failed = false, is_input_error = false;
    std::string message;
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        has_failed = is_input_error = true;
        message                     = error.what();
      }
    catch (const std::exception &error)
      {
        has_failed = true;
        message    = sentence(error);
      }

    using namespace dealii::Utilities::MPI;
    const unsigned int n_processes = n_mpi_processes(communicator);
    const unsigned int first_failed =
      min(has_failed ? this_mpi_process(communicator) : n_processes,
          communicator);
    if (first_failed == n_processes)
      return;
    message        = broadcast(communicator, message, first_failed);
    is_input_error = broadcast(communicator, is_input_error, first_failed);
    if (is_input_error)
      throw InputError(message);
    throw AgreedFailure(message);
  }



  std::string
  sentence(const std::exception &error)
  {
    if (dynamic_cast<const std::bad_alloc *>(&error) != nullptr)
      return "There is not enough memory.";
    std::stringstream text;
    if (const auto *const internal =
          dynamic_cast<const dealii::ExceptionBase *>(&error))
      internal->print_info(text);
    else
      text << error.what();

    std::string line;
    for (std::string word; text >> word;)
      line += (line.empty() ? "" : " ") + word;
    return line.empty() ? "an error without a message" : line;
  }
} // namespace StickSlip
