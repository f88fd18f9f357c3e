// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_patch_volumes_h
#define stickslip_mechanics_patch_volumes_h

#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mesh/mesh_level.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * The change of volume of a patch of cells on the mean and the moduli that
   * resist it: with the derivatives g_i of the volume |P| by the displacements
   * of the nodes, the stiffness of the patch is kappa g_i g_j^T / |P|.
   */
  template <int dim>
  struct PatchVolume
  {
    /** |P|, m^dim. */
    double volume = 0;
    /** Local indices of the nodes, ascending, and g_i, m^(dim - 1). */
    std::vector<std::pair<unsigned int, Tensor<1, dim>>> gradients;
    /** Means over the patch of kappa and mu, Pa, and of zeta and eta, Pa s. */
    double bulk_modulus = 0, shear_modulus = 0;
    double bulk_viscosity = 0, shear_viscosity = 0;
  };

  /**
   * The patches that touch an owned node, in bodies whose material asks for the
   * mean volumetric strain; @p materials in the order of the bodies. The
   * patches of these must be coupled, see CoarseBody.
   */
  template <int dim>
  std::vector<PatchVolume<dim>>
  patch_volumes(const MeshLevel<dim>              &level,
                const std::vector<MaterialFields> &materials);

  /**
   * The volumetric strain of a nodal @p displacement on each active cell of a
   * body, the mean over its patch, on patches that touch an owned node. Empty
   * if the body does not couple patches.
   */
  template <int dim>
  std::vector<double>
  patch_dilatations(const MeshLevel<dim> &level,
                    const unsigned int    body,
                    const NodalVector    &displacement);
} // namespace StickSlip

#endif
