// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_gmsh_sections_h
#define stickslip_geometry_gmsh_sections_h

#include <cstdint>
#include <string>

namespace StickSlip
{
  /**
   * The characters of a mesh file of Gmsh, its sections, and a place in one.
   * Numbers are text or, within the sections where they may be, binary. All
   * functions throw InputError if what they look for is not at the place.
   */
  class GmshSections
  {
  public:
    /** Both arguments must stay. */
    GmshSections(const std::string &contents, const std::string &file_name);

    /** True if numbers are binary, and the bytes of a count or tag of version
     * 4.1 then. */
    bool         binary     = false;
    unsigned int size_bytes = 8;

    /** Throw InputError: the mesh file does what is said. */
    [[noreturn]] void
    fail(const std::string &what) const;

    /** Go to the next section and return its name; empty if there is none. */
    std::string
    next_section();

    /** Go behind the section, whatever it contains. */
    void
    skip_section();

    /** Go behind the end of the section, which must be here. */
    void
    end_section();

    /** Go behind the end of the line. */
    void
    end_line();

    /** The next word or number that is text in all files. */
    std::string
    word();

    template <typename Number>
    Number
    text();

    /** Characters between the next two quotes. */
    std::string
    quoted();

    /** The next number that may be binary. */
    template <typename Number>
    Number
    bytes();

    int
    integer();

    double
    real();

    /** A number of a node or element in version 2.2. */
    std::uint64_t
    tag();

    /** A count, or a number of a node or element, in version 4.1. */
    std::uint64_t
    size();

    /** The number, or that of characters if it is beyond, so that nothing is
     * reserved for a number that cannot be true. */
    std::uint64_t
    plausible(const std::uint64_t number) const;

  private:
    [[noreturn]] void
    fail_at_end() const;

    void
    skip_spaces();

    const std::string &contents;
    const std::string &name;
    std::string        section;
    std::size_t        place = 0;
  };
} // namespace StickSlip

#endif
