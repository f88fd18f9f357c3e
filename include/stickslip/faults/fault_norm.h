// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_faults_fault_norm_h
#define stickslip_faults_fault_norm_h

#include <stickslip/faults/fault_nodes.h>
#include <stickslip/faults/node_laws.h>

namespace StickSlip
{
  /**
   * The root of the sum over the faults of the mean square, sum w e^2 / sum w,
   * of @p values at the slave nodes: a measure of errors that is the same for
   * small and large faults, and in which each fault counts, however small it is
   * next to the others. Nodes off contact and those with a prescribed slip rate
   * count neither for the sum nor for the area: a fault that is driven far
   * below is not smoother for that.
   */
  template <int dim>
  double
  fault_norm(const FaultNodes<dim>     &faults,
             const NodeLaws            &laws,
             const std::vector<double> &values);
} // namespace StickSlip

#endif
