// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/volume_writer.h>
#include <stickslip/output/vtu_file.h>

namespace StickSlip
{
  namespace
  {
    /** The places of a deal.II cell's vertices in the order of VTK. */
    template <int dim>
    std::vector<unsigned int>
    vtk_order(const ReferenceCell &shape)
    {
      if (!shape.is_hyper_cube())
        {
          std::vector<unsigned int> order(shape.n_vertices());
          for (unsigned int v = 0; v < order.size(); ++v)
            order[v] = v;
          return order;
        }
      return dim == 2 ? std::vector<unsigned int>{0, 1, 3, 2} :
                        std::vector<unsigned int>{0, 1, 3, 2, 4, 5, 7, 6};
    }



    /** All bodies as one grid: the nodes of each, hanging ones included, in the
     * order of its mesh, and its cells. */
    template <int dim>
    struct VolumeGrid
    {
      const MeshLevel<dim> &level;
      VtuGrid               grid;

      /** The first point of each body, and the number of all. */
      std::vector<std::size_t> first_point = {0};

      explicit VolumeGrid(const MeshLevel<dim> &level)
        : level(level)
      {
        for (const auto &body : level.bodies)
          {
            const DoFHandler<dim>          &dofs = body->dof_handler();
            std::vector<Point<dim>>         points(dofs.n_dofs());
            const std::vector<unsigned int> order =
              vtk_order<dim>(dofs.get_fe().reference_cell());
            for (const auto &cell : dofs.active_cell_iterators())
              {
                std::vector<std::int64_t> vertices;
                for (const unsigned int v : order)
                  {
                    const auto dof = cell->vertex_dof_index(v, 0);
                    points[dof]    = cell->vertex(v);
                    vertices.push_back(first_point.back() + dof);
                  }
                grid.add_cell(dim, vertices);
              }
            for (const Point<dim> &point : points)
              grid.add_point(point);
            first_point.push_back(grid.n_points());
          }
      }

      /** Vectors with three components at all points, from values of nodes;
       * one component a node is that out of the plane. */
      std::vector<double>
      at_points(const std::vector<double> &nodal) const
      {
        const unsigned int  n_components = level.nodes.n_components();
        const unsigned int  first        = (n_components == 1 ? 2 : 0);
        std::vector<double> values(3 * grid.n_points());
        for (unsigned int body = 0; body < level.bodies.size(); ++body)
          for (std::size_t point = first_point[body];
               point < first_point[body + 1];
               ++point)
            for (const auto &[node, factor] :
                 level.resolve(body, point - first_point[body]))
              for (unsigned int c = 0; c < n_components; ++c)
                values[3 * point + first + c] +=
                  factor * nodal[std::size_t(node) * n_components + c];
        return values;
      }

      /** Call @p action with the number of each body and its cells, in the
       * order of the grid. */
      template <typename Action>
      void
      for_each_cell(const Action &action) const
      {
        for (unsigned int body = 0; body < level.bodies.size(); ++body)
          for (const auto &cell :
               level.bodies[body]->dof_handler().active_cell_iterators())
            action(body, cell);
      }
    };



    /** The strain of each cell's centre. @p displacement: of the points. */
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    cell_strains(const VolumeGrid<dim>     &points,
                 const std::vector<double> &displacement)
    {
      std::vector<SymmetricTensor<2, 3>>   strains;
      std::unique_ptr<FEValues<dim>>       at_centre;
      std::vector<types::global_dof_index> dofs;
      unsigned int                         last = numbers::invalid_unsigned_int;
      points.for_each_cell([&](const unsigned int body, const auto &cell) {
        if (body != last)
          {
            const auto &fe = cell->get_fe();
            at_centre      = std::make_unique<FEValues<dim>>(
              fe,
              Quadrature<dim>(fe.reference_cell().template barycenter<dim>()),
              update_gradients);
            dofs.resize(fe.n_dofs_per_cell());
            last = body;
          }
        at_centre->reinit(cell);
        cell->get_dof_indices(dofs);
        Tensor<2, 3> gradient;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          for (unsigned int c = 0; c < 3; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              gradient[c][d] +=
                displacement[3 * (points.first_point[body] + dofs[i]) + c] *
                at_centre->shape_grad(i, 0)[d];
        strains.push_back(symmetrize(gradient));
      });
      return strains;
    }



    /** Entries of tensors of the cells, each as numbers by the name with the
     * axes: those that need not be zero. */
    template <int dim>
    void
    add_tensors(VtuFile                                  &file,
                const std::string                        &name,
                const std::vector<SymmetricTensor<2, 3>> &tensors,
                const std::string                        &units,
                const bool                                out_of_plane)
    {
      const std::string axes = "xyz";
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int d = c; d < 3; ++d)
          {
            const bool in_axes = d < dim;
            if (out_of_plane ? (in_axes || c == d) :
                               !(in_axes || (c == d && name == "stress")))
              continue;
            std::vector<double> values;
            values.reserve(tensors.size());
            for (const SymmetricTensor<2, 3> &tensor : tensors)
              values.push_back(tensor[c][d]);
            file.add_cell_data(name + "_" + axes[c] + axes[d],
                               1,
                               values,
                               units);
          }
    }



