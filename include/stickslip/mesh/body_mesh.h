// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mesh_body_mesh_h
#define stickslip_mesh_body_mesh_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <stickslip/geometry/coarse_body.h>
#include <stickslip/mesh/body_sides.h>
#include <stickslip/mesh/cell_patches.h>
#include <stickslip/mesh/red_refinement.h>
#include <stickslip/mesh/unit_numbers.h>
#include <stickslip/mesh/unit_refinement.h>

#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Numbers of vertices and active cells of a whole mesh, and the smallest and
   * largest diameter of the cells that are here, m.
   */
  struct MeshFigures
  {
    unsigned int n_vertices = 0, n_cells = 0;
    double       smallest = std::numeric_limits<double>::max(), largest = 0;
  };

  /**
   * One mesh of one body: the triangulation, the nodal basis of continuous
   * piecewise (multi)linear functions on it, one number a node, and the
   * constraints of the bound nodes: hanging ones, and those on the upper side
   * along a periodic axis, which follow their images on the lower one. Owners
   * are found for all bodies together, see MeshHierarchy, from whole meshes, or
   * from cells that are refined only then and only where a process needs them,
   * see UnitRefinement. After that a process keeps a part, which knows its
   * numbers in the whole.
   *
   * Cells are trees of deal.II's, but for tetrahedra, which each refinement
   * leaves in a mesh of its own, see RedRefinement.
   */
  template <int dim>
  class BodyMesh
  {
  public:
    /**
     * The mesh of a body: coarse cells, refined all over, then passes that
     * each refine every cell with a vertex on one of the @p sides_at_faults,
     * as far as CoarseBody::refine_where says, then the cells that are listed.
     * Throws InputError if these are tetrahedra, or if a cell is inverted since
     * its faults bend.
     */
    BodyMesh(const CoarseBody<dim>              &body,
             const std::set<types::boundary_id> &sides_at_faults);

    /** The mesh of a brick. */
    BodyMesh(const BodyGeometry<dim>            &geometry,
             const std::set<types::boundary_id> &sides_at_faults);

    /** The share of a process in the mesh that the @p steps lead to, of which
     * @p depth are beyond the @p units, whose cells have @p owners. What is
     * here are cells of the whole mesh and others, see is_real(). Throws
     * InputError if a cell is inverted. Collective. */
    BodyMesh(const std::shared_ptr<const BodyMesh>                  &units,
             const std::shared_ptr<const std::vector<unsigned int>> &owners,
             const RefinementSteps                                  &steps,
             const unsigned int                                      depth,
             const MPI_Comm &communicator);

    /** The mesh in which every cell of @p finer that can be is coarsened; if
     * none can be, the next of CoarseBody::coarser_cells. */
    static std::shared_ptr<const BodyMesh>
    coarsened(const BodyMesh &finer);

    /** Some active cells of the mesh @p whole, real ones. Bound nodes whose
     * masters are not all here have no entries in the constraints. Such a mesh
     * is refined or coarsened no further. If asked for, @p dofs_before gets the
     * degree of freedom that each had in @p whole. */
    BodyMesh(const BodyMesh                       &whole,
             const std::vector<bool>              &is_kept,
             std::vector<types::global_dof_index> *dofs_before = nullptr);

    /** The number of times that this mesh can be coarsened. */
    unsigned int
    n_coarsenings() const;

    /** True if the mesh is finer than the coarse cells. */
    bool
    can_be_coarsened() const
    {
      return n_coarsenings() > 0;
    }

    /** True if there are coarser cells than the coarse ones of this mesh. */
    bool
    has_coarser_cells() const;

    /** True if the refined cells of a body may be made only where a process
     * needs them: refined as RefinementSteps say, and all over if they are
     * triangles or tetrahedra, or if sides are joined. */
    static bool
    can_have_units(const CoarseBody<dim> &body);

    /** Numbers of the nodes, if this is a share in a mesh that is nowhere as a
     * whole, else null. */
    const NodeNumbers *
    numbers_in_units() const
    {
      return unit_numbers ? &unit_numbers->nodes : nullptr;
    }

    /** True if an active cell is one of the mesh, not in place of others. */
    bool
    is_real(const typename Triangulation<dim>::cell_iterator &cell) const
    {
      return real_cells.empty() || real_cells[cell->active_cell_index()];
    }

    /** For each vertex of the triangulation, if it is on a side that every
     * process keeps as a whole: one with directions that are asked for, and on
     * such bodies also one at a fault. */
    std::vector<bool>
    vertices_on_kept_sides() const;

    /** True if both meshes are refined from the same coarse cells. */
    bool
    is_nested_with(const BodyMesh &other) const;

    /** For each vertex the ends of the edge of the next coarser mesh in whose
     * middle it is, or twice itself. Empty if cells are trees, or if there is
     * no coarser mesh. */
    const std::vector<std::array<unsigned int, 2>> &
    vertex_parents() const;

    /** Boundary indicator of the lower and of the upper side. */
    static constexpr types::boundary_id lower_side =
      CoarseBody<dim>::lower_side;
    static constexpr types::boundary_id upper_side =
      CoarseBody<dim>::upper_side;

    /** The faces and nodes on one side; nodes have the numbers of their degrees
     * of freedom. */
    FaultSurface<dim>
    surface(const types::boundary_id side) const;

    /** The faces on one side that are here. */
    std::vector<SideFace<dim>>
    faces_on_side(const types::boundary_id side) const;

    /** The degrees of freedom on one side, hanging ones included; on periodic
     * bodies images only once. */
    std::vector<types::global_dof_index>
    dofs_on_side(const types::boundary_id side) const;

    /** The degree of freedom at each vertex of the triangulation, invalid where
     * no active cell has it. */
    std::vector<types::global_dof_index>
    dofs_of_vertices() const;

    /** Reference positions of all nodes. */
    std::vector<Point<dim>>
    node_positions() const;

    /** Numbers of the whole mesh and sizes of what is here. */
    MeshFigures
    figures() const;

    /** Numbers of vertices and of active cells of the whole mesh. */
    unsigned int
    n_vertices() const;
    unsigned int
    n_cells() const;

    /** The number of a degree of freedom in the whole mesh. */
    types::global_dof_index
    whole_dof(const types::global_dof_index dof) const
    {
      return part         ? part->dofs[dof] :
             unit_numbers ? unit_numbers->nodes.serial[dof] :
                            dof;
    }

    /** The number of an active cell in the whole mesh. */
    unsigned int
    whole_cell(const unsigned int cell) const
    {
      return unit_numbers         ? unit_numbers->cells[cell] :
             cell_numbers.empty() ? cell :
                                    cell_numbers[cell];
    }

    const Triangulation<dim> &
    triangulation() const
    {
      return *mesh;
    }

    const DoFHandler<dim> &
    dof_handler() const
    {
      return *dofs;
    }

    const AffineConstraints<double> &
    bound_nodes() const
    {
      return constraints;
    }

    /** The cells whose nodes couple to each other: single ones, if the body
     * does not couple patches. */
    const CellPatches &
    patches() const
    {
      return cell_patches;
    }

    /** Length after which fields repeat along each horizontal axis, m; zero:
     * the body ends there. */
    const Tensor<1, dim - 1> &
    lateral_period() const;

    /** True if the body does not deform; it has one cell then. */
    bool
    is_rigid() const
    {
      return rigid;
    }

  private:
    explicit BodyMesh(const BodyMesh &finer);

    /** A mesh of the coarse cells that can be refined. */
    std::shared_ptr<Triangulation<dim>>
    copy_coarse_cells() const;

    /** This mesh before hanging vertices went back to the middle of what they
     * hang on. */
    std::shared_ptr<const Triangulation<dim>>
    unstraightened() const;

    void
    join_periodic_sides(Triangulation<dim> &triangulation) const;

    /** Sides that every process has as a whole until it keeps a part: those
     * that it keeps, and joined ones, with those at faults that both have nodes
     * in common with. */
    std::set<types::boundary_id>
    sides_of_shares() const;

    /** Number the degrees of freedom. */
    void
    number_dofs();

    /** Number the degrees of freedom and cells of a whole mesh, and find the
     * bound nodes and patches. */
    void
    distribute_dofs();

    /** Bind nodes on the upper side along a periodic axis to their images. */
    void
    bind_images();

    void
    find_patches();

    /** Lower end of the body, and its length along periodic axes. */
    std::array<double, dim - 1> lateral_lower;
    Tensor<1, dim - 1>          period;
    bool                        rigid;
    bool                        couples_patches;

    /** Sides at faults, and those that every process keeps as a whole. */
    std::set<types::boundary_id> fault_sides, kept_sides;

    /** Numbers in the whole mesh, if only part of it is here. */
    struct Part
    {
      unsigned int                         n_vertices, n_cells;
      std::vector<types::global_dof_index> dofs;
    };

    std::optional<Part> part;

    /** Numbers of the active cells in the whole mesh; empty: as they are. */
    std::vector<unsigned int> cell_numbers;

    /** The mesh before any refinement. */
    std::shared_ptr<const Triangulation<dim>> coarse_cells;

    /** Cells of still coarser meshes, finest first. */
    std::vector<std::shared_ptr<const Triangulation<dim>>> coarser_cells;

    /** Meshes of tetrahedra, the last of which is the one of the body. */
    std::vector<std::shared_ptr<const RedRefinement>> red_refinements;

    /** The mesh of the units, if cells are made only where they are needed. */
    std::shared_ptr<const BodyMesh>            units;
    std::unique_ptr<const UnitRefinement<dim>> refinement;
    std::vector<bool>                          real_cells;
    std::unique_ptr<const UnitNumbers>         unit_numbers;

    std::shared_ptr<const Triangulation<dim>> mesh;
    std::unique_ptr<DoFHandler<dim>>          dofs;
    AffineConstraints<double>                 constraints;
    CellPatches                               cell_patches;
  };

  /** Meshes of all bodies, in the order of the topology. */
  template <int dim>
  using BodyMeshes = std::vector<std::shared_ptr<const BodyMesh<dim>>>;
} // namespace StickSlip

#endif
