// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_random_vectors_h
#define stickslip_tests_random_vectors_h

#include <gtest/gtest.h>
#include <stickslip/multigrid/level_hierarchy.h>

#include <random>

namespace StickSlip::Tests
{
  /** Normally distributed entries, zero in masked components. */
  template <int n_components>
  NodalVector
  random_vector(const LevelDescription<n_components> &level,
                const NodeMask                       &active,
                const unsigned int                    seed = 11)
  {
    std::mt19937                     engine(seed);
    std::normal_distribution<double> normal;
    NodalVector                      x = level.nodes.make_vector();
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      x.local_element(i) = normal(engine);
    active.apply(x);
    return x;
  }



  /** The mask in which each tangential jump is truncated with this
   * probability. */
  template <int n_components>
  NodeMask
  random_truncation(const LevelDescription<n_components> &finest,
                    const double                          probability,
                    std::mt19937                         &engine)
  {
    std::bernoulli_distribution is_truncated(probability);
    NodeMask                    active = finest.fixed;
    for (const unsigned int p : finest.nonsmooth_nodes)
      for (unsigned int c = 0; c + 1 < n_components; ++c)
        if (is_truncated(engine))
          active.mask(p, c);
    return active;
  }



  /** Expect that the V-cycle with these components is symmetric, up to a
   * relative @p tolerance, and positive. */
  template <int n_components>
  void
  expect_symmetric_cycle(LevelHierarchy<n_components> &hierarchy,
                         const NodeMask               &active,
                         const double                  tolerance)
  {
    const NodalVector x  = random_vector(hierarchy.finest(), active, 1);
    const NodalVector y  = random_vector(hierarchy.finest(), active, 2);
    NodalVector       Vx = x, Vy = y;
    hierarchy.v_cycle(Vx, x);
    hierarchy.v_cycle(Vy, y);
    EXPECT_NEAR(x * Vy, y * Vx, tolerance * x.l2_norm() * Vy.l2_norm());
    EXPECT_GT(x * Vx, 0.);
  }
} // namespace StickSlip::Tests

#endif
