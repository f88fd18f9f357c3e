// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/run_summary.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace StickSlip
{
  void
  RunSummary::Section::add(const std::string &key,
                           const double       value,
                           const std::string &unit)
  {
    std::ostringstream text;
    text << value << (unit.empty() ? "" : " ") << unit;
    add(key, text.str());
  }



  void
  RunSummary::print(std::ostream &out) const
  {
    std::size_t width = 0;
    for (const Section &section : sections)
      for (const auto &line : section.lines)
        width = std::max(width, line.first.size());

    for (const Section &section : sections)
      if (!section.lines.empty())
        {
          out << (&section == &sections.front() ? "" : "\n") << section.name
              << '\n';
          for (const auto &[key, value] : section.lines)
            out << "  " << key << std::string(width - key.size() + 2, ' ')
                << value << '\n';
        }
  }



  void
  RunSummary::write(const std::string &file_name) const
  {
    std::ostringstream text;
    print(text);
    write_file_atomically(file_name, text.str());
  }
} // namespace StickSlip
