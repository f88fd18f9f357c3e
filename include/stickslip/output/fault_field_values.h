// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_field_values_h
#define stickslip_output_fault_field_values_h

#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/output_fields.h>

namespace StickSlip
{
  /**
   * The values of a field at all nodes of a fault, and what they are.
   */
  struct FaultFieldValues
  {
    std::string units, description;

    /** Numbers of each node: 1, dim-1 or dim. */
    unsigned int n_components;

    /** All numbers, node by node. */
    std::vector<double> values;
  };

  /** True if a fault has a field at all: some are there only where its sides
   * may part. */
  template <int dim>
  bool
  has_values(const FaultSnapshot<dim> &fault, const FaultField field);

  /** A field of a fault; without values if the snapshot has none. */
  template <int dim>
  FaultFieldValues
  field_values(const FaultSnapshot<dim> &fault, const FaultField field);
} // namespace StickSlip

#endif
