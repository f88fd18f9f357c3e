// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_functional_sums_h
#define stickslip_tnnmg_functional_sums_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>
#include <stickslip/tnnmg/solver_parameters.h>

#include <array>

namespace StickSlip
{
  /*
   * Sums over the terms of a nonsmooth functional phi that this process has,
   * whose @p nodes are given by their numbers in the vectors. None is
   * collective: several of them are added up over all processes at once.
   */

  /** The components of one node, given by its local index. */
  template <int n_components>
  inline Tensor<1, n_components>
  block(const NodalVector &vector, const unsigned int node)
  {
    Tensor<1, n_components> values;
    for (unsigned int c = 0; c < n_components; ++c)
      values[c] = vector.local_element(node * n_components + c);
    return values;
  }

  /** Carry out @p action for the local indices of all components of some
   * nodes. */
  template <int n_components, typename Action>
  inline void
  for_each_entry(const std::vector<unsigned int> &nodes, const Action &action)
  {
    for (const unsigned int node : nodes)
      for (unsigned int i = node * n_components; i < (node + 1) * n_components;
           ++i)
        action(i);
  }

  /** Copy the components of some nodes from one vector to another one. */
  template <int n_components>
  void
  copy_blocks(const std::vector<unsigned int> &nodes,
              const NodalVector               &from,
              NodalVector                     &to)
  {
    for_each_entry<n_components>(nodes, [&](const unsigned int i) {
      to.local_element(i) = from.local_element(i);
    });
  }

  /** The point at which the k-th term of phi and the rest of J, which has the
   * diagonal block @p A and the negative gradient @p residual at the node, are
   * minimal over its @p active components; the others keep their values of
   * @p start. */
  template <int n_components>
  inline Tensor<1, n_components>
  minimiser_at(const NonsmoothFunctional<n_components> &functional,
               const unsigned int                       k,
               const Tensor<2, n_components>           &A,
               const Tensor<1, n_components>           &residual,
               const std::array<bool, n_components>    &active,
               const Tensor<1, n_components>           &start)
  {
    // Moving the part of the active components of this node to the left leaves
    // what the minimiser is asked for.
    Tensor<1, n_components> load = residual;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        if (active[c] && active[d])
          load[c] += A[c][d] * start[d];
    return functional.minimise(k, A, load, active, start);
  }

  /** Move @p w to the next point of the domain of phi; nothing is done if phi
   * has no bounds. */
  template <int n_components>
  void
  project(const NonsmoothFunctional<n_components> &functional,
          const std::vector<unsigned int>         &nodes,
          NodalVector                             &w);

  /** A component that a step takes to a bound: its node, and its value there,
   * which adding the step may miss by rounding. */
  struct BoundComponent
  {
    unsigned int node, component;
    double       value;
  };

  /** Shorten @p d so that w + d is that point of the domain of phi which is
   * next to the original w + d. Returns what was shortened. */
  template <int n_components>
  std::vector<BoundComponent>
  project_step(const NonsmoothFunctional<n_components> &functional,
               const std::vector<unsigned int>         &nodes,
               const NodalVector                       &w,
               NodalVector                             &d);

  /** phi(w) - phi(v) summed term by term, so that little cancels. */
  template <int n_components>
  double
  increase(const NonsmoothFunctional<n_components> &functional,
           const std::vector<unsigned int>         &nodes,
           const NodalVector                       &w,
           const NodalVector                       &v);

  /** The derivative of phi at w + t d in direction d, where w and w + d are in
   * the domain of phi and 0 <= t <= 1. */
  template <int n_components>
  double
  slope_of(const NonsmoothFunctional<n_components> &functional,
           const std::vector<unsigned int>         &nodes,
           const NodalVector                       &w,
           const NodalVector                       &d,
           const double                             t);

  /** r -= the gradient of phi at w. */
  template <int n_components>
  void
  subtract_gradient(const NonsmoothFunctional<n_components> &functional,
                    const std::vector<unsigned int>         &nodes,
                    const NodalVector                       &w,
                    NodalVector                             &r);

  /**
   * The curvature of phi at w, a block for each of its nodes
   * (NonsmoothFunctional::secant_hessian() with @p force, the negative
   * gradient of J), and the truncation: masked in @p active, which holds those
   * that are not fixed at first, are the components at a bound, and all
   * components of a node that phi depends on where phi is not smooth or the
   * least curvature of the node exceeds parameters.truncation_factor times the
   * diagonal of A, @p diagonal_blocks. Without nonlinear smoothing it is the
   * second derivative of phi, and only those are truncated where there is none.
   *
   * Returns the number of truncated components.
   */
  template <int n_components>
  unsigned int
  linearise(const NonsmoothFunctional<n_components>    &functional,
            const std::vector<unsigned int>            &nodes,
            const TNNMGParameters                      &parameters,
            const std::vector<Tensor<2, n_components>> &diagonal_blocks,
            const NodalVector                          &w,
            const NodalVector                          &force,
            std::vector<Tensor<2, n_components>>       &hessians,
            NodeMask                                   &active);
} // namespace StickSlip

#endif