    /** Hooke's law for each cell. */
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    cell_stresses(const VolumeGrid<dim>                    &points,
                  const std::vector<SymmetricTensor<2, 3>> &strains,
                  const std::vector<VolumeMaterial<dim>>   &materials)
    {
      std::vector<SymmetricTensor<2, 3>> stresses;
      points.for_each_cell([&](const unsigned int body, const auto &cell) {
        const SymmetricTensor<2, 3>    &strain = strains[stresses.size()];
        const std::pair<double, double> lame =
          materials[body].lame_parameters(cell->center());
        stresses.push_back(2. * lame.second * strain +
                           lame.first * trace(strain) *
                             unit_symmetric_tensor<3>());
      });
      return stresses;
    }



    template <int dim>
    std::string
    text_of_volume(const double                            time,
                   const MeshLevel<dim>                   &level,
                   const VolumeNodalValues                &nodal,
                   const std::vector<VolumeMaterial<dim>> &materials,
                   const std::vector<std::string>         &body_names,
                   const std::vector<VolumeField>         &wanted)
    {
      const VolumeGrid<dim> points(level);
      VtuFile               file(points.grid, time, VtuFile::Precision::simple);
      file.add_names("body_names", body_names);

      std::vector<double> displacement;
      if (!nodal.displacement.empty())
        displacement = points.at_points(nodal.displacement);
      if (has_field(wanted, VolumeField::displacement))
        file.add_point_data("displacement", 3, displacement, "m");
      if (has_field(wanted, VolumeField::velocity))
        file.add_point_data("velocity",
                            3,
                            points.at_points(nodal.velocity),
                            "m/s");
      if (has_field(wanted, VolumeField::acceleration))
        file.add_point_data("acceleration",
                            3,
                            points.at_points(nodal.acceleration),
                            "m/s^2");

      const bool with_stress = has_field(wanted, VolumeField::stress),
                 with_strain = has_field(wanted, VolumeField::strain);
      if (with_stress || with_strain)
        {
          const bool out_of_plane = level.nodes.n_components() == 1;
          const std::vector<SymmetricTensor<2, 3>> strains =
            cell_strains(points, displacement);
          if (with_stress)
            add_tensors<dim>(file,
                             "stress",
                             cell_stresses(points, strains, materials),
                             "Pa",
                             out_of_plane);
          if (with_strain)
            add_tensors<dim>(file, "strain", strains, "1", out_of_plane);
        }
      const auto add_numbers = [&](const std::string &name,
                                   const std::string &units,
                                   const auto        &value) {
        std::vector<double> values;
        points.for_each_cell([&](const unsigned int body, const auto &cell) {
          values.push_back(value(body, cell->center()));
        });
        file.add_cell_data(name, 1, values, units);
      };
      if (has_field(wanted, VolumeField::body))
        add_numbers("body",
                    "",
                    [](const unsigned int body, const Point<dim> &) {
                      return body;
                    });
      if (has_field(wanted, VolumeField::material))
        for (unsigned int i = 0; i < materials[0].fields.size(); ++i)
          add_numbers(materials[0].fields[i].name,
                      materials[0].fields[i].units,
                      [&](const unsigned int body, const Point<dim> &centre) {
                        return materials[body].fields[i].value(centre);
                      });
      return file.text();
    }
  } // namespace



  template <int dim>
  std::string
  write_volume(const std::string                      &directory,
               const unsigned int                      number,
               const double                            time,
               const MeshLevel<dim>                   &level,
               const VolumeNodalValues                &values,
               const std::vector<VolumeMaterial<dim>> &materials,
               const std::vector<std::string>         &body_names,
               const std::vector<VolumeField>         &fields)
  {
    const std::string name =
      "solution_" + Utilities::int_to_string(number, 5) + ".vtu";
    write_file_atomically(
      directory + "/" + name,
      text_of_volume(time, level, values, materials, body_names, fields));
    return name;
  }



  template decltype(write_volume<2>) write_volume<2>;
  template decltype(write_volume<3>) write_volume<3>;
} // namespace StickSlip
