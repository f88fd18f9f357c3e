// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_sweep_triangles_h
#define stickslip_multigrid_sweep_triangles_h

#include <deal.II/base/aligned_vector.h>

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/sweep_kernels.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The owned rows of a block matrix as a sweep of Gauss-Seidel reads them
   * (sweep_kernels.h): couplings to nodes that come earlier in the sweep below
   * the diagonal, those to nodes that come later above it, apart from each
   * other. Couplings between nodes that are relaxed at once, a diagonal block
   * among them, are in neither.
   */
  template <int n_components, typename Number>
  class SweepTriangles
  {
  public:
    SweepTriangles() = default;

    /** @p order: when each local node comes in the sweep, the same for those
     * that are relaxed at once; if it is empty, nodes come by their number.
     * Couplings to a ghost are read where the order says, too. */
    explicit SweepTriangles(
      const std::shared_ptr<const BlockSparsity> &sparsity,
      const std::vector<std::uint64_t>           &order = {});

    unsigned int
    n_rows() const
    {
      return first_above.size();
    }

    /** Take over the blocks of a row. */
    template <typename OtherNumber>
    void
    set_row(const unsigned int                            i,
            const BlockMatrix<n_components, OtherNumber> &matrix);

    Kernels::Triangle<Number>
    below() const;

    Kernels::Triangle<Number>
    above() const;

    /** The block of row i and a node j that comes earlier, as the kernels store
     * it. */
    const Number *
    block_below(const unsigned int i, const unsigned int j) const;

    /** Bytes, without the sparsity, which is shared. */
    std::size_t
    memory_consumption() const;

  private:
    static constexpr unsigned int block_size = n_components * n_components;

    struct Part
    {
      std::vector<unsigned int> row_start = {0};
      AlignedVector<Number>     values;

      unsigned int
      n_entries(const unsigned int row) const
      {
        return row_start[row + 1] - row_start[row];
      }

      /** The first number of a row. */
      const Number *
      row(const unsigned int i) const
      {
        return values.data() + std::size_t(row_start[i]) * block_size;
      }
    };

    /** The columns of all rows, in each of them those below first and those
     * above last. */
    const std::vector<unsigned int> &
    columns() const
    {
      return sorted_columns.empty() ? sparsity->column : sorted_columns;
    }

    std::shared_ptr<const BlockSparsity> sparsity;
    /** Empty if the columns of the sparsity are in this order. */
    std::vector<unsigned int> sorted_columns;
    Part                      lower, upper;
    /** For each row the position of its first column above. */
    std::vector<unsigned int> first_above;
  };
} // namespace StickSlip

#endif
