// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_welded_problem_h
#define stickslip_contrib_welded_problem_h

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <stickslip/scene/scene_parameters.h>

namespace Measure
{
  using namespace dealii;
  using namespace StickSlip;

  /** An acceleration that changes from node to node, as a part of a right hand
   * side that a multigrid method cannot leave to one level. */
  template <int dim>
  double
  rough_acceleration(const Point<dim> &point, const unsigned int component);

  /**
   * The operator of a time step of a scene with its faults welded, by means of
   * deal.II alone: one triangulation of all bodies with the same cells, and
   *
   *   A = 2/tau M + C + tau/2 K
   *
   * as one sparse matrix. For bodies of the same lateral extent and the same
   * number of refinements, held at the bottom or the top.
   */
  template <int dim>
  class WeldedProblem
  {
  public:
    WeldedProblem(const SceneParameters<dim> &scene, const double tau);

    /** Assemble system_matrix, and rhs from gravity, tractions and
     * M rough_acceleration. */
    void
    assemble_system();

    /** Call @p visit(cell, matrix of the cell) on all cells of all levels, or
     * on the active ones. */
    void
    for_each_cell_matrix(
      const bool                                             all_levels,
      const std::function<void(const typename DoFHandler<dim>::cell_iterator &,
                               const FullMatrix<double> &)> &visit) const;

    /** The components that are held on the bottom and on the top. */
    std::vector<std::pair<types::boundary_id, ComponentMask>>
    held_sides() const;

    Triangulation<dim>        triangulation;
    DoFHandler<dim>           dof_handler;
    AffineConstraints<double> constraints;
    SparsityPattern           sparsity;
    SparseMatrix<double>      system_matrix;
    Vector<double>            rhs;

  private:
    void
    make_grid();

    /** The body at a height. */
    const BodyParameters<dim> &
    body_at(const double height) const;

    void
    add_tractions();

    const SceneParameters<dim> &scene;
    const double                tau;
  };
} // namespace Measure

#endif
