// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/dofs/dof_accessor.h>
#include <deal.II/fe/fe.h>
#include <deal.II/lac/full_matrix.h>

#include <stickslip/mechanics/halving_error.h>
#include <stickslip/mechanics/strain_energy.h>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    using CellIterator = typename DoFHandler<dim>::cell_iterator;



    template <int n_components>
    using VertexValues = std::vector<Tensor<1, n_components>>;



    /** The values of a field at the vertices of an active cell. */
    template <int dim, int n_components>
    VertexValues<n_components>
    values_at(const MeshLevel<dim>    &level,
              const NodalVector       &field,
              const unsigned int       body,
              const CellIterator<dim> &cell)
    {
      VertexValues<n_components> values(cell->n_vertices());
      for (const auto v : cell->vertex_indices())
        for (const auto &[node, weight] :
             level.resolve(body, cell->vertex_dof_index(v, 0)))
          for (unsigned int c = 0; c < n_components; ++c)
            values[v][c] +=
              weight * field.local_element(
                         level.nodes.local_index(node) * n_components + c);
      return values;
    }



    template <int n_components>
    VertexValues<n_components>
    product(const FullMatrix<double>         &matrix,
            const VertexValues<n_components> &values)
    {
      VertexValues<n_components> result(matrix.m());
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < matrix.n(); ++j)
          result[i] += matrix(i, j) * values[j];
      return result;
    }



    /** Walk through the trees of both meshes side by side. */
    template <int dim, int n_components>
    class Comparison
    {
    public:
      Comparison(const MeshLevel<dim>              &coarse,
                 const NodalVector                 &coarse_field,
                 const MeshLevel<dim>              &fine,
                 const NodalVector                 &fine_field,
                 const std::vector<MaterialFields> &materials)
        : coarse(coarse)
        , coarse_field(coarse_field)
        , fine(fine)
        , fine_field(fine_field)
        , strain_energy(fine, materials)
      {}

      HalvingError
      compare()
      {
        for (unsigned int b = 0; b < coarse.bodies.size(); ++b)
          {
            const DoFHandler<dim> &dofs = coarse.bodies[b]->dof_handler();
            body                        = b;
            error.of_cells.emplace_back(
              dofs.get_triangulation().n_active_cells(), 0.);
            if (coarse.bodies[b]->is_rigid())
              continue;
            auto fine_cell = fine.bodies[b]->dof_handler().begin(0);
            for (auto cell = dofs.begin(0); cell != dofs.end(0);
                 ++cell, ++fine_cell)
              visit(cell, fine_cell);
          }
        return error;
      }

    private:
      void
      visit(const CellIterator<dim> &cell, const CellIterator<dim> &fine_cell)
      {
        if (!cell->is_active())
          {
            for (unsigned int child = 0; child < cell->n_children(); ++child)
              visit(cell->child(child), fine_cell->child(child));
            return;
          }
        const FiniteElement<dim> &fe =
          coarse.bodies[body]->dof_handler().get_fe();
        const VertexValues<n_components> values =
          values_at<dim, n_components>(coarse, coarse_field, body, cell);
        // The children are a patch of the finer mesh.
        std::vector<CellIterator<dim>>          children;
        std::vector<VertexValues<n_components>> present, missing;
        for (unsigned int child = 0; child < fine_cell->n_children(); ++child)
          {
            children.push_back(fine_cell->child(child));
            present.push_back(values_at<dim, n_components>(
              fine, fine_field, body, children.back()));
            missing.push_back(present.back());
            const VertexValues<n_components> interpolated =
              product(fe.get_prolongation_matrix(child,
                                                 fine_cell->refinement_case()),
                      values);
            for (unsigned int v = 0; v < interpolated.size(); ++v)
              missing.back()[v] -= interpolated[v];
          }
        error.energy += strain_energy(body, children, present);
        const double of_cell = strain_energy(body, children, missing);
        error.of_cells[body][cell->active_cell_index()] += of_cell;
        error.sum += of_cell;
      }

      const MeshLevel<dim>           &coarse;
      const NodalVector              &coarse_field;
      const MeshLevel<dim>           &fine;
      const NodalVector              &fine_field;
      StrainEnergy<dim, n_components> strain_energy;
      unsigned int                    body = 0;
      HalvingError                    error;
    };
  } // namespace



  template <int dim, int n_components>
  HalvingError
  halving_error(const MeshLevel<dim>              &coarse,
                const NodalVector                 &coarse_displacement,
                const MeshLevel<dim>              &fine,
                const NodalVector                 &fine_displacement,
                const std::vector<MaterialFields> &materials)
  {
    return Comparison<dim, n_components>(
             coarse, coarse_displacement, fine, fine_displacement, materials)
      .compare();
  }



  template decltype(halving_error<2>)    halving_error<2>;
  template decltype(halving_error<3>)    halving_error<3>;
  template decltype(halving_error<2, 1>) halving_error<2, 1>;
} // namespace StickSlip
