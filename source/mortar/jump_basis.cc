// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/jump_basis.h>
#include <stickslip/mortar/moved_surface.h>
#include <stickslip/mortar/shared_coupling.h>

#include <algorithm>
#include <tuple>

namespace StickSlip
{
  namespace
  {
    /** Nodes of the rotation term that the row does not have (integrals can
     * vanish where faces meet) get this entry, rounding that is just large
     * enough not to be dropped: the sparsity of products then has a place for
     * them. */
    constexpr double least_entry = 2e-14;



    template <int dim>
    std::vector<Point<dim>>
    current_positions(const FaultSurface<dim>           &surface,
                      const std::vector<Tensor<1, dim>> &displacement)
    {
      std::vector<Point<dim>> positions;
      for (unsigned int p = 0; p < surface.points.size(); ++p)
        positions.push_back(surface.points[p] + displacement[p]);
      return positions;
    }



    /** Sides that bend have the normals that they have where they are now. */
    template <int dim>
    MortarCoupling<dim>
    couple(const FaultSurface<dim>      &slave,
           const FaultSurface<dim>      &master,
           const FaultDisplacement<dim> &displacement,
           const bool                    are_bent,
           const std::vector<bool>      &excluded,
           const MPI_Comm               &communicator)
    {
      const std::vector<Point<dim>> slave_positions =
        current_positions(slave, displacement.slave);
      const std::vector<Point<dim>> master_positions =
        current_positions(master, displacement.master);
      if (!are_bent)
        return build_shared_coupling<dim>(slave,
                                          slave_positions,
                                          master,
                                          master_positions,
                                          excluded,
                                          communicator);
      return build_shared_coupling<dim>(moved_surface(slave, slave_positions),
                                        slave_positions,
                                        moved_surface(master, master_positions),
                                        master_positions,
                                        excluded,
                                        communicator);
    }



    template <typename Row>
    void
    add_multiple(GlobalRow &sum, const double factor, const Row &row)
    {
      for (const auto &entry : row)
        sum.emplace_back(entry.first, factor * entry.second);
    }



    bool
    has_column(const SparseRow &row, const unsigned int column)
    {
      return std::any_of(row.begin(), row.end(), [&](const auto &entry) {
        return entry.first == column;
      });
    }



    /** The partners of the k-th slave node, those of the rotation term among
     * them. */
    template <int dim>
    GlobalRow
    partners_of(const FaultContact<dim> &contact, const unsigned int k)
    {
      const MortarCoupling<dim> &coupling = contact.coupling;
      GlobalRow                  result;
      for (const auto &[q, factor] : coupling.master_rows[k])
        result.emplace_back(contact.master.nodes[q], factor);
      for (const auto &[q, factor] : coupling.inactive_slave_rows[k])
        result.emplace_back(contact.slave.nodes[q], factor);
      if (!coupling.rotation_rows.empty())
        for (const auto &term : coupling.rotation_rows[k])
          if (!has_column(coupling.master_rows[k], term.first))
            result.emplace_back(contact.master.nodes[term.first], least_entry);
      return result;
    }



    /** The rotation term of the k-th slave node, which takes the least entries
     * back. */
    template <int dim>
    std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>>
    rotation_term_of(const FaultContact<dim> &contact, const unsigned int k)
    {
      const MortarCoupling<dim> &coupling = contact.coupling;
      std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>> result;
      for (auto [q, matrix] : coupling.rotation_rows[k])
        {
          if (!has_column(coupling.master_rows[k], q))
            for (unsigned int d = 0; d < dim; ++d)
              matrix[d][d] += least_entry;
          result.emplace_back(contact.master.nodes[q], matrix);
        }
      return result;
    }
  } // namespace



  template <int dim>
  JumpBasis<dim>::JumpBasis(
    const MeshLevel<dim>                      &level,
    const std::vector<FaultSides>             &sides,
    const std::vector<FaultAxes<dim>>         &axes,
    const std::vector<FaultDisplacement<dim>> &displacements,
    const std::vector<std::vector<bool>>      &excluded)
  {
    AssertDimension(axes.size(), sides.size());
    AssertDimension(displacements.size(), sides.size());
    AssertDimension(excluded.size(), sides.size());
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        const FaultSurface<dim> &slave  = level.surface(f, sides[f].slave);
        const FaultSurface<dim> &master = level.surface(f, sides[f].master);
        const bool is_bent = !slave.is_plane() || !master.is_plane();
        contacts.push_back(
          {slave,
           master,
           sides[f],
           axes[f],
           couple(slave,
                  master,
                  displacements[f],
                  is_bent,
                  excluded[f],
                  level.nodes.communicator()),
           std::min(face_sizes(slave).second, face_sizes(master).second),
           is_bent});
      }

