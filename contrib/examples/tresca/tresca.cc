// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * An elastic block that is dragged over a plate, with Tresca's friction, by
 * TNNMG and by an active set method.
 *
 * The block Omega = (0,4) x (0,1) lies on a rigid plate and stays on it. Its
 * left side may not move to the side, its right side is pulled with the
 * traction p = 1, and on the lower side Gamma the plate resists with at most
 * g = 1/2 for each unit of length. In plane strain, with the strain eps(u) and
 * the constants lambda and mu of Lame, the displacement minimises
 *
 *   J(u) = 1/2 int (2 mu eps(u) : eps(u) + lambda (div u)^2)
 *          - int_right p u_x + int_Gamma g |u_x|
 *
 * over u_x = 0 on the left and u_y = 0 on Gamma. Near the right end the block
 * slides; further away friction has taken up the whole force, and it sticks.
 *
 * With bilinear finite elements, and the last integral by the trapezoidal rule
 * with the weights w_i, this is
 *
 *   1/2 u . A u - b . u + sum_i phi_i(u_i),      phi_i(v) = w_i g |v_x|,
 *
 * a quadratic function and a nonsmooth one that is a sum over nodes, which is
 * what TNNMG (Graeser and Sander 2019) is for. Each node has two components, of
 * which phi sees one.
 *
 * The active set method is the semismooth Newton method for this problem (see
 * Stadler 2004): with the force r = b - A u that is left for friction, a node
 * slides where |r_i + c w_i u_i| > w_i g, with the friction w_i g against that
 * sum's sign, and sticks elsewhere.
 *
 * Both methods start at zero on the first mesh, and on each other one at the
 * result of the mesh before. The table shows their iterations, their linear
 * iterations and their seconds of the processor, in which setting up the
 * multigrid methods is counted, and how far their results are apart, in the
 * energy norm and relative.
 *
 * Usage: tresca [REFINEMENTS], of a mesh of 8 x 2 cells, 6 without.
 */

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <stickslip/tnnmg/tnnmg_solver.h>

#include "../comparison.h"

using namespace dealii;
using namespace StickSlip;

// Constants of the material and the loads.
constexpr double lambda = 100., mu = 100., traction = 1., friction = 0.5;

// Numbers of the sides, as GridGenerator gives them.
constexpr types::boundary_id left = 0, right = 1, bottom = 2;



// The functional phi. Where the block sticks it is not smooth; where it slides,
// phi is linear, so that there is no second derivative.
class TrescaFriction : public NonsmoothFunctional<2>
{
public:
  TrescaFriction(const std::vector<unsigned int> &nodes,
                 const std::vector<double>       &bounds)
    : numbers(nodes)
    , bounds(bounds)
  {}

  const std::vector<unsigned int> &
  nodes() const override
  {
    return numbers;
  }

  double
  value(const unsigned int k, const Tensor<1, 2> &v) const override
  {
    return bounds[k] * std::abs(v[0]);
  }

  double
  directional_derivative(const unsigned int  k,
                         const Tensor<1, 2> &v,
                         const Tensor<1, 2> &direction) const override
  {
    return v[0] == 0. ? bounds[k] * std::abs(direction[0]) :
                        gradient(k, v) * direction;
  }

  Tensor<1, 2>
  gradient(const unsigned int k, const Tensor<1, 2> &v) const override
  {
    return Tensor<1, 2>({v[0] == 0. ? 0. : std::copysign(bounds[k], v[0]), 0.});
  }

  Tensor<2, 2>
  hessian(const unsigned int, const Tensor<1, 2> &) const override
  {
    return Tensor<2, 2>();
  }

  bool
  is_smooth(const unsigned int, const Tensor<1, 2> &v) const override
  {
    return v[0] != 0.;
  }

  bool
  acts_on(const unsigned int, const unsigned int component) const override
  {
    return component == 0;
  }

