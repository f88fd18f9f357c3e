// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_linearisation_cost_h
#define stickslip_contrib_linearisation_cost_h

#include <stickslip/problem/spatial_problem.h>

#include "measurement.h"

namespace Measure
{
  using namespace StickSlip;

  /**
   * Time of changes of the operator on all levels, and of a V-cycle to compare
   * them with, in s.
   */
  struct LinearisationCost
  {
    /** Of the step size. */
    double new_coefficients = 0;
    /** Of all second derivatives of friction. */
    double new_hessians = 0;
    /** Of the truncation, at all nodes of the faults. */
    double new_truncation = 0;
    /** The cost at one in a hundred of these nodes, side by side. */
    double moved_front = 0;
    double v_cycle     = 0;
  };



  template <int dim>
  LinearisationCost
  measure_linearisation(SpatialProblem<dim>       &problem,
                        const std::vector<double> &coefficients)
  {
    constexpr unsigned int repetitions = 4;
    LinearisationCost      cost;
    std::vector<double>    others = coefficients;
    for (double &coefficient : others)
      coefficient *= 2.;
    LevelHierarchy<dim> &hierarchy    = problem.hierarchy();
    const auto           set_operator = [&](const std::vector<double> &c) {
      problem.combine(c);
      hierarchy.take_over_operator();
    };
    cost.new_coefficients = shortest(
      repetitions,
      [&]() { set_operator(coefficients); },
      [&]() { set_operator(others); });

    // Curvatures of the size of the matrix; every second node is truncated, or
    // every other.
    hierarchy.set_coarse_update_threshold(0.);
    const LevelDescription<dim> &finest   = hierarchy.finest();
    const auto                   hessians = [&](const double factor) {
      std::vector<Tensor<2, dim>> result;
      for (const unsigned int p : finest.nonsmooth_nodes)
        {
          const Tensor<2, dim> diagonal =
            hierarchy.operators().matrix().diagonal_block(p);
          Tensor<2, dim> hessian;
          for (unsigned int c = 0; c < dim; ++c)
            if (finest.fixed.is_active(p, c))
              hessian[c][c] = factor * diagonal[c][c];
          result.push_back(hessian);
        }
      return result;
    };
    const auto truncation = [&](const unsigned int remainder) {
      NodeMask active = finest.fixed;
      for (unsigned int k = remainder; k < finest.nonsmooth_nodes.size();
           k += 2)
        active.mask_node(finest.nonsmooth_nodes[k]);
      return active;
    };
    const auto front = [&](const unsigned int end) {
      NodeMask active = finest.fixed;
      for (unsigned int k = 0; k < end; ++k)
        active.mask_node(finest.nonsmooth_nodes[k]);
      return active;
    };
    const auto     one = hessians(1.), two = hessians(2.);
    const NodeMask even = truncation(0), odd = truncation(1);
    cost.new_hessians = shortest(
      repetitions,
      [&]() { hierarchy.linearise(one, finest.fixed); },
      [&]() { hierarchy.linearise(two, finest.fixed); });
    // No curvature where a node is truncated.
    const std::vector<Tensor<2, dim>> none(one.size());
    cost.new_truncation = shortest(
      repetitions,
      [&]() { hierarchy.linearise(none, even); },
      [&]() { hierarchy.linearise(none, odd); });
    const unsigned int half  = finest.nonsmooth_nodes.size() / 2;
    const NodeMask     there = front(half),
                   moved     = front(half + std::max(half / 50, 1u));
    cost.moved_front         = shortest(
      repetitions,
      [&]() { hierarchy.linearise(none, moved); },
      [&]() { hierarchy.linearise(none, there); });
    hierarchy.linearise(none, even);

    NodalVector x = finest.nodes.make_vector(), b = x;
    b = 1.;
    even.apply(b);
    cost.v_cycle =
      shortest(2 * repetitions, [&]() { hierarchy.v_cycle(x, b); });
    return cost;
  }
} // namespace Measure

#endif
