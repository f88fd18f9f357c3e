// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/index_set.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/base/input_error.h>
#include <stickslip/base/make_set.h>
#include <stickslip/mortar/excluded_nodes.h>
#include <stickslip/problem/contact_space.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** The shear modulus of a body on one of its sides, Pa: the mean over the
     * nodes there, if it varies. One for a rigid body, where nobody asks.
     * Collective. */
    template <int dim>
    double
    shear_modulus(const MeshLevel<dim> &level,
                  const BodySide       &part,
                  const MaterialFields &material)
    {
      const BodyMesh<dim> &body = *level.bodies[part.body];
      if (body.is_rigid())
        return 1.;
      if (material.are_constant())
        return material.constants().shear_modulus();
      const auto              function = material.function<dim>();
      const FaultSurface<dim> surface  = body.surface(part.side);
      double                  sum = 0., n_nodes = 0.;
      for (unsigned int k = 0; k < surface.nodes.size(); ++k)
        if (level.nodes.owned().is_element(
              level.global_node(part.body, surface.nodes[k])))
          {
            sum += function(surface.points[k]).shear_modulus();
            n_nodes += 1.;
          }
      const MPI_Comm communicator = level.nodes.communicator();
      return Utilities::MPI::sum(sum, communicator) /
             Utilities::MPI::sum(n_nodes, communicator);
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
        sum += shear_modulus(level, part, materials[part.body]);
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



  template <int dim, int n_components>
  ContactSpace<dim, n_components>::ContactSpace(
    const MeshHierarchy<dim>                &meshes,
    const std::vector<MaterialFields>       &materials,
    const BoundaryValues<dim, n_components> &boundary_values,
    const std::vector<SlipRates<dim>>       &slip_rates,
    const std::vector<OpeningParts<dim>>    &opening)
    : mesh_hierarchy(meshes)
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
    axes = make_fault_axes(finest, meshes.topology(), sides);
    for (unsigned int l = 0; l < meshes.n_levels(); ++l)
      {
        dirichlet_masks.push_back(boundary_values.dirichlet_mask(l));
        excluded.push_back(
          excluded_nodes(meshes.level(l), sides, dirichlet_masks[l]));
        boundary_frames.push_back(boundary_values.frames(l));
      }
    if (std::any_of(slip_rates.begin(),
                    slip_rates.end(),
                    [](const auto &rates) { return bool(rates); }))
      prescribed_slip =
        std::make_unique<PrescribedSlip<dim>>(meshes, sides, slip_rates);
    find_openings(opening);
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::find_openings(
    const std::vector<OpeningParts<dim>> &opening)
  {
    const unsigned int n_levels = mesh_hierarchy.n_levels();
    opening_nodes.resize(n_levels);
    for (unsigned int l = 0; l < n_levels; ++l)
      {
        std::vector<types::global_dof_index> &nodes = opening_nodes[l];
        for (unsigned int f = 0; f < opening.size(); ++f)
          {
            if (!opening[f])
              continue;
            const FaultSurface<dim> &slave =
              mesh_hierarchy.level(l).surface(f, sides[f].slave);
            std::vector<bool> is_part(slave.nodes.size(), true);
            if (l + 1 == n_levels)
              is_part = opening[f](slave.points);
            for (unsigned int k = 0; k < slave.nodes.size(); ++k)
              if (is_part[k])
                nodes.push_back(slave.nodes[k]);
          }
        make_set(nodes);
        if (!prescribed_slip)
          continue;
        const auto &known = prescribed_slip->nodes(l);
        nodes.erase(std::remove_if(nodes.begin(),
                                   nodes.end(),
                                   [&](const types::global_dof_index p) {
                                     return std::binary_search(known.begin(),
                                                               known.end(),
                                                               p);
                                   }),
                    nodes.end());
      }
  }



  template <int dim, int n_components>
  typename ContactSpace<dim, n_components>::Mapping
  ContactSpace<dim, n_components>::make_mapping(
    const NodalVector                     &displacement,
    const std::vector<Tensor<1, dim - 1>> &expected_slip) const
  {
    const unsigned int    n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim> &finest   = mesh_hierarchy.finest();

    Mapping                             mapping;
    std::vector<JumpBasis<dim>>        &bases = mapping.bases;
    std::vector<FaultDisplacement<dim>> displacements =
      gather_fault_displacements(finest, sides, displacement);
    std::vector<FaultAxes<dim>> axes_now = axes;
    bases.reserve(n_levels);
    mapping.gaps = follow_bends(expected_slip, axes_now, displacements);
    for (unsigned int l = n_levels; l-- > 0;)
      {
        const MeshLevel<dim> &level = mesh_hierarchy.level(l);
        if (l + 1 < n_levels)
          {
            displacements = inject(mesh_hierarchy, l, sides, displacements);
            axes_now      = inject(mesh_hierarchy, l, sides, axes_now);
          }
        bases.emplace_back(level, sides, axes_now, displacements, excluded[l]);
        if (l + 1 < n_levels)
          bases.back().forget_faults();
      }
    std::reverse(bases.begin(), bases.end());
    for (unsigned int i = 0; i < bases.back().faults().size(); ++i)
      if (!(bases.back().faults()[i].coupling.covered_area > 0.))
        throw AgreedFailure("The two sides of the fault '" +
                            mesh_hierarchy.topology().faults()[i].name +
                            "' do not touch.");
    return mapping;
  }



  template <int dim, int n_components>
  std::vector<std::optional<LargestGap>>
  ContactSpace<dim, n_components>::follow_bends(
    const std::vector<Tensor<1, dim - 1>> &expected_slip,
    std::vector<FaultAxes<dim>>           &axes_now,
    std::vector<FaultDisplacement<dim>>   &displacements) const
  {
    const MeshLevel<dim>                  &finest = mesh_hierarchy.finest();
    std::vector<std::optional<LargestGap>> gaps(sides.size());
    double                                 farthest = 0.;
    for (const Tensor<1, dim - 1> &slip : expected_slip)
      farthest = std::max(farthest, slip.norm());
    unsigned int first = 0;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        const FaultSurface<dim> &slave  = finest.surface(f, sides[f].slave);
        const FaultSurface<dim> &master = finest.surface(f, sides[f].master);
        const unsigned int       n      = slave.nodes.size();
        std::vector<Tensor<1, dim - 1>> slip;
        if (!expected_slip.empty())
          slip.assign(expected_slip.begin() + first,
                      expected_slip.begin() + first + n);
        first += n;
        if (slave.is_plane() && master.is_plane())
          {
            for (unsigned int k = 0; k < slip.size(); ++k)
              for (unsigned int c = 0; c < dim - 1; ++c)
                for (unsigned int d = 0; d < dim; ++d)
                  displacements[f].slave[k][d] +=
                    0.5 * slip[k][c] * axes_now[f].at(k)[d][c];
            continue;
          }
        try
          {
            SecantCoupling<dim> coupling =
              secant_coupling(slave,
                              master,
                              sides[f],
                              displacements[f],
                              slip,
                              farthest,
                              axes_now[f].reference_axis(),
                              finest.nodes.communicator());
            axes_now[f]      = std::move(coupling.axes);
            displacements[f] = std::move(coupling.displacement);
            gaps[f]          = coupling.gap;
          }
        catch (const InputError &error)
          {
            throw AgreedFailure("The fault '" +
                                mesh_hierarchy.topology().faults()[f].name +
                                "': " + error.what());
          }
      }
    return gaps;
  }



  template <int dim, int n_components>
  NodalProlongation
  ContactSpace<dim, n_components>::prolongation_rows(
    const unsigned int    level,
    const JumpBasis<dim> &basis,
    const NodePartition  &nodes) const
  {
    std::vector<types::global_dof_index> wanted;
    for (unsigned int i = 0; i < nodes.n_local(); ++i)
      for (const auto &jump : basis.to_jumps(nodes.global_index(i)))
        if (!nodes.owned().is_element(jump.first))
          wanted.push_back(jump.first);
    return NodalProlongation(mesh_hierarchy.prolongation(level),
                             mesh_hierarchy.level(level).nodes,
                             make_index_set(nodes.n_global(), wanted));
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::set_mapping(Mapping              mapping,
                                               const BlockSparsity &sparsity)
  {
    std::vector<JumpBasis<dim>> &bases    = mapping.bases;
    const unsigned int           n_levels = mesh_hierarchy.n_levels();
    const MeshLevel<dim>        &finest   = mesh_hierarchy.finest();

    // Memory of the old transfers is needed for the new ones.
    levels.clear();

    // A node at which components are prescribed is no contact node.
    std::vector<NodeFrames<n_components>> frames = boundary_frames;
    if constexpr (n_components == dim)
      for (unsigned int l = 0; l < n_levels; ++l)
        for (const auto &[node, node_axes] : bases[l].frames())
          frames[l].set(node, node_axes);

    // From the nodal basis to jumps, and from there down the levels. Each
    // product tells the ghosts and the sparsity on its coarse side.
    to_jump_basis = std::make_unique<GalerkinProduct<n_components>>(
      finest.nodes,
      sparsity,
      local_rows(finest.nodes,
                 [&](const types::global_dof_index node) {
                   return bases.back().to_nodal(node);
                 }),
      finest.nodes.owned(),
      LocalFrames(),
      frames.back());
    std::vector<LevelDescription<n_components>> descriptions(n_levels);
    descriptions.back().nodes          = to_jump_basis->coarse_nodes();
    descriptions.back().frames         = to_jump_basis->coarse_frames();
    const BlockSparsity *fine_sparsity = to_jump_basis->coarse_sparsity().get();
    for (unsigned int l = n_levels - 1; l > 0; --l)
      {
        LevelDescription<n_components> &fine = descriptions[l];
        const NodalProlongation         prolongation =
          prolongation_rows(l, bases[l], fine.nodes);
        fine.to_coarser = std::make_shared<GalerkinProduct<n_components>>(
          fine.nodes,
          *fine_sparsity,
          local_rows(fine.nodes,
                     [&](const types::global_dof_index node) {
                       return jump_prolongation(bases[l - 1],
                                                bases[l],
                                                prolongation,
                                                node);
                     }),
          mesh_hierarchy.level(l - 1).nodes.owned(),
          fine.frames,
          frames[l - 1]);
        descriptions[l - 1].nodes  = fine.to_coarser->coarse_nodes();
        descriptions[l - 1].frames = fine.to_coarser->coarse_frames();
        fine_sparsity              = fine.to_coarser->coarse_sparsity().get();
      }
    describe(descriptions, bases);

    std::vector<GlobalRow> inverse_rows;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      inverse_rows.push_back(
        bases.back().to_jumps(finest.nodes.global_index(i)));
    B_inverse = TransferMatrix(inverse_rows,
                               finest.nodes,
                               to_jump_basis->coarse_nodes(),
                               frames.back().local_part(finest.nodes));
    rotation =
      RotationCoupling<dim, n_components>(bases.back(),
                                          frames.back(),
                                          to_jump_basis->coarse_nodes(),
                                          *to_jump_basis->coarse_sparsity());
    bases.back().forget_rotation_terms();
    levels       = std::move(descriptions);
    finest_basis = std::make_unique<JumpBasis<dim>>(std::move(bases.back()));
    largest_gaps = std::move(mapping.gaps);
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::describe(
    std::vector<LevelDescription<n_components>> &levels,
    const std::vector<JumpBasis<dim>>           &bases) const
  {
    const std::vector<types::global_dof_index> no_nodes;
    for (unsigned int l = 0; l < levels.size(); ++l)
      {
        LevelDescription<n_components> &level = levels[l];
        level.nonsmooth_nodes = bases[l].owned_contact_nodes(level.nodes);
        level.fixed =
          fixed_components(mesh_hierarchy.level(l),
                           level.nodes,
                           dirichlet_masks[l],
                           bases[l],
                           prescribed_slip ? prescribed_slip->nodes(l) :
                                             no_nodes,
                           opening_nodes[l]);
      }
  }



  template <int dim, int n_components>
  const std::vector<LevelDescription<n_components>> &
  ContactSpace<dim, n_components>::descriptions() const
  {
    return levels;
  }



  template <int dim, int n_components>
  GalerkinProduct<n_components> &
  ContactSpace<dim, n_components>::jump_product()
  {
    return *to_jump_basis;
  }



  template <int dim, int n_components>
  const RotationCoupling<dim, n_components> &
  ContactSpace<dim, n_components>::rotation_coupling() const
  {
    return rotation;
  }



  template <int dim, int n_components>
  const MeshHierarchy<dim> &
  ContactSpace<dim, n_components>::meshes() const
  {
    return mesh_hierarchy;
  }



  template <int dim, int n_components>
  const JumpBasis<dim> &
  ContactSpace<dim, n_components>::jump_basis() const
  {
    return *finest_basis;
  }



  template <int dim, int n_components>
  const std::vector<std::optional<LargestGap>> &
  ContactSpace<dim, n_components>::gaps() const
  {
    return largest_gaps;
  }



  template <int dim, int n_components>
  bool
  ContactSpace<dim, n_components>::may_open(
    const types::global_dof_index node) const
  {
    const std::vector<types::global_dof_index> &nodes = opening_nodes.back();
    return std::binary_search(nodes.begin(), nodes.end(), node);
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::to_jumps(NodalVector       &w,
                                            const NodalVector &u) const
  {
    if (Utilities::MPI::n_mpi_processes(u.get_mpi_communicator()) == 1)
      B_inverse.prolongate(w, u, n_components);
    else
      {
        // Values with the ghosts of the jump basis.
        NodalVector values = make_vector();
        std::copy_n(u.begin(), u.locally_owned_size(), values.begin());
        B_inverse.prolongate(w, values, n_components);
      }
    rotation.add(1., w);
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::to_nodal(NodalVector       &u,
                                            const NodalVector &w) const
  {
    if (rotation.empty())
      {
        to_jump_basis->prolongation().prolongate(u, w, n_components);
        return;
      }
    NodalVector without_term = w;
    rotation.add(-1., without_term);
    to_jump_basis->prolongation().prolongate(u, without_term, n_components);
  }



  template <int dim, int n_components>
  NodalVector
  ContactSpace<dim, n_components>::to_dual(const NodalVector &f) const
  {
    NodalVector dual = make_vector();
    to_jump_basis->prolongation().restrict_to(dual, f, n_components);
    rotation.add_transpose(-1., dual);
    return dual;
  }



  template <int dim, int n_components>
  NodalVector
  ContactSpace<dim, n_components>::to_nodal_forces(
    const NodalVector &dual) const
  {
    NodalVector turned = dual, forces = make_vector(),
                result = make_nodal_vector();
    rotation.add_transpose(1., turned);
    B_inverse.restrict_to(forces, turned, n_components);
    std::copy_n(forces.begin(), forces.locally_owned_size(), result.begin());
    return result;
  }



  template <int dim, int n_components>
  void
  ContactSpace<dim, n_components>::set_known_jumps(const double time,
                                                   NodalVector &w) const
  {
    const LevelDescription<n_components> &finest = levels.back();
    for (const unsigned int p : finest.nonsmooth_nodes)
      if (!may_open(finest.nodes.global_index(p)))
        for (unsigned int c = FaultAxes<dim>::normal_component;
             c < n_components;
             ++c)
          w.local_element(p * n_components + c) = 0.;
    if (prescribed_slip)
      prescribed_slip->set_slip_rates(time, *finest_basis, finest.nodes, w);
  }



  template <int dim, int n_components>
  double
  ContactSpace<dim, n_components>::longest_slip_ramp() const
  {
    return prescribed_slip ? prescribed_slip->longest_ramp() : 0.;
  }



  template <int dim, int n_components>
  NodalVector
  ContactSpace<dim, n_components>::make_vector() const
  {
    return levels.back().nodes.make_vector();
  }



  template <int dim, int n_components>
  NodalVector
  ContactSpace<dim, n_components>::make_nodal_vector() const
  {
    return mesh_hierarchy.finest().nodes.make_vector();
  }



  template class ContactSpace<2>;
  template class ContactSpace<3>;
  template class ContactSpace<2, 1>;
} // namespace StickSlip
