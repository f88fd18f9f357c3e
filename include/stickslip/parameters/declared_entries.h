// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_declared_entries_h
#define stickslip_parameters_declared_entries_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * One entry, as a handler knows it.
   */
  struct DeclaredEntry
  {
    /** Names of the nested subsections, outermost first. */
    std::vector<std::string> sections;

    std::string name;
    std::string default_value;

    /** Allowed values, in words. */
    std::string allowed;

    /** SI unit of its numbers; empty if they have none. */
    std::string unit;

    /** True if the entry sets a SpatialField. */
    bool is_field = false;

    /** True if it sets a StressField. */
    bool is_stress = false;

    std::string documentation;
  };

  /**
   * All entries of a handler in the order of their declaration.
   */
  std::vector<DeclaredEntry>
  declared_entries(const ParameterHandler &prm);
} // namespace StickSlip

#endif
