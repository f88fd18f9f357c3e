// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_line_factors_h
#define stickslip_multigrid_line_factors_h

#include <stickslip/algebra/node_mask.h>
#include <stickslip/multigrid/strong_lines.h>

#include <cstdint>
#include <vector>

namespace StickSlip
{
  /**
   * The parts of a symmetric block matrix that belong to lines of nodes, one
   * banded factorisation L D L^T for each of them. Masked components are left
   * out.
   */
  template <int n_components, typename Number>
  class LineFactors
  {
  public:
    LineFactors() = default;

    /** Lines of nodes that are in no two of them. */
    LineFactors(const BlockSparsity         &sparsity,
                const std::vector<NodeLine> &lines);

    unsigned int
    n_lines() const
    {
      return lines.size();
    }

    const NodeLine &
    nodes(const unsigned int l) const
    {
      return lines[l].nodes;
    }

    /** The number of nodes of the longest line. */
    unsigned int
    longest() const;

    /** Take over the blocks of a row that couple a node to earlier ones of its
     * line. */
    template <typename OtherNumber>
    void
    set_row(const unsigned int                            node,
            const BlockMatrix<n_components, OtherNumber> &matrix);

    /** Set the diagonal block of a node of a line, of which only the @p active
     * components take part. */
    void
    set_diagonal(const unsigned int             node,
                 const Tensor<2, n_components> &block,
                 const NodeMask                &active);

    /** Factorise the lines of which something has been set. */
    void
    factorise();

    /** Replace the right hand side at the nodes of a line, one node after the
     * other, by the solution. */
    void
    solve(const unsigned int l, Number *values) const;

    /** Bytes. */
    std::size_t
    memory_consumption() const;

  private:
    static constexpr unsigned int block_size = n_components * n_components;

    using Block = Tensor<2, n_components>;

    struct Line
    {
      NodeLine nodes;
      /** Number of earlier nodes that a node may couple to. */
      unsigned int width = 1;
      /** Of the first block of the band; the row of a node has width of them,
       * for the nodes just before it. */
      std::size_t first_block = 0;
      bool        is_current  = true;
    };

    void
    factorise(const Line &line);

    /** The block of the node at place i in a line and of that k + 1 places
     * before it, in the band of the matrix or of L. */
    std::size_t
    band_position(const Line        &line,
                  const unsigned int i,
                  const unsigned int k) const
    {
      return (line.first_block + std::size_t(i) * line.width + k) * block_size;
    }

    std::vector<Line> lines;
    /** By node: its line, and its place there. */
    std::vector<unsigned int> line, place;
    /** By node: bits of the components that take part, diagonal block of the
     * matrix, inverse of that of D. */
    std::vector<std::uint8_t> components;
    std::vector<Number>       diagonal, inverse_pivot;
    /** The blocks off the diagonal of the matrix and of L. */
    std::vector<Number> band, factor;
  };
} // namespace StickSlip

#endif
