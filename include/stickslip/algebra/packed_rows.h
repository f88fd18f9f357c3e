// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_packed_rows_h
#define stickslip_algebra_packed_rows_h

#include <boost/range/iterator_range_core.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Sparse rows one behind the other, in a tenth of the memory of rows by
   * themselves. @p Column: the type of the numbers of columns.
   */
  template <typename Column>
  class PackedRows
  {
  public:
    /** Column and value. */
    using Entry = std::pair<Column, double>;

    using Row = boost::iterator_range<const Entry *>;

    std::size_t
    size() const
    {
      return ends.size();
    }

    Row
    operator[](const std::size_t row) const
    {
      return {entries.data() + (row == 0 ? 0 : ends[row - 1]),
              entries.data() + ends[row]};
    }

    /** Append an entry to the row that has been begun. */
    void
    add_entry(const Column column, const double value)
    {
      entries.emplace_back(column, value);
    }

    void
    end_row()
    {
      ends.push_back(entries.size());
    }

    template <typename Entries>
    void
    add_row(const Entries &row)
    {
      entries.insert(entries.end(), row.begin(), row.end());
      end_row();
    }

    /** Give back the memory for more rows. */
    void
    close()
    {
      entries.shrink_to_fit();
      ends.shrink_to_fit();
    }

  private:
    std::vector<Entry>        entries;
    std::vector<unsigned int> ends;
  };
} // namespace StickSlip

#endif
