// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_table_columns_h
#define stickslip_output_table_columns_h

#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Title, unit and meaning of one column of a table; the unit is empty where
   * there is none.
   */
  struct TableColumn
  {
    std::string title, unit, meaning;
  };

  using TableColumns = std::vector<TableColumn>;

  /** The header of a table: its titles, with commas between them. */
  std::string
  header_of(const TableColumns &columns);

  /**
   * Write columns.csv, which says what is in the other tables of a run: for
   * each column the table's file, the title, the unit and the meaning. Throws
   * InputError if the file cannot be written.
   */
  void
  write_columns(
    const std::string                                       &file_name,
    const std::vector<std::pair<std::string, TableColumns>> &tables);
} // namespace StickSlip

#endif
