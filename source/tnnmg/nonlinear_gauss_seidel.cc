// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>

namespace StickSlip
{
  namespace
  {
    /** The point at which the k-th term of the functional and the rest of the
     * energy are minimal at its node, between the active components. */
    template <int n_components>
    Tensor<1, n_components>
    minimiser_at_term(const OperatorSum<n_components>         &operators,
                      const NonsmoothFunctional<n_components> &functional,
                      const unsigned int                       k,
                      const NodalVector                       &w,
                      const NodalVector                       &r)
    {
      const unsigned int            i = functional.nodes()[k];
      const Tensor<2, n_components> A = operators.matrix().diagonal_block(i);
      const Tensor<1, n_components> start = block<n_components>(w, i);
      // Moving the part of the active components of this node to the left
      // leaves what the minimiser is asked for.
      Tensor<1, n_components>        load = block<n_components>(r, i);
      std::array<bool, n_components> active;
      for (unsigned int c = 0; c < n_components; ++c)
        active[c] = operators.unknowns().fixed.is_active(i, c);
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          if (active[d])
            load[c] += A[c][d] * start[d];
      Tensor<1, n_components> v =
        functional.minimise(k, A, load, active, start);
      for (unsigned int c = 0; c < n_components; ++c)
        if (!active[c])
          v[c] = start[c];
      return v;
    }
  } // namespace



  template <int n_components>
  void
  nonlinear_gauss_seidel(const OperatorSum<n_components>         &operators,
                         const NonsmoothFunctional<n_components> &functional,
                         const bool                               is_everywhere,
                         NodalVector                             &w,
                         NodalVector                             &r)
  {
    const std::vector<unsigned int> &nodes = functional.nodes();
    const auto                       move_to = [&](const unsigned int             i,
                             const Tensor<1, n_components> &v) {
      operators.matrix().subtract_column(i, v - block<n_components>(w, i), r);
      for (unsigned int c = 0; c < n_components; ++c)
        w.local_element(i * n_components + c) = v[c];
    };

    r.zero_out_ghost_values();
    unsigned int next = 0;
    for (unsigned int k = 0; k <= nodes.size(); ++k)
      {
        const unsigned int end =
          k < nodes.size() ? nodes[k] : operators.matrix().n_rows();
        if (is_everywhere)
          for (unsigned int i = next; i < end; ++i)
            move_to(i,
                    block<n_components>(w, i) + operators.inverse_diagonal(i) *
                                                  block<n_components>(r, i));
        if (k < nodes.size())
          move_to(end, minimiser_at_term(operators, functional, k, w, r));
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
