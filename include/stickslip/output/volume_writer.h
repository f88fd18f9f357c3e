// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_volume_writer_h
#define stickslip_output_volume_writer_h

#include <stickslip/algebra/node_partition.h>
#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/output/output_fields.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * A number of the material, as a function of the position.
   */
  template <int dim>
  struct VolumeMaterialField
  {
    std::string                               name, units;
    std::function<double(const Point<dim> &)> value;
  };

  /**
   * Material of a body for the writer, as functions of the position.
   */
  template <int dim>
  struct VolumeMaterial
  {
    /** Lame's parameters lambda and mu, Pa. */
    std::function<std::pair<double, double>(const Point<dim> &)>
      lame_parameters;

    /** The volumetric strain that each active cell resists after a nodal
     * displacement; none: that of its centre. */
    std::function<std::vector<double>(const NodalVector &)> dilatations;

    /** Values to write besides; the same names for all bodies. */
    std::vector<VolumeMaterialField<dim>> fields;
  };

  /**
   * Nodal values of all bodies: m, m/s, m/s^2.
   */
  struct VolumeState
  {
    const NodalVector &displacement, &velocity, &acceleration;
  };

  /**
   * All that a file shows of the bodies; for each field as many values as there
   * are points or cells, times its components.
   */
  struct VolumeContent
  {
    struct Field
    {
      std::string         name;
      unsigned int        n_components;
      std::vector<double> values;
      std::string         units;
    };

    /** Serial numbers of the points and cells. */
    std::vector<types::global_dof_index> points, cells;

    /** Dimension of the cells, and the most corners that one has. */
    unsigned int dimension, n_corners;

    /** Positions of the points, three numbers each, m, and for each cell its
     * points in the order of VTK by their places here; -1 stands for those that
     * its shape has not. */
    std::vector<double>       positions;
    std::vector<std::int64_t> corners;

    std::vector<Field> of_points, of_cells;
  };

  /**
   * The @p fields of the cells that this process shows: of all processes
   * together each cell once. Collective.
   *
   * Vectors have three components; where bodies move out of the plane, z is
   * the axis that they move along. Stress (Pa) and strain are those of each
   * cell's centre, as cell data; the stress is the elastic one, tension
   * positive, in plane strain with that out of the plane, stress_zz; where
   * bodies move out of the plane, both have the entries with z. Fields of @p
   * materials are those of the centre, too.
   */
  template <int dim>
  VolumeContent
  own_volume(const MeshLevel<dim>                   &level,
             const VolumeState                      &state,
             const std::vector<VolumeMaterial<dim>> &materials,
             const std::vector<VolumeField>         &fields);

  /**
   * The content of all processes together on the first one, in the order of one
   * process alone, nothing on the others. Collective.
   */
  template <int dim>
  VolumeContent
  gather_volume(const MeshLevel<dim> &level, const VolumeContent &own);
} // namespace StickSlip

#endif
