// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_transfer_matrix_h
#define stickslip_algebra_transfer_matrix_h

#include <stickslip/algebra/node_frames.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A row of a sparse matrix of scalars between nodes, in global numbers of the
   * columns.
   */
  using GlobalRow = std::vector<std::pair<types::global_dof_index, double>>;

  /**
   * A sparse matrix of scalars that maps nodal values of one set of nodes
   * ("coarse", the columns) to another ("fine", the rows), the same way for
   * each component. It serves as prolongation between levels and as change of
   * basis on one level.
   *
   * Where nodes have axes of their own, R_f those of fine nodes and R_c those
   * of coarse ones, P maps vectors in space, and what is applied to the
   * components of the nodes is
   *
   *   T = R_f^T P R_c,
   *
   * with the same scalars: P and rotations are kept apart.
   *
   * A process holds the rows of its owned fine nodes and, where products with
   * matrices are to be formed, those of its ghosts; the columns are the owned
   * coarse nodes and their ghosts.
   */
  class TransferMatrix
  {
  public:
    TransferMatrix() = default;

    /**
     * @p rows: one for each local fine node, or for the owned ones only, in
     * local order. Entries of a row with the same column are added up; those
     * below 1e-14 in size after that are dropped. @p row_frames and
     * @p column_frames: axes of the nodes of @p fine and @p coarse.
     */
    TransferMatrix(const std::vector<GlobalRow> &rows,
                   const NodePartition          &fine,
                   const NodePartition          &coarse,
                   const LocalFrames            &row_frames    = {},
                   const LocalFrames            &column_frames = {});

    /** Number of rows, those of ghosts included. */
    unsigned int
    n_rows() const;

    unsigned int
    n_columns() const;

    /** fine = T coarse, each node with @p components entries. This and the next
     * two are collective among neighbours. */
    template <typename Number>
    void
    prolongate(NodeValues<Number>       &fine,
               const NodeValues<Number> &coarse,
               const unsigned int        components) const;

    /** fine += T coarse. */
    template <typename Number>
    void
    prolongate_add(NodeValues<Number>       &fine,
                   const NodeValues<Number> &coarse,
                   const unsigned int        components) const;

    /** coarse = T^T fine. */
    template <typename Number>
    void
    restrict_to(NodeValues<Number>       &coarse,
                const NodeValues<Number> &fine,
                const unsigned int        components) const;

    /** Bytes on this process, without the axes of nodes, which are shared. */
    std::size_t
    memory_consumption() const;

    /** Compressed rows. */
    struct Compressed
    {
      std::vector<unsigned int> row_start = {0};
      std::vector<unsigned int> column;
      std::vector<double>       value;
    };

    /** Rows begin <= i < end, of which products are made in the same way. */
    struct RowRange
    {
      enum Kind
      {
        /** Sums over the entries. */
        summed,
        /** Values of the columns from @p column on: a change of basis
         * leaves most nodes as they are. */
        copied,
        /** A row that depends on axes of nodes. */
        turned
      };

      unsigned int begin, end;
      Kind         kind;
      unsigned int column = 0;
    };

    /** The scalars P. */
    const Compressed &
    matrix() const
    {
      return by_row;
    }

    /** The transpose of the rows of owned fine nodes. */
    const Compressed &
    transpose() const
    {
      return by_column;
    }

    /** The axes of the fine nodes. */
    const LocalFrames &
    row_frames() const
    {
      return frames_of_rows;
    }

    /** The axes of the coarse nodes. */
    const LocalFrames &
    column_frames() const
    {
      return frames_of_columns;
    }

  private:
    void
    append_row(const GlobalRow &row, const NodePartition &coarse);

    unsigned int n_owned_rows = 0;
    Compressed   by_row;
    Compressed   by_column;
    LocalFrames  frames_of_rows;
    LocalFrames  frames_of_columns;
    /** Rows of P and of its transpose by what their products take. */
    std::vector<RowRange> row_ranges, column_ranges;
  };
} // namespace StickSlip

#endif
