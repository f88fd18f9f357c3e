// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include "opening_iterations.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Contact without friction by the primal-dual active set method
   * (Hintermueller, Ito and Kunisch 2003), a factorisation in each step. */
  template <int dim>
  Vector<double>
  active_set(const BlockMatrix<dim>              &A,
             const NodeMask                      &fixed,
             const std::vector<Reference::Bound> &bounds,
             const NodalVector                   &b,
             const NodalVector                   &given)
  {
    const BlockSparsity   &blocks = A.sparsity();
    const unsigned int     n      = blocks.n_rows() * dim;
    DynamicSparsityPattern pattern(n);
    const auto             for_each_entry = [&](const auto &action) {
      for (unsigned int i = 0; i < blocks.n_rows(); ++i)
        for (unsigned int k = blocks.row_start[i]; k < blocks.row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              action(i * dim + c,
                     blocks.column[k] * dim + d,
                     A.block(k)[c * dim + d]);
    };
    for_each_entry([&](const unsigned int i, const unsigned int j, double) {
      pattern.add(i, j);
    });
    SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    SparseMatrix<double> matrix(sparsity), divided(sparsity);
    for_each_entry([&](const unsigned int i,
                       const unsigned int j,
                       const double       value) { matrix.add(i, j, value); });

    Vector<double>    w(n), load(n), reaction(n);
    std::vector<bool> is_given(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        load[i]     = b.local_element(i);
        is_given[i] = !fixed.is_active(i / dim, i % dim);
        if (is_given[i])
          w[i] = given.local_element(i);
      }
    const std::vector<bool> always_given = is_given;
    for (unsigned int step = 0; step < 50; ++step)
      {
        // Nodes stay at their bounds as long as the force there presses.
        const std::vector<bool> before = is_given;
        is_given                       = always_given;
        for (const Reference::Bound &bound : bounds)
          {
            const unsigned int i     = bound.node * dim + dim - 1;
            const double       value = bound.sign * double(bound.value);
            if (bound.sign * (reaction[i] + matrix(i, i) * (value - w[i])) > 0.)
              {
                is_given[i] = true;
                w[i]        = value;
              }
          }
        if (step > 0 && is_given == before)
          return w;
        divided = 0.;
        Vector<double> rhs(n);
        for_each_entry(
          [&](const unsigned int i, const unsigned int j, const double value) {
            if (!is_given[i] && !is_given[j])
              divided.add(i, j, value);
            else if (!is_given[i])
              rhs[i] -= value * w[j];
          });
        for (unsigned int i = 0; i < n; ++i)
          if (is_given[i])
            {
              divided.set(i, i, 1.);
              rhs[i] = w[i];
            }
          else
            rhs[i] += load[i];
        SparseDirectUMFPACK factors;
        factors.initialize(divided);
        factors.vmult(w, rhs);
        matrix.vmult(reaction, w);
        reaction -= load;
      }
    ADD_FAILURE() << "The active set method does not end.";
    return w;
  }



  template <int dim>
  void
  expect_result_of_active_set(const std::vector<BodyGeometry<dim>> &bodies)
  {
    OpeningLayers<dim>   layers(bodies, true);
    LevelHierarchy<dim> &hierarchy = layers.problem.hierarchy();
    for (const double tau : {1e-1, 1e-3})
      {
        const NodalVector b = layers.set_step(tau, alternating_traction<dim>);
        Friction<dim>     friction = layers.friction(rough_alpha<dim>);
        const auto        bounds   = layers.let_open(friction, some_gaps<dim>);
        layers.faults_of(friction).set_normal_stresses(
          std::vector<double>(bounds.size(), 0.));
        const Vector<double> exact = active_set(hierarchy.operators().matrix(),
                                                hierarchy.finest().fixed,
                                                bounds,
                                                b,
                                                layers.start());
        TNNMGParameters      parameters;
        parameters.tolerance = 1e-10;
        NodalVector solution = layers.start();
        for (const Start start : all_starts)
          {
            NodalVector w = make_start(layers, start, solution);
            EXPECT_TRUE(TNNMGSolver<dim>(hierarchy, parameters)
                          .solve(*friction.functional, b, w)
                          .converged);
            double error = 0.;
            for (unsigned int i = 0; i < exact.size(); ++i)
              error = std::max(error, std::abs(w.local_element(i) - exact[i]));
            EXPECT_LE(error, 1e-8 * exact.linfty_norm());
            for (const Reference::Bound &bound : bounds)
              {
                const unsigned int i = bound.node * dim + dim - 1;
                EXPECT_EQ(w.local_element(i) ==
                            bound.sign * double(bound.value),
                          exact[i] == bound.sign * double(bound.value));
              }
            if (start == Start::zero)
              solution = w;
          }
        const unsigned int n = layers.n_open(friction, solution);
        EXPECT_GT(n, bounds.size() / 5);
        EXPECT_LT(n, bounds.size());
      }
  }
} // namespace



TEST(OpeningFrictionless, IsThatOfTheActiveSetMethod)
{
  expect_result_of_active_set<2>(
    {make_body<2>(1., {{10, 2}}, 2), make_body<2>(1., {{14, 2}}, 2)});
  expect_result_of_active_set<2>(
    std::vector<BodyGeometry<2>>(4, make_body<2>(1., {{10, 2}}, 2)));
  expect_result_of_active_set<3>(
    {make_body<3>(1., {{3, 3, 1}}, 1), make_body<3>(1., {{4, 4, 1}}, 1)});
}
