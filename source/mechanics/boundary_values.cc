// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <stickslip/base/input_error.h>
#include <stickslip/mechanics/boundary_values.h>
#include <stickslip/mechanics/side_axes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    bool
    has_traction(const BoundaryCondition<dim> &condition)
    {
      return std::find(condition.type.begin(),
                       condition.type.end(),
                       BoundaryType::traction) != condition.type.end();
    }



    bool
    is_prescribed(const BoundaryType type)
    {
      return type == BoundaryType::fixed || type == BoundaryType::velocity;
    }



    /** Add a force along the axis @p c, N, to the load of a node. */
    template <int n_components>
    void
    add_along(const Tensor<2, n_components> &axes,
              const unsigned int             c,
              const double                   force,
              const unsigned int             node,
              NodalVector                   &load)
    {
      for (unsigned int d = 0; d < n_components; ++d)
        if (axes[d][c] != 0.)
          load.local_element(node * n_components + d) += axes[d][c] * force;
    }
  } // namespace



  template <int dim, int n_components>
  BoundaryValues<dim, n_components>::BoundaryValues(
    const MeshHierarchy<dim>                  &meshes,
    const std::vector<BoundaryCondition<dim>> &conditions,
    const std::vector<std::string>            &body_names)
    : meshes(meshes)
  {
    const MeshLevel<dim> &finest = meshes.finest();
    for (const BoundaryCondition<dim> &condition : conditions)
      {
        Side side;
        side.body =
          std::find(body_names.begin(), body_names.end(), condition.body) -
          body_names.begin();
        AssertIndexRange(side.body, body_names.size());
        side.condition = condition;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            side.varies[c] = condition.varies_in_time(c);
            side.values.emplace_back(condition.expression[c], true);
          }
        const BodyMesh<dim> &body = *finest.bodies[side.body];
        for (unsigned int c = 0; c < n_components; ++c)
          side.axes[c][c] = 1.;
        if (condition.axes == BoundaryAxes::side)
          {
            const FaultSurface<dim> surface = body.surface(condition.side);
            try
              {
                find_axes(surface, body.is_rigid(), side);
              }
            catch (const InputError &error)
              {
                throw InputError("'Boundary conditions/" + condition.body +
                                 " " + condition.side_name +
                                 "/Axes' = 'side': " + error.what());
              }
          }
        const auto add_node = [&](const types::global_dof_index dof,
                                  const Point<dim>             &point) {
          const auto node = finest.global_node(side.body, dof);
          if (!finest.nodes.owned().is_element(node))
            return;
          side.points.push_back(point);
          side.nodes.push_back(finest.nodes.local_index(node));
        };
        if (body.is_rigid())
          {
            // All of it moves with the side.
            const std::vector<Point<dim>> points = body.node_positions();
            for (types::global_dof_index dof = 0; dof < points.size(); ++dof)
              if (!body.bound_nodes().is_constrained(dof))
                add_node(dof, points[dof]);
          }
        else
          {
            const FaultSurface<dim> surface = body.surface(condition.side);
            for (unsigned int k = 0; k < surface.nodes.size(); ++k)
              add_node(surface.nodes[k], surface.points[k]);
          }
        sides.push_back(std::move(side));
      }
    for (auto &[node, turned] : find_turned_nodes(meshes.n_levels() - 1))
      if (finest.nodes.owned().is_element(node))
        turned_nodes.emplace(finest.nodes.local_index(node), turned);
  }



  template <int dim, int n_components>
  void
  BoundaryValues<dim, n_components>::find_axes(const FaultSurface<dim> &surface,
                                               const bool is_rigid,
                                               Side      &side)
  {
    std::vector<Tensor<1, dim>> normals = {surface.normal};
    if (!is_plane(surface))
      {
        if (is_rigid)
          throw InputError("the side is curved and its body rigid, which moves "
                           "as a whole; give the velocity along the axes of "
                           "space.");
        side.normals = SideNormals<dim>(surface);
        normals      = side.normals.all();
      }
    side.reference = reference_of_side(normals);
    if (dim == 3 && side.reference == numbers::invalid_unsigned_int)
      {
        // Any two tangents do where both are held or both are free.
        const auto &type = side.condition.type;
        if (type[0] != type[1] ||
            (type[0] != BoundaryType::free && type[0] != BoundaryType::fixed))
          throw InputError("the side comes within 15 degrees of being normal "
                           "to each axis of space, so that its tangential "
                           "directions are not the same everywhere; it must be "
                           "divided, or both of them 'free' or 'fixed'.");
      }
    if constexpr (n_components == dim)
      side.axes = axes_of_side(surface.normal, side.reference);
  }



  template <int dim, int n_components>
  Tensor<2, n_components>
  BoundaryValues<dim, n_components>::Side::axes_at(
    const Point<dim> &point) const
  {
    return normals.empty() ? axes : axes_with(normals.at(point));
  }



  template <int dim, int n_components>
  Tensor<2, n_components>
  BoundaryValues<dim, n_components>::Side::axes_with(
    [[maybe_unused]] const Tensor<1, dim> &normal) const
  {
    if constexpr (n_components == dim)
      return axes_of_side(normal, reference);
    return axes;
  }



  template <int dim, int n_components>
  std::map<types::global_dof_index,
           typename BoundaryValues<dim, n_components>::TurnedNode>
  BoundaryValues<dim, n_components>::find_turned_nodes(
    const unsigned int l) const
  {
    const MeshLevel<dim>                         &level = meshes.level(l);
    std::map<types::global_dof_index, TurnedNode> nodes;
    const auto for_each_node = [&](const Side &side, const auto &action) {
      const BodyMesh<dim> &body = *level.bodies[side.body];
      if (!body.is_rigid())
        {
          const FaultSurface<dim> surface = body.surface(side.condition.side);
          for (unsigned int k = 0; k < surface.nodes.size(); ++k)
            action(level.global_node(side.body, surface.nodes[k]),
                   surface.points[k]);
          return;
        }
      // All of it moves with the side.
      const std::vector<Point<dim>> points = body.node_positions();
      for (types::global_dof_index dof = 0; dof < points.size(); ++dof)
        if (!body.bound_nodes().is_constrained(dof))
          action(level.global_node(side.body, dof), points[dof]);
    };
    for (const Side &side : sides)
      if (side.condition.axes == BoundaryAxes::side &&
          std::any_of(side.condition.type.begin(),
                      side.condition.type.end(),
                      is_prescribed))
        for_each_node(side,
                      [&](const types::global_dof_index node,
                          const Point<dim>             &point) {
                        nodes[node].point = point;
                      });
    if (nodes.empty())
      return nodes;
    // Of two values for one direction the one that is given last counts.
    for (unsigned int i = sides.size(); i-- > 0;)
      for_each_node(sides[i],
                    [&](const types::global_dof_index node,
                        const Point<dim>             &point) {
                      const auto turned = nodes.find(node);
                      if (turned == nodes.end())
                        return;
                      const Tensor<2, n_components> axes =
                        sides[i].axes_at(point);
                      for (unsigned int c = 0; c < n_components; ++c)
                        {
                          Tensor<1, n_components> direction;
                          for (unsigned int d = 0; d < n_components; ++d)
                            direction[d] = axes[d][c];
                          if (is_prescribed(sides[i].condition.type[c]) &&
                              turned->second.constraint.add(direction))
                            turned->second.values.emplace_back(i, c);
                        }
                    });
    return nodes;
  }



  template <int dim, int n_components>
  NodeFrames<n_components>
  BoundaryValues<dim, n_components>::frames(const unsigned int l) const
  {
    NodeFrames<n_components> frames;
    for (const auto &[node, turned] : find_turned_nodes(l))
      // Any axes do where all components are prescribed.
      if (turned.constraint.size() < n_components)
        frames.set(node, turned.constraint.axes());
    return frames;
  }



  template <int dim, int n_components>
  NodeMask
  BoundaryValues<dim, n_components>::dirichlet_mask(const unsigned int l) const
  {
    const MeshLevel<dim> &level = meshes.level(l);
    NodeMask              mask(level.nodes.n_owned(), n_components);
    const auto            mask_owned = [&](const types::global_dof_index node,
                                const unsigned int            c) {
      if (!level.nodes.owned().is_element(node))
        return;
      if (const unsigned int i = level.nodes.local_index(node);
          mask.is_active(i, c))
        mask.mask(i, c);
    };
    for (unsigned int b = 0; b < level.bodies.size(); ++b)
      if (level.bodies[b]->is_rigid())
        for (types::global_dof_index dof = 0;
             dof < level.bodies[b]->dof_handler().n_dofs();
             ++dof)
          for (unsigned int c = 0; c < n_components; ++c)
            mask_owned(level.global_node(b, dof), c);
    const auto turned_nodes = find_turned_nodes(l);
    for (const auto &[node, turned] : turned_nodes)
      for (unsigned int k = 0; k < turned.constraint.size(); ++k)
        mask_owned(node, n_components - 1 - k);
    for (const Side &side : sides)
      for (const auto dof :
           level.bodies[side.body]->dofs_on_side(side.condition.side))
        for (unsigned int c = 0; c < n_components; ++c)
          if (is_prescribed(side.condition.type[c]))
            if (const auto node = level.global_node(side.body, dof);
                turned_nodes.count(node) == 0)
              mask_owned(node, c);
    return mask;
  }



  template <int dim, int n_components>
  void
  BoundaryValues<dim, n_components>::set_velocities(const double time,
                                                    NodalVector &velocity)
  {
    for (Side &side : sides)
      for (unsigned int c = 0;
           c < n_components && side.condition.axes == BoundaryAxes::space;
           ++c)
        {
          if (side.condition.type[c] == BoundaryType::velocity)
            {
              const double ramp = smooth_ramp(time, side.condition.ramp_length);
              for (unsigned int k = 0; k < side.nodes.size(); ++k)
                velocity.local_element(side.nodes[k] * n_components + c) =
                  ramp * side.values[c].value(side.points[k], time);
            }
          else if (side.condition.type[c] == BoundaryType::fixed)
            for (const unsigned int node : side.nodes)
              velocity.local_element(node * n_components + c) = 0.;
        }
    for (const auto &[node, turned] : turned_nodes)
      {
        std::array<double, n_components> values{};
        for (unsigned int k = 0; k < turned.values.size(); ++k)
          {
            const auto [i, c] = turned.values[k];
            Side &side        = sides[i];
            if (side.condition.type[c] == BoundaryType::velocity)
              values[k] = smooth_ramp(time, side.condition.ramp_length) *
                          side.values[c].value(turned.point, time);
          }
        Tensor<1, n_components> u;
        for (unsigned int d = 0; d < n_components; ++d)
          u[d] = velocity.local_element(node * n_components + d);
        u = turned.constraint.impose(u, values);
        for (unsigned int d = 0; d < n_components; ++d)
          velocity.local_element(node * n_components + d) = u[d];
      }
  }



  template <int dim, int n_components>
  bool
  BoundaryValues<dim, n_components>::has_tractions() const
  {
    return std::any_of(sides.begin(), sides.end(), [](const Side &side) {
      return has_traction(side.condition);
    });
  }



  template <int dim, int n_components>
  void
  BoundaryValues<dim, n_components>::add_tractions(const double time,
                                                   NodalVector &load)
  {
    const MeshLevel<dim> &level = meshes.finest();
    const IndexSet       &owned = level.nodes.owned();
    for (Side &side : sides)
      {
        if (!has_traction(side.condition))
          continue;
        const DoFHandler<dim> &dofs = level.bodies[side.body]->dof_handler();
        const double ramp = smooth_ramp(time, side.condition.ramp_length);
        // Faces of a body are of one shape.
        const ReferenceCell face_shape =
          dofs.get_fe().reference_cell().face_reference_cell(0);
        FEFaceValues<dim> fe_values(
          dofs.get_fe(),
          face_shape.template get_gauss_type_quadrature<dim - 1>(3),
          update_values | update_quadrature_points | update_JxW_values |
            (side.normals.empty() ? update_default : update_normal_vectors));
        std::vector<types::global_dof_index> cell_dofs(fe_values.dofs_per_cell);
        for (const auto &cell : dofs.active_cell_iterators())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == side.condition.side)
              {
                fe_values.reinit(cell, f);
                cell->get_dof_indices(cell_dofs);
                for (unsigned int c = 0; c < n_components; ++c)
                  if (side.condition.type[c] == BoundaryType::traction)
                    {
                      for (const unsigned int q :
                           fe_values.quadrature_point_indices())
                        {
                          const Tensor<2, n_components> axes =
                            side.normals.empty() ?
                              side.axes :
                              side.axes_with(
                                Tensor<1, dim>(fe_values.normal_vector(q)));
                          const double traction =
                            ramp * fe_values.JxW(q) *
                            side.values[c].value(fe_values.quadrature_point(q),
                                                 time);
                          for (unsigned int i = 0; i < cell_dofs.size(); ++i)
                            {
                              // A hanging node hands its load to its masters.
                              const double value =
                                traction * fe_values.shape_value(i, q);
                              for (const auto &master :
                                   level.resolve(side.body, cell_dofs[i]))
                                if (owned.is_element(master.first))
                                  add_along(axes,
                                            c,
                                            master.second * value,
                                            level.nodes.local_index(
                                              master.first),
                                            load);
                            }
                        }
                    }
              }
      }
  }



  template <int dim, int n_components>
  double
  BoundaryValues<dim, n_components>::longest_ramp() const
  {
    double longest = 0;
    for (const Side &side : sides)
      for (const BoundaryType type : side.condition.type)
        if (type == BoundaryType::velocity || type == BoundaryType::traction)
          longest = std::max(longest, side.condition.ramp_length);
    return longest;
  }



  template <int dim, int n_components>
  bool
  BoundaryValues<dim, n_components>::velocities_become_constant() const
  {
    for (const Side &side : sides)
      for (unsigned int c = 0; c < n_components; ++c)
        if (side.varies[c] && side.condition.type[c] == BoundaryType::velocity)
          return false;
    return true;
  }



  template <int dim, int n_components>
  double
  BoundaryValues<dim, n_components>::loading_error(const double       time,
                                                   const double       tau,
                                                   LargestLoads<dim> &largest)
  {
    // Zero on sides that have not been met yet.
    largest.resize(sides.size());
    double error = 0;
    for (unsigned int i = 0; i < sides.size(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          Side &side = sides[i];
          if (!side.varies[c])
            continue;
          std::vector<double> second_difference(side.points.size());
          for (const double part : {0., 0.5, 1.})
            {
              const double t    = time + part * tau;
              const double ramp = smooth_ramp(t, side.condition.ramp_length) *
                                  (part == 0.5 ? -2. : 1.);
              for (unsigned int k = 0; k < side.points.size(); ++k)
                {
                  const double value =
                    ramp * side.values[c].value(side.points[k], t);
                  second_difference[k] += value;
                  largest[i][c] =
                    std::max(largest[i][c],
                             std::abs(part == 0.5 ? value / 2. : value));
                }
            }
          double deviation = 0;
          for (const double difference : second_difference)
            deviation = std::max(deviation, std::abs(difference));
          const MPI_Comm communicator = meshes.finest().nodes.communicator();
          deviation     = Utilities::MPI::max(deviation, communicator);
          largest[i][c] = Utilities::MPI::max(largest[i][c], communicator);
          error =
            std::max(error,
                     deviation /
                       (3. * std::max(largest[i][c],
                                      std::numeric_limits<double>::min())));
        }
    return error;
  }



  template class BoundaryValues<2>;
  template class BoundaryValues<3>;
  template class BoundaryValues<2, 1>;
} // namespace StickSlip
