// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_shear_traction_h
#define stickslip_problem_shear_traction_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>
#include <stickslip/problem/system_state.h>

namespace StickSlip
{
  /**
   * Slip rate, m/s, below which the friction law does not tell the traction:
   * numbers end at 1e-308, and with a small direct effect a the slip rate of a
   * stuck node, exp(-mu/a), lies far below.
   */
  constexpr double least_slip_rate = 1e-300;

  /**
   * The friction coefficient at a slave node times the direction of slip,
   * slave relative to master: from the law, or, where that does not tell it,
   * from the balance of forces that the state remembers. Zero where nothing
   * presses.
   */
  template <int dim>
  Tensor<1, dim - 1>
  directed_friction(const FaultNodes<dim>  &faults,
                    const NodeLaws         &laws,
                    const SystemState<dim> &state,
                    const unsigned int      k);

  /**
   * The shear traction at a slave node, slave relative to master, Pa: what
   * resists the slip, friction or that which keeps a prescribed slip. Without
   * radiation damping.
   */
  template <int dim>
  Tensor<1, dim - 1>
  shear_traction(const FaultNodes<dim>  &faults,
                 const NodeLaws         &laws,
                 const SystemState<dim> &state,
                 const unsigned int      k);

  /**
   * The shear traction at a slave node as it is written: that over the last
   * step where there is one (SystemState::mean_traction).
   */
  template <int dim>
  Tensor<1, dim - 1>
  written_traction(const FaultNodes<dim>  &faults,
                   const NodeLaws         &laws,
                   const SystemState<dim> &state,
                   const unsigned int      k);

  /**
   * Shear tractions at all slave nodes.
   */
  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  shear_tractions(const FaultNodes<dim>  &faults,
                  const NodeLaws         &laws,
                  const SystemState<dim> &state);

  /**
   * Shear tractions at all slave nodes at other slip rates than those of @p
   * state.
   */
  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  shear_tractions(const FaultNodes<dim>                 &faults,
                  const NodeLaws                        &laws,
                  const SystemState<dim>                &state,
                  const std::vector<Tensor<1, dim - 1>> &slip_rate);

  /**
   * The shear tractions that balance @p forces on all slave nodes, N, Pa, where
   * the law does not tell them; else as below.
   */
  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  balancing_tractions(const FaultNodes<dim>                 &faults,
                      const NodeLaws                        &laws,
                      const SystemState<dim>                &state,
                      const std::vector<Tensor<1, dim - 1>> &forces);

  /**
   * The shear tractions at all slave nodes that balance the forces on them, Pa,
   * where the law does not tell them, and zero elsewhere: where the slip rates
   * of @p state are below least_slip_rate or prescribed. Empty if there is no
   * such node. @p A and @p b: the rate problem, @p w its solution. Collective.
   */
  template <int dim, int n_components = dim>
  std::vector<Tensor<1, dim - 1>>
  balancing_tractions(const FaultNodes<dim>           &faults,
                      const NodeLaws                  &laws,
                      const SystemState<dim>          &state,
                      const BlockMatrix<n_components> &A,
                      const NodalVector               &b,
                      const NodalVector               &w);
} // namespace StickSlip

#endif
