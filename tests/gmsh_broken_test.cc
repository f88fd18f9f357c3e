// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/geometry/fault_cutting.h>

#include <functional>
#include <utility>

#include "error_message.h"
#include "mesh_text.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::vector<MeshFault> one_fault = {{"main", "fault", {}}};



  /** Broken meshes, and words that the message must contain. */
  struct Broken
  {
    std::string              what;
    std::function<void()>    action;
    std::vector<std::string> parts;
  };



  std::ostream &
  operator<<(std::ostream &out, const Broken &broken)
  {
    return out << broken.what;
  }



  void
  cut(const MeshText                 &mesh,
      const std::vector<MeshFault>   &faults = one_fault,
      const std::vector<std::string> &bodies = {"west", "east"})
  {
    cut_at_faults(GroupedCells<2>({mesh.file()}, bodies), faults);
  }



  /** Cut the two columns after a change. */
  std::function<void()>
  cut_changed(const std::function<void(MeshText &)> &change,
              const std::vector<MeshFault>          &faults = one_fault)
  {
    return [=]() {
      MeshText mesh = two_columns();
      change(mesh);
      cut(mesh, faults);
    };
  }



  std::function<void()>
  cut_separate(const std::function<void(MeshText &)> &change,
               const std::vector<MeshFault>          &faults)
  {
    return [=]() {
      MeshText mesh = two_separate_columns();
      change(mesh);
      cut(mesh, faults);
    };
  }



  /** Read the two columns with one part of the text replaced. */
  std::function<void()>
  read_replaced(const std::string &old_text, const std::string &new_text)
  {
    return [=]() {
      std::string       text  = two_columns().text();
      const std::size_t place = text.find(old_text);
      ASSERT_NE(place, std::string::npos) << old_text;
      text.replace(place, old_text.size(), new_text);
      GmshFile::parse(text, "test.msh");
    };
  }



  std::function<void()>
  read(const std::string &text)
  {
    return [=]() { GmshFile::parse(text, "test.msh"); };
  }



  /** The two columns up to behind the first place of a word. */
  std::string
  until(const std::string &word)
  {
    const std::string text = two_columns().text();
    return text.substr(0, text.find(word) + word.size());
  }



  /** The bytes of a number. */
  template <typename Number>
  std::string
  bytes(const Number number)
  {
    return std::string(reinterpret_cast<const char *>(&number), sizeof(Number));
  }



  std::string
  binary_format(const int one)
  {
    return "$MeshFormat\n4.1 1 8\n" + bytes(one) + "\n$EndMeshFormat\n";
  }



  const auto no_change = [](MeshText &) {};

  const std::vector<MeshFault> named_sides = {
    {"main", "", {{{{"west", "fault"}}, {{"east", "east_side"}}}}}};



  const Broken files[] = {
    {"missing file",
     []() { GmshFile("/nowhere/test.msh"); },
     {"'/nowhere/test.msh'", "cannot be read"}},
    {"folder", []() { GmshFile("/"); }, {"'/'", "is a folder"}},
    {"compressed", read("\x1f\x8b\b"), {"'test.msh'", "not one of Gmsh"}},
    {"node of a negative number",
     read_replaced("1 0 0 0", "-1 0 0 0"),
     {"'-1'", "$Nodes", "number"}},
    {"empty", read(""), {"'test.msh'", "not one of Gmsh"}},
    {"other format", read("solid cube\n"), {"'test.msh'", "not one of Gmsh"}},
    {"old version", read_replaced("2.2 0 8", "2.0 0 8"), {"version 2.0"}},
    {"new version", read_replaced("2.2 0 8", "4 0 8"), {"version 4,"}},
    {"no number of bytes", read("$MeshFormat\n4.1 1 3\n"), {"3 bytes"}},
    {"other byte order",
     read(binary_format(1 << 24)),
     {"'test.msh'", "bytes in another order"}},
    {"binary that ends",
     read(binary_format(1) + "$Nodes\n" + bytes<std::uint64_t>(1) + "abc"),
     {"'test.msh'", "ends", "$Nodes"}},
    {"ends at once", read(until("$MeshFormat")), {"ends", "$MeshFormat"}},
    {"ends among names", read(until("\"west\"")), {"ends", "$PhysicalNames"}},
    {"ends in a name", read(until("\"wes")), {"ends", "$PhysicalNames"}},
    {"ends among nodes", read(until("$Nodes\n9\n1 0 0")), {"ends", "$Nodes"}},
    {"ends among elements", read(until("$Elements\n14\n1 3 2")), {"ends"}},
    {"no elements", read(until("$EndNodes")), {"no section $Elements"}},
    {"too many nodes",
     read_replaced("$Nodes\n9", "$Nodes\n8"),
     {"more in its section $Nodes"}},
    {"too few nodes",
     read_replaced("$Nodes\n9", "$Nodes\n10"),
     {"$Nodes", "'$EndNodes'", "number"}},
    {"huge number of nodes",
     read_replaced("$Nodes\n9", "$Nodes\n9000000000000000"),
     {"$Nodes", "'$EndNodes'", "number"}},
    {"too many elements",
     read_replaced("$Elements\n14", "$Elements\n13"),
     {"more in its section $Elements"}},
    {"no number", read_replaced("1 0 0 0", "1 0 O 0"), {"'O'", "$Nodes"}},
    {"infinite position", read_replaced("1 0 0 0", "1 0 inf 0"), {"finite"}},
    {"repeated node", read_replaced("2 1 0 0", "1 1 0 0"), {"number 1"}},
    {"node out of range",
     read_replaced("1 3 2 1 1 1 2 5 4", "1 3 2 1 1 1 2 5 99"),
     {"'west'", "number 1", "node 99"}},
    {"section without end", read_replaced("$Nodes", "$Others"), {"$Others"}},
    {"no nodes",
     read("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n0\n$EndElements"),
     {"no section $Nodes"}},
    {"names used twice",
     read_replaced("\"east\"", "\"west\""),
     {"two groups 'west'", "dimension 2"}},
    {"second order",
     read_replaced("1 3 2 1 1", "1 16 2 1 1"),
     {"second order", "'west'", "-order 1"}},
    {"prisms", read_replaced("1 3 2 1 1", "1 6 2 1 1"), {"prisms", "'west'"}},
    {"unknown elements",
     read_replaced("1 3 2 1 1", "1 93 2 2 1"),
     {"type 93", "'east'"}},
    {"partitioned",
     read("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 0\n"
          "$EndEntities\n$PartitionedEntities\n2\n$EndPartitionedEntities\n"
          "$Nodes\n0 0 0 0\n$EndNodes\n"
          "$Elements\n1 1 1 1\n2 7 2 1\n1 1 2 3\n$EndElements\n"),
     {"dimension 2", "number 7", "partitions"}}};



  const Broken groups[] = {
    {"third dimension",
     cut_changed([](MeshText &mesh) { mesh.nodes[4][2] = 0.1; }),
     {"'test.msh'", "'west'", "(1, 1, 0.1)", "z must be 0"}},
    {"volumes in the plane",
     cut_changed([](MeshText &mesh) {
       mesh.groups.push_back({3, 1, "lump"});
       mesh.elements.push_back({4, 1, {1, 2, 5, 4}});
     }),
     {"volumes", "'lump'", "2 dimensions"}},
    {"lines only",
     cut_changed([](MeshText &mesh) {
       mesh.elements.erase(mesh.elements.begin(), mesh.elements.begin() + 4);
     }),
     {"no surfaces"}},
    {"cell without group",
     cut_changed([](MeshText &mesh) { mesh.elements[0].group = 0; }),
     {"cell at (0.5, 0.5)", "no physical group"}},
    {"group without name",
     cut_changed([](MeshText &mesh) { mesh.elements[4].group = 77; }),
     {"without a name", "number 77", "lines"}},
    {"group without elements",
     cut_changed([](MeshText &mesh) {
       mesh.groups.push_back({1, 9, "far"});
     }),
     {"'far'", "no lines"}},
    {"group that is no body",
     cut_changed([](MeshText &mesh) { mesh.groups[1].name = "orient"; }),
     {"'orient'", "none of the bodies", "west, east"}},
    {"body without group",
     []() {
       cut(two_columns(), one_fault, {"west", "east", "north"});
     },
     {"'north'", "no cells"}},
    {"two shapes",
     cut_changed([](MeshText &mesh) {
       mesh.elements[0] = {2, 1, {1, 2, 5}};
       mesh.elements.push_back({2, 1, {1, 5, 4}});
     }),
     {"'west'", "both triangles and quadrilaterals"}},
    {"inverted cell",
     cut_changed([](MeshText &mesh) {
       mesh.nodes[0] = {{0.8, 1.8, 0.}};
     }),
     {"'west'", "inverted"}},
    {"crossed nodes",
     cut_changed([](MeshText &mesh) {
       mesh.elements[0].nodes = {1, 5, 2, 4};
     }),
     {"'west'", "(0.5, 0.5)", "inverted"}},
    {"degenerate cell",
     cut_changed([](MeshText &mesh) { mesh.nodes[0] = mesh.nodes[1]; }),
     {"'west'", "degenerate"}},
    {"cell without extent",
     cut_changed([](MeshText &mesh) {
       mesh.elements[0].nodes = {1, 1, 1, 1};
     }),
     {"'west'", "degenerate"}}};



  const Broken cuts[] = {
    {"face of no cell",
     cut_changed([](MeshText &mesh) { mesh.elements[4].nodes = {2, 8}; }),
     {"'fault'", "(1, 1)", "any cell"}},
    {"face in two groups",
     cut_changed([](MeshText &mesh) {
       mesh.elements.push_back({1, 4, {1, 2}});
     }),
     {"'bottom'", "'left'", "(0.5, 0)"}},
    {"face in two faults",
     cut_changed(
       [](MeshText &mesh) {
         mesh.groups.push_back({1, 6, "second"});
         mesh.elements.push_back({1, 6, {2, 5}});
       },
       {{"main", "fault", {}}, {"other", "second", {}}}),
     {"'fault'", "'second'", "(1, 0.5)"}},
    {"fault at a boundary",
     cut_changed(no_change, {{"main", "left", {}}, {"other", "fault", {}}}),
     {"'main'", "'left'", "(0, 0.5)"}},
    {"cell that is there twice",
     cut_changed([](MeshText &mesh) {
       mesh.elements.push_back({3, 1, {1, 2, 5, 4}});
     }),
     {"'west'", "more than two cells"}},
    {"large cell beside small ones",
     cut_changed([](MeshText &mesh) {
       mesh.nodes.push_back({{2., 0.5, 0.}});
       mesh.nodes.push_back({{3., 0.5, 0.}});
       mesh.nodes.push_back({{3., 0., 0.}});
       mesh.nodes.push_back({{3., 1., 0.}});
       mesh.elements.push_back({3, 2, {3, 12, 11, 10}});
       mesh.elements.push_back({3, 2, {10, 11, 13, 6}});
     }),
     {"'east'", "in no group"}},
    {"the same cells in two files",
     []() {
       const GmshFile file = two_columns().file();
       cut_at_faults(GroupedCells<2>({file, file}, {"west", "east"}),
                     one_fault);
     },
     {"'west'"}},
    {"boundary without group",
     cut_changed([](MeshText &mesh) { mesh.elements.pop_back(); }),
     {"'east'", "(2, 1.5)", "in no group", "one of 1"}},
    {"open fault",
     cut_changed([](MeshText &mesh) { mesh.elements[12].group = 1; }),
     {"'main'", "'fault'", "(2, 0.5)", "'east'"}},
    {"joined bodies without any face",
     cut_changed([](MeshText &mesh) {
       mesh.elements.erase(mesh.elements.begin() + 5);
     }),
     {"'west'", "'east'", "(1, 1.5)", "no fault"}},
    {"joined bodies in a group",
     cut_changed(no_change, {}),
     {"'west'", "'east'", "'fault'", "no fault"}},
    {"group inside a body",
     cut_changed([](MeshText &mesh) {
       mesh.groups.push_back({1, 6, "inner"});
       mesh.elements.push_back({1, 6, {4, 5}});
     }),
     {"'inner'", "'west'", "(0.5, 1)"}},
    {"three cells at a face",
     cut_changed([](MeshText &mesh) {
       mesh.nodes.push_back({{3., 0., 0.}});
       mesh.elements.push_back({3, 2, {2, 10, 6, 5}});
     }),
     {"(1, 0.5)", "more than two cells"}},
    {"doubled nodes where no fault is",
     cut_separate(no_change, {}),
     {"'west'", "'east'", "'fault'", "'east_side'", "do not share"}},
    {"doubled nodes within a body",
     []() {
       MeshText mesh = two_separate_columns();
       for (auto &element : mesh.elements)
         if (element.type == 3)
           element.group = 1;
       mesh.groups.erase(mesh.groups.begin() + 1);
       cut(mesh, {}, {"west"});
     },
     {"'west'", "do not share"}},
    {"joined nodes at sides",
     cut_changed(no_change,
                 {{"main",
                   "",
                   {{{{"west", "fault"}}, {{"east", "right"}}}}}}),
     {"'west fault'", "'main'", "(1, 0.5)", "both sides"}},
    {"no such group",
     cut_changed(no_change, {{"main", "crack", {}}}),
     {"'main'", "'crack'", "fault, bottom"}},
    {"no such group of a side",
     cut_changed(no_change,
                 {{"main", "", {{{{"west", "wall"}}, {{"east", "left"}}}}}}),
     {"'main'", "'west wall'", "bottom"}},
    {"group of another body",
     cut_separate(no_change,
                  {{"main",
                    "",
                    {{{{"west", "right"}}, {{"east", "east_side"}}}}}}),
     {"'west'", "'right'", "'main'"}},
    {"one group for two faults",
     cut_changed(no_change, {{"main", "fault", {}}, {"other", "fault", {}}}),
     {"'main'", "'other'", "'fault'"}},
    {"one side for two faults",
     cut_separate(no_change, {named_sides[0], {"other", "", named_sides[0].between}}),
     {"'other'", "'west'", "side of a fault already"}},
    {"unknown body",
     cut_changed(no_change, {{"main", "fault", {{{{"west", ""}}, {{"north", ""}}}}}}),
     {"'main'", "'north'", "west, east"}},
    {"bodies on one side only",
     cut_changed(no_change, {{"main", "fault", {{{{"west", ""}}, {}}}}}),
     {"'main'", "one side only"}},
    {"bodies and groups",
     cut_changed(no_change,
                 {{"main", "fault", {{{{"west", ""}}, {{"east", "right"}}}}}}),
     {"'main'", "one of these"}},
    {"other bodies",
     cut_changed(no_change,
                 {{"main", "fault", {{{{"west", ""}}, {{"west", ""}}}}}}),
     {"'main'", "(1, 0.5)", "'west'", "'east'", "not those"}},
    {"fault with a branch",
     cut_changed([](MeshText &mesh) {
       mesh.elements.push_back({1, 1, {4, 5}});
     }),
     {"'main'", "branches"}},
    {"fault that cannot slip",
     []() {
       // One body, with a column to the left that makes the face interior.
       MeshText mesh = two_columns();
       for (auto &element : mesh.elements)
         if (element.type == 3)
           element.group = 1;
       for (const double y : {0., 1., 2.})
         mesh.nodes.push_back({{-1., y, 0.}});
       mesh.elements.push_back({3, 1, {10, 1, 4, 11}});
       mesh.elements.push_back({3, 1, {11, 4, 7, 12}});
       mesh.elements[4].nodes  = {4, 5};
       mesh.elements[5].nodes  = {4, 5};
       mesh.elements[10].nodes = {10, 11};
       mesh.elements[11].nodes = {11, 12};
       mesh.elements.push_back({1, 2, {10, 1}});
       mesh.elements.push_back({1, 3, {12, 7}});
       mesh.groups.erase(mesh.groups.begin() + 1);
       cut(mesh, one_fault, {"west"});
     },
     {"'main'", "cannot slip"}},
    {"overlapping bodies",
     []() {
       MeshText mesh = two_separate_columns();
       for (int node = 9; node < 12; ++node)
         mesh.nodes[node][0] = 0.6;
       cut(mesh, named_sides);
     },
     {"'west'", "'east'", "overlap"}},
    {"folded body",
     []() {
       MeshText mesh = two_separate_columns();
       for (auto &element : mesh.elements)
         if (element.type == 3)
           element.group = 1;
       mesh.groups.erase(mesh.groups.begin() + 1);
       for (int node = 9; node < 12; ++node)
         mesh.nodes[node][0] = 0.6;
       cut(mesh, {}, {"west"});
     },
     {"'west'", "overlap"}}};



  class BrokenMesh : public ::testing::TestWithParam<Broken>
  {};
} // namespace



TEST_P(BrokenMesh, IsAnsweredWithOneSentence)
{
  expect_one_sentence_with(message_of(GetParam().action), GetParam().parts);
}



INSTANTIATE_TEST_SUITE_P(Files, BrokenMesh, ::testing::ValuesIn(files));
INSTANTIATE_TEST_SUITE_P(Groups, BrokenMesh, ::testing::ValuesIn(groups));
INSTANTIATE_TEST_SUITE_P(Cuts, BrokenMesh, ::testing::ValuesIn(cuts));



// The mesh that all of these change is none of them.
TEST(MeshText, UnchangedIsCut)
{
  EXPECT_EQ(message_of([]() { cut(two_columns()); }), "no error");
  EXPECT_EQ(message_of([]() { cut(two_separate_columns(), named_sides); }),
            "no error");
}
