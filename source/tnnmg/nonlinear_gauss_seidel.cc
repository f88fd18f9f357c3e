// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/masked_entries.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>

namespace StickSlip
{
  template <int n_components>
  void
  nonlinear_gauss_seidel(const OperatorSum<n_components>         &operators,
                         const NonsmoothFunctional<n_components> &functional,
                         const bool                               is_everywhere,
                         NodalVector                             &w,
                         NodalVector                             &r)
  {
    const std::vector<unsigned int> &nodes = functional.nodes();
    const BlockMatrix<n_components> &A     = operators.matrix();
    const NodeMask                  &fixed = operators.unknowns().fixed;
    const auto                       move_to = [&](const unsigned int             i,
                             const Tensor<1, n_components> &v) {
      A.subtract_column(i, v - block<n_components>(w, i), r);
      for (unsigned int c = 0; c < n_components; ++c)
        w.local_element(i * n_components + c) = v[c];
    };
    const auto minimise = [&](const unsigned int k) {
      const unsigned int             i = nodes[k];
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
    unsigned int next = 0;
    for (unsigned int k = 0; k <= nodes.size(); ++k)
      {
        const unsigned int end = k < nodes.size() ? nodes[k] : A.n_rows();
        if (is_everywhere)
          for (unsigned int i = next; i < end; ++i)
            relax(i);
        if (k < nodes.size())
          minimise(k);
        next = end + 1;
      }
    add_ghosts_to_owners(r);
  }



#define STICKSLIP_INSTANTIATE(n_components)           \
  template void nonlinear_gauss_seidel<n_components>( \
    const OperatorSum<n_components> &,                \
    const NonsmoothFunctional<n_components> &,        \
    const bool,                                       \
    NodalVector &,                                    \
    NodalVector &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
