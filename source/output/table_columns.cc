// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/table_columns.h>

namespace StickSlip
{
  std::string
  header_of(const TableColumns &columns)
  {
    std::string result;
    for (const TableColumn &column : columns)
      result += (result.empty() ? "" : ",") + column.title;
    return result;
  }



  void
  write_columns(const std::string &file_name,
                const std::vector<std::pair<std::string, TableColumns>> &tables)
  {
    // Meanings are sentences with commas, but without quotation marks.
    std::string text = "file,column,unit,meaning\n";
    for (const auto &[name, columns] : tables)
      for (const TableColumn &column : columns)
        text += name + ',' + column.title + ',' + column.unit + ",\"" +
                column.meaning + "\"\n";
    write_file_atomically(file_name, text);
  }
} // namespace StickSlip
