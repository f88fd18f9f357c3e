// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/pvd_record.h>

#include <limits>
#include <sstream>

namespace StickSlip
{
  void
  PvdRecord::add(const double time, const std::string &vtu_file_name)
  {
    files.emplace_back(time, vtu_file_name);

    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"Collection\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n"
         << "  <Collection>\n";
    for (const auto &[entry_time, name] : files)
      text << "    <DataSet timestep=\"" << entry_time
           << "\" group=\"\" part=\"0\" file=\"" << name << "\"/>\n";
    text << "  </Collection>\n"
         << "</VTKFile>\n";
    write_file_atomically(file_name, text.str());
  }
} // namespace StickSlip
