// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_input_error_h
#define stickslip_base_input_error_h

#include <stdexcept>
#include <string>

namespace StickSlip
{
  /**
   * An entry of the user's that cannot be used. The message is one sentence
   * naming the entry, its value and what is allowed, fit to be shown as it is.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {}
  };
} // namespace StickSlip

#endif
