// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * A membrane above an obstacle, by TNNMG and by deal.II's active set method.
 *
 * The square Omega = (-1,1)^2 carries a membrane that is held at its boundary,
 * pressed down by the force f = -10 and kept up by a staircase psi: the problem
 * of deal.II's tutorial step-41. Its displacement minimises
 *
 *   J(u) = 1/2 int |grad u|^2 - int f u       over u = 0 on the boundary,
 *                                             u >= psi in Omega.
 *
 * With bilinear finite elements, and the condition asked for at the nodes only,
 * this is
 *
 *   1/2 u . A u - b . u + sum_i phi_i(u_i),
 *   phi_i(x) = 0 for x >= psi(x_i), infinite for x < psi(x_i),
 *
 * a quadratic function and a nonsmooth one that is a sum over nodes, which is
 * what TNNMG (Graeser and Sander 2019) is for. The program tells the solver
 * three things: the matrix A, the levels of the mesh, and phi.
 *
 * Both methods start at zero on the first mesh, and on each other one at the
 * result of the mesh before. The table shows their iterations, their linear
 * iterations and their seconds of the processor, in which setting up the
 * multigrid methods is counted, and how far their results are apart, in the
 * energy norm and relative.
 *
 * Usage: obstacle [REFINEMENTS], of a mesh of 4 x 4 cells, 6 without.
 */

#include <deal.II/base/function.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/table_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/numerics/matrix_tools.h>
#include <deal.II/numerics/vector_tools.h>

#include <stickslip/tnnmg/tnnmg_solver.h>

#include "../comparison.h"

using namespace dealii;
using namespace StickSlip;

// The obstacle, a staircase of four steps.
double
obstacle_height(const Point<2> &x)
{
  return x[0] < -0.5 ? -0.2 : x[0] < 0. ? -0.4 : x[0] < 0.5 ? -0.6 : -0.8;
}



// The functional phi: what the solver must know of it are the domain, to which
// it projects its corrections, where a value is at its bound, the derivatives,
// and the minimiser for a single node. In the domain phi is zero, and so are
// its derivatives.
class ObstacleFunctional : public NonsmoothFunctional<1>
{
public:
  ObstacleFunctional(const std::vector<unsigned int> &nodes,
                     const std::vector<double>       &heights)
    : numbers(nodes)
    , heights(heights)
  {}

  const std::vector<unsigned int> &
  nodes() const override
  {
    return numbers;
  }

  bool
  has_bounds() const override
  {
    return true;
  }

  Tensor<1, 1>
  project(const unsigned int k, const Tensor<1, 1> &v) const override
  {
    return Tensor<1, 1>({std::max(v[0], heights[k])});
  }

  // The membrane lies on the obstacle.
  bool
  is_at_bound(const unsigned int  k,
              const Tensor<1, 1> &v,
              const unsigned int) const override
  {
    return v[0] == heights[k];
  }

  // Minimise 1/2 A v^2 - r v over v >= psi.
  Tensor<1, 1>
  minimise(const unsigned int         k,
           const Tensor<2, 1>        &A,
           const Tensor<1, 1>        &r,
           const std::array<bool, 1> &active,
           const Tensor<1, 1>        &start) const override
  {
    if (!active[0])
      return start;
    return Tensor<1, 1>({std::max(r[0] / A[0][0], heights[k])});
  }

  bool
  is_smooth(const unsigned int, const Tensor<1, 1> &) const override
  {
    return true;
  }

  bool
  acts_on(const unsigned int, const unsigned int) const override
  {
    return false;
  }

  double
  value(const unsigned int, const Tensor<1, 1> &) const override
  {
    return 0.;
  }

  double
  directional_derivative(const unsigned int,
                         const Tensor<1, 1> &,
                         const Tensor<1, 1> &) const override
  {
    return 0.;
  }

  Tensor<1, 1>
  gradient(const unsigned int, const Tensor<1, 1> &) const override
  {
    return Tensor<1, 1>();
  }

  Tensor<2, 1>
  hessian(const unsigned int, const Tensor<1, 1> &) const override
  {
    return Tensor<2, 1>();
  }

private:
  const std::vector<unsigned int> numbers;
  const std::vector<double>       heights;
};



