// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/time/spatial_problem.h>

namespace StickSlip
{
  namespace
  {
    /** The components that never take part: prescribed ones, those of hanging
     * nodes, and the normal jumps, which are zero. */
    template <int dim>
    NodeMask
    fixed_components(const MeshLevel<dim> &level,
                     const NodeMask       &dirichlet,
                     const JumpBasis<dim> &basis)
    {
      NodeMask mask = dirichlet;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        for (const auto &line : level.bodies[b]->hanging_nodes().get_lines())
          mask.mask_node(level.node(b, line.index));
      for (const unsigned int p : basis.contact_nodes())
        mask.mask(p, dim - 1);
      return mask;
    }
  } // namespace



  template <int dim>
  SpatialProblem<dim>::SpatialProblem(const MeshHierarchy<dim>    &meshes,
                                      const std::vector<Material> &materials,
                                      BoundaryValues<dim> &boundary_values,
                                      const double         gravity)
    : mesh_hierarchy(meshes)
    , boundary(boundary_values)
  {
    const MeshLevel<dim> &finest = meshes.finest();
    for (unsigned int lower = 0; lower + 1 < meshes.n_bodies(); ++lower)
      sides.push_back(choose_fault_sides(finest, lower));
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      dirichlet_masks.push_back(boundary.dirichlet_mask(l));

    ElasticMatrices<dim> matrices =
      assemble_elastic_matrices(finest, materials);
    nodal_terms.push_back(std::move(matrices.mass));
    nodal_terms.push_back(std::move(matrices.damping));
    nodal_terms.push_back(std::move(matrices.stiffness));
    gravity_load = assemble_gravity(finest, materials, gravity);

    build_contact(finest.nodes.make_vector());
  }



  template <int dim>
  void
  SpatialProblem<dim>::build_contact(const NodalVector &displacement)
  {
    ++builds;
    const unsigned int            n_levels = mesh_hierarchy.n_levels();
    std::vector<LevelDescription> descriptions(n_levels);

    std::unique_ptr<JumpBasis<dim>> finer_basis;
    NodalVector                     level_displacement = displacement;
    for (unsigned int l = n_levels; l-- > 0;)
      {
        const MeshLevel<dim> &level = mesh_hierarchy.level(l);
        if (l + 1 < n_levels)
          {
            NodalVector injected = level.nodes.make_vector();
            inject(injected,
                   level_displacement,
                   mesh_hierarchy.prolongation(l + 1),
                   dim);
            level_displacement = injected;
          }
        auto basis = std::make_unique<JumpBasis<dim>>(level,
                                                      sides,
                                                      level_displacement,
                                                      dirichlet_masks[l]);

        descriptions[l].nodes           = level.nodes;
        descriptions[l].nonsmooth_nodes = basis->contact_nodes();
        descriptions[l].fixed =
          fixed_components(level, dirichlet_masks[l], *basis);
        if (l + 1 < n_levels)
          descriptions[l + 1].prolongation =
            jump_prolongation(*basis,
                              *finer_basis,
                              mesh_hierarchy.prolongation(l + 1));
        if (l + 2 == n_levels)
          finest_basis = std::move(finer_basis);
        finer_basis = std::move(basis);
      }
    if (n_levels == 1)
      finest_basis = std::move(finer_basis);

    for (unsigned int i = 0; i < finest_basis->faults().size(); ++i)
      AssertThrow(finest_basis->faults()[i].coupling.covered_area > 0.,
                  ExcMessage("The two sides of fault " + std::to_string(i + 1) +
                             " (counted from below) do not touch."));

    GalerkinProduct<dim> to_jump_basis(finest_basis->to_nodal(),
                                       nodal_terms.front().sparsity());
    const NodeMask       all(mesh_hierarchy.finest().nodes.n_local(), dim);
    std::vector<BlockMatrix<dim>> terms;
    for (const BlockMatrix<dim> &term : nodal_terms)
      {
        terms.emplace_back(to_jump_basis.coarse_sparsity());
        to_jump_basis.compute(term, all, terms.back());
      }
    levels = std::make_unique<LevelHierarchy<dim>>(std::move(descriptions));
    levels->set_terms(std::move(terms));
  }



  template <int dim>
  const MeshHierarchy<dim> &
  SpatialProblem<dim>::meshes() const
  {
    return mesh_hierarchy;
  }



  template <int dim>
  LevelHierarchy<dim> &
  SpatialProblem<dim>::hierarchy()
  {
    return *levels;
  }



  template <int dim>
  const LevelHierarchy<dim> &
  SpatialProblem<dim>::hierarchy() const
  {
    return *levels;
  }



  template <int dim>
  const JumpBasis<dim> &
  SpatialProblem<dim>::jump_basis() const
  {
    return *finest_basis;
  }



  template <int dim>
  void
  SpatialProblem<dim>::to_jumps(NodalVector &w, const NodalVector &u) const
  {
    finest_basis->to_jumps().prolongate(w, u, dim);
  }



  template <int dim>
  void
  SpatialProblem<dim>::to_nodal(NodalVector &u, const NodalVector &w) const
  {
    finest_basis->to_nodal().prolongate(u, w, dim);
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::load(const double time)
  {
    NodalVector nodal = gravity_load;
    boundary.add_tractions(time, nodal);
    NodalVector dual = make_vector();
    finest_basis->to_nodal().restrict_to(dual, nodal, dim);
    return dual;
  }



  template <int dim>
  BoundaryValues<dim> &
  SpatialProblem<dim>::boundary_values()
  {
    return boundary;
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::make_vector() const
  {
    return mesh_hierarchy.finest().nodes.make_vector();
  }



  template <int dim>
  unsigned int
  SpatialProblem<dim>::n_builds() const
  {
    return builds;
  }



  template class SpatialProblem<2>;
  template class SpatialProblem<3>;
} // namespace StickSlip
