// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "error_message.h"
#include "stacked_bodies.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  const std::vector<std::string> two_bodies = {"lower", "upper"};

  constexpr types::boundary_id top = 3, bottom = 2;



  std::string
  message_of_topology(const std::vector<Fault> &faults)
  {
    return message_of([&]() { FaultTopology(two_bodies, faults); });
  }



  std::string
  message_of_meshes(const Fault &fault)
  {
    const FaultTopology topology(two_bodies, {fault});
    const auto          bodies =
      stack<2>({make_body<2>(1., {{4, 1}}, 1), make_body<2>(1., {{4, 1}}, 1)});
    return message_of(
      [&]() { MeshHierarchy<2>(bodies, topology, MPI_COMM_WORLD); });
  }
} // namespace



TEST(Topology, StackHasAFaultBetweenEachTwoBodies)
{
  const FaultTopology stack =
    stack_topology<3>({"a", "b", "c"}, {"first", "second"});
  ASSERT_EQ(stack.faults().size(), 2u);
  for (unsigned int f = 0; f < 2; ++f)
    {
      const Fault &fault = stack.faults()[f];
      EXPECT_EQ(fault.name, f == 0 ? "first" : "second");
      ASSERT_EQ(fault.sides[0].size(), 1u);
      ASSERT_EQ(fault.sides[1].size(), 1u);
      EXPECT_TRUE(fault.sides[0][0] == (BodySide{f, 5}));
      EXPECT_TRUE(fault.sides[1][0] == (BodySide{f + 1, 4}));
    }
  using Sides = std::set<types::boundary_id>;
  EXPECT_EQ(stack.sides_at_faults(0), (Sides{5}));
  EXPECT_EQ(stack.sides_at_faults(1), (Sides{4, 5}));
  EXPECT_EQ(stack.sides_at_faults(2), (Sides{4}));
  EXPECT_TRUE(stack.is_at_fault(0, 5));
  EXPECT_FALSE(stack.is_at_fault(0, 4));
}



TEST(Topology, BrokenOnesAreAnsweredWithOneSentence)
{
  expect_one_sentence_with(message_of_topology({{"main", {{{{0, top}}, {}}}}}),
                           {"'main'", "one side only"});
  expect_one_sentence_with(message_of_topology(
                             {{"main", {{{{0, top}}, {{2, bottom}}}}}}),
                           {"'main'", "body number 3", "only 2"});
  expect_one_sentence_with(message_of_topology(
                             {{"main", {{{{0, top}}, {{1, bottom}}}}},
                              {"other", {{{{1, top}}, {{0, top}}}}}}),
                           {"'other'", "side 3", "'lower'"});
  expect_one_sentence_with(message_of_topology(
                             {{"main", {{{{0, top}}, {{0, top}}}}}}),
                           {"'main'", "side 3", "'lower'"});

  expect_one_sentence_with(message_of_meshes(
                             {"main", {{{{0, top}}, {{1, 7}}}}}),
                           {"'main'", "no faces"});
  // Sides far from each other, and such that face the same way.
  expect_one_sentence_with(message_of_meshes({"main", {{{{0, 1}}, {{1, 0}}}}}),
                           {"'main'", "do not face"});
  expect_one_sentence_with(message_of_meshes(
                             {"main", {{{{0, bottom}}, {{1, bottom}}}}}),
                           {"'main'", "do not face"});
}



TEST(Topology, MeshesDoNotDependOnTheOrderOfBodies)
{
  const auto             bodies = layered_bodies();
  const MeshHierarchy<2> stacked(bodies, MPI_COMM_WORLD);

  const std::vector<unsigned int> order = {3, 0, 4, 2, 1};
  std::vector<BodyGeometry<2>>    permuted(bodies.size());
  std::vector<std::string>        names(bodies.size());
  for (unsigned int b = 0; b < bodies.size(); ++b)
    {
      permuted[order[b]] = bodies[b];
      names[order[b]]    = std::to_string(b);
    }
  std::vector<Fault> faults;
  for (unsigned int f = 0; f + 1 < bodies.size(); ++f)
    faults.push_back(
      {std::to_string(f), {{{{order[f], top}}, {{order[f + 1], bottom}}}}});
  const MeshHierarchy<2> listed(permuted,
                                FaultTopology(names, faults),
                                MPI_COMM_WORLD);

  ASSERT_EQ(listed.n_levels(), stacked.n_levels());
  for (unsigned int l = 0; l < listed.n_levels(); ++l)
    {
      EXPECT_EQ(listed.level(l).n_nodes(), stacked.level(l).n_nodes());
      for (unsigned int f = 0; f < faults.size(); ++f)
        for (const unsigned int side : {0, 1})
          EXPECT_EQ(listed.level(l).surface(f, side).points,
                    stacked.level(l).surface(f, side).points);
    }
}
