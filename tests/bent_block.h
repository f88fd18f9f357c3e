// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_bent_block_h
#define stickslip_tests_bent_block_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <stickslip/multigrid/level_hierarchy.h>

#include <cmath>
#include <functional>

#include "random_axes.h"

namespace StickSlip::Tests
{
  /**
   * An elastic block of 2.5 by 0.5 m (2.5 by 0.6 by 0.5 m), held on its upper
   * side; or the block bent to a part of a ring (of a pipe), so that its lower
   * side has the radius 1 m and its middle the length 2.5 m. Levels are found
   * by halving cells. Nodes are counted along the block first, from the lower
   * side to the upper one last.
   */
  template <int dim>
  class BentBlock
  {
  public:
    /** @p cells of the coarsest level along the block and the other axes; all
     * of it is turned by the angle @p tilt from the first axis to the last
     * one. */
    BentBlock(const std::array<unsigned int, dim> &cells,
              const unsigned int                   n_levels,
              const bool                           is_bent,
              const double                         tilt = 0.)
      : n_levels(n_levels)
      , cells(cells)
      , is_bent(is_bent)
      , tilt(tilt)
    {}

    unsigned int
    n_nodes(const unsigned int l) const
    {
      unsigned int n = 1;
      for (unsigned int d = 0; d < dim; ++d)
        n *= (cells[d] << l) + 1;
      return n;
    }

    /** The number of the lower side's nodes, which come first. */
    unsigned int
    n_lower(const unsigned int l) const
    {
      return n_nodes(l) / ((cells[dim - 1] << l) + 1);
    }

    /** Between 0 and 1 in each direction. */
    Point<dim>
    reference_point(const unsigned int l, const unsigned int node) const
    {
      const Index i = index(l, node);
      Point<dim>  point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = double(i[d]) / (cells[d] << l);
      return point;
    }

    /** The axes of a node, tangential to the lower side and normal. */
    Tensor<2, dim>
    axes(const unsigned int l, const unsigned int node) const
    {
      const double   angle = angle_at(reference_point(l, node));
      Tensor<2, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d][d] = 1.;
      result[0][0]             = std::cos(angle);
      result[0][dim - 1]       = std::sin(angle);
      result[dim - 1][0]       = -std::sin(angle);
      result[dim - 1][dim - 1] = std::cos(angle);
      return result;
    }

    /** Axes of the nodes of the lower side on all levels. */
    std::vector<NodeFrames<dim>>
    frames_of_lower_side() const
    {
      std::vector<NodeFrames<dim>> frames(n_levels);
      for (unsigned int l = 0; l < n_levels; ++l)
        for (unsigned int i = 0; i < n_lower(l); ++i)
          frames[l].set(i, axes(l, i));
      return frames;
    }

    /** Random axes for all nodes of all levels, or those with even numbers. */
    std::vector<NodeFrames<dim>>
    random_frames(const bool all) const
    {
      std::mt19937                 engine(3);
      std::vector<NodeFrames<dim>> frames(n_levels);
      for (unsigned int l = 0; l < n_levels; ++l)
        for (unsigned int i = 0; i < n_nodes(l); i += all ? 1 : 2)
          frames[l].set(i, random_axes<dim>(engine));
      return frames;
    }

    /** Fixes components of a node, which has the given number on level l and
     * local index. */
    using Fix = std::function<void(const unsigned int l,
                                   const unsigned int node,
                                   const unsigned int index,
                                   NodeMask          &fixed)>;

    /** A problem with the block's operator. */
    struct Problem
    {
      std::unique_ptr<OperatorSum<dim>>    operators;
      std::unique_ptr<LevelHierarchy<dim>> hierarchy;
    };

    /** The nodes of the lower side are nonsmooth; where @p slides is true,
     * their last component is fixed. */
    Problem
    make(const std::vector<NodeFrames<dim>> &frames,
         const bool                          slides,
         const MPI_Comm                      communicator) const
    {
      return make(
        frames,
        [&](const unsigned int l,
            const unsigned int node,
            const unsigned int index,
            NodeMask          &fixed) {
          if (slides && node < n_lower(l))
            fixed.mask(index, dim - 1);
        },
        communicator);
    }

