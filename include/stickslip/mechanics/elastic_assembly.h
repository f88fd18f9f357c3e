// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_elastic_assembly_h
#define stickslip_mechanics_elastic_assembly_h

#include <stickslip/algebra/term_matrix.h>
#include <stickslip/mechanics/boundary_condition.h>
#include <stickslip/mechanics/material_fields.h>
#include <stickslip/mesh/mesh_hierarchy.h>

namespace StickSlip
{
  /**
   * The matrices of the semidiscrete equation of motion of all bodies,
   *
   *   M u_tt + C u_t + K u = f,
   *
   * in the nodal basis of one level, the bodies not yet coupled. Hanging nodes
   * are eliminated: their rows and columns are empty. Each process has the rows
   * of its nodes, assembled from all cells that touch them, without messages.
   */
  template <int n_components>
  struct ElasticMatrices
  {
    /** Consistent mass M, kg (per m in plane strain); no matrix at all if it
     * was not asked for. */
    TermMatrix<n_components> mass;
    /** Viscous damping C, N s/m; no matrix at all if no body is viscous. */
    TermMatrix<n_components> damping;
    /** Stiffness K, N/m. */
    TermMatrix<n_components> stiffness;
    /** Owned nodes, ascending, around which K or C resists changes of volume
     * far more than those of shape, on patches of nearly incompressible bodies;
     * where both do, that which does so more. */
    std::vector<unsigned int> stiff_volumes, viscous_volumes;
  };

  /**
   * Assemble the matrices; @p materials in the order of the bodies.
   * The mass matrix only @p with_mass. Parameters that vary are taken at the
   * quadrature points.
   *
   * The mean volumetric strain of patches of cells, where a material asks for
   * it, takes the place of tr(eps) in the part of the stiffness and of the
   * viscosity that resists the change of volume; the deviatoric part is
   * integrated in full (Nagtegaal, Parks and Rice 1974; Hughes 1980). Moduli of
   * the mean strain are means over the patch as well.
   *
   * A single component is the displacement out of the plane: then K is the
   * Laplace operator with mu, C that with eta, and no volume changes.
   */
  template <int dim, int n_components = dim>
  ElasticMatrices<n_components>
  assemble_elastic_matrices(const MeshLevel<dim>              &level,
                            const std::vector<MaterialFields> &materials,
                            const bool with_mass = true);

  /**
   * Evaluate parameters that vary wherever this process needs them, at the
   * quadrature points and centres of its cells. Throws InputError, on this
   * process only, where one is out of range.
   */
  template <int dim>
  void
  check_materials(const MeshLevel<dim>              &level,
                  const std::vector<MaterialFields> &materials);

  /**
   * The load vector of gravity, rho times its @p acceleration, m/s^2.
   */
  template <int dim>
  NodalVector
  assemble_gravity(const MeshLevel<dim>              &level,
                   const std::vector<MaterialFields> &materials,
                   const Tensor<1, dim>              &acceleration);
} // namespace StickSlip

#endif
