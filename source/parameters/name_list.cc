// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/name_list.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    std::vector<std::string>
    words(const std::string &name)
    {
      std::istringstream       stream(name);
      std::vector<std::string> list;
      for (std::string word; stream >> word;)
        list.push_back(word);
      return list;
    }



    bool
    is_plain(const std::string &word)
    {
      return std::all_of(word.begin(), word.end(), [](const unsigned char c) {
        return std::isalnum(c) || c == '_' || c == '-';
      });
    }
  } // namespace



  bool
  NameList::match(const std::string &text) const
  {
    for (const std::string &name : Utilities::split_string_list(text))
      {
        const std::vector<std::string> list = words(name);
        if (list.size() != words_per_name ||
            !std::all_of(list.begin(), list.end(), is_plain))
          return false;
      }
    return true;
  }



  std::string
  NameList::description(const OutputStyle) const
  {
    return (words_per_name == 1 ? std::string("names of") :
                                  std::string("names of two words of")) +
           " letters, digits, _ and -, separated by commas";
  }



  std::vector<std::string>
  NameList::split(const std::string &text)
  {
    std::vector<std::string> names;
    for (const std::string &name : Utilities::split_string_list(text))
      {
        std::string joined;
        for (const std::string &word : words(name))
          joined += (joined.empty() ? "" : " ") + word;
        names.push_back(joined);
      }
    return names;
  }



  std::string
  join_names(const std::vector<std::string> &names,
             const std::string              &separator)
  {
    std::string list;
    for (unsigned int i = 0; i < names.size(); ++i)
      list += (i == 0 ? "" : separator) + names[i];
    return list;
  }
} // namespace StickSlip