    /** The nodes of the upper side are held, others as @p fix says. Each
     * process has about as many nodes as others, but all of the coarsest level
     * belong to the first one. */
    Problem
    make(const std::vector<NodeFrames<dim>> &frames,
         const Fix                          &fix,
         const MPI_Comm                      communicator) const
    {
      const NodePartition space = space_nodes(communicator);
      const auto          sparsity =
        std::make_shared<const BlockSparsity>(stencil(space));
      BlockMatrix<dim> K(sparsity);
      assemble(space, K);
      GalerkinProduct<dim> to_frames(space,
                                     *sparsity,
                                     local_rows(space,
                                                [](const unsigned int i) {
                                                  return GlobalRow{{i, 1.}};
                                                }),
                                     space.owned(),
                                     {},
                                     frames.back());
      BlockMatrix<dim>     A(to_frames.coarse_sparsity());
      to_frames.compute(K, NodeMask(space.n_local(), dim), A);

      std::vector<LevelDescription<dim>> levels(n_levels);
      levels.back().nodes                          = to_frames.coarse_nodes();
      levels.back().frames                         = to_frames.coarse_frames();
      std::shared_ptr<const BlockSparsity> of_fine = A.shared_sparsity();
      for (unsigned int l = n_levels - 1; l > 0; --l)
        {
          LevelDescription<dim> &fine = levels[l], &coarse = levels[l - 1];
          fine.to_coarser = std::make_shared<GalerkinProduct<dim>>(
            fine.nodes,
            *of_fine,
            local_rows(fine.nodes,
                       [&](const unsigned int i) {
                         return interpolation(l, i);
                       }),
            owned(l - 1, communicator),
            fine.frames,
            frames[l - 1]);
          coarse.nodes  = fine.to_coarser->coarse_nodes();
          coarse.frames = fine.to_coarser->coarse_frames();
          of_fine       = fine.to_coarser->coarse_sparsity();
        }
      for (unsigned int l = 0; l < n_levels; ++l)
        {
          LevelDescription<dim> &level = levels[l];
          level.fixed                  = NodeMask(level.nodes.n_local(), dim);
          for (unsigned int i = 0; i < level.nodes.n_local(); ++i)
            {
              const unsigned int node = level.nodes.global_index(i);
              if (node >= n_nodes(l) - n_lower(l))
                level.fixed.mask_node(i);
              else
                fix(l, node, i, level.fixed);
              if (node < n_lower(l) && i < level.nodes.n_owned())
                level.nonsmooth_nodes.push_back(i);
            }
        }
      Problem problem;
      problem.operators =
        std::make_unique<OperatorSum<dim>>(levels.back(),
                                           std::vector<TermMatrix<dim>>{A});
      problem.operators->combine({1.});
      problem.hierarchy =
        std::make_unique<LevelHierarchy<dim>>(*problem.operators,
                                              std::move(levels));
      return problem;
    }

    const unsigned int n_levels;

  private:
    using Index = std::array<unsigned int, dim>;

