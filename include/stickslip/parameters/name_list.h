// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_parameters_name_list_h
#define stickslip_parameters_name_list_h

#include <deal.II/base/patterns.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Pattern of a possibly empty list of names separated by commas. A name is
   * one or two words of letters, digits, '_' and '-', so that it can head a
   * column of a table and be part of the path of an entry.
   */
  class NameList : public Patterns::PatternBase
  {
  public:
    explicit NameList(const unsigned int words_per_name = 1)
      : words_per_name(words_per_name)
    {}

    virtual bool
    match(const std::string &text) const override;

    /** Allowed values, in words, whatever the @p style. */
    virtual std::string
    description(const OutputStyle style = Machine) const override;

    virtual std::unique_ptr<PatternBase>
    clone() const override
    {
      return std::make_unique<NameList>(*this);
    }

    /**
     * The names in a list, with any spaces between two words made one.
     */
    static std::vector<std::string>
    split(const std::string &text);

  private:
    unsigned int words_per_name;
  };

  /**
   * The names in one text; as it stands, a list that NameList::split() takes
   * apart.
   */
  std::string
  join_names(const std::vector<std::string> &names,
             const std::string              &separator = ", ");
} // namespace StickSlip

#endif
