// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/tnnmg/functional_sums.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  double
  increase(const NonsmoothFunctional<dim> &functional,
           const NodalVector              &w,
           const NodalVector              &v)
  {
    double                           sum   = 0;
    const std::vector<unsigned int> &nodes = functional.nodes();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      sum += functional.value(k, block<dim>(w, nodes[k])) -
             functional.value(k, block<dim>(v, nodes[k]));
    return Utilities::MPI::sum(sum, w.get_mpi_communicator());
  }



  template <int dim>
  double
  slope_of(const NonsmoothFunctional<dim> &functional,
           const NodalVector              &w,
           const NodalVector              &d,
           const double                    t)
  {
    double                           sum   = 0;
    const std::vector<unsigned int> &nodes = functional.nodes();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, dim> direction = block<dim>(d, nodes[k]);
        sum += functional.directional_derivative(
          k, block<dim>(w, nodes[k]) + t * direction, direction);
      }
    return Utilities::MPI::sum(sum, w.get_mpi_communicator());
  }



  template <int dim>
  void
  subtract_gradient(const NonsmoothFunctional<dim> &functional,
                    const NodalVector              &w,
                    NodalVector                    &r)
  {
    const std::vector<unsigned int> &nodes = functional.nodes();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, dim> gradient =
          functional.gradient(k, block<dim>(w, nodes[k]));
        for (unsigned int c = 0; c < dim; ++c)
          r.local_element(nodes[k] * dim + c) -= gradient[c];
      }
  }



  template <int dim>
  unsigned int
  linearise(const NonsmoothFunctional<dim>    &functional,
            const TNNMGParameters             &parameters,
            const std::vector<Tensor<2, dim>> &diagonal_blocks,
            const NodalVector                 &w,
            std::vector<Tensor<2, dim>>       &hessians,
            NodeMask                          &active)
  {
    const std::vector<unsigned int> &nodes = functional.nodes();
    AssertDimension(diagonal_blocks.size(), nodes.size());
    const bool   truncates   = parameters.nonlinear_smoothing;
    unsigned int n_truncated = 0;
    hessians.assign(nodes.size(), Tensor<2, dim>());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int   i      = nodes[k];
        const Tensor<1, dim> v      = block<dim>(w, i);
        bool                 smooth = !truncates || functional.is_smooth(k, v);
        if (smooth)
          hessians[k] = functional.hessian(k, v);
        for (unsigned int c = 0; c < dim && smooth; ++c)
          // Written so that a NaN is not smooth.
          smooth = truncates ?
                     hessians[k][c][c] <=
                       parameters.truncation_factor * diagonal_blocks[k][c][c] :
                     std::isfinite(hessians[k][c][c]);
        if (!smooth)
          {
            hessians[k] = 0.;
            for (unsigned int c = 0; c < dim; ++c)
              if (functional.acts_on(k, c) && active.is_active(i, c))
                {
                  active.mask(i, c);
                  ++n_truncated;
                }
          }
      }
    return n_truncated;
  }



#define STICKSLIP_INSTANTIATE(dim)                                               \
  template double       increase<dim>(const NonsmoothFunctional<dim> &,          \
                                const NodalVector &,                       \
                                const NodalVector &);                      \
  template double       slope_of<dim>(const NonsmoothFunctional<dim> &,          \
                                const NodalVector &,                       \
                                const NodalVector &,                       \
                                const double);                             \
  template void         subtract_gradient<dim>(const NonsmoothFunctional<dim> &, \
                                       const NodalVector &,              \
                                       NodalVector &);                   \
  template unsigned int linearise<dim>(const NonsmoothFunctional<dim> &,         \
                                       const TNNMGParameters &,                  \
                                       const std::vector<Tensor<2, dim>> &,      \
                                       const NodalVector &,                      \
                                       std::vector<Tensor<2, dim>> &,            \
                                       NodeMask &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
