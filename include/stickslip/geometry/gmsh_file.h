// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_gmsh_file_h
#define stickslip_geometry_gmsh_file_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The contents of a mesh file of Gmsh: nodes, and elements with their
   * physical groups. Nothing is checked that needs an understanding of the
   * mesh.
   *
   * Files of versions 2.2 and 4.1 can be read, as text and binary, with
   * points, lines, triangles, quadrilaterals, tetrahedra and hexahedra. The
   * formats are described in the reference manual of Gmsh, chapter "File
   * formats".
   */
  struct GmshFile
  {
    /** Elements that are in no physical group. */
    static constexpr unsigned int no_group = numbers::invalid_unsigned_int;

    struct Group
    {
      /** Dimension of its elements. */
      unsigned int dim;

      /** Number in the file, unique for each dimension. */
      int tag;

      /** Empty if the file does not name it. */
      std::string name;
    };

    struct Element
    {
      /** Places in the array of nodes, in deal.II's order of the vertices. */
      std::array<unsigned int, 8> nodes;
      unsigned int                n_nodes;

      /** Place in the array of groups, or no_group. */
      unsigned int group;
    };

    /** Name of the file, for messages. */
    std::string name;

    /** Positions of all nodes, m. There may be some that no element has. */
    std::vector<Point<3>> nodes;

    /** Groups that are named or have elements. */
    std::vector<Group> groups;

    /** Elements of each dimension from 0 to 3. One that is in several groups
     * is listed once for each. */
    std::array<std::vector<Element>, 4> elements;

    GmshFile() = default;

    /**
     * Read the file, with lengths in multiples of @p length_unit, m. Throws
     * InputError if the file cannot be read, ends too early, or has elements of
     * other kinds.
     */
    explicit GmshFile(const std::string &file_name,
                      const double       length_unit = 1.);

    /** The contents of a file, for messages called @p name. */
    static GmshFile
    parse(const std::string &contents,
          const std::string &name,
          const double       length_unit = 1.);

    /** The group in words, for messages: "the group 'name'". */
    std::string
    describe(const unsigned int group) const;
  };
} // namespace StickSlip

#endif
