// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_mesh_text_h
#define stickslip_tests_mesh_text_h

#include <stickslip/geometry/gmsh_file.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace StickSlip::Tests
{
  /** The contents of a small mesh file of version 2.2. */
  struct MeshText
  {
    struct Group
    {
      int         dim;
      int         tag;
      std::string name;
    };

    struct Element
    {
      /** Gmsh's number of the shape: 1 line, 2 triangle, 3 quadrilateral. */
      int              type;
      int              group;
      std::vector<int> nodes;
    };

    /** Nodes and elements are numbered from one. */
    std::vector<std::array<double, 3>> nodes;
    std::vector<Group>                 groups;
    std::vector<Element>               elements;

    std::string
    text() const
    {
      std::ostringstream out;
      out.precision(17);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
          << groups.size() << '\n';
      for (const Group &group : groups)
        out << group.dim << ' ' << group.tag << " \"" << group.name << "\"\n";
      out << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << '\n';
      for (unsigned int i = 0; i < nodes.size(); ++i)
        out << i + 1 << ' ' << nodes[i][0] << ' ' << nodes[i][1] << ' '
            << nodes[i][2] << '\n';
      out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
      for (unsigned int i = 0; i < elements.size(); ++i)
        {
          out << i + 1 << ' ' << elements[i].type << " 2 " << elements[i].group
              << " 1";
          for (const int node : elements[i].nodes)
            out << ' ' << node;
          out << '\n';
        }
      out << "$EndElements\n";
      return out.str();
    }

    GmshFile
    file() const
    {
      return GmshFile::parse(text(), "test.msh");
    }
  };



  /** Two columns of two unit squares, the bodies "west" and "east", and the
   * group "fault" between them. Nodes from left to right, then upwards. */
  inline MeshText
  two_columns()
  {
    MeshText mesh;
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        mesh.nodes.push_back({{double(x), double(y), 0.}});
    mesh.groups   = {{2, 1, "west"},
                     {2, 2, "east"},
                     {1, 1, "fault"},
                     {1, 2, "bottom"},
                     {1, 3, "top"},
                     {1, 4, "left"},
                     {1, 5, "right"}};
    mesh.elements = {{3, 1, {1, 2, 5, 4}},
                     {3, 1, {4, 5, 8, 7}},
                     {3, 2, {2, 3, 6, 5}},
                     {3, 2, {5, 6, 9, 8}},
                     {1, 1, {2, 5}},
                     {1, 1, {5, 8}},
                     {1, 2, {1, 2}},
                     {1, 2, {2, 3}},
                     {1, 3, {7, 8}},
                     {1, 3, {8, 9}},
                     {1, 4, {1, 4}},
                     {1, 4, {4, 7}},
                     {1, 5, {3, 6}},
                     {1, 5, {6, 9}}};
    return mesh;
  }



  /** Columns of which "east" has nodes of its own on the fault, 10 to 12,
   * where its faces are in the group "east_side". */
  inline MeshText
  two_separate_columns()
  {
    MeshText mesh = two_columns();
    for (int y = 0; y < 3; ++y)
      mesh.nodes.push_back({{1., double(y), 0.}});
    mesh.groups.push_back({1, 6, "east_side"});
    mesh.elements[2].nodes = {10, 3, 6, 11};
    mesh.elements[3].nodes = {11, 6, 9, 12};
    mesh.elements[7].nodes = {10, 3};
    mesh.elements[9].nodes = {12, 9};
    mesh.elements.push_back({1, 6, {10, 11}});
    mesh.elements.push_back({1, 6, {11, 12}});
    return mesh;
  }
} // namespace StickSlip::Tests

#endif
