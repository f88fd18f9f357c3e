// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>

#include <stickslip/tnnmg/functional_sums.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /**
     * True if a node takes part in the linear correction: not if the least
     * curvature over the components that phi_k depends on exceeds
     * @p factor times the diagonal of A, nor if the largest one does by so
     * much that single precision would lose the least.
     *
     * In three dimensions friction across the direction of slip, mu/V, is
     * mu/a times as stiff as friction along it, a/V. That is no harm to the
     * correction; without it, nodes that slide are left to the nonlinear
     * smoother alone.
     */
    template <int n_components>
    bool
    is_moderate(const NonsmoothFunctional<n_components> &functional,
                const unsigned int                       k,
                const Tensor<2, n_components>           &hessian,
                const Tensor<2, n_components>           &diagonal_block,
                const double                             factor)
    {
      constexpr double largest_ratio = 1e3;

      unsigned int n_acting = 0;
      double       diagonal = std::numeric_limits<double>::max();
      double       trace    = 0.;
      for (unsigned int c = 0; c < n_components; ++c)
        if (functional.acts_on(k, c))
          {
            ++n_acting;
            diagonal = std::min(diagonal, diagonal_block[c][c]);
            trace += hessian[c][c];
          }
      // Written so that a NaN is not moderate.
      if (n_components == 1 || n_acting < 2 || trace <= factor * diagonal)
        return trace <= factor * diagonal;
      if (!(trace <= largest_ratio * factor * diagonal))
        return false;
      // In descending order; zeros of the other components come last.
      return eigenvalues(symmetrize(hessian))[n_acting - 1] <=
             factor * diagonal;
    }



    /**
     * Return whether the functional is quadratic with this second derivative as
     * far as a correction may take the node: ten times where the @p force that
     * is left leads it without its neighbours, and as far on the other side.
     * So it is on a fault that slides freely below the rate from which on there
     * is friction, and never at one that is stuck there.
     */
    template <int n_components>
    bool
    is_quadratic(const NonsmoothFunctional<n_components> &functional,
                 const unsigned int                       k,
                 const Tensor<1, n_components>           &v,
                 const Tensor<2, n_components>           &hessian,
                 const Tensor<2, n_components>           &diagonal_block,
                 const Tensor<1, n_components>           &force)
    {
      constexpr double reach = 10.;

      Tensor<1, n_components> way;
      for (unsigned int c = 0; c < n_components; ++c)
        if (functional.acts_on(k, c))
          {
            if (!std::isfinite(hessian[c][c]))
              return false;
            way[c] = reach * force[c] / diagonal_block[c][c];
          }
      const double length = way.norm();
      if (!(length > 0.))
        return false;
      const Tensor<1, n_components> gradient = functional.gradient(k, v);
      for (const double side : {-1., 1.})
        {
          const Tensor<1, n_components> expected =
            gradient + hessian * (side * way);
          const Tensor<1, n_components> there =
            functional.gradient(k, v + side * way);
          if (!((there - expected).norm() <= 1e-12 * expected.norm()))
            return false;
        }
      return true;
    }
  } // namespace



  template <int n_components>
  void
  project(const NonsmoothFunctional<n_components> &functional,
          const std::vector<unsigned int>         &nodes,
          NodalVector                             &w)
  {
    if (!functional.has_bounds())
      return;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, n_components> v =
          functional.project(k, block<n_components>(w, nodes[k]));
        for (unsigned int c = 0; c < n_components; ++c)
          w.local_element(nodes[k] * n_components + c) = v[c];
      }
  }



  template <int n_components>
  std::vector<BoundComponent>
  project_step(const NonsmoothFunctional<n_components> &functional,
               const std::vector<unsigned int>         &nodes,
               const NodalVector                       &w,
               NodalVector                             &d)
  {
    std::vector<BoundComponent> shortened;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, n_components> v = block<n_components>(w, nodes[k]);
        const Tensor<1, n_components> goal =
          v + block<n_components>(d, nodes[k]);
        const Tensor<1, n_components> next = functional.project(k, goal);
        for (unsigned int c = 0; c < n_components; ++c)
          if (next[c] != goal[c])
            {
              d.local_element(nodes[k] * n_components + c) = next[c] - v[c];
              shortened.push_back({nodes[k], c, next[c]});
            }
      }
    return shortened;
  }



  template <int n_components>
  double
  increase(const NonsmoothFunctional<n_components> &functional,
           const std::vector<unsigned int>         &nodes,
           const NodalVector                       &w,
           const NodalVector                       &v)
  {
    double sum = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      sum += functional.value(k, block<n_components>(w, nodes[k])) -
             functional.value(k, block<n_components>(v, nodes[k]));
    return sum;
  }



  template <int n_components>
  double
  slope_of(const NonsmoothFunctional<n_components> &functional,
           const std::vector<unsigned int>         &nodes,
           const NodalVector                       &w,
           const NodalVector                       &d,
           const double                             t)
  {
    const bool has_bounds = functional.has_bounds();
    double     sum        = 0;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, n_components> direction =
          block<n_components>(d, nodes[k]);
        Tensor<1, n_components> v =
          block<n_components>(w, nodes[k]) + t * direction;
        // Rounding may lead out of the domain.
        if (has_bounds)
          v = functional.project(k, v);
        sum += functional.directional_derivative(k, v, direction);
      }
    return sum;
  }



  template <int n_components>
  void
  subtract_gradient(const NonsmoothFunctional<n_components> &functional,
                    const std::vector<unsigned int>         &nodes,
                    const NodalVector                       &w,
                    NodalVector                             &r)
  {
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, n_components> gradient =
          functional.gradient(k, block<n_components>(w, nodes[k]));
        for (unsigned int c = 0; c < n_components; ++c)
          r.local_element(nodes[k] * n_components + c) -= gradient[c];
      }
  }



  template <int n_components>
  unsigned int
  linearise(const NonsmoothFunctional<n_components>    &functional,
            const std::vector<unsigned int>            &nodes,
            const TNNMGParameters                      &parameters,
            const std::vector<Tensor<2, n_components>> &diagonal_blocks,
            const NodalVector                          &w,
            const NodalVector                          &force,
            std::vector<Tensor<2, n_components>>       &hessians,
            NodeMask                                   &active)
  {
    AssertDimension(diagonal_blocks.size(), nodes.size());
    const bool   has_bounds  = functional.has_bounds();
    unsigned int n_truncated = 0;
    hessians.assign(nodes.size(), Tensor<2, n_components>());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int            i = nodes[k];
        const Tensor<1, n_components> v = block<n_components>(w, i);
        bool                          smooth;
        if (parameters.nonlinear_smoothing)
          {
            smooth = functional.is_smooth(k, v);
            if (smooth)
              {
                hessians[k] =
                  functional.secant_hessian(k,
                                            v,
                                            block<n_components>(force, i));
                smooth = is_moderate(functional,
                                     k,
                                     hessians[k],
                                     diagonal_blocks[k],
                                     parameters.truncation_factor);
              }
            else
              {
                hessians[k] = functional.hessian(k, v);
                smooth      = is_quadratic(functional,
                                      k,
                                      v,
                                      hessians[k],
                                      diagonal_blocks[k],
                                      block<n_components>(force, i));
              }
          }
        else
          {
            hessians[k] = functional.hessian(k, v);
            smooth      = true;
            for (unsigned int c = 0; c < n_components; ++c)
              smooth = smooth && std::isfinite(hessians[k][c][c]);
          }
        if (!smooth)
          {
            hessians[k] = 0.;
            for (unsigned int c = 0; c < n_components; ++c)
              if (functional.acts_on(k, c) && active.is_active(i, c))
                {
                  active.mask(i, c);
                  ++n_truncated;
                }
          }
        if (has_bounds)
          for (unsigned int c = 0; c < n_components; ++c)
            if (active.is_active(i, c) && functional.is_at_bound(k, v, c))
              {
                active.mask(i, c);
                ++n_truncated;
              }
      }
    return n_truncated;
  }



#define STICKSLIP_INSTANTIATE(n_components)                        \
  template void project<n_components>(                             \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    NodalVector &);                                                \
  template std::vector<BoundComponent> project_step<n_components>( \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    const NodalVector &,                                           \
    NodalVector &);                                                \
  template double increase<n_components>(                          \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    const NodalVector &,                                           \
    const NodalVector &);                                          \
  template double slope_of<n_components>(                          \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    const NodalVector &,                                           \
    const NodalVector &,                                           \
    const double);                                                 \
  template void subtract_gradient<n_components>(                   \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    const NodalVector &,                                           \
    NodalVector &);                                                \
  template unsigned int linearise<n_components>(                   \
    const NonsmoothFunctional<n_components> &,                     \
    const std::vector<unsigned int> &,                             \
    const TNNMGParameters &,                                       \
    const std::vector<Tensor<2, n_components>> &,                  \
    const NodalVector &,                                           \
    const NodalVector &,                                           \
    std::vector<Tensor<2, n_components>> &,                        \
    NodeMask &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
