// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/gmsh_file.h>

#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "mesh_text.h"
#include "project_directories.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::string meshes = STICKSLIP_SOURCE_DIR "/tests/meshes/";



  /** Elements by their positions and the name of their group, in no order. */
  std::multiset<std::pair<std::string, std::vector<std::vector<float>>>>
  elements_by_position(const GmshFile &file)
  {
    std::multiset<std::pair<std::string, std::vector<std::vector<float>>>>
      result;
    for (const auto &elements : file.elements)
      for (const auto &element : elements)
        {
          std::vector<std::vector<float>> positions;
          for (unsigned int v = 0; v < element.n_nodes; ++v)
            {
              const Point<3> &node = file.nodes[element.nodes[v]];
              positions.push_back(
                {float(node[0]), float(node[1]), float(node[2])});
            }
          result.emplace(file.describe(element.group), positions);
        }
    return result;
  }



  template <typename Number>
  void
  append(std::string &bytes, const Number number)
  {
    bytes.append(reinterpret_cast<const char *>(&number), sizeof(Number));
  }
} // namespace



TEST(GmshFile, PlainDataOfASmallOne)
{
  const GmshFile file = two_columns().file();
  ASSERT_EQ(file.nodes.size(), 9u);
  EXPECT_EQ(file.nodes[5], Point<3>(2., 1., 0.));
  ASSERT_EQ(file.groups.size(), 7u);
  EXPECT_EQ(file.groups[1].name, "east");
  EXPECT_EQ(file.groups[1].dim, 2u);
  ASSERT_EQ(file.elements[2].size(), 4u);
  ASSERT_EQ(file.elements[1].size(), 10u);
  // In deal.II's order.
  const GmshFile::Element &last = file.elements[2][3];
  EXPECT_EQ(last.n_nodes, 4u);
  EXPECT_EQ(last.group, 1u);
  EXPECT_EQ(std::vector<unsigned int>(last.nodes.begin(),
                                      last.nodes.begin() + 4),
            std::vector<unsigned int>({4, 5, 7, 8}));
  EXPECT_EQ(file.describe(2), "the group 'fault'");
}



TEST(GmshFile, LengthsAreMultiplesOfTheUnit)
{
  const GmshFile file = GmshFile::parse(two_columns().text(), "test", 1000.);
  EXPECT_EQ(file.nodes[5], Point<3>(2000., 1000., 0.));
}



TEST(GmshFile, AllFormatsSayTheSame)
{
  const GmshFile file(meshes + "slit.msh");
  EXPECT_GT(file.elements[2].size(), 50u);
  EXPECT_EQ(file.groups.size(), 6u);
  const auto expected = elements_by_position(file);
  for (const std::string other :
       {"slit_binary.msh", "slit_22.msh", "slit_22_binary.msh"})
    {
      const GmshFile same(meshes + other);
      EXPECT_EQ(same.nodes.size(), file.nodes.size()) << other;
      EXPECT_EQ(elements_by_position(same), expected) << other;
    }
}



TEST(GmshFile, HexahedraAndTetrahedraHavePositiveVolumesInDealIIsOrder)
{
  for (const std::string name : {"dipping.msh", "patch.msh"})
    {
      const GmshFile file(meshes + name);
      ASSERT_FALSE(file.elements[3].empty());
      for (const auto &cell : file.elements[3])
        {
          const auto vertex = [&](const unsigned int v) {
            return file.nodes[cell.nodes[v]];
          };
          const bool is_tetrahedron = cell.n_nodes == 4;
          EXPECT_GT(cross_product_3d(vertex(1) - vertex(0),
                                     vertex(2) - vertex(0)) *
                      (vertex(is_tetrahedron ? 3 : 4) - vertex(0)),
                    0.);
          // Vertex 3 is opposite to 0 in the lower face.
          if (!is_tetrahedron)
            {
              EXPECT_GT(cross_product_3d(vertex(2) - vertex(3),
                                         vertex(1) - vertex(3)) *
                          (vertex(7) - vertex(3)),
                        0.);
            }
        }
    }
}



// Numbers beyond 32 bits, in text and binary, and nodes with parameters.
TEST(GmshFile, LargeNumbersOfNodes)
{
  const std::uint64_t large = std::uint64_t(1) << 40;
  std::string         text =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n1\n1 3 \"a line\"\n$EndPhysicalNames\n"
    "$Entities\n0 1 0 0\n5 0 0 0 1 0 0 2 3 -4 2 1 -2\n"
    "$EndEntities\n$Nodes\n1 2 1 " +
    std::to_string(large) + "\n1 5 1 2\n7\n" + std::to_string(large) +
    "\n0 0 0 0.\n1 0 0 1.\n$EndNodes\n"
    "$Elements\n1 1 1 1\n1 5 1 1\n" +
    std::to_string(large) + " " + std::to_string(large) + " 7\n$EndElements\n";
  std::string binary = "$MeshFormat\n4.1 1 8\n";
  append(binary, 1);
  binary += "\n$EndMeshFormat\n$PhysicalNames\n1\n1 3 \"a line\"\n"
            "$EndPhysicalNames\n$Entities\n";
  for (const std::uint64_t n : {0, 1, 0, 0})
    append(binary, n);
  append(binary, 5);
  for (const double x : {0., 0., 0., 1., 0., 0.})
    append(binary, x);
  append(binary, std::uint64_t(2));
  append(binary, 3);
  append(binary, -4);
  append(binary, std::uint64_t(2));
  append(binary, 1);
  append(binary, -2);
  binary += "\n$EndEntities\n$Nodes\n";
  for (const std::uint64_t n :
       {std::uint64_t(1), std::uint64_t(2), std::uint64_t(1), large})
    append(binary, n);
  for (const int n : {1, 5, 1})
    append(binary, n);
  for (const std::uint64_t n : {std::uint64_t(2), std::uint64_t(7), large})
    append(binary, n);
  for (const double x : {0., 0., 0., 0., 1., 0., 0., 1.})
    append(binary, x);
  binary += "\n$EndNodes\n$Elements\n";
  for (const std::uint64_t n : {1, 1, 1, 1})
    append(binary, n);
  for (const int n : {1, 5, 1})
    append(binary, n);
  for (const std::uint64_t n :
       {std::uint64_t(1), large, large, std::uint64_t(7)})
    append(binary, n);
  binary += "\n$EndElements\n";

  for (const std::string &contents : {text, binary})
    {
      const GmshFile file = GmshFile::parse(contents, "test");
      ASSERT_EQ(file.nodes.size(), 2u);
      EXPECT_EQ(file.nodes[1], Point<3>(1., 0., 0.));
      // Once for each of the two groups.
      ASSERT_EQ(file.elements[1].size(), 2u);
      for (unsigned int g = 0; g < 2; ++g)
        {
          const GmshFile::Element &element = file.elements[1][g];
          EXPECT_EQ(element.group, g);
          EXPECT_EQ(element.nodes[0], 1u);
          EXPECT_EQ(element.nodes[1], 0u);
        }
      EXPECT_EQ(file.describe(0), "the group 'a line'");
      EXPECT_EQ(file.describe(1),
                "the group without a name, number 4 of dimension 1");
    }
}



TEST(GmshFile, UnknownSectionsAndWindowsLinesAreNoMatter)
{
  const MeshText mesh = two_columns();
  std::string    text = mesh.text();
  text.insert(text.find("$Nodes"),
              "$Comments\nNodes of $Nodes\n$EndComments\n");
  std::string lines;
  for (const char c : text)
    lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(elements_by_position(GmshFile::parse(lines, "test")),
            elements_by_position(mesh.file()));
}
