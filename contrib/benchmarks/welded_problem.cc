// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include "welded_problem.h"

#include <deal.II/base/function_parser.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

namespace Measure
{
  template <int dim>
  double
  rough_acceleration(const Point<dim> &point, const unsigned int component)
  {
    double phase = 1e5;
    for (unsigned int d = 0; d < dim; ++d)
      phase *= point[d] / 5. + 1.3 + 0.4 * d + 0.7 * component;
    return 10. * std::sin(phase);
  }



  template <int dim>
  WeldedProblem<dim>::WeldedProblem(const SceneParameters<dim> &scene,
                                    const double                tau)
    // Geometric multigrid wants this of locally refined meshes.
    : triangulation(Triangulation<dim>::limit_level_difference_at_vertices)
    , dof_handler(triangulation)
    , scene(scene)
    , tau(tau)
  {
    make_grid();
    dof_handler.distribute_dofs(FESystem<dim>(FE_Q<dim>(1), dim));
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    for (const auto &side : held_sides())
      DoFTools::make_zero_boundary_constraints(dof_handler,
                                               side.first,
                                               constraints,
                                               side.second);
    constraints.close();
  }



  template <int dim>
  void
  WeldedProblem<dim>::make_grid()
  {
    const BodyGeometry<dim>         &lowest  = scene.bodies.front().geometry;
    const BodyGeometry<dim>         &highest = scene.bodies.back().geometry;
    std::vector<std::vector<double>> sizes(dim);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      sizes[d].assign(lowest.coarse_cells[d],
                      (lowest.upper_corner()[d] - lowest.lower_corner()[d]) /
                        lowest.coarse_cells[d]);
    std::vector<double> faults;
    for (const BodyParameters<dim> &body : scene.bodies)
      {
        const BodyGeometry<dim> &geometry = body.geometry;
        bool                     alike =
          geometry.uniform_refinements == lowest.uniform_refinements &&
          geometry.refinement_passes == lowest.refinement_passes;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          alike = alike && geometry.coarse_cells[d] == lowest.coarse_cells[d] &&
                  geometry.lower_corner()[d] == lowest.lower_corner()[d] &&
                  geometry.upper_corner()[d] == lowest.upper_corner()[d];
        AssertThrow(alike, ExcMessage("The meshes of the bodies must match."));
        sizes[dim - 1].insert(sizes[dim - 1].end(),
                              geometry.coarse_cells[dim - 1],
                              geometry.thickness /
                                geometry.coarse_cells[dim - 1]);
        faults.push_back(geometry.upper_corner()[dim - 1]);
      }
    faults.pop_back();

    GridGenerator::subdivided_hyper_rectangle(triangulation,
                                              sizes,
                                              lowest.lower_corner(),
                                              highest.upper_corner(),
                                              /*colorize=*/true);
    triangulation.refine_global(lowest.uniform_refinements);
    for (unsigned int pass = 0; pass < lowest.refinement_passes; ++pass)
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          for (const auto v : cell->vertex_indices())
            for (const double height : faults)
              if (std::abs(cell->vertex(v)[dim - 1] - height) <
                  1e-10 * lowest.thickness)
                cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
      }
  }



  template <int dim>
  std::vector<std::pair<types::boundary_id, ComponentMask>>
  WeldedProblem<dim>::held_sides() const
  {
    std::vector<std::pair<types::boundary_id, ComponentMask>> result;
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      {
        AssertThrow((condition.body == scene.bodies.front().name &&
                     condition.side == 2 * (dim - 1)) ||
                      (condition.body == scene.bodies.back().name &&
                       condition.side == 2 * (dim - 1) + 1),
                    ExcMessage(
                      "Only conditions at the bottom and the top are known."));
        ComponentMask mask(dim, false);
        for (unsigned int c = 0; c < dim; ++c)
          mask.set(c,
                   condition.type[c] == BoundaryType::fixed ||
                     condition.type[c] == BoundaryType::velocity);
        if (mask.n_selected_components() > 0)
          result.emplace_back(condition.side, mask);
      }
    return result;
  }



  template <int dim>
  const BodyParameters<dim> &
  WeldedProblem<dim>::body_at(const double height) const
  {
    for (const BodyParameters<dim> &body : scene.bodies)
      if (height < body.geometry.upper_corner()[dim - 1])
        return body;
    AssertThrow(false, ExcMessage("There is no body."));
    return scene.bodies.back();
  }



  template <int dim>
  void
  WeldedProblem<dim>::for_each_cell_matrix(
    const bool                                             all_levels,
    const std::function<void(const typename DoFHandler<dim>::cell_iterator &,
                             const FullMatrix<double> &)> &visit) const
  {
    const FiniteElement<dim> &fe = dof_handler.get_fe();
    const unsigned int        n  = fe.n_dofs_per_cell();
    const QGauss<dim>         quadrature(fe.degree + 1);
    FEValues<dim>             fe_values(
      fe, quadrature, update_values | update_gradients | update_JxW_values);
    const FEValuesExtractors::Vector     velocity(0);
    FullMatrix<double>                   matrix(n, n);
    std::vector<Tensor<1, dim>>          value(n);
    std::vector<SymmetricTensor<2, dim>> strain(n), stress(n);

    const auto compute =
      [&](const typename DoFHandler<dim>::cell_iterator &cell) {
        const Material material =
          body_at(cell->center()[dim - 1]).material.constants();
        // Elastic and viscous stress at once: both are isotropic.
        const double mu =
          tau / 2. * material.shear_modulus() + material.shear_viscosity;
        const double lambda = tau / 2. * material.lame_lambda() +
                              material.bulk_viscosity -
                              2. / 3. * material.shear_viscosity;
        const double rho = 2. / tau * material.density;
        fe_values.reinit(typename Triangulation<dim>::cell_iterator(cell));
        matrix = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            for (unsigned int i = 0; i < n; ++i)
              {
                value[i]  = fe_values[velocity].value(i, q);
                strain[i] = fe_values[velocity].symmetric_gradient(i, q);
                stress[i] =
                  2. * mu * strain[i] +
                  lambda * trace(strain[i]) * unit_symmetric_tensor<dim>();
              }
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                matrix(i, j) +=
                  (rho * (value[i] * value[j]) + strain[i] * stress[j]) *
                  fe_values.JxW(q);
          }
        visit(cell, matrix);
      };
    if (all_levels)
      for (const auto &cell : dof_handler.cell_iterators())
        compute(cell);
    else
      for (const auto &cell : dof_handler.active_cell_iterators())
        compute(cell);
  }



  template <int dim>
  void
  WeldedProblem<dim>::assemble_system()
  {
    const FiniteElement<dim>            &fe = dof_handler.get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    {
      DynamicSparsityPattern dynamic(dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(dof_handler,
                                      dynamic,
                                      constraints,
                                      /*keep_constrained_dofs=*/false);
      sparsity.copy_from(dynamic);
    }
    system_matrix.reinit(sparsity);
    for_each_cell_matrix(false, [&](const auto &cell, const auto &matrix) {
      cell->get_dof_indices(dofs);
      constraints.distribute_local_to_global(matrix, dofs, system_matrix);
    });

    rhs.reinit(dof_handler.n_dofs());
    Vector<double> acceleration(dof_handler.n_dofs());
    {
      std::vector<Point<dim>> points(dof_handler.n_dofs());
      DoFTools::map_dofs_to_support_points(MappingQ1<dim>(),
                                           dof_handler,
                                           points);
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            acceleration(dofs[i]) =
              rough_acceleration(points[dofs[i]],
                                 fe.system_to_component_index(i).first);
        }
      constraints.distribute(acceleration);
    }
    FEValues<dim>                    fe_values(fe,
                            QGauss<dim>(fe.degree + 1),
                            update_values | update_JxW_values);
    const FEValuesExtractors::Vector velocity(0);
    std::vector<Tensor<1, dim>>      force(fe_values.get_quadrature().size());
    Vector<double>                   local(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        fe_values[velocity].get_function_values(acceleration, force);
        cell->get_dof_indices(dofs);
        local = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            force[q] += scene.gravity_vector();
            for (unsigned int i = 0; i < local.size(); ++i)
              local(i) +=
                body_at(cell->center()[dim - 1]).material.density.constant() *
                (force[q] * fe_values[velocity].value(i, q)) * fe_values.JxW(q);
          }
        constraints.distribute_local_to_global(local, dofs, rhs);
      }
    add_tractions();
  }



  template <int dim>
  void
  WeldedProblem<dim>::add_tractions()
  {
    const FiniteElement<dim>            &fe = dof_handler.get_fe();
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    FEFaceValues<dim>                    fe_values(fe,
                                QGauss<dim - 1>(3),
                                update_values | update_quadrature_points |
                                  update_JxW_values);
    Vector<double>                       local(fe.n_dofs_per_cell());
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      for (unsigned int c = 0; c < dim; ++c)
        {
          if (condition.type[c] != BoundaryType::traction)
            continue;
          FunctionParser<dim> traction(1, tau);
          traction.initialize(FunctionParser<dim>::default_variable_names() +
                                ",t",
                              condition.expression[c],
                              {},
                              /*time_dependent=*/true);
          traction.set_time(tau);
          const double ramp = smooth_ramp(tau, condition.ramp_length);
          for (const auto &cell : dof_handler.active_cell_iterators())
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  cell->face(f)->boundary_id() == condition.side)
                {
                  fe_values.reinit(cell, f);
                  cell->get_dof_indices(dofs);
                  local = 0.;
                  for (const unsigned int q :
                       fe_values.quadrature_point_indices())
                    for (unsigned int i = 0; i < local.size(); ++i)
                      if (fe.system_to_component_index(i).first == c)
                        local(i) +=
                          ramp * fe_values.JxW(q) *
                          traction.value(fe_values.quadrature_point(q)) *
                          fe_values.shape_value(i, q);
                  constraints.distribute_local_to_global(local, dofs, rhs);
                }
        }
  }



#define STICKSLIP_INSTANTIATE(dim)                             \
  template double rough_acceleration<dim>(const Point<dim> &,  \
                                          const unsigned int); \
  template class WeldedProblem<dim>;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace Measure
