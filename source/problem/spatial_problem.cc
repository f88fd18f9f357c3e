// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/agreed_failure.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/problem/contact_components.h>
#include <stickslip/problem/spatial_problem.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** The shear modulus of a body on one of its sides: the mean over the
     * nodes there, if it varies. That of a rigid body is not asked for. */
    template <int dim>
    double
    shear_modulus(const BodyMesh<dim>     &body,
                  const types::boundary_id side,
                  const MaterialFields    &material)
    {
      if (body.is_rigid())
        return 1.;
      if (material.are_constant())
        return material.constants().shear_modulus();
      const auto function = material.function<dim>();
      double     sum      = 0;
      const auto points   = body.surface(side).points;
      for (const Point<dim> &point : points)
        sum += function(point).shear_modulus();
      return sum / points.size();
    }



    /** The mean of the shear moduli of the parts of one side of a fault. */
    template <int dim>
    double
    shear_modulus(const MeshLevel<dim>              &level,
                  const std::vector<BodySide>       &parts,
                  const std::vector<MaterialFields> &materials)
    {
      double sum = 0;
      for (const BodySide &part : parts)
        sum += shear_modulus(*level.bodies[part.body],
                             part.side,
                             materials[part.body]);
      return sum / parts.size();
    }



    /** The results of @p row for all nodes with a local index. */
    template <typename Row>
    std::vector<GlobalRow>
    local_rows(const NodePartition &nodes, const Row &row)
    {
      std::vector<GlobalRow> rows;
      rows.reserve(nodes.n_local());
      for (unsigned int i = 0; i < nodes.n_local(); ++i)
        rows.push_back(row(nodes.global_index(i)));
      return rows;
    }
  } // namespace



  template <int dim>
  SpatialProblem<dim>::SpatialProblem(
    const MeshHierarchy<dim>          &meshes,
    const std::vector<MaterialFields> &materials,
    BoundaryValues<dim>               &boundary_values,
    const Tensor<1, dim>              &gravity,
    const bool                         with_inertia,
    const std::vector<SlipRates<dim>> &slip_rates)
    : mesh_hierarchy(meshes)
    , boundary(boundary_values)
  {
    const MeshLevel<dim>     &finest = meshes.finest();
    const std::vector<Fault> &faults = meshes.topology().faults();
    for (unsigned int f = 0; f < faults.size(); ++f)
      sides.push_back(choose_fault_sides(
        finest,
        meshes.topology(),
        f,
        shear_modulus(finest, faults[f].sides[1], materials) /
          shear_modulus(finest, faults[f].sides[0], materials)));
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      dirichlet_masks.push_back(boundary.dirichlet_mask(l));
    if (std::any_of(slip_rates.begin(),
                    slip_rates.end(),
                    [](const auto &rates) { return bool(rates); }))
      prescribed_slip =
        std::make_unique<PrescribedSlip<dim>>(meshes, sides, slip_rates);

    ElasticMatrices<dim> matrices =
      assemble_elastic_matrices(finest, materials, with_inertia);
    const auto add = [&](const Term term, BlockMatrix<dim> &matrix) {
      if (matrix.shared_sparsity() == nullptr)
        return;
      terms.push_back(term);
      nodal_terms.push_back(std::move(matrix));
    };
    add(mass, matrices.mass);
    add(damping, matrices.damping);
    add(stiffness, matrices.stiffness);
    if (gravity.norm_square() > 0.)
      gravity_load = assemble_gravity(finest, materials, gravity);

    build_contact(finest.nodes.make_vector());
  }



  template <int dim>
  bool
  SpatialProblem<dim>::has(const Term term) const
  {
    return std::find(terms.begin(), terms.end(), term) != terms.end();
  }



  template <int dim>
  const BlockMatrix<dim> &
  SpatialProblem<dim>::term(const Term term) const
  {
    const auto position = std::find(terms.begin(), terms.end(), term);
    AssertThrow(position != terms.end(),
                ExcMessage("The equation has no such term."));
    return operator_sum->terms()[position - terms.begin()];
  }



  template <int dim>
  void
  SpatialProblem<dim>::combine(const std::vector<double> &coefficients)
  {
    std::vector<double> present;
    for (const Term term : terms)
      present.push_back(coefficients[term]);
    operator_sum->combine(present);
  }



  template <int dim>
  void
  SpatialProblem<dim>::build_contact(const NodalVector &displacement)
  {
    ++builds;
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();

    std::vector<JumpBasis<dim>>         bases;
    std::vector<FaultDisplacement<dim>> displacements =
      gather_fault_displacements(finest, sides, displacement);
    for (unsigned int l = n_levels; l-- > 0;)
      {
        const MeshLevel<dim> &level = mesh_hierarchy.level(l);
        if (l + 1 < n_levels)
          displacements = inject(level,
                                 mesh_hierarchy.level(l + 1),
                                 mesh_hierarchy.prolongation(l + 1),
                                 sides,
                                 displacements);
        bases.emplace_back(level, sides, displacements, dirichlet_masks[l]);
      }
    std::reverse(bases.begin(), bases.end());
    for (unsigned int i = 0; i < bases.back().faults().size(); ++i)
      if (!(bases.back().faults()[i].coupling.covered_area > 0.))
        throw AgreedFailure("The two sides of the fault '" +
                            mesh_hierarchy.topology().faults()[i].name +
                            "' do not touch.");

    build(bases);
    finest_basis = std::make_unique<JumpBasis<dim>>(std::move(bases.back()));
  }



  template <int dim>
  void
  SpatialProblem<dim>::build(const std::vector<JumpBasis<dim>> &bases)
  {
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();

    // The memory is needed for the new ones.
    levels.reset();
    operator_sum.reset();

    // From the nodal basis to jumps, and from there down the levels. Each
    // product tells the ghosts and the sparsity on its coarse side.
    to_jump_basis = std::make_unique<GalerkinProduct<dim>>(
      finest.nodes,
      nodal_terms.front().sparsity(),
      local_rows(finest.nodes,
                 [&](const types::global_dof_index node) {
                   return bases.back().to_nodal(node);
                 }),
      finest.nodes.owned());
    std::vector<LevelDescription<dim>> descriptions(n_levels);
    descriptions.back().nodes     = to_jump_basis->coarse_nodes();
    const BlockSparsity *sparsity = to_jump_basis->coarse_sparsity().get();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        LevelDescription<dim> &fine = descriptions[l];
        fine.to_coarser             = std::make_shared<GalerkinProduct<dim>>(
          fine.nodes,
          *sparsity,
          local_rows(fine.nodes,
                     [&](const types::global_dof_index node) {
                       return jump_prolongation(bases[l - 1],
                                                bases[l],
                                                mesh_hierarchy.prolongation(l),
                                                node);
                     }),
          mesh_hierarchy.level(l - 1).nodes.owned());
        descriptions[l - 1].nodes = fine.to_coarser->coarse_nodes();
        sparsity                  = fine.to_coarser->coarse_sparsity().get();
      }
    describe(descriptions, bases);

    const NodeMask                all(finest.nodes.n_local(), dim);
    std::vector<BlockMatrix<dim>> terms;
    for (const BlockMatrix<dim> &term : nodal_terms)
      {
        terms.emplace_back(to_jump_basis->coarse_sparsity());
        to_jump_basis->compute(term, all, terms.back());
      }
    std::vector<GlobalRow> inverse_rows;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      inverse_rows.push_back(
        bases.back().to_jumps(finest.nodes.global_index(i)));
    B_inverse =
      TransferMatrix(inverse_rows, finest.nodes, to_jump_basis->coarse_nodes());
    operator_sum =
      std::make_unique<OperatorSum<dim>>(descriptions.back(), std::move(terms));
    levels = std::make_unique<LevelHierarchy<dim>>(*operator_sum,
                                                   std::move(descriptions));
  }



  template <int dim>
  void
  SpatialProblem<dim>::describe(
    std::vector<LevelDescription<dim>> &descriptions,
    const std::vector<JumpBasis<dim>>  &bases) const
  {
    const std::vector<types::global_dof_index> no_nodes;
    for (unsigned int l = 0; l < descriptions.size(); ++l)
      {
        LevelDescription<dim> &level = descriptions[l];
        level.nonsmooth_nodes = bases[l].owned_contact_nodes(level.nodes);
        level.fixed =
          fixed_components(mesh_hierarchy.level(l),
                           dirichlet_masks[l],
                           bases[l],
                           prescribed_slip ? prescribed_slip->nodes(l) :
                                             no_nodes)
            .local_part(level.nodes);
      }
  }



  template <int dim>
  bool
  SpatialProblem<dim>::is_coupled() const
  {
    return levels != nullptr;
  }



  template <int dim>
  const MeshHierarchy<dim> &
  SpatialProblem<dim>::meshes() const
  {
    return mesh_hierarchy;
  }



  template <int dim>
  OperatorSum<dim> &
  SpatialProblem<dim>::operators()
  {
    return *operator_sum;
  }



  template <int dim>
  const OperatorSum<dim> &
  SpatialProblem<dim>::operators() const
  {
    return *operator_sum;
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
    // With the ghosts of the jump basis.
    NodalVector values = make_vector();
    std::copy_n(u.begin(), u.locally_owned_size(), values.begin());
    B_inverse.prolongate(w, values, dim);
  }



  template <int dim>
  void
  SpatialProblem<dim>::to_nodal(NodalVector &u, const NodalVector &w) const
  {
    to_jump_basis->prolongation().prolongate(u, w, dim);
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::to_dual(const NodalVector &f) const
  {
    NodalVector dual = make_vector();
    to_jump_basis->prolongation().restrict_to(dual, f, dim);
    return dual;
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::load(const double time)
  {
    const bool has_gravity = gravity_load.size() > 0;
    if (!has_gravity && !boundary.has_tractions())
      return make_vector();
    NodalVector nodal = has_gravity ? gravity_load : make_nodal_vector();
    boundary.add_tractions(time, nodal);
    return to_dual(nodal);
  }



  template <int dim>
  BoundaryValues<dim> &
  SpatialProblem<dim>::boundary_values()
  {
    return boundary;
  }



  template <int dim>
  void
  SpatialProblem<dim>::set_known_jumps(const double time, NodalVector &w) const
  {
    const LevelDescription<dim> &finest = levels->finest();
    for (const unsigned int p : finest.nonsmooth_nodes)
      w.local_element(p * dim + FaultAxes<dim>::normal_component) = 0.;
    if (prescribed_slip)
      prescribed_slip->set_slip_rates(time, *finest_basis, finest.nodes, w);
  }



  template <int dim>
  double
  SpatialProblem<dim>::longest_ramp() const
  {
    const double of_sides = boundary.longest_ramp();
    return prescribed_slip ?
             std::max(of_sides, prescribed_slip->longest_ramp()) :
             of_sides;
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::make_vector() const
  {
    return levels->finest().nodes.make_vector();
  }



  template <int dim>
  NodalVector
  SpatialProblem<dim>::make_nodal_vector() const
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