  // Minimise 1/2 A_xx v_x^2 - r_x v_x + g |v_x|. Nodes on the plate do not move
  // along the other axis, and in the corner not at all.
  Tensor<1, 2>
  minimise(const unsigned int         k,
           const Tensor<2, 2>        &A,
           const Tensor<1, 2>        &r,
           const std::array<bool, 2> &active,
           const Tensor<1, 2>        &start) const override
  {
    AssertThrow(!active[1], ExcMessage("Nodes on the plate are held along y."));
    Tensor<1, 2> v = start;
    if (active[0])
      v[0] =
        std::copysign(std::max(std::abs(r[0]) - bounds[k], 0.), r[0]) / A[0][0];
    return v;
  }

private:
  const std::vector<unsigned int> numbers;
  const std::vector<double>       bounds;
};



// The block on one mesh. Its degrees of freedom are those of a scalar element,
// the nodes; component c of the displacement of node i has the number 2 i + c.
class Block
{
public:
  explicit Block(const unsigned int n_refinements);

  SolveSummary
  solve_by_tnnmg(Vector<double> &u) const;

  Examples::ActiveSetSummary
  solve_by_active_set(Vector<double> &u) const;

  // Columns of the table on the problem itself.
  void
  add_columns(TableHandler &table) const;

  Triangulation<2>     triangulation;
  const FE_Q<2>        fe;
  DoFHandler<2>        dof_handler;
  SparsityPattern      sparsity;
  SparseMatrix<double> A;
  Vector<double>       b, solution;

private:
  void
  assemble_stiffness();

  // Traction on the right, and weights of nodes on the plate.
  void
  assemble_sides();

  NodeMask            fixed;
  std::vector<double> weights;
};



Block::Block(const unsigned int n_refinements)
  : triangulation(Triangulation<2>::limit_level_difference_at_vertices)
  , fe(1)
  , dof_handler(triangulation)
{
  GridGenerator::subdivided_hyper_rectangle(
    triangulation, {8, 2}, Point<2>(0., 0.), Point<2>(4., 1.), true);
  triangulation.refine_global(n_refinements);
  dof_handler.distribute_dofs(fe);
  dof_handler.distribute_mg_dofs();
  assemble_stiffness();
  assemble_sides();

  fixed = NodeMask(dof_handler.n_dofs(), 2);
  for (const unsigned int i :
       DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(), {left}))
    fixed.mask(i, 0);
  for (const unsigned int i :
       DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(), {bottom}))
    fixed.mask(i, 1);
}



void
Block::assemble_stiffness()
{
  std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
  DynamicSparsityPattern               couplings(2 * dof_handler.n_dofs());
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      for (const auto i : dofs)
        for (const auto j : dofs)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              couplings.add(2 * i + c, 2 * j + d);
    }
  sparsity.copy_from(couplings);
  A.reinit(sparsity);

  FEValues<2> values(fe, QGauss<2>(2), update_gradients | update_JxW_values);
  for (const auto &cell : dof_handler.active_cell_iterators())
    {
      cell->get_dof_indices(dofs);
      values.reinit(cell);
      for (unsigned int i = 0; i < dofs.size(); ++i)
        for (unsigned int j = 0; j < dofs.size(); ++j)
          {
            Tensor<2, 2> block;
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const Tensor<1, 2> p = values.shape_grad(i, q),
                                   s = values.shape_grad(j, q);
                block +=
                  (lambda * outer_product(p, s) + mu * outer_product(s, p) +
                   mu * (p * s) * unit_symmetric_tensor<2>()) *
                  values.JxW(q);
              }
            for (unsigned int c = 0; c < 2; ++c)
              for (unsigned int d = 0; d < 2; ++d)
                A.add(2 * dofs[i] + c, 2 * dofs[j] + d, block[c][d]);
          }
    }
}