    // Each active node, its fault and its place there.
    std::vector<std::tuple<types::global_dof_index, unsigned int, unsigned int>>
      active;
    for (unsigned int f = 0; f < contacts.size(); ++f)
      for (unsigned int k = 0; k < contacts[f].slave.nodes.size(); ++k)
        if (contacts[f].coupling.active[k])
          active.emplace_back(contacts[f].slave.nodes[k], f, k);
    std::sort(active.begin(), active.end());
    active_nodes.reserve(active.size());
    factors.reserve(active.size());
    for (const auto &[node, f, k] : active)
      {
        const FaultContact<dim> &contact = contacts[f];
        active_nodes.push_back(node);
        factors.push_back(contact.coupling.averaging_factor[k]);
        partners.add_row(partners_of(contact, k));
        if (!contact.coupling.rotation_rows.empty())
          rotation_terms[node] = rotation_term_of(contact, k);
        if (!contact.axes.are_those_of_space())
          jump_frames.set(node, contact.axes.at(k));
      }
    partners.close();
    for (FaultContact<dim> &contact : contacts)
      contact.coupling.forget_rows();
  }



  template <int dim>
  void
  JumpBasis<dim>::forget_faults()
  {
    contacts.clear();
    contacts.shrink_to_fit();
    forget_rotation_terms();
  }



  template <int dim>
  void
  JumpBasis<dim>::forget_rotation_terms()
  {
    rotation_terms.clear();
  }



  template <int dim>
  unsigned int
  JumpBasis<dim>::position(const types::global_dof_index node) const
  {
    const auto found =
      std::lower_bound(active_nodes.begin(), active_nodes.end(), node);
    return found != active_nodes.end() && *found == node ?
             found - active_nodes.begin() :
             active_nodes.size();
  }



  template <int dim>
  GlobalRow
  JumpBasis<dim>::to_nodal(const types::global_dof_index node) const
  {
    const unsigned int p = position(node);
    if (p == active_nodes.size())
      return {{node, 1.}};
    GlobalRow row = {{node, 1. / factors[p]}};
    add_multiple(row, 1., partners[p]);
    return row;
  }



  template <int dim>
  GlobalRow
  JumpBasis<dim>::to_jumps(const types::global_dof_index node) const
  {
    const unsigned int p = position(node);
    if (p == active_nodes.size())
      return {{node, 1.}};
    GlobalRow row = {{node, factors[p]}};
    add_multiple(row, -factors[p], partners[p]);
    return row;
  }



  template <int dim>
  std::vector<std::pair<types::global_dof_index, Tensor<2, dim>>>
  JumpBasis<dim>::rotation_term(const types::global_dof_index node) const
  {
    const auto term = rotation_terms.find(node);
    if (term == rotation_terms.end())
      return {};
    return term->second;
  }



  template <int dim>
  std::vector<unsigned int>
  JumpBasis<dim>::owned_contact_nodes(const NodePartition &nodes) const
  {
    std::vector<unsigned int> result;
    for (const auto node : active_nodes)
      if (nodes.owned().is_element(node))
        result.push_back(nodes.local_index(node));
    return result;
  }



  template <int dim>
  GlobalRow
  jump_prolongation(const JumpBasis<dim>         &coarse,
                    const JumpBasis<dim>         &fine,
                    const NodalProlongation      &prolongation,
                    const types::global_dof_index node)
  {
    GlobalRow result;
    for (const auto &jump : fine.to_jumps(node))
      for (const auto &value : prolongation.row(jump.first))
        add_multiple(result,
                     jump.second * value.second,
                     coarse.to_nodal(value.first));
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                     \
  template struct FaultContact<dim>;                                   \
  template class JumpBasis<dim>;                                       \
  template GlobalRow jump_prolongation<dim>(const JumpBasis<dim> &,    \
                                            const JumpBasis<dim> &,    \
                                            const NodalProlongation &, \
                                            const types::global_dof_index);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
