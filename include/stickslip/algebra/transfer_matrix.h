// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_transfer_matrix_h
#define stickslip_algebra_transfer_matrix_h

#include <stickslip/algebra/node_partition.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A sparse matrix of scalars that maps nodal values of one set of nodes
   * ("coarse", the columns) to another ("fine", the rows), the same way for
   * each component. It serves as prolongation between levels and as change of
   * basis on one level.
   */
  class TransferMatrix
  {
  public:
    /** One row: local column indices and values. */
    using Row = std::vector<std::pair<unsigned int, double>>;

    TransferMatrix() = default;

    /**
     * Entries of a row with the same column are added up; those below 1e-14
     * in size after that are dropped.
     */
    TransferMatrix(const std::vector<Row> &rows, const unsigned int n_columns);

    static TransferMatrix
    identity(const unsigned int n);

    unsigned int
    n_rows() const;

    unsigned int
    n_columns() const;

    /** The product this * right. */
    TransferMatrix
    operator*(const TransferMatrix &right) const;

    /** fine = P coarse, each node with @p components entries. */
    void
    prolongate(NodalVector       &fine,
               const NodalVector &coarse,
               const unsigned int components) const;

    /** fine += P coarse. */
    void
    prolongate_add(NodalVector       &fine,
                   const NodalVector &coarse,
                   const unsigned int components) const;

    /** coarse = P^T fine. */
    void
    restrict_to(NodalVector       &coarse,
                const NodalVector &fine,
                const unsigned int components) const;

    std::size_t
    memory_consumption() const;

    /** Compressed rows, and the same of the transpose. */
    struct Compressed
    {
      std::vector<unsigned int> row_start = {0};
      std::vector<unsigned int> column;
      std::vector<double>       value;
    };

    const Compressed &
    matrix() const;

    const Compressed &
    transpose() const;

  private:
    Compressed by_row;
    Compressed by_column;
  };
} // namespace StickSlip

#endif
