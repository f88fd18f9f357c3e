// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/jump_basis.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Extents of all faces along the fault: their mean and their least. */
    template <int dim>
    std::pair<double, double>
    face_sizes(const FaultSurface<dim> &surface)
    {
      double sum = 0, least = std::numeric_limits<double>::max();
      for (const auto &face : surface.faces)
        {
          const double size =
            surface.points[face.front()].distance(surface.points[face.back()]);
          sum += size;
          least = std::min(least, size);
        }
      return {sum / surface.faces.size(), least};
    }



    template <int dim>
    std::vector<Point<dim - 1>>
    current_positions(const FaultSurface<dim>         &surface,
                      const std::vector<unsigned int> &nodes,
                      const NodalVector               &displacement)
    {
      std::vector<Point<dim - 1>> positions(nodes.size());
      for (unsigned int p = 0; p < nodes.size(); ++p)
        for (unsigned int d = 0; d < dim - 1; ++d)
          positions[p][d] = surface.points[p][d] +
                            displacement.local_element(nodes[p] * dim + d);
      return positions;
    }
  } // namespace



  template <int dim>
  FaultSides
  choose_fault_sides(const MeshLevel<dim> &level, const unsigned int lower)
  {
    constexpr auto top    = BodyMesh<dim>::upper_side;
    constexpr auto bottom = BodyMesh<dim>::lower_side;
    const double   size_below =
      face_sizes(level.bodies[lower]->surface(top)).first;
    const double size_above =
      face_sizes(level.bodies[lower + 1]->surface(bottom)).first;
    // Equal sizes differ by rounding.
    if (size_below < (1. - 1e-8) * size_above)
      return {lower, lower + 1, top, bottom};
    return {lower + 1, lower, bottom, top};
  }



  template <int dim>
  JumpBasis<dim>::JumpBasis(const MeshLevel<dim>          &level,
                            const std::vector<FaultSides> &sides,
                            const NodalVector             &displacement,
                            const NodeMask                &dirichlet)
  {
    const unsigned int               n_nodes = level.nodes.n_local();
    std::vector<TransferMatrix::Row> forward(n_nodes), inverse(n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      forward[i] = inverse[i] = {{i, 1.}};

    for (const FaultSides &side : sides)
      {
        FaultContact<dim> contact;
        contact.sides = side;
        contact.slave_surface =
          level.bodies[side.slave_body]->surface(side.slave_side);
        const FaultSurface<dim> master =
          level.bodies[side.master_body]->surface(side.master_side);
        for (const auto dof : contact.slave_surface.dofs)
          contact.slave_nodes.push_back(level.node(side.slave_body, dof));
        for (const auto dof : master.dofs)
          contact.master_nodes.push_back(level.node(side.master_body, dof));
        contact.smallest_face =
          std::min(face_sizes(contact.slave_surface).second,
                   face_sizes(master).second);

        std::vector<bool> excluded;
        for (const unsigned int p : contact.slave_nodes)
          excluded.push_back(!dirichlet.is_fully_active(p));
        contact.coupling = build_mortar_coupling<dim>(
          contact.slave_surface,
          current_positions(contact.slave_surface,
                            contact.slave_nodes,
                            displacement),
          master,
          current_positions(master, contact.master_nodes, displacement),
          excluded);

        const MortarCoupling &coupling = contact.coupling;
        for (unsigned int k = 0; k < contact.slave_nodes.size(); ++k)
          if (coupling.active[k])
            {
              const unsigned int p      = contact.slave_nodes[k];
              const double       factor = coupling.averaging_factor[k];
              forward[p]                = {{p, 1. / factor}};
              inverse[p]                = {{p, factor}};
              const auto add            = [&](const unsigned int node,
                                   const double       value) {
                forward[p].emplace_back(node, value);
                inverse[p].emplace_back(node, -factor * value);
              };
              for (const auto &entry : coupling.master_rows[k])
                add(contact.master_nodes[entry.first], entry.second);
              for (const auto &entry : coupling.inactive_slave_rows[k])
                add(contact.slave_nodes[entry.first], entry.second);
              active_nodes.push_back(p);
            }
        contacts.push_back(std::move(contact));
      }
    std::sort(active_nodes.begin(), active_nodes.end());
    B         = TransferMatrix(forward, n_nodes);
    B_inverse = TransferMatrix(inverse, n_nodes);
  }



  template <int dim>
  const std::vector<FaultContact<dim>> &
  JumpBasis<dim>::faults() const
  {
    return contacts;
  }



  template <int dim>
  const TransferMatrix &
  JumpBasis<dim>::to_nodal() const
  {
    return B;
  }



  template <int dim>
  const TransferMatrix &
  JumpBasis<dim>::to_jumps() const
  {
    return B_inverse;
  }



  template <int dim>
  const std::vector<unsigned int> &
  JumpBasis<dim>::contact_nodes() const
  {
    return active_nodes;
  }



  template <int dim>
  TransferMatrix
  jump_prolongation(const JumpBasis<dim> &coarse,
                    const JumpBasis<dim> &fine,
                    const TransferMatrix &nodal_prolongation)
  {
    return fine.to_jumps() * (nodal_prolongation * coarse.to_nodal());
  }



  void
  inject(NodalVector          &coarse,
         const NodalVector    &fine,
         const TransferMatrix &nodal_prolongation,
         const unsigned int    components)
  {
    const auto &P = nodal_prolongation.matrix();
    coarse        = 0.;
    for (unsigned int i = 0; i < nodal_prolongation.n_rows(); ++i)
      if (P.row_start[i + 1] == P.row_start[i] + 1 &&
          P.value[P.row_start[i]] == 1.)
        for (unsigned int c = 0; c < components; ++c)
          coarse.local_element(P.column[P.row_start[i]] * components + c) =
            fine.local_element(i * components + c);
  }



#define STICKSLIP_INSTANTIATE(dim)                                        \
  template struct FaultContact<dim>;                                      \
  template class JumpBasis<dim>;                                          \
  template FaultSides     choose_fault_sides<dim>(const MeshLevel<dim> &, \
                                              const unsigned int);    \
  template TransferMatrix jump_prolongation<dim>(const JumpBasis<dim> &,  \
                                                 const JumpBasis<dim> &,  \
                                                 const TransferMatrix &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
