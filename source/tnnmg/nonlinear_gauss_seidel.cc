// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>

namespace StickSlip
{
  template <int n_components>
  void
  nonlinear_gauss_seidel(const LevelHierarchy<n_components>      &hierarchy,
                         const NonsmoothFunctional<n_components> &functional,
                         const NodalVector                       &b,
                         NodalVector                             &w)
  {
    const BlockMatrix<n_components> &matrix = hierarchy.matrix();
    const NodeMask                  &fixed  = hierarchy.finest().fixed;
    const double *inverse = hierarchy.inverse_diagonal().data();
    const std::vector<unsigned int> &nodes = functional.nodes();
    const Kernels::BlockRows<double> A     = matrix.rows();

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



  template void
  nonlinear_gauss_seidel<1>(const LevelHierarchy<1> &,
                            const NonsmoothFunctional<1> &,
                            const NodalVector &,
                            NodalVector &);
  template void
  nonlinear_gauss_seidel<2>(const LevelHierarchy<2> &,
                            const NonsmoothFunctional<2> &,
                            const NodalVector &,
                            NodalVector &);
  template void
  nonlinear_gauss_seidel<3>(const LevelHierarchy<3> &,
                            const NonsmoothFunctional<3> &,
                            const NodalVector &,
                            NodalVector &);
} // namespace StickSlip
