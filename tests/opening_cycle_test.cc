// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <iostream>

#include "falling_block.h"
#include "linear_iterations.h"
#include "opening_layers.h"
#include "pressed_sphere.h"
#include "random_vectors.h"
#include "without_friction.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Each normal jump is at its bound with this probability. */
  template <int dim>
  NodeMask
  random_contact(const LevelDescription<dim> &finest, const double probability)
  {
    static std::mt19937         engine(5);
    std::bernoulli_distribution touches(probability);
    NodeMask                    active = finest.fixed;
    for (const unsigned int p : finest.nonsmooth_nodes)
      if (touches(engine))
        active.mask(p, dim - 1);
    return active;
  }



  /** Smoothing sweeps of a scene that does not say how many. */
  template <int dim>
  unsigned int
  default_sweeps(const bool may_open)
  {
    const std::string contact = may_open ? "unilateral" : "bilateral";
    return static_cast<unsigned int>(
      read_opening_scene<dim>(dim == 2 ? falling_block : pressed_sphere,
                              {"Faults/contact/Contact=" + contact,
                               "Faults/contact/Initial gap=0"})
        .tnnmg.smoothing_sweeps);
  }



  /** The factor by which the error shrinks in a V-cycle in the end, in the
   * energy norm: mean of the last ten of thirty. */
  template <int dim>
  double
  convergence_factor(LevelHierarchy<dim> &hierarchy, const NodeMask &active)
  {
    constexpr unsigned int n_cycles = 30, n_last = 10;
    NodalVector            error   = random_vector(hierarchy.finest(), active);
    NodalVector            product = error, correction = error;
    double                 first = 0., last = 0.;
    for (unsigned int k = 0; k <= n_cycles; ++k)
      {
        hierarchy.vmult_linearised(product, error);
        last = std::sqrt(error * product);
        if (k == n_cycles - n_last)
          first = last;
        hierarchy.v_cycle(correction, product);
        error -= correction;
      }
    return std::pow(last / first, 1. / n_last);
  }



  template <int dim>
  void
  expect_fast_cycles(const std::string                    &name,
                     const std::vector<BodyGeometry<dim>> &bodies)
  {
    OpeningLayers<dim>   layers(bodies, true);
    LevelHierarchy<dim> &hierarchy = layers.problem.hierarchy();
    hierarchy.set_smoothing_sweeps(default_sweeps<dim>(true));
    layers.problem.combine(Newmark<dim>().operator_coefficients(1e-2));
    std::cout << name << ':';
    for (const CyclePrecision precision :
         {CyclePrecision::single_precision, CyclePrecision::double_precision})
      {
        hierarchy.set_cycle_precision(precision);
        for (const double probability : {0., 0.1, 0.5, 0.9, 1.})
          {
            const NodeMask active =
              random_contact(hierarchy.finest(), probability);
            linearise_without_friction(hierarchy, active);
            const double       factor = convergence_factor(hierarchy, active);
            const unsigned int steps =
              cg_iterations(hierarchy,
                            random_vector(hierarchy.finest(), active));
            std::cout << ' ' << factor << '/' << steps;
            EXPECT_LE(factor, 0.55) << name << ' ' << probability;
            EXPECT_LE(steps, dim == 2 ? 11u : 12u)
              << name << ' ' << probability;
          }
      }
    std::cout << std::endl;
  }



  /** The levels with what is masked on the finest one handed down: a component
   * of a coarse jump is dropped if it is in all fine jumps in its reach, and
   * what is prescribed on its level. */
  template <int dim>
  std::vector<LevelDescription<dim>>
  hand_down(const LevelHierarchy<dim> &hierarchy, const NodeMask &active)
  {
    std::vector<LevelDescription<dim>> levels;
    for (unsigned int l = 0; l < hierarchy.n_levels(); ++l)
      levels.push_back(hierarchy.description(l));
    levels.back().fixed = active;
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        const LevelDescription<dim>       &fine   = levels[l];
        LevelDescription<dim>             &coarse = levels[l - 1];
        std::vector<std::array<bool, dim>> reaches(coarse.fixed.n_nodes());
        const auto &P = fine.to_coarser->prolongation().matrix();
        for (const unsigned int i : fine.nonsmooth_nodes)
          for (unsigned int k = P.row_start[i]; k < P.row_start[i + 1]; ++k)
            for (unsigned int c = 0; c < dim; ++c)
              if (fine.fixed.is_active(i, c))
                reaches[P.column[k]][c] = true;
        for (const unsigned int I : coarse.nonsmooth_nodes)
          for (unsigned int c = 0; c < dim; ++c)
            if (!reaches[I][c])
              coarse.fixed.mask(I, c);
      }
    return levels;
  }



  /** Expect a cycle that is symmetric, and the same as one whose levels were
   * made for this division of the nodes alone. */
  template <int dim>
  void
  expect_cycle_made_anew(const std::vector<BodyGeometry<dim>> &bodies,
                         const bool                            opens_in_part)
  {
    OpeningLayers<dim>   layers(bodies, true, opens_in_part);
    LevelHierarchy<dim> &hierarchy = layers.problem.hierarchy();
    hierarchy.set_cycle_precision(CyclePrecision::double_precision);
    // One after the other on the same hierarchy, so that traces of the last one
    // would show.
    for (const double probability : {0.5, 0., 1., 0.9, 0.2})
      for (const double tau : {1e-2, 1e-4})
        {
          layers.problem.combine(Newmark<dim>().operator_coefficients(tau));
          const NodeMask active =
            random_contact(hierarchy.finest(), probability);
          linearise_without_friction(hierarchy, active);
          OperatorSum<dim>    only_A(hand_down(hierarchy, active).back(),
                                  {hierarchy.operators().matrix()});
          LevelHierarchy<dim> anew(only_A, hand_down(hierarchy, active));
          anew.set_cycle_precision(CyclePrecision::double_precision);
          only_A.combine({1.});
          linearise_without_friction(anew, active);

          const NodalVector b = random_vector(hierarchy.finest(), active);
          NodalVector       x = b, y = b, a = b;
          for (unsigned int i = 0; i < a.locally_owned_size(); ++i)
            a.local_element(i) *= std::sin(3. * i);
          NodalVector V_a = a;
          hierarchy.v_cycle(x, b);
          anew.v_cycle(y, b);
          hierarchy.v_cycle(V_a, a);
          EXPECT_NEAR(a * x, b * V_a, 1e-12 * a.l2_norm() * x.l2_norm());
          const double size = y.linfty_norm();
          x -= y;
          EXPECT_LE(x.linfty_norm(), 1e-12 * size);
        }
  }
} // namespace



