// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>

#include <stickslip/output/atomic_file.h>
#include <stickslip/output/volume_writer.h>

#include <list>
#include <sstream>

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



    /** The strain of each cell's centre, in the order of the cells. */
    template <int dim>
    std::vector<SymmetricTensor<2, dim>>
    cell_strains(const DoFHandler<dim> &dofs,
                 const Vector<double>  &displacement)
    {
      const Point<dim> centre =
        dofs.get_fe().reference_cell().template barycenter<dim>();
      FEValues<dim>                        at_centre(dofs.get_fe(),
                              Quadrature<dim>(centre),
                              update_gradients);
      const FEValuesExtractors::Vector     components(0);
      std::vector<SymmetricTensor<2, dim>> strain(1);
      std::vector<SymmetricTensor<2, dim>> strains;
      for (const auto &cell : dofs.active_cell_iterators())
        {
          at_centre.reinit(cell);
          at_centre[components].get_function_symmetric_gradients(displacement,
                                                                 strain);
          strains.push_back(strain[0]);
        }
      return strains;
    }



    /** Hooke's law for each cell. */
    template <int dim>
    std::vector<SymmetricTensor<2, dim>>
    cell_stresses(const DoFHandler<dim>                      &dofs,
                  const std::vector<SymmetricTensor<2, dim>> &strains,
                  const VolumeMaterial<dim>                  &material)
    {
      std::vector<SymmetricTensor<2, dim>> stresses;
      for (const auto &cell : dofs.active_cell_iterators())
        {
          const SymmetricTensor<2, dim> &strain =
            strains[cell->active_cell_index()];
          const std::pair<double, double> lame =
            material.lame_parameters(cell->center());
          stresses.push_back(2. * lame.second * strain +
                             lame.first * trace(strain) *
                               unit_symmetric_tensor<dim>());
        }
      return stresses;
    }



    /** Collects the fields of one body. */
    template <int dim>
    class BodyFields
    {
    public:
      BodyFields(DataOut<dim>         &data_out,
                 const MeshLevel<dim> &level,
                 const unsigned int    body)
        : data_out(data_out)
        , level(level)
        , body(body)
        , dofs(level.bodies[body]->triangulation())
      {
        dofs.distribute_dofs(
          FESystem<dim>(level.bodies[body]->dof_handler().get_fe(), dim));
        data_out.attach_dof_handler(dofs);
      }

      /** @p nodal: the values of all nodes of all bodies. */
      Vector<double>
      of_body(const std::vector<double> &nodal) const
      {
        return values_of_body(level, body, dofs, nodal);
      }

      const DoFHandler<dim> &
      dof_handler() const
      {
        return dofs;
      }

      void
      add_vector(const std::string &name, const Vector<double> &values)
      {
        data_out.add_data_vector(
          values,
          std::vector<std::string>(dim, name),
          DataOut<dim>::type_dof_data,
          std::vector<DataComponentInterpretation::DataComponentInterpretation>(
            dim, DataComponentInterpretation::component_is_part_of_vector));
      }

      /** One number a cell. */
      void
      add_numbers(const std::string                                     &name,
                  const std::function<double(const unsigned int number,
                                             const Point<dim>  &centre)> &value)
      {
        Vector<double> values(dofs.get_triangulation().n_active_cells());
        for (const auto &cell : dofs.active_cell_iterators())
          values[cell->active_cell_index()] =
            value(cell->active_cell_index(), cell->center());
        cell_values.push_back(std::move(values));
        data_out.add_data_vector(cell_values.back(),
                                 name,
                                 DataOut<dim>::type_cell_data);
      }

      /** Entries c <= d, each as numbers by the name with the axes. */
      void
      add_tensors(const std::string                          &name,
                  const std::vector<SymmetricTensor<2, dim>> &tensors)
      {
        const std::string axes = "xyz";
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = c; d < dim; ++d)
            add_numbers(name + "_" + axes[c] + axes[d],
                        [&](const unsigned int number, const Point<dim> &) {
                          return tensors[number][c][d];
                        });
      }

      /** The patches stay; what they were made from goes with this object. */
      void
      finish()
      {
        data_out.build_patches();
        data_out.clear_input_data_references();
      }

    private:
      DataOut<dim>             &data_out;
      const MeshLevel<dim>     &level;
      const unsigned int        body;
      DoFHandler<dim>           dofs;
      std::list<Vector<double>> cell_values;
    };



    template <int dim>
    void
    build_patches(DataOut<dim>                   &data_out,
                  const MeshLevel<dim>           &level,
                  const unsigned int              number,
                  const VolumeNodalValues        &nodal,
                  const VolumeMaterial<dim>      &material,
                  const std::vector<VolumeField> &wanted)
    {
      BodyFields<dim> body(data_out, level, number);
      // Objects that must live until the patches are built.
      Vector<double> displacement, velocity, acceleration;
      if (!nodal.displacement.empty())
        displacement = body.of_body(nodal.displacement);
      if (has_field(wanted, VolumeField::displacement))
        body.add_vector("displacement", displacement);
      if (has_field(wanted, VolumeField::velocity))
        {
          velocity = body.of_body(nodal.velocity);
          body.add_vector("velocity", velocity);
        }
      if (has_field(wanted, VolumeField::acceleration))
        {
          acceleration = body.of_body(nodal.acceleration);
          body.add_vector("acceleration", acceleration);
        }

      const bool with_stress = has_field(wanted, VolumeField::stress),
                 with_strain = has_field(wanted, VolumeField::strain);
      if (with_stress || with_strain)
        {
          const std::vector<SymmetricTensor<2, dim>> strains =
            cell_strains(body.dof_handler(), displacement);
          if (with_stress)
            body.add_tensors(
              "stress", cell_stresses(body.dof_handler(), strains, material));
          if (with_strain)
            body.add_tensors("strain", strains);
        }
      if (has_field(wanted, VolumeField::body))
        body.add_numbers("body", [&](const unsigned int, const Point<dim> &) {
          return number;
        });
      if (has_field(wanted, VolumeField::material))
        for (const auto &[name, value] : material.fields)
          body.add_numbers(name,
                           [&value = value](const unsigned int,
                                            const Point<dim> &centre) {
                             return value(centre);
                           });
      body.finish();
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
               const std::vector<VolumeField>         &fields)
  {
    // The patches of the first body, to which those of the others are added.
    DataOut<dim> all;
    for (unsigned int body = 0; body < level.bodies.size(); ++body)
      {
        DataOut<dim> one;
        build_patches(
          body == 0 ? all : one, level, body, values, materials[body], fields);
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
    std::ostringstream content;
    all.write_vtu(content);
    write_file_atomically(directory + "/" + name, content.str());
    return name;
  }



  template decltype(write_volume<2>) write_volume<2>;
  template decltype(write_volume<3>) write_volume<3>;
} // namespace StickSlip
