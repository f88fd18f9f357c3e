// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <stickslip/output/volume_writer.h>

#include <fstream>

namespace StickSlip
{
  namespace
  {
    /** The part of all nodal values that belongs to one body, hanging nodes
     * included, in the numbers of a vector-valued DoFHandler. */
    template <int dim>
    Vector<double>
    values_of_body(const MeshLevel<dim>      &level,
                   const unsigned int         body,
                   const DoFHandler<dim>     &vector_dofs,
                   const std::vector<double> &nodal)
    {
      const DoFHandler<dim> &scalar_dofs = level.bodies[body]->dof_handler();

      Vector<double>                       values(vector_dofs.n_dofs());
      std::vector<types::global_dof_index> scalar(
        scalar_dofs.get_fe().n_dofs_per_cell());
      std::vector<types::global_dof_index> vector(
        vector_dofs.get_fe().n_dofs_per_cell());
      auto scalar_cell = scalar_dofs.begin_active();
      for (const auto &cell : vector_dofs.active_cell_iterators())
        {
          scalar_cell->get_dof_indices(scalar);
          cell->get_dof_indices(vector);
          for (unsigned int i = 0; i < vector.size(); ++i)
            {
              const auto component =
                vector_dofs.get_fe().system_to_component_index(i);
              double value = 0;
              for (const auto &node :
                   level.resolve(body, scalar[component.second]))
                value += node.second *
                         nodal[std::size_t(node.first) * dim + component.first];
              values[vector[i]] = value;
            }
          ++scalar_cell;
        }
      return values;
    }



    /** One vector for each entry sigma_cd, c <= d, cell by cell. */
    template <int dim>
    std::vector<Vector<double>>
    cell_stresses(const DoFHandler<dim>     &dofs,
                  const Vector<double>      &displacement,
                  const VolumeMaterial<dim> &material)
    {
      std::vector<Vector<double>> stresses(
        dim * (dim + 1) / 2,
        Vector<double>(dofs.get_triangulation().n_active_cells()));
      Point<dim> centre;
      for (unsigned int d = 0; d < dim; ++d)
        centre[d] = 0.5;
      FEValues<dim>                        at_centre(dofs.get_fe(),
                              Quadrature<dim>(centre),
                              update_gradients);
      const FEValuesExtractors::Vector     components(0);
      std::vector<SymmetricTensor<2, dim>> strain(1);
      for (const auto &cell : dofs.active_cell_iterators())
        {
          at_centre.reinit(cell);
          at_centre[components].get_function_symmetric_gradients(displacement,
                                                                 strain);
          const std::pair<double, double> lame =
            material.lame_parameters(cell->center());
          const SymmetricTensor<2, dim> stress =
            2. * lame.second * strain[0] +
            lame.first * trace(strain[0]) * unit_symmetric_tensor<dim>();
          unsigned int entry = 0;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = c; d < dim; ++d)
              stresses[entry++][cell->active_cell_index()] = stress[c][d];
        }
      return stresses;
    }



    template <int dim>
    void
    build_patches(DataOut<dim>              &data_out,
                  const MeshLevel<dim>      &level,
                  const unsigned int         body,
                  const std::vector<double> &displacement,
                  const std::vector<double> &velocity,
                  const VolumeMaterial<dim> &material)
    {
      DoFHandler<dim> dofs(level.bodies[body]->triangulation());
      dofs.distribute_dofs(FESystem<dim>(FE_Q<dim>(1), dim));
      const Vector<double> u = values_of_body(level, body, dofs, displacement);
      const Vector<double> v = values_of_body(level, body, dofs, velocity);
      const std::vector<Vector<double>> stresses =
        cell_stresses(dofs, u, material);
      Vector<double> number_of_body(dofs.get_triangulation().n_active_cells());
      number_of_body = body;
      std::vector<Vector<double>> fields;
      for (const auto &field : material.fields)
        {
          fields.emplace_back(number_of_body.size());
          for (const auto &cell : dofs.active_cell_iterators())
            fields.back()[cell->active_cell_index()] =
              field.second(cell->center());
        }

      data_out.attach_dof_handler(dofs);
      const auto add_vector = [&](const Vector<double> &values,
                                  const std::string    &name) {
        data_out.add_data_vector(
          values,
          std::vector<std::string>(dim, name),
          DataOut<dim>::type_dof_data,
          std::vector<DataComponentInterpretation::DataComponentInterpretation>(
            dim, DataComponentInterpretation::component_is_part_of_vector));
      };
      add_vector(u, "displacement");
      add_vector(v, "velocity");
      const std::string axes  = "xyz";
      unsigned int      entry = 0;
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = c; d < dim; ++d)
          data_out.add_data_vector(stresses[entry++],
                                   std::string("stress_") + axes[c] + axes[d],
                                   DataOut<dim>::type_cell_data);
      data_out.add_data_vector(number_of_body,
                               "body",
                               DataOut<dim>::type_cell_data);
      for (unsigned int f = 0; f < fields.size(); ++f)
        data_out.add_data_vector(fields[f],
                                 material.fields[f].first,
                                 DataOut<dim>::type_cell_data);
      data_out.build_patches();
      // The patches stay; what they were made from goes with this function.
      data_out.clear_input_data_references();
    }
  } // namespace



  template <int dim>
  std::string
  write_volume(const std::string                      &directory,
               const unsigned int                      number,
               const double                            time,
               const MeshLevel<dim>                   &level,
               const std::vector<double>              &displacement,
               const std::vector<double>              &velocity,
               const std::vector<VolumeMaterial<dim>> &materials)
  {
    // The patches of the first body, to which those of the others are added.
    DataOut<dim> all;
    for (unsigned int body = 0; body < level.bodies.size(); ++body)
      {
        DataOut<dim> one;
        build_patches(body == 0 ? all : one,
                      level,
                      body,
                      displacement,
                      velocity,
                      materials[body]);
        if (body > 0)
          all.merge_patches(one);
      }
    DataOutBase::VtkFlags flags;
    flags.time = time;
    // A tenth larger than by the best compression, in a small part of its time.
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    all.set_flags(flags);

    const std::string name =
      "solution_" + Utilities::int_to_string(number, 5) + ".vtu";
    std::ofstream file(directory + "/" + name);
    // The library has much to say on a stream it cannot use.
    if (file)
      all.write_vtu(file);
    AssertThrow(file.good(),
                ExcMessage("The file '" + directory + "/" + name +
                           "' could not be written."));
    return name;
  }



  template std::string
  write_volume<2>(const std::string &,
                  const unsigned int,
                  const double,
                  const MeshLevel<2> &,
                  const std::vector<double> &,
                  const std::vector<double> &,
                  const std::vector<VolumeMaterial<2>> &);
  template std::string
  write_volume<3>(const std::string &,
                  const unsigned int,
                  const double,
                  const MeshLevel<3> &,
                  const std::vector<double> &,
                  const std::vector<double> &,
                  const std::vector<VolumeMaterial<3>> &);
} // namespace StickSlip
