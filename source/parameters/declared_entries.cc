// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <stickslip/parameters/declared_entries.h>
#include <stickslip/parameters/field_pattern.h>
#include <stickslip/parameters/number_range.h>
#include <stickslip/parameters/stress_field.h>

#include <sstream>

namespace StickSlip
{
  namespace
  {
    using Tree = boost::property_tree::ptree;



    // deal.II's patterns describe themselves to a machine; ours in words.
    std::string
    in_words(const std::string &description)
    {
      if (description == "[Anything]")
        return "any text";
      for (const auto &[beginning, choice] :
           {std::make_pair(std::string("[Selection "), "one of: "),
            std::make_pair(std::string("[MultipleSelection "),
                           "any of, separated by commas: ")})
        if (description.rfind(beginning, 0) == 0)
          {
            std::string words;
            for (const char c : description.substr(beginning.size()))
              if (c == '|')
                words += ", ";
              else if (c != ']')
                words += c;
            while (!words.empty() && words.back() == ' ')
              words.pop_back();
            return choice + words;
          }
      return description;
    }



    // The unit that a description() names.
    std::string
    unit_in(const std::string &description)
    {
      const std::string before = NumberRange::before_unit;
      const std::size_t place  = description.find(before);
      if (place == std::string::npos)
        return "";
      const std::size_t begin = place + before.size();
      return description.substr(
        begin, description.find(NumberRange::after_unit, begin) - begin);
    }



    void
    collect(const Tree                     &tree,
            const std::vector<std::string> &sections,
            std::vector<DeclaredEntry>     &entries)
    {
      for (const auto &[name, child] : tree)
        if (child.find("pattern_description") != child.not_found())
          {
            DeclaredEntry entry;
            entry.sections      = sections;
            entry.name          = name;
            entry.default_value = child.get<std::string>("default_value");
            entry.documentation = child.get<std::string>("documentation");
            const std::string pattern =
              child.get<std::string>("pattern_description");
            entry.allowed = in_words(pattern);
            entry.unit    = unit_in(pattern);
            entry.is_stress =
              pattern.find(StressField::each_component) != std::string::npos;
            entry.is_field =
              !entry.is_stress &&
              pattern.find(FieldPattern::ending) != std::string::npos;
            entries.push_back(entry);
          }
        else
          {
            std::vector<std::string> inner = sections;
            inner.push_back(name);
            collect(child, inner, entries);
          }
    }
  } // namespace



  std::vector<DeclaredEntry>
  declared_entries(const ParameterHandler &prm)
  {
    // The handler keeps its tree to itself; JSON shows all of it.
    std::stringstream stream;
    prm.print_parameters(stream,
                         static_cast<ParameterHandler::OutputStyle>(
                           ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder));
    Tree tree;
    boost::property_tree::read_json(stream, tree);

    std::vector<DeclaredEntry> entries;
    collect(tree, {}, entries);
    return entries;
  }
} // namespace StickSlip
