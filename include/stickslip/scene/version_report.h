// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_version_report_h
#define stickslip_scene_version_report_h

#include <string>

namespace StickSlip
{
  /** The revision of the sources that the program was built from, as git names
   * it, with -dirty behind it if they had been changed; "unknown" where there
   * was no git. */
  std::string
  source_revision();

  /** The version of the program, the revision of its sources, how it was
   * compiled, and the libraries that it uses, a line each. */
  std::string
  version_report();
} // namespace StickSlip

#endif
