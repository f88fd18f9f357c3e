// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_nonsmooth_functional_h
#define stickslip_tnnmg_nonsmooth_functional_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A convex functional that is a sum of terms, each of the d components of
   * one node:
   *
   *   phi(v) = sum_k phi_k(v_{node(k)}).
   *
   * The terms may be nonsmooth. What the solver needs of them is gathered
   * here; it knows nothing of where they come from. All member functions take
   * the position @p k of a term in nodes().
   *
   * A term may be infinite outside a closed convex domain, such as that of an
   * obstacle: has_bounds() says so. The solver keeps to the domain by project()
   * and minimise(), and takes components out of its linear corrections where
   * they are at a bound, is_at_bound(). All other functions are asked for
   * points of the domain only, and are those of the finite function which phi_k
   * is there.
   */
  template <int n_components>
  class NonsmoothFunctional
  {
  public:
    virtual ~NonsmoothFunctional() = default;

    /**
     * The local indices of the owned nodes that carry a term, in ascending
     * order, each at most once.
     */
    virtual const std::vector<unsigned int> &
    nodes() const = 0;

    /**
     * Return whether some term has a domain, on this process or on another one;
     * project() and is_at_bound() are not asked otherwise. By default none has.
     */
    virtual bool
    has_bounds() const;

    /**
     * The point of the domain of phi_k next to v, and v itself if that is in
     * the domain.
     */
    virtual Tensor<1, n_components>
    project(const unsigned int k, const Tensor<1, n_components> &v) const;

    /**
     * Return whether a component of a point of the domain is at its boundary,
     * bit for bit as project() and minimise() put it there: linear corrections
     * do not change it.
     */
    virtual bool
    is_at_bound(const unsigned int             k,
                const Tensor<1, n_components> &v,
                const unsigned int             component) const;

    /**
     * The value phi_k(v).
     */
    virtual double
    value(const unsigned int k, const Tensor<1, n_components> &v) const = 0;

    /**
     * The derivative phi_k'(v; direction) in one direction, from that side.
     */
    virtual double
    directional_derivative(const unsigned int             k,
                           const Tensor<1, n_components> &v,
                           const Tensor<1, n_components> &direction) const = 0;

    /**
     * The gradient at v. Where phi_k is not differentiable, the element of
     * the subdifferential of least norm.
     */
    virtual Tensor<1, n_components>
    gradient(const unsigned int k, const Tensor<1, n_components> &v) const = 0;

    /**
     * The second derivative at v, symmetric and positive semidefinite. Where
     * is_smooth() is false, an element of the generalised second derivative,
     * or numbers that are not finite if there is none.
     */
    virtual Tensor<2, n_components>
    hessian(const unsigned int k, const Tensor<1, n_components> &v) const = 0;

    /**
     * Substitute for the second derivative in a linear correction
     * where @p force, the negative gradient of all that is minimised, is left
     * at the node: symmetric, positive semidefinite, and close to hessian()
     * if the force is small. Where phi_k is far from quadratic, the slope of
     * its gradient over the way to the point at which phi_k alone balances
     * the force tells more than that at v. By default the same as hessian().
     */
    virtual Tensor<2, n_components>
    secant_hessian(const unsigned int             k,
                   const Tensor<1, n_components> &v,
                   const Tensor<1, n_components> &force) const;

    /**
     * True if phi_k is twice differentiable in a neighbourhood of v. Where it
     * is not, the node's nonsmooth components are truncated from the
     * linearisation whatever the size of the second derivative.
     */
    virtual bool
    is_smooth(const unsigned int k, const Tensor<1, n_components> &v) const = 0;

    /**
     * True if phi_k, but for its domain, depends on this component of the
     * node's unknown. The components it does not depend on are truncated at
     * their bounds only.
     */
    virtual bool
    acts_on(const unsigned int k, const unsigned int component) const = 0;

    /**
     * The minimiser v of
     *
     *   1/2 v . A v - r . v + phi_k(v)
     *
     * over the components with @p active true; the others of the returned
     * vector equal those of @p start, and r already holds what they
     * contribute. A restricted to the active components is symmetric and
     * positive definite. The minimiser is exact up to rounding, whatever
     * @p start is.
     */
    virtual Tensor<1, n_components>
    minimise(const unsigned int                    k,
             const Tensor<2, n_components>        &A,
             const Tensor<1, n_components>        &r,
             const std::array<bool, n_components> &active,
             const Tensor<1, n_components>        &start) const = 0;
  };



  template <int n_components>
  bool
  NonsmoothFunctional<n_components>::has_bounds() const
  {
    return false;
  }



  template <int n_components>
  Tensor<1, n_components>
  NonsmoothFunctional<n_components>::project(
    const unsigned int,
    const Tensor<1, n_components> &v) const
  {
    return v;
  }



  template <int n_components>
  bool
  NonsmoothFunctional<n_components>::is_at_bound(
    const unsigned int,
    const Tensor<1, n_components> &,
    const unsigned int) const
  {
    return false;
  }



  template <int n_components>
  Tensor<2, n_components>
  NonsmoothFunctional<n_components>::secant_hessian(
    const unsigned int             k,
    const Tensor<1, n_components> &v,
    const Tensor<1, n_components> &) const
  {
    return hessian(k, v);
  }
} // namespace StickSlip

#endif
