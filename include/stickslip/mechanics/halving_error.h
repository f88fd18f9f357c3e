// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_halving_error_h
#define stickslip_mechanics_halving_error_h

#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mesh/mesh_level.h>

#include <vector>

namespace StickSlip
{
  /**
   * Part of the elastic energy of a field that a mesh does not resolve, by the
   * same field on the mesh with all of its cells refined once.
   *
   * With the field u of the finer mesh and that of the coarser one, v, it is
   * the energy of u - v. For elements of degree one and smooth fields, a third
   * of it is left on the finer mesh, at corners more (Ferraz-Leite, Ortner,
   * Praetorius 2010).
   */
  struct HalvingError
  {
    /** Energy of u - v in each active cell of the coarser mesh, body after
     * body, J (per m in two dimensions). */
    std::vector<std::vector<double>> of_cells;

    /** Their sum, and the energy of u. */
    double sum = 0., energy = 0.;
  };

  /**
   * Compare nodal displacements of a level, m, with those of the level in which
   * all of its cells are refined once. Both must be on one process, and all
   * their nodes be owned.
   */
  template <int dim, int n_components = dim>
  HalvingError
  halving_error(const MeshLevel<dim>              &coarse,
                const NodalVector                 &coarse_displacement,
                const MeshLevel<dim>              &fine,
                const NodalVector                 &fine_displacement,
                const std::vector<MaterialFields> &materials);
} // namespace StickSlip

#endif
