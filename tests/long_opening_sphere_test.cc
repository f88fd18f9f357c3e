// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "pressed_sphere.h"

using namespace StickSlip;
using namespace StickSlip::Tests;



TEST(LongOpening, ASphereIsPressedOnAPlane)
{
  // Cells of a seventh of the radius.
  expect_hertz_sphere(3, 0.007);
}
