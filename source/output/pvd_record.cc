// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/pvd_record.h>

#include <limits>
#include <sstream>

namespace StickSlip
{
  void
  PvdRecord::add(const double                    time,
                 const std::vector<std::string> &vtu_file_names)
  {
    for (const std::string &name : vtu_file_names)
      files.emplace_back(time, name);
    write();
  }



  void
  PvdRecord::resume(const VolumeEntries &entries)
  {
    files = entries;
    if (!files.empty())
      write();
  }



  void
  PvdRecord::write() const
  {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"Collection\" version=\"0.1\" "
            "byte_order=\"LittleEndian\">\n"
         << "  <Collection>\n";
    unsigned int part = 0;
    for (unsigned int i = 0; i < files.size(); ++i)
      {
        part = i > 0 && files[i].first == files[i - 1].first ? part + 1 : 0;
        text << "    <DataSet timestep=\"" << files[i].first
             << "\" group=\"\" part=\"" << part << "\" file=\""
             << files[i].second << "\"/>\n";
      }
    text << "  </Collection>\n"
         << "</VTKFile>\n";
    write_file_atomically(file_name, text.str());
  }
} // namespace StickSlip
