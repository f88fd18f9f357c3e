// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_block_gauss_seidel_h
#define stickslip_multigrid_block_gauss_seidel_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/sweep_kernels.h>
#include <stickslip/multigrid/line_factors.h>

namespace StickSlip
{
  /**
   * Block Gauss-Seidel as the smoother of a multigrid cycle: the owned rows of
   * a block matrix, stored as sweep_kernels.h wants them, with the inverses of
   * the diagonal blocks of the components that take part. Components that do
   * not are zero in every result, and must be zero in every start.
   *
   * If there are lines of strongly coupled nodes (strong_lines.h), all nodes
   * of a line are relaxed at once, and "below the diagonal" are couplings to
   * nodes and lines that come earlier; without lines nothing of this is there.
   *
   * On several processes each acts on its own nodes, with the values of the
   * others as they were before the sweep.
   */
  template <int n_components, typename Number>
  class BlockGaussSeidel
  {
  public:
    BlockGaussSeidel() = default;

    explicit BlockGaussSeidel(const BlockSparsity         &sparsity,
                              const std::vector<NodeLine> &lines = {});

    /** Return if there are lines; then set_diagonal() is what sets diagonal
     * blocks, not set_inverse_diagonal(). */
    bool
    has_lines() const
    {
      return factors.n_lines() > 0;
    }

    /** Factorise the lines that have changed, before the next sweep. */
    void
    factorise_lines();

    /** Take over the blocks of a row off the diagonal. */
    template <typename OtherNumber>
    void
    set_row(const unsigned int                            i,
            const BlockMatrix<n_components, OtherNumber> &matrix);

    /** Set the diagonal block of a row, of which only the @p active components
     * are used. */
    void
    set_diagonal(const unsigned int             i,
                 const Tensor<2, n_components> &block,
                 const NodeMask                &active);

    /** Set it by the inverse of its active part. */
    void
    set_inverse_diagonal(const unsigned int             i,
                         const Tensor<2, n_components> &inverse);

    /** x after a forward sweep from zero, and the residual r = b - A x, not
     * masked. The first of these is without communication, the second fetches
     * the ghosts of x. */
    void
    sweep_from_zero(NodeValues<Number> &x, const NodeValues<Number> &b) const;

    void
    residual_after_first_sweep(NodeValues<Number>       &r,
                               const NodeValues<Number> &x) const;

    /** A forward sweep from any x, after which @p change is the change of x,
     * with its ghosts. */
    void
    sweep_forward(NodeValues<Number>       &x,
                  NodeValues<Number>       &change,
                  const NodeValues<Number> &b) const;

    /** r = b - A x after sweep_forward() with this @p change. */
    void
    residual_after_sweep(NodeValues<Number>       &r,
                         const NodeValues<Number> &change) const;

    /** A backward sweep; fetches the ghosts of x. */
    void
    sweep_backward(NodeValues<Number> &x, const NodeValues<Number> &b) const;

    std::size_t
    memory_consumption() const;

  private:
    struct Part
    {
      std::vector<unsigned int> row_start = {0};
      std::vector<unsigned int> column;
      AlignedVector<Number>     values;

      Kernels::Triangle<Number>
      rows() const;

      /** The first block of a row. */
      Number *
      first_of(const unsigned int row);

      std::size_t
      memory_consumption() const;
    };

    /** The part of a coupling, empty if it belongs to a diagonal block or a
     * line. */
    Part *
    part_of(const unsigned int row, const unsigned int column);

    /** Relax a line with the values of all others as they are. */
    void
    relax_line(const unsigned int        l,
               const NodeValues<Number> &b,
               NodeValues<Number>       &x) const;

    /** x at its nodes from the remainder. */
    void
    solve_line(const unsigned int l, NodeValues<Number> &x) const;

    unsigned int          n_rows = 0;
    Part                  lower, upper;
    AlignedVector<Number> inverse_diagonal;
    /** With lines, those of one node among them, in the order of the sweep. */
    LineFactors<n_components, Number> factors;
    /** The right hand side of a line. */
    mutable std::vector<Number> remainder;
  };

} // namespace StickSlip

#endif
