// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_volume_writer_h
#define stickslip_output_volume_writer_h

#include <stickslip/algebra/node_partition.h>
#include <stickslip/mesh/mesh_hierarchy.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * What the writer has to know of a body's material, as functions of the
   * position.
   */
  template <int dim>
  struct VolumeMaterial
  {
    /** Lame's parameters lambda and mu, Pa. */
    std::function<std::pair<double, double>(const Point<dim> &)>
      lame_parameters;

    /** Values to write besides, by name; the same names for all bodies. */
    std::vector<
      std::pair<std::string, std::function<double(const Point<dim> &)>>>
      fields;
  };

  /**
   * Write displacement (m), velocity (m/s), stress (Pa) and the number of the
   * body of all bodies into one VTU file in @p directory, with the ending
   * for this step; returns its name.
   *
   * The nodal values are those of all nodes in the order of their global
   * numbers, see gather_on_first(); one process writes for all.
   *
   * The stress is the elastic one, of each cell's centre, tension positive. In
   * two dimensions the stress out of the plane is left out. Fields of
   * @p materials are those of the centre, too.
   */
  template <int dim>
  std::string
  write_volume(const std::string                      &directory,
               const unsigned int                      number,
               const double                            time,
               const MeshLevel<dim>                   &level,
               const std::vector<double>              &displacement,
               const std::vector<double>              &velocity,
               const std::vector<VolumeMaterial<dim>> &materials);
} // namespace StickSlip

#endif
