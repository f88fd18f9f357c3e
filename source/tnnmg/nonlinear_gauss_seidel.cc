// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>

namespace StickSlip
{
  template <int n_components>
  void
  nonlinear_gauss_seidel(const OperatorSum<n_components>         &operators,
                         const NonsmoothFunctional<n_components> &functional,
                         const NodalVector                       &b,
                         NodalVector                             &w)
  {
    const BlockMatrix<n_components> &matrix  = operators.matrix();
    const NodeMask                  &fixed   = operators.unknowns().fixed;
    const double                    *inverse = operators.inverse_diagonals();
    const std::vector<unsigned int> &nodes   = functional.nodes();
    const Kernels::BlockRows<double> A       = matrix.rows();

    update_ghosts(w);
    unsigned int next = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int i = nodes[k];
        Kernels::gauss_seidel_forward<n_components>(
          A, inverse, next, i, b.begin(), w.begin());
        next = i + 1;

        double rest[n_components];
        Kernels::residual<n_components>(A,
                                        i,
                                        i + 1,
                                        b.begin(),
                                        w.begin(),
                                        rest -
                                          std::ptrdiff_t(i) * n_components);

        // Moving the part of the active components of this node to the left
        // leaves what the minimiser is asked for.
        const Tensor<2, n_components>  diagonal = matrix.diagonal_block(i);
        Tensor<1, n_components>        start, r;
        std::array<bool, n_components> active;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            start[c]  = w.local_element(i * n_components + c);
            active[c] = fixed.is_active(i, c);
          }
        for (unsigned int c = 0; c < n_components; ++c)
          {
            r[c] = rest[c];
            for (unsigned int d = 0; d < n_components; ++d)
              if (active[d])
                r[c] += diagonal[c][d] * start[d];
          }
        const Tensor<1, n_components> v =
          functional.minimise(k, diagonal, r, active, start);
        for (unsigned int c = 0; c < n_components; ++c)
          if (active[c])
            w.local_element(i * n_components + c) = v[c];
      }
    Kernels::gauss_seidel_forward<n_components>(
      A, inverse, next, matrix.n_rows(), b.begin(), w.begin());
  }



#define STICKSLIP_INSTANTIATE(n_components)           \
  template void nonlinear_gauss_seidel<n_components>( \
    const OperatorSum<n_components> &,                \
    const NonsmoothFunctional<n_components> &,        \
    const NodalVector &,                              \
    NodalVector &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
