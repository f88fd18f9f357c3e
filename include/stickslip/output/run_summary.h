// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_run_summary_h
#define stickslip_output_run_summary_h

#include <iosfwd>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Named sections of lines `key  value`, written with the values aligned, as
   * in summary.txt. Sections and keys keep the order in which they come.
   */
  class RunSummary
  {
  public:
    struct Section
    {
      std::string                                      name;
      std::vector<std::pair<std::string, std::string>> lines;

      void
      add(const std::string &key, const std::string &value)
      {
        lines.emplace_back(key, value);
      }

      /** A number with six significant digits and its unit, if any. */
      void
      add(const std::string &key,
          const double       value,
          const std::string &unit = "");

      /** A count, with all its digits. */
      void
      add_count(const std::string &key, const unsigned long long value)
      {
        add(key, std::to_string(value));
      }
    };

    /** A new section, which stays where it is; left out if it stays empty. */
    Section &
    add_section(const std::string &name)
    {
      sections.push_back({name, {}});
      return sections.back();
    }

    void
    print(std::ostream &out) const;

    /**
     * Write or replace the file. Throws InputError if that is impossible.
     */
    void
    write(const std::string &file_name) const;

  private:
    std::list<Section> sections;
  };
} // namespace StickSlip

#endif