void
Block::assemble_sides()
{
  b.reinit(2 * dof_handler.n_dofs());
  weights.assign(dof_handler.n_dofs(), 0.);
  std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
  FEFaceValues<2> values(fe, QGauss<1>(2), update_values | update_JxW_values);
  for (const auto &cell : dof_handler.active_cell_iterators())
    for (const unsigned int face : cell->face_indices())
      if (cell->face(face)->at_boundary())
        {
          cell->get_dof_indices(dofs);
          values.reinit(cell, face);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            for (const unsigned int q : values.quadrature_point_indices())
              {
                const double weight = values.shape_value(i, q) * values.JxW(q);
                if (cell->face(face)->boundary_id() == right)
                  b(2 * dofs[i]) += traction * weight;
                if (cell->face(face)->boundary_id() == bottom)
                  weights[dofs[i]] += weight;
              }
        }
}



// This is all that it takes to use the solver: matrix, fixed components,
// levels, functional; then the iteration.
SolveSummary
Block::solve_by_tnnmg(Vector<double> &u) const
{
  const BlockMatrix<2> matrix = Examples::make_block_matrix<2>(A);

  std::vector<unsigned int> nodes;
  std::vector<double>       bounds;
  for (unsigned int i = 0; i < weights.size(); ++i)
    if (weights[i] > 0.)
      {
        nodes.push_back(i);
        bounds.push_back(friction * weights[i]);
      }
  const TrescaFriction functional(nodes, bounds);

  const std::vector<LevelDescription<2>> levels =
    Examples::refinement_levels(dof_handler, matrix, fixed, nodes);
  OperatorSum<2> operators(levels.back(), {matrix});
  operators.combine({1.});
  LevelHierarchy<2> hierarchy(operators, levels);

  TNNMGParameters parameters;
  parameters.tolerance = 1e-8;
  TNNMGSolver<2> solver(hierarchy, parameters);

  NodalVector load = levels.back().nodes.make_vector(), w = load;
  for (unsigned int i = 0; i < b.size(); ++i)
    {
      load.local_element(i) = b(i);
      w.local_element(i)    = u(i);
    }
  const SolveSummary summary = solver.solve(functional, load, w);
  for (unsigned int i = 0; i < u.size(); ++i)
    u(i) = w.local_element(i);
  return summary;
}



Examples::ActiveSetSummary
Block::solve_by_active_set(Vector<double> &u) const
{
  constexpr double c = mu;

  const auto divide = [&](const Vector<double> &u,
                          const Vector<double> &reaction) {
    Examples::Division result;
    result.load          = b;
    result.values        = std::vector<double>(u.size(), 0.);
    result.is_prescribed = std::vector<bool>(u.size(), false);
    for (unsigned int i = 0; i < weights.size(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        if (!fixed.is_active(i, d))
          result.is_prescribed[2 * i + d] = true;
        else if (d == 0 && weights[i] > 0.)
          {
            const double bound = friction * weights[i];
            const double sum   = c * weights[i] * u(2 * i) - reaction(2 * i);
            if (std::abs(sum) > bound)
              result.load(2 * i) -= std::copysign(bound, sum);
            else
              result.is_prescribed[2 * i] = true;
          }
    return result;
  };

  // The translations, which the algebraic multigrid method asks for.
  std::vector<std::vector<bool>> translations(2, std::vector<bool>(u.size()));
  for (unsigned int i = 0; i < u.size(); ++i)
    translations[i % 2][i] = true;
  return Examples::solve_by_active_set(A, b, translations, divide, u);
}



void
Block::add_columns(TableHandler &table) const
{
  unsigned int n_sticking = 0;
  for (unsigned int i = 0; i < weights.size(); ++i)
    if (weights[i] > 0. && solution(2 * i) == 0.)
      ++n_sticking;
  table.add_value("unknowns", A.m());
  table.add_value("sticking", n_sticking);
}



int
main(int argc, char *argv[])
{
  return Examples::compare_on_meshes<2, Block>(argc, argv);
}
