// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_agreed_failure_h
#define stickslip_base_agreed_failure_h

#include <stdexcept>
#include <string>

namespace StickSlip
{
  /**
   * A failure that all processes know of: each throws this at the same place,
   * so that none waits for another. The message is one sentence.
   */
  class AgreedFailure : public std::runtime_error
  {
  public:
    explicit AgreedFailure(const std::string &message)
      : std::runtime_error(message)
    {}
  };
} // namespace StickSlip

#endif
