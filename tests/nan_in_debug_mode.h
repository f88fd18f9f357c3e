// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_nan_in_debug_mode_h
#define stickslip_tests_nan_in_debug_mode_h

#include <gtest/gtest.h>

/** In debug mode deal.II ends the process at the first number that is none, so
 * that a test of what the program does with it must be skipped. */
#ifdef DEBUG
#  define SKIP_WHERE_NAN_IS_FATAL() \
    GTEST_SKIP() << "A number that is none is fatal in debug mode."
#else
#  define SKIP_WHERE_NAN_IS_FATAL() static_cast<void>(0)
#endif

#endif
