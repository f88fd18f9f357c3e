// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_volume_writer_h
#define stickslip_output_volume_writer_h

#include <stickslip/algebra/node_partition.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Write displacement (m), velocity (m/s), stress (Pa) and the number of the
   * body of all bodies into one VTU file in @p directory, with the ending
   * for this step; returns its name.
   *
   * The nodal values are those of all nodes in the order of their global
   * numbers, see gather_on_first(); one process writes for all.
   *
   * The stress is the elastic one, of each cell's centre, tension positive;
   * @p lame_parameters holds lambda and mu (Pa) of each body. In two dimensions
   * the stress out of the plane is left out.
   */
  template <int dim>
  std::string
  write_volume(const std::string                            &directory,
               const unsigned int                            number,
               const double                                  time,
               const MeshLevel<dim>                         &level,
               const std::vector<double>                    &displacement,
               const std::vector<double>                    &velocity,
               const std::vector<std::pair<double, double>> &lame_parameters);
} // namespace StickSlip

#endif