// The membrane on one mesh.
class Membrane
{
public:
  explicit Membrane(const unsigned int n_refinements);

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
  IndexSet            boundary;
  std::vector<double> heights;
};



// A mesh and what belongs to it, as in any program with deal.II. The levels of
// the multigrid method are those of the triangulation.
Membrane::Membrane(const unsigned int n_refinements)
  : triangulation(Triangulation<2>::limit_level_difference_at_vertices)
  , fe(1)
  , dof_handler(triangulation)
{
  GridGenerator::subdivided_hyper_cube(triangulation, 4, -1., 1.);
  triangulation.refine_global(n_refinements);
  dof_handler.distribute_dofs(fe);
  dof_handler.distribute_mg_dofs();

  DynamicSparsityPattern couplings(dof_handler.n_dofs());
  DoFTools::make_sparsity_pattern(dof_handler, couplings);
  sparsity.copy_from(couplings);
  A.reinit(sparsity);
  b.reinit(dof_handler.n_dofs());
  MatrixCreator::create_laplace_matrix(dof_handler, QGauss<2>(2), A);
  VectorTools::create_right_hand_side(dof_handler,
                                      QGauss<2>(2),
                                      Functions::ConstantFunction<2>(-10.),
                                      b);
  boundary = DoFTools::extract_boundary_dofs(dof_handler);

  std::vector<Point<2>> points(dof_handler.n_dofs());
  DoFTools::map_dofs_to_support_points(MappingQ1<2>(), dof_handler, points);
  for (const Point<2> &x : points)
    heights.push_back(obstacle_height(x));
}



// This is all that it takes to use the solver: matrix, fixed components,
// levels, functional; then the iteration.
SolveSummary
Membrane::solve_by_tnnmg(Vector<double> &u) const
{
  const BlockMatrix<1> matrix = Examples::make_block_matrix<1>(A);

  NodeMask                  fixed(dof_handler.n_dofs(), 1);
  std::vector<unsigned int> nodes;
  std::vector<double>       bounds;
  for (unsigned int i = 0; i < dof_handler.n_dofs(); ++i)
    if (boundary.is_element(i))
      fixed.mask_node(i);
    else
      {
        nodes.push_back(i);
        bounds.push_back(heights[i]);
      }
  const ObstacleFunctional functional(nodes, bounds);

  const std::vector<LevelDescription<1>> levels =
    Examples::refinement_levels(dof_handler, matrix, fixed, nodes);
  OperatorSum<1> operators(levels.back(), {matrix});
  operators.combine({1.});
  LevelHierarchy<1> hierarchy(operators, levels);

  TNNMGParameters parameters;
  parameters.tolerance = 1e-8;
  TNNMGSolver<1> solver(hierarchy, parameters);

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



// With the reaction r = A u - b of the obstacle, a node is on it where
// r_i + c_i (psi_i - u_i) > 0, for any c_i > 0. Here the gap is compared with
// the reaction by the stiffness of the node, c_i = A_ii. The tutorial's 100
// times the integral of the basis function takes 19 iterations on 66,049
// unknowns and 38 on 263,169.
Examples::ActiveSetSummary
Membrane::solve_by_active_set(Vector<double> &u) const
{
  const auto divide = [&](const Vector<double> &u,
                          const Vector<double> &reaction) {
    Examples::Division result;
    result.load          = b;
    result.values        = heights;
    result.is_prescribed = std::vector<bool>(u.size(), false);
    for (unsigned int i = 0; i < u.size(); ++i)
      if (boundary.is_element(i))
        {
          result.is_prescribed[i] = true;
          result.values[i]        = 0.;
        }
      else
        result.is_prescribed[i] =
          reaction(i) + A.diag_element(i) * (heights[i] - u(i)) > 0.;
    return result;
  };
  return Examples::solve_by_active_set(A, b, {}, divide, u);
}



void
Membrane::add_columns(TableHandler &table) const
{
  table.add_value("unknowns", A.m());
}



int
main(int argc, char *argv[])
{
  return Examples::compare_on_meshes<1, Membrane>(argc, argv);
}