    Index
    index(const unsigned int l, unsigned int node) const
    {
      Index result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int n = (cells[d] << l) + 1;
          result[d]            = node % n;
          node /= n;
        }
      return result;
    }

    unsigned int
    node(const unsigned int l, const Index &index) const
    {
      unsigned int result = 0;
      for (unsigned int d = dim; d-- > 0;)
        result = result * ((cells[d] << l) + 1) + index[d];
      return result;
    }

    double
    angle_at(const Point<dim> &reference_point) const
    {
      return is_bent ? 2. * reference_point[0] : 0.;
    }

    Point<dim>
    in_space(const Point<dim> &reference_point) const
    {
      Point<dim> point;
      if (dim == 3)
        point[1] = 0.6 * reference_point[1];
      const double height = 0.5 * reference_point[dim - 1];
      if (is_bent)
        {
          const double angle = angle_at(reference_point);
          point[0]           = (1. + height) * std::sin(angle);
          point[dim - 1]     = (1. + height) * std::cos(angle);
        }
      else
        {
          point[0]       = 2.5 * reference_point[0];
          point[dim - 1] = height;
        }
      const double x = point[0], y = point[dim - 1];
      point[0]       = std::cos(tilt) * x - std::sin(tilt) * y;
      point[dim - 1] = std::sin(tilt) * x + std::cos(tilt) * y;
      return point;
    }

    /** The nodes within one cell, as far as there are any. */
    std::vector<unsigned int>
    neighbours(const unsigned int l, const unsigned int i) const
    {
      const Index               centre = index(l, i);
      std::vector<unsigned int> result;
      const unsigned int        n_offsets = (dim == 2 ? 9 : 27);
      for (unsigned int offset = 0; offset < n_offsets; ++offset)
        {
          Index        neighbour;
          unsigned int rest      = offset;
          bool         is_inside = true;
          for (unsigned int d = 0; d < dim; ++d, rest /= 3)
            {
              neighbour[d] = centre[d] + rest % 3 - 1;
              // Below zero it is large.
              is_inside = is_inside && neighbour[d] <= (cells[d] << l);
            }
          if (is_inside)
            result.push_back(node(l, neighbour));
        }
      return result;
    }

    /** The values on level l - 1 of which that of a node is the mean. */
    GlobalRow
    interpolation(const unsigned int l, const unsigned int i) const
    {
      const Index fine = index(l, i);
      GlobalRow   row;
      for (unsigned int corner = 0; corner < (1u << dim); ++corner)
        {
          Index  coarse;
          double weight = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int up = (corner >> d) & 1u;
              coarse[d]             = fine[d] / 2 + up;
              if (fine[d] % 2 == 1)
                weight *= 0.5;
              else if (up == 1)
                weight = 0.;
            }
          if (weight > 0.)
            row.emplace_back(node(l - 1, coarse), weight);
        }
      return row;
    }

    IndexSet
    owned(const unsigned int l, const MPI_Comm communicator) const
    {
      const unsigned int n    = n_nodes(l);
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int size = Utilities::MPI::n_mpi_processes(communicator);
      IndexSet           result(n);
      if (l > 0)
        result.add_range(n * rank / size, n * (rank + 1) / size);
      else if (rank == 0)
        result.add_range(0, n);
      return result;
    }

    NodePartition
    space_nodes(const MPI_Comm communicator) const
    {
      const IndexSet own = owned(n_levels - 1, communicator);
      IndexSet       ghosts(own.size());
      for (const auto i : own)
        for (const unsigned int j : neighbours(n_levels - 1, i))
          ghosts.add_index(j);
      ghosts.subtract_set(own);
      return NodePartition(own, ghosts, dim, communicator);
    }

    std::vector<std::vector<unsigned int>>
    stencil(const NodePartition &nodes) const
    {
      std::vector<std::vector<unsigned int>> rows(nodes.n_owned());
      for (unsigned int i = 0; i < nodes.n_owned(); ++i)
        for (const unsigned int j :
             neighbours(n_levels - 1, nodes.global_index(i)))
          rows[i].push_back(nodes.local_index(j));
      return rows;
    }

    template <typename Row>
    static std::vector<GlobalRow>
    local_rows(const NodePartition &nodes, const Row &row)
    {
      std::vector<GlobalRow> rows;
      for (unsigned int i = 0; i < nodes.n_local(); ++i)
        rows.push_back(row(nodes.global_index(i)));
      return rows;
    }

    /** The stiffness matrix in the axes of space; both moduli are one. */
    void
    assemble(const NodePartition &nodes, BlockMatrix<dim> &K) const
    {
      const unsigned int        l = n_levels - 1;
      std::vector<unsigned int> n_cells;
      for (unsigned int d = 0; d < dim; ++d)
        n_cells.push_back(cells[d] << l);
      Point<dim> far_corner;
      for (unsigned int d = 0; d < dim; ++d)
        far_corner[d] = 1.;
      Triangulation<dim> mesh;
      GridGenerator::subdivided_hyper_rectangle(mesh,
                                                n_cells,
                                                Point<dim>(),
                                                far_corner);
      std::vector<unsigned int> number;
      for (const Point<dim> &vertex : mesh.get_vertices())
        {
          Index position;
          for (unsigned int d = 0; d < dim; ++d)
            position[d] = std::lround(vertex[d] * n_cells[d]);
          number.push_back(node(l, position));
        }
      GridTools::transform([&](const Point<dim> &p) { return in_space(p); },
                           mesh);

      const FE_Q<dim> fe(1);
      FEValues<dim>   fe_values(fe,
                              QGauss<dim>(2),
                              update_gradients | update_JxW_values);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          fe_values.reinit(cell);
          for (const unsigned int a : cell->vertex_indices())
            {
              const unsigned int row = number[cell->vertex_index(a)];
              if (!nodes.owned().is_element(row))
                continue;
              for (const unsigned int b : cell->vertex_indices())
                {
                  double *block = K.block(K.sparsity().position(
                    nodes.local_index(row),
                    nodes.local_index(number[cell->vertex_index(b)])));
                  for (const unsigned int q :
                       fe_values.quadrature_point_indices())
                    {
                      const Tensor<1, dim> ga = fe_values.shape_grad(a, q),
                                           gb = fe_values.shape_grad(b, q);
                      for (unsigned int c = 0; c < dim; ++c)
                        for (unsigned int d = 0; d < dim; ++d)
                          block[c * dim + d] += (ga[c] * gb[d] + ga[d] * gb[c] +
                                                 (c == d ? ga * gb : 0.)) *
                                                fe_values.JxW(q);
                    }
                }
            }
        }
    }

    const Index  cells;
    const bool   is_bent;
    const double tilt;
  };
} // namespace StickSlip::Tests

#endif
