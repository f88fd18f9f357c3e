// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/gmsh_sections.h>

#include <algorithm>
#include <charconv>
#include <cstring>

namespace StickSlip
{
  namespace
  {
    bool
    is_space(const char c)
    {
      return c == ' ' || c == '\t' || c == '\n' || c == '\r';
    }
  } // namespace



  GmshSections::GmshSections(const std::string &contents,
                             const std::string &file_name)
    : contents(contents)
    , name(file_name)
  {}



  void
  GmshSections::fail(const std::string &what) const
  {
    throw InputError("The mesh file '" + name + "' " + what + ".");
  }



  void
  GmshSections::fail_at_end() const
  {
    fail("ends within its section $" + section);
  }



  std::string
  GmshSections::next_section()
  {
    place = contents.find('$', std::min(place, contents.size()));
    if (place == std::string::npos)
      return "";
    const std::size_t end =
      std::min(contents.find_first_of("\r\n", place), contents.size());
    section = contents.substr(place + 1, end - place - 1);
    section.erase(section.find_last_not_of(" \t") + 1);
    place = std::min(contents.find('\n', end), contents.size() - 1) + 1;
    return section;
  }



  void
  GmshSections::skip_section()
  {
    place = contents.find("$End" + section, place);
    if (place == std::string::npos)
      fail_at_end();
    place = std::min(contents.find('\n', place), contents.size());
  }



  void
  GmshSections::end_section()
  {
    skip_spaces();
    const std::string end = "$End" + section;
    if (contents.compare(place, end.size(), end) == 0)
      place += end.size();
    else if (place >= contents.size())
      fail_at_end();
    else
      fail("has more in its section $" + section +
           " than the numbers there say");
  }



  void
  GmshSections::end_line()
  {
    const std::size_t end = contents.find('\n', place);
    if (end == std::string::npos)
      fail_at_end();
    place = end + 1;
  }



  void
  GmshSections::skip_spaces()
  {
    while (place < contents.size() && is_space(contents[place]))
      ++place;
  }



  std::string
  GmshSections::word()
  {
    skip_spaces();
    std::size_t end = place;
    while (end < contents.size() && !is_space(contents[end]))
      ++end;
    if (end == place)
      fail_at_end();
    const std::string result = contents.substr(place, end - place);
    place                    = end;
    return result;
  }



  std::string
  GmshSections::quoted()
  {
    const std::size_t begin = contents.find('"', place);
    if (begin == std::string::npos)
      fail_at_end();
    const std::size_t end = contents.find('"', begin + 1);
    if (end == std::string::npos)
      fail_at_end();
    place = end + 1;
    return contents.substr(begin + 1, end - begin - 1);
  }



  template <typename Number>
  Number
  GmshSections::text()
  {
    skip_spaces();
    Number            number = {};
    const char *const end    = contents.data() + contents.size();
    const auto [behind, error] =
      std::from_chars(contents.data() + place, end, number);
    if (error != std::errc() || (behind != end && !is_space(*behind)))
      {
        const std::string found = word();
        fail("has '" + found.substr(0, 20) + "' in its section $" + section +
             " where a number must be");
      }
    place = behind - contents.data();
    return number;
  }



  template <typename Number>
  Number
  GmshSections::bytes()
  {
    Number number;
    if (contents.size() - place < sizeof(Number))
      fail_at_end();
    std::memcpy(&number, contents.data() + place, sizeof(Number));
    place += sizeof(Number);
    return number;
  }



  int
  GmshSections::integer()
  {
    return binary ? bytes<int>() : text<int>();
  }



  double
  GmshSections::real()
  {
    return binary ? bytes<double>() : text<double>();
  }



  std::uint64_t
  GmshSections::tag()
  {
    return binary ? bytes<std::uint32_t>() : text<std::uint64_t>();
  }



  std::uint64_t
  GmshSections::size()
  {
    if (!binary)
      return text<std::uint64_t>();
    return size_bytes == 8 ? bytes<std::uint64_t>() : bytes<std::uint32_t>();
  }



  std::uint64_t
  GmshSections::plausible(const std::uint64_t number) const
  {
    return std::min<std::uint64_t>(number, contents.size());
  }



  template int
  GmshSections::text<int>();
  template std::uint64_t
  GmshSections::text<std::uint64_t>();
  template double
  GmshSections::text<double>();
  template int
  GmshSections::bytes<int>();
} // namespace StickSlip
