// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/quadrature.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include <stickslip/algebra/serial_order.h>
#include <stickslip/output/volume_writer.h>

#include <algorithm>

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



    /**
     * The cells of all bodies that this process shows: those of whose nodes it
     * owns the one with the least number, so that each cell has one process;
     * and their points, hanging ones included.
     */
    template <int dim>
    class OwnVolume
    {
    public:
      explicit OwnVolume(const MeshLevel<dim> &level)
        : level(level)
      {
        for (unsigned int body = 0; body < level.bodies.size(); ++body)
          {
            const DoFHandler<dim> &dofs = level.bodies[body]->dof_handler();
            index_of_dof.emplace_back(dofs.n_dofs(),
                                      numbers::invalid_unsigned_int);
            own_cells.emplace_back();
            for (const auto &cell : dofs.active_cell_iterators())
              own_cells.back().push_back(is_own(body, cell));
          }
        for_each_cell([&](const unsigned int body, const auto &cell) {
          cells.push_back(level.serial_cell(body, cell->active_cell_index()));
          for (const auto v : cell->vertex_indices())
            {
              const auto    dof   = cell->vertex_dof_index(v, 0);
              unsigned int &index = index_of_dof[body][dof];
              if (index != numbers::invalid_unsigned_int)
                continue;
              index = points.size();
              points.push_back(level.serial_node(body, dof));
              for (unsigned int d = 0; d < 3; ++d)
                positions.push_back(d < dim ? cell->vertex(v)[d] : 0.);
              rows.push_back(level.resolve(body, dof));
            }
        });
      }

      /** Call @p action with the number of each body and its cells. */
      template <typename Action>
      void
      for_each_cell(const Action &action) const
      {
        for (unsigned int body = 0; body < level.bodies.size(); ++body)
          for (const auto &cell :
               level.bodies[body]->dof_handler().active_cell_iterators())
            if (own_cells[body][cell->active_cell_index()])
              action(body, cell);
      }

      /** The place of a degree of freedom among the points. */
      unsigned int
      point(const unsigned int body, const types::global_dof_index dof) const
      {
        return index_of_dof[body][dof];
      }

      /** Vectors with three components at the points, from values of nodes;
       * one component a node is that out of the plane. */
      std::vector<double>
      at_points(const NodalVector &nodal) const
      {
        update_ghosts(nodal);
        const unsigned int  n_components = level.nodes.n_components();
        const unsigned int  first        = (n_components == 1 ? 2 : 0);
        std::vector<double> values(3 * points.size());
        for (std::size_t i = 0; i < rows.size(); ++i)
          for (const auto &[node, factor] : rows[i])
            for (unsigned int c = 0; c < n_components; ++c)
              values[3 * i + first + c] +=
                factor * nodal.local_element(
                           level.nodes.local_index(node) * n_components + c);
        return values;
      }

      /** See VolumeContent::corners. */
      std::vector<std::int64_t>
      connectivity() const
      {
        std::vector<std::int64_t> result;
        for_each_cell([&](const unsigned int body, const auto &cell) {
          const std::vector<unsigned int> order =
            vtk_order<dim>(cell->reference_cell());
          for (const unsigned int v : order)
            result.push_back(point(body, cell->vertex_dof_index(v, 0)));
          result.resize(result.size() + vertices_per_cell - order.size(), -1);
        });
        return result;
      }

      static constexpr unsigned int vertices_per_cell =
        GeometryInfo<dim>::vertices_per_cell;

      const MeshLevel<dim> &level;

      /** Serial numbers, and positions of the points, three numbers each,
       * m. */
      std::vector<types::global_dof_index> cells, points;
      std::vector<double>                  positions;

    private:
      bool
      is_own(const unsigned int                                    body,
             const typename DoFHandler<dim>::active_cell_iterator &cell) const
      {
        types::global_dof_index least = numbers::invalid_dof_index;
        for (const auto v : cell->vertex_indices())
          for (const auto &master :
               level.resolve(body, cell->vertex_dof_index(v, 0)))
            least = std::min(least, master.first);
        return level.nodes.owned().is_element(least);
      }

      /** By the numbers of active cells of each body. */
      std::vector<std::vector<bool>>         own_cells;
      std::vector<std::vector<unsigned int>> index_of_dof;
      std::vector<GlobalRow>                 rows;
    };



    /** The strain of each cell's centre. @p displacement: of the points. */
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    cell_strains(const OwnVolume<dim>      &own,
                 const std::vector<double> &displacement)
    {
      std::vector<SymmetricTensor<2, 3>>   strains;
      std::unique_ptr<FEValues<dim>>       at_centre;
      std::vector<types::global_dof_index> dofs;
      unsigned int                         last = numbers::invalid_unsigned_int;
      own.for_each_cell([&](const unsigned int body, const auto &cell) {
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
              gradient[c][d] += displacement[3 * own.point(body, dofs[i]) + c] *
                                at_centre->shape_grad(i, 0)[d];
        strains.push_back(symmetrize(gradient));
      });
      return strains;
    }



    /** Hooke's law for each cell, with the volumetric strain of its patch where
     * that is what the body resists. */
    template <int dim>
    std::vector<SymmetricTensor<2, 3>>
    cell_stresses(const OwnVolume<dim>                     &own,
                  const std::vector<SymmetricTensor<2, 3>> &strains,
                  const NodalVector                        &displacement,
                  const std::vector<VolumeMaterial<dim>>   &materials)
    {
      std::vector<std::vector<double>> of_patches(materials.size());
      for (unsigned int body = 0; body < materials.size(); ++body)
        if (materials[body].dilatations)
          of_patches[body] = materials[body].dilatations(displacement);
      std::vector<SymmetricTensor<2, 3>> stresses;
      own.for_each_cell([&](const unsigned int body, const auto &cell) {
        const SymmetricTensor<2, 3>    &strain = strains[stresses.size()];
        const std::pair<double, double> lame =
          materials[body].lame_parameters(cell->center());
        double mean_part = lame.first * trace(strain);
        if (!of_patches[body].empty())
          // The deviator stays that of the centre.
          mean_part +=
            (lame.first + 2. / 3. * lame.second) *
            (of_patches[body][cell->active_cell_index()] - trace(strain));
        stresses.push_back(2. * lame.second * strain +
                           mean_part * unit_symmetric_tensor<3>());
      });
      return stresses;
    }



    /** The fields of the cells. */
    template <int dim>
    class CellFields
    {
    public:
      CellFields(const OwnVolume<dim>              &own,
                 std::vector<VolumeContent::Field> &fields)
        : own(own)
        , fields(fields)
      {}

      /** The value of a function of the body and the centre of a cell. */
      template <typename Value>
      void
      add(const std::string &name,
          const std::string &units,
          const Value       &value) const
      {
        std::vector<double> values;
        own.for_each_cell([&](const unsigned int body, const auto &cell) {
          values.push_back(value(body, cell->center()));
        });
        fields.push_back({name, 1, values, units});
      }

      /** Entries of tensors of the cells, each as numbers by the name with the
       * axes: those that need not be zero. */
      void
      add_tensors(const std::string                        &name,
                  const std::vector<SymmetricTensor<2, 3>> &tensors,
                  const std::string                        &units) const
      {
        const bool        out_of_plane = own.level.nodes.n_components() == 1;
        const std::string axes         = "xyz";
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
              fields.push_back(
                {name + "_" + axes[c] + axes[d], 1, values, units});
            }
      }

    private:
      const OwnVolume<dim>              &own;
      std::vector<VolumeContent::Field> &fields;
    };
  } // namespace



  template <int dim>
  VolumeContent
  own_volume(const MeshLevel<dim>                   &level,
             const VolumeState                      &state,
             const std::vector<VolumeMaterial<dim>> &materials,
             const std::vector<VolumeField>         &wanted)
  {
    const OwnVolume<dim> own(level);
    VolumeContent        content;
    content.points    = own.points;
    content.cells     = own.cells;
    content.dimension = dim;
    content.n_corners = own.vertices_per_cell;
    content.positions = own.positions;
    content.corners   = own.connectivity();

    const auto add_vectors = [&](const std::string         &name,
                                 const std::vector<double> &values,
                                 const std::string         &units) {
      content.of_points.push_back({name, 3, values, units});
    };
    const bool with_stress       = has_field(wanted, VolumeField::stress),
               with_strain       = has_field(wanted, VolumeField::strain),
               with_displacement = has_field(wanted, VolumeField::displacement);
    std::vector<double> displacement;
    if (with_displacement || with_stress || with_strain)
      displacement = own.at_points(state.displacement);
    if (with_displacement)
      add_vectors("displacement", displacement, "m");
    if (has_field(wanted, VolumeField::velocity))
      add_vectors("velocity", own.at_points(state.velocity), "m/s");
    if (has_field(wanted, VolumeField::acceleration))
      add_vectors("acceleration", own.at_points(state.acceleration), "m/s^2");

    const CellFields<dim> of_cells(own, content.of_cells);
    if (with_stress || with_strain)
      {
        const std::vector<SymmetricTensor<2, 3>> strains =
          cell_strains(own, displacement);
        if (with_stress)
          of_cells.add_tensors(
            "stress",
            cell_stresses(own, strains, state.displacement, materials),
            "Pa");
        if (with_strain)
          of_cells.add_tensors("strain", strains, "1");
      }
    if (has_field(wanted, VolumeField::body))
      of_cells.add("body", "", [](const unsigned int body, const Point<dim> &) {
        return body;
      });
    if (has_field(wanted, VolumeField::material))
      for (unsigned int i = 0; i < materials[0].fields.size(); ++i)
        of_cells.add(materials[0].fields[i].name,
                     materials[0].fields[i].units,
                     [&](const unsigned int body, const Point<dim> &centre) {
                       return materials[body].fields[i].value(centre);
                     });
    return content;
  }



  template <int dim>
  VolumeContent
  gather_volume(const MeshLevel<dim> &level, const VolumeContent &own)
  {
    const MPI_Comm    communicator = level.nodes.communicator();
    const SerialOrder points(own.points, level.n_nodes(), communicator),
      cells(own.cells, level.n_cells(), communicator);
    std::vector<std::int64_t> corners = own.corners;
    for (std::int64_t &corner : corners)
      if (corner >= 0)
        corner = own.points[corner];

    VolumeContent all;
    all.dimension     = own.dimension;
    all.n_corners     = own.n_corners;
    all.positions     = points.gather(own.positions, 3);
    all.corners       = cells.gather(corners, own.n_corners);
    const auto gather = [](const SerialOrder                       &order,
                           const std::vector<VolumeContent::Field> &fields) {
      std::vector<VolumeContent::Field> result;
      for (const auto &[name, n_components, values, units] : fields)
        result.push_back(
          {name, n_components, order.gather(values, n_components), units});
      return result;
    };
    all.of_points = gather(points, own.of_points);
    all.of_cells  = gather(cells, own.of_cells);
    return all;
  }



  template decltype(own_volume<2>)    own_volume<2>;
  template decltype(own_volume<3>)    own_volume<3>;
  template decltype(gather_volume<2>) gather_volume<2>;
  template decltype(gather_volume<3>) gather_volume<3>;
} // namespace StickSlip