TEST(OpeningCycle, CoarseNormalsAreDroppedWhereAllFineOnesAre)
{
  for (const bool opens_in_part : {false, true})
    {
      expect_cycle_made_anew<2>({make_body<2>(1., {{10, 2}}, 3),
                                 make_body<2>(1., {{14, 2}}, 3)},
                                opens_in_part);
      expect_cycle_made_anew<3>({make_body<3>(1., {{3, 3, 1}}, 2),
                                 make_body<3>(1., {{4, 4, 1}}, 2)},
                                opens_in_part);
    }
}



TEST(OpeningCycle, HasTwoSweepsWhereAFaultMayOpen)
{
  EXPECT_EQ(default_sweeps<2>(true), 2u);
  EXPECT_EQ(default_sweeps<2>(false), 1u);
  EXPECT_EQ(default_sweeps<3>(true), 2u);
  EXPECT_EQ(default_sweeps<3>(false), 1u);
}



TEST(OpeningCycle, ConvergesWithRandomOpenNodes)
{
  for (const unsigned int upper_cells : {10, 14})
    for (const unsigned int passes : {1, 2, 3, 4})
      expect_fast_cycles<2>(std::to_string(upper_cells) + " cells, " +
                              std::to_string(passes) + " passes",
                            {make_body<2>(1., {{10, 2}}, passes),
                             make_body<2>(1., {{upper_cells, 2}}, passes)});
  for (const unsigned int upper_cells : {5, 7})
    for (const unsigned int passes : {1, 2})
      expect_fast_cycles<3>(
        "three dimensions, " + std::to_string(upper_cells) + " cells, " +
          std::to_string(passes) + " passes",
        {make_body<3>(1., {{5, 5, 1}}, passes),
         make_body<3>(1., {{upper_cells, upper_cells, 1}}, passes)});
}
