// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "shaken_block.h"

using namespace StickSlip::Tests;

TEST(LongOpening, AThousandContacts)
{
  expect_clean_contacts(1000);
}
