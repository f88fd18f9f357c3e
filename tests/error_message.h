// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_error_message_h
#define stickslip_tests_error_message_h

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>

#include <string>
#include <vector>

namespace StickSlip::Tests
{
  /** Message to the user if the action fails on the input. */
  template <typename Action>
  std::string
  message_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }



  /** One sentence on one line, with all of these parts. */
  inline void
  expect_one_sentence_with(const std::string              &message,
                           const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos)
        << "'" << part << "' is missing in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.back(), '.') << message;
  }
} // namespace StickSlip::Tests

#endif
