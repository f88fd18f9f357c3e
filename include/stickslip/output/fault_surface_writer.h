// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_surface_writer_h
#define stickslip_output_fault_surface_writer_h

#include <stickslip/output/fault_layout.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/output_fields.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Write a fault at one time into a VTU file in @p directory; returns its
   * name, `fault_<name>_<number>.vtu`.
   *
   * Points are the nodes of the fault in the order of the snapshot, at its
   * FaultSnapshot::positions; cells are lines, triangles or quadrilaterals.
   * Nodes at the end of a periodic fault have a second point at its other end,
   * where it goes on, behind all others. Of each node there are
   *
   *   tangent [_1, _2]  unit vectors of the components of slip and traction
   *   normal            unit vector from the first to the second side
   *   contact_weight    share in the area of contact, m^(dim-1)
   *
   * and the @p fields asked for; tangential vectors have dim-1 components.
   * Units are with the arrays, as VTK's information key UNITS_LABEL. Numbers
   * are in double precision.
   */
  template <int dim>
  std::string
  write_fault_surface(const std::string             &directory,
                      const unsigned int             number,
                      const double                   time,
                      const FaultLayout<dim>        &shape,
                      const FaultSnapshot<dim>      &fault,
                      const std::vector<FaultField> &fields);
} // namespace StickSlip

#endif
