// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_fault_shape_h
#define stickslip_geometry_fault_shape_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <stickslip/geometry/body_cells.h>
#include <stickslip/geometry/fault_topology.h>

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The curve, in three dimensions the surface, on which the vertices of a
   * fault are: those of the coarse mesh, and those that refinement adds.
   */
  template <int dim>
  class FaultShape
  {
  public:
    virtual ~FaultShape() = default;

    /** The place on the fault of a point near to it, m. The same for the same
     * point, whichever body asks. */
    virtual Point<dim>
    place(const Point<dim> &point) const = 0;
  };



  /** One coordinate as a function of the others: an elevation where that is
   * the last one. Points are moved along this axis only. */
  template <int dim>
  class GraphShape : public FaultShape<dim>
  {
  public:
    /** The function does not look at the coordinate along @p axis. */
    GraphShape(const unsigned int                               axis,
               const std::function<double(const Point<dim> &)> &coordinate)
      : axis(axis)
      , coordinate(coordinate)
    {}

    virtual Point<dim>
    place(const Point<dim> &point) const override;

  private:
    unsigned int                              axis;
    std::function<double(const Point<dim> &)> coordinate;
  };



  /** A shape for each side of a body that has one. */
  template <int dim>
  using SideShapes =
    std::map<types::boundary_id, std::shared_ptr<const FaultShape<dim>>>;

  /**
   * Let the vertices that refinement adds on some sides of a body be on their
   * shapes, those inside stay where they are otherwise. What refinement gives
   * is the same on both sides of a fault, bit by bit, where its faces are.
   *
   * In deal.II's terms: faces get manifolds, with the indicators of the sides
   * as their numbers. An edge between two sides of different shapes is on both.
   */
  template <int dim>
  void
  set_shapes(Triangulation<dim> &cells, const SideShapes<dim> &shapes);

  /** True if sides of the cells have shapes. */
  template <int dim>
  bool
  has_shapes(const Triangulation<dim> &cells);

  /** Distance up to which vertices of a coarse mesh may be off their fault, in
   * the size of the smallest face there. */
  constexpr double most_off_shape = 0.1;

  /** By how much a fault turns at least at a corner, or an edge in three
   * dimensions, that stays in a smooth shape, degrees. */
  constexpr double least_corner = 50.;

  /**
   * Move the vertices of bodies on the sides of faults onto the shapes of
   * these; @p shapes: one a fault, none where faces are straight. Throws
   * InputError with the name of the fault if a vertex is farther off than
   * most_off_shape.
   */
  template <int dim>
  void
  move_onto_shapes(
    std::vector<BodyCells<dim>>                               &bodies,
    const FaultTopology                                       &topology,
    const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes);

  /** The shapes of a body's sides, of those of all faults. */
  template <int dim>
  SideShapes<dim>
  shapes_of_body(
    const unsigned int                                         body,
    const FaultTopology                                       &topology,
    const std::vector<std::shared_ptr<const FaultShape<dim>>> &shapes);

  /** Move hanging vertices inside of a body to the middle of what they hang on,
   * where the functions that are bound there are continuous. Only the vertices
   * at active cells with a mark, if there are marks. */
  template <int dim>
  void
  straighten_hanging_vertices(Triangulation<dim>      &mesh,
                              const std::vector<bool> &marks = {});

  /** Throw InputError: a fault bends too much for the cells at it. */
  template <int dim>
  [[noreturn]] void
  refuse_inverted_cell(const Point<dim> &centre);

  /** Throw InputError if an active cell, one with a mark if there are marks, is
   * inverted at one of its vertices. */
  template <int dim>
  void
  refuse_inverted_cells(const Triangulation<dim> &mesh,
                        const std::vector<bool>  &marks = {});
} // namespace StickSlip

#endif
