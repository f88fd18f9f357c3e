// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_strain_energy_h
#define stickslip_mechanics_strain_energy_h

#include <deal.II/dofs/dof_handler.h>

#include <stickslip/mechanics/materials_of_cell.h>
#include <stickslip/mesh/mesh_level.h>

#include <memory>

namespace StickSlip
{
  /**
   * The elastic energy of patches of cells, by the quadrature and the
   * volumetric strain of assemble_elastic_matrices().
   */
  template <int dim, int n_components = dim>
  class StrainEnergy
  {
  public:
    /** @p materials in the order of the bodies of the level, which must live
     * longer. */
    StrainEnergy(const MeshLevel<dim>              &level,
                 const std::vector<MaterialFields> &materials);

    /** The energy of the cells of a patch of a body, J (per m in two
     * dimensions), with displacements at the vertices of each, m. */
    double
    operator()(
      const unsigned int                                          body,
      const std::vector<typename DoFHandler<dim>::cell_iterator> &cells,
      const std::vector<std::vector<Tensor<1, n_components>>> &displacements);

  private:
    MaterialsOfCell<dim>                        materials;
    std::vector<std::unique_ptr<FEValues<dim>>> values_of_body;
  };
} // namespace StickSlip

#endif
