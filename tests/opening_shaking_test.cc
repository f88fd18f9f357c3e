// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "shaken_block.h"

using namespace StickSlip::Tests;

TEST(OpeningShaking, GapsFrictionAndStatesAreExact)
{
  expect_clean_contacts(40);
}



TEST(OpeningShaking, StatesMayBeFrozen)
{
  expect_clean_contacts(10, {"Faults/contact/State while open=frozen"});
}
