// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_friction_chain_h
#define stickslip_tests_friction_chain_h

#include <stickslip/friction/fault_friction.h>
#include <stickslip/friction/rate_and_state.h>
#include <stickslip/multigrid/level_hierarchy.h>

#include <random>

#include "coulomb_functional.h"
#include "dense_minimisation.h"
#include "serial_matrices.h"

namespace StickSlip::Tests
{
  using Kind = Reference::Term::Kind;

  /**
   * A functional on the given nodes, and what a reference needs of it. The
   * state alpha means nothing to Coulomb's friction.
   */
  template <int dim>
  struct Friction
  {
    std::unique_ptr<NonsmoothFunctional<dim>> functional;
    std::vector<Reference::Term>              terms;
  };

  template <int dim>
  Friction<dim>
  make_friction(const Kind                       kind,
                const std::vector<unsigned int> &nodes,
                const std::vector<double>       &weights,
                const double                     normal_stress,
                const std::vector<double>       &alpha)
  {
    const RateAndStateParameters parameters;
    Friction<dim>                friction;
    std::vector<double>          loads;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        Reference::Term term;
        term.node = nodes[k];
        term.kind = kind;
        term.load = weights[k] * normal_stress;
        if (kind == Kind::coulomb)
          term.load *= 0.6L;
        else
          {
            term.a = parameters.a;
            term.log_min =
              std::log(parameters.reference_slip_rate) -
              (parameters.reference_friction +
               parameters.b *
                 (alpha[k] + std::log(parameters.reference_slip_rate /
                                      parameters.characteristic_slip))) /
                parameters.a;
          }
        loads.push_back(term.load);
        friction.terms.push_back(term);
      }
    if (kind == Kind::coulomb)
      {
        friction.functional =
          std::make_unique<CoulombFunctional<dim>>(nodes, loads);
        return friction;
      }
    auto functional = std::make_unique<FaultFriction<dim>>(
      nodes,
      weights,
      std::vector<double>(nodes.size(), normal_stress),
      std::vector<std::shared_ptr<const FrictionLaw>>{
        std::make_shared<RateAndStateLaw>(parameters,
                                          kind == Kind::truncated ?
                                            Regularisation::truncated :
                                            Regularisation::arcsinh)},
      std::vector<unsigned int>(nodes.size(), 0));
    functional->set_state(alpha);
    friction.functional = std::move(functional);
    return friction;
  }



  /**
   * Seventeen nodes in a row, neighbours joined by random springs of very
   * different directions. The last node is held, the first nine have friction;
   * every other of these has its normal component fixed. Coarse levels have
   * nine and five nodes.
   */
  template <int dim>
  struct FrictionChain
  {
    static constexpr unsigned int n_nodes = 17;
    static constexpr double       scale   = 1e7;

    std::mt19937                     engine{7};
    std::normal_distribution<double> normal;
    OperatorSum<dim>                 operators;
    LevelHierarchy<dim>              hierarchy;
    NodalVector                      b, start;

    FrictionChain()
      : operators(descriptions().back(), {springs()})
      , hierarchy(operators, descriptions())
      , b(hierarchy.finest().nodes.make_vector())
      , start(b)
    {
      operators.combine({1.});
      for (unsigned int i = 0; i < b.size(); ++i)
        b.local_element(i) = 5e3 * normal(engine);
      for (unsigned int c = 0; c < dim; ++c)
        start.local_element((n_nodes - 1) * dim + c) = 2e-4 * normal(engine);
    }

    BlockMatrix<dim>
    springs()
    {
      const auto       sparsity = chain_sparsity(n_nodes);
      BlockMatrix<dim> A(sparsity);
      const auto       add = [&](const unsigned int    i,
                           const unsigned int    j,
                           const Tensor<2, dim> &value) {
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            A.block(sparsity->position(i, j))[c * dim + d] += value[c][d];
      };
      for (unsigned int i = 0; i + 1 < n_nodes; ++i)
        {
          Tensor<2, dim> R, spring;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              R[c][d] = normal(engine);
          spring = R * transpose(R);
          for (unsigned int c = 0; c < dim; ++c)
            spring[c][c] += 0.5;
          spring *= scale;
          add(i, i, spring);
          add(i + 1, i + 1, spring);
          add(i, i + 1, -spring);
          add(i + 1, i, -spring);
        }
      return A;
    }

    Friction<dim>
    friction(const Kind kind, const std::vector<double> &alpha) const
    {
      const std::vector<unsigned int> nodes =
        hierarchy.finest().nonsmooth_nodes;
      return make_friction<dim>(
        kind, nodes, std::vector<double>(nodes.size(), 0.1), 5e4, alpha);
    }

    static std::shared_ptr<const BlockSparsity>
    chain_sparsity(const unsigned int n)
    {
      std::vector<std::vector<unsigned int>> rows(n);
      for (unsigned int i = 0; i < n; ++i)
        for (const int j : {int(i) - 1, int(i) + 1})
          if (j >= 0 && j < int(n))
            rows[i].push_back(j);
      return std::make_shared<const BlockSparsity>(rows);
    }

    static std::vector<LevelDescription<dim>>
    descriptions()
    {
      std::vector<LevelDescription<dim>> levels(3);
      for (unsigned int l = 0; l < 3; ++l)
        {
          const unsigned int n = (4u << l) + 1, n_friction = (2u << l) + 1;
          levels[l].nodes = serial_nodes(n, dim);
          levels[l].fixed = NodeMask(n, dim);
          levels[l].fixed.mask_node(n - 1);
          for (unsigned int i = 0; i < n_friction; ++i)
            levels[l].nonsmooth_nodes.push_back(i);
          if (l == 0)
            continue;
          std::vector<GlobalRow> rows(n);
          for (unsigned int i = 0; i < n; ++i)
            if (i % 2 == 0)
              rows[i] = {{i / 2, 1.}};
            else
              rows[i] = {{i / 2, 0.5}, {i / 2 + 1, 0.5}};
          // The coarse nodes make a chain again.
          levels[l].to_coarser =
            std::make_shared<GalerkinProduct<dim>>(levels[l].nodes,
                                                   *chain_sparsity(n),
                                                   rows,
                                                   complete_index_set((n + 1) /
                                                                      2));
        }
      for (unsigned int i = 1; i < 9; i += 2)
        levels[2].fixed.mask(i, dim - 1);
      return levels;
    }
  };
} // namespace StickSlip::Tests

#endif
