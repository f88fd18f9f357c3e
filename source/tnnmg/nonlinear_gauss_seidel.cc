// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/masked_entries.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>

#include <algorithm>

namespace StickSlip
{
  template <int n_components>
  NonlinearGaussSeidel<n_components>::NonlinearGaussSeidel(
    const OperatorSum<n_components> &operators)
    : operators(operators)
    , turns(operators.unknowns().nodes,
            operators.matrix().sparsity(),
            /*units=*/{},
            /*may_overlap=*/false)
  {
    if (turns.n_turns() == 1)
      return;
    const NodePartition      &nodes = operators.unknowns().nodes;
    std::vector<unsigned int> ghosts;
    for (const unsigned int j : operators.matrix().sparsity().coupled_to(
           operators.unknowns().nonsmooth_nodes))
      if (j >= nodes.n_owned())
        ghosts.push_back(j);
    beside_nonsmooth_nodes = SomeGhosts(nodes, ghosts);
  }



  template <int n_components>
  void
  NonlinearGaussSeidel<n_components>::sweep(
    const NonsmoothFunctional<n_components> &functional,
    const bool                               is_everywhere,
    NodalVector                             &w,
    NodalVector                             &r) const
  {
    const std::vector<unsigned int> &nonsmooth = functional.nodes();
    const BlockMatrix<n_components> &A         = operators.matrix();
    const NodeMask                  &fixed     = operators.unknowns().fixed;
    const auto                       move_to = [&](const unsigned int             i,
                             const Tensor<1, n_components> &v) {
      A.subtract_column(i, v - block<n_components>(w, i), r);
      for (unsigned int c = 0; c < n_components; ++c)
        w.local_element(i * n_components + c) = v[c];
    };
    const auto minimise = [&](const unsigned int k) {
      const unsigned int             i = nonsmooth[k];
      std::array<bool, n_components> active;
      for (unsigned int c = 0; c < n_components; ++c)
        active[c] = fixed.is_active(i, c);
      move_to(i,
              minimiser_at<n_components>(functional,
                                         k,
                                         A.diagonal_block(i),
                                         block<n_components>(r, i),
                                         active,
                                         block<n_components>(w, i)));
    };
    const auto relax = [&](const unsigned int i) {
      move_to(i,
              block<n_components>(w, i) +
                invert_active(A.diagonal_block(i), fixed, i) *
                  block<n_components>(r, i));
    };

    r.zero_out_ghost_values();
    for (unsigned int turn = 0; turn < turns.n_turns(); ++turn)
      {
        for (const auto &[begin, end] : turns.units(turn))
          {
            unsigned int i = begin;
            unsigned int k =
              std::lower_bound(nonsmooth.begin(), nonsmooth.end(), begin) -
              nonsmooth.begin();
            for (; k < nonsmooth.size() && nonsmooth[k] < end; ++k)
              {
                if (is_everywhere)
                  for (; i < nonsmooth[k]; ++i)
                    relax(i);
                minimise(k);
                i = nonsmooth[k] + 1;
              }
            if (is_everywhere)
              for (; i < end; ++i)
                relax(i);
          }
        if (is_everywhere)
          add_ghosts_to_owners(r);
        else
          beside_nonsmooth_nodes.add_to_owners(r);
      }
  }



  template class NonlinearGaussSeidel<1>;
  template class NonlinearGaussSeidel<2>;
  template class NonlinearGaussSeidel<3>;
} // namespace StickSlip
