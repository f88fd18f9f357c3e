// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_sampled_functional_h
#define stickslip_tnnmg_sampled_functional_h

#include <stickslip/tnnmg/nonsmooth_functional.h>

namespace StickSlip
{
  /**
   * Some terms of another functional, multiplied by factors, at nodes of their
   * own:
   *
   *   phi(v) = sum_k factors[k] psi_{terms[k]}(v_{nodes[k]}).
   *
   * That functional must live longer than this one.
   */
  template <int n_components>
  class SampledFunctional : public NonsmoothFunctional<n_components>
  {
  public:
    using Vector = Tensor<1, n_components>;
    using Matrix = Tensor<2, n_components>;

    /** @p nodes are ascending, @p terms positions in the nodes of
     * @p functional, and @p factors positive. */
    SampledFunctional(const NonsmoothFunctional<n_components> &functional,
                      const std::vector<unsigned int>         &nodes,
                      const std::vector<unsigned int>         &terms,
                      const std::vector<double>               &factors)
      : functional(functional)
      , node_indices(nodes)
      , terms(terms)
      , factors(factors)
    {
      AssertDimension(terms.size(), nodes.size());
      AssertDimension(factors.size(), nodes.size());
    }

    const std::vector<unsigned int> &
    nodes() const override
    {
      return node_indices;
    }

    bool
    has_bounds() const override
    {
      return functional.has_bounds();
    }

    Vector
    project(const unsigned int k, const Vector &v) const override
    {
      return functional.project(terms[k], v);
    }

    bool
    is_at_bound(const unsigned int k,
                const Vector      &v,
                const unsigned int component) const override
    {
      return functional.is_at_bound(terms[k], v, component);
    }

    double
    value(const unsigned int k, const Vector &v) const override
    {
      return factors[k] * functional.value(terms[k], v);
    }

    double
    directional_derivative(const unsigned int k,
                           const Vector      &v,
                           const Vector      &direction) const override
    {
      return factors[k] *
             functional.directional_derivative(terms[k], v, direction);
    }

    Vector
    gradient(const unsigned int k, const Vector &v) const override
    {
      return factors[k] * functional.gradient(terms[k], v);
    }

    Matrix
    hessian(const unsigned int k, const Vector &v) const override
    {
      return factors[k] * functional.hessian(terms[k], v);
    }

    Matrix
    secant_hessian(const unsigned int k,
                   const Vector      &v,
                   const Vector      &force) const override
    {
      return factors[k] *
             functional.secant_hessian(terms[k], v, force / factors[k]);
    }

    bool
    is_smooth(const unsigned int k, const Vector &v) const override
    {
      return functional.is_smooth(terms[k], v);
    }

    bool
    acts_on(const unsigned int k, const unsigned int component) const override
    {
      return functional.acts_on(terms[k], component);
    }

    Vector
    minimise(const unsigned int                    k,
             const Matrix                         &A,
             const Vector                         &r,
             const std::array<bool, n_components> &active,
             const Vector                         &start) const override
    {
      return functional.minimise(
        terms[k], A / factors[k], r / factors[k], active, start);
    }

  private:
    const NonsmoothFunctional<n_components> &functional;
    const std::vector<unsigned int>          node_indices, terms;
    const std::vector<double>                factors;
  };
} // namespace StickSlip

#endif
