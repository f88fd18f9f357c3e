// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_block_gauss_seidel_h
#define stickslip_multigrid_block_gauss_seidel_h

#include <stickslip/multigrid/line_factors.h>
#include <stickslip/multigrid/patch_factors.h>
#include <stickslip/multigrid/sweep_turns.h>

namespace StickSlip
{
  /**
   * Block Gauss-Seidel as the smoother of a multigrid cycle: the owned rows of
   * a block matrix, and the inverses of the diagonal blocks of the components
   * that take part. Components that do not are zero in every result, and must
   * be zero in every start.
   *
   * If there are lines of strongly coupled nodes (strong_lines.h), all nodes
   * of a line are relaxed at once. If there are patches (volume_cells.h), which
   * may overlap, a sweep takes patch after patch, and the residual after it is
   * a passage through the matrix of its own.
   *
   * Processes take turns where their nodes couple (sweep_turns.h), so that a
   * sweep is one of the whole matrix; patches that have nodes of several
   * processes are those of CutPatches.
   */
  template <int n_components, typename Number>
  class BlockGaussSeidel
  {
  public:
    BlockGaussSeidel() = default;

    /** Nodes that are in none of the @p lines or @p patches, of which one are
     * empty, are relaxed alone. Collective; nodes that have not been set are of
     * one process alone. */
    explicit BlockGaussSeidel(
      const std::shared_ptr<const BlockSparsity> &sparsity,
      const std::vector<NodeLine>                &lines   = {},
      const std::vector<NodePatch>               &patches = {},
      const NodePartition                        &nodes   = NodePartition());

    bool
    has_lines() const
    {
      return line_factors.n_lines() > 0;
    }

    bool
    has_patches() const
    {
      return patch_factors.n_patches() > 0;
    }

    /** Factorise the lines and patches that have changed, before the next
     * sweep. */
    void
    factorise();

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

    /** x after a forward sweep from zero, with its ghosts, and the residual
     * r = b - A x, not masked. */
    void
    sweep_from_zero(NodeValues<Number> &x, const NodeValues<Number> &b) const;

    void
    residual_after_first_sweep(NodeValues<Number>       &r,
                               const NodeValues<Number> &x,
                               const NodeValues<Number> &b) const;

    /** A forward sweep from any x, whose ghosts it fetches, after which
     * @p change is the change of x; both have ghosts. */
    void
    sweep_forward(NodeValues<Number>       &x,
                  NodeValues<Number>       &change,
                  const NodeValues<Number> &b) const;

    /** r = b - A x after sweep_forward() with this @p change. */
    void
    residual_after_sweep(NodeValues<Number>       &r,
                         const NodeValues<Number> &x,
                         const NodeValues<Number> &change,
                         const NodeValues<Number> &b) const;

    /** r = b - A x in some rows, with the ghosts that x has; with patches. */
    void
    residual_in_rows(const std::vector<unsigned int> &rows,
                     NodeValues<Number>              &r,
                     const NodeValues<Number>        &x,
                     const NodeValues<Number>        &b) const;

    /** A backward sweep; fetches the ghosts of x. */
    void
    sweep_backward(NodeValues<Number> &x, const NodeValues<Number> &b) const;

    std::size_t
    memory_consumption() const;

  private:
    /** Call @p relax with the first unit of a range and that behind the last,
     * turn after turn or from the last to the first, and fetch the ghosts of x
     * after each, but those of the first turn after a backward sweep. */
    template <typename Relax>
    void
    for_each_range(const bool                is_forward,
                   const NodeValues<Number> &x,
                   const Relax              &relax) const;

    /** Call @p relax with unit after unit. */
    template <typename Relax>
    void
    for_each_unit(const bool                is_forward,
                  const NodeValues<Number> &x,
                  const Relax              &relax) const;

    /** Relax all units with the values of the others as they are. */
    void
    sweep(const bool                is_forward,
          NodeValues<Number>       &x,
          const NodeValues<Number> &b) const;

    /** Relax a line with the values of all others as they are. */
    void
    relax_line(const unsigned int        l,
               const NodeValues<Number> &b,
               NodeValues<Number>       &x) const;

    /** x at the nodes of a line from the remainder. */
    void
    solve_line(const unsigned int l, NodeValues<Number> &x) const;

    /** Relax a patch with the values of all others as they are. */
    void
    relax_patch(const unsigned int        p,
                const NodeValues<Number> &b,
                NodeValues<Number>       &x) const;

    /** Write (b - A x)_i for @p n rows one after the other to @p s; with
     * patches. */
    void
    residual_of(const unsigned int       *rows,
                const unsigned int        n,
                const NodeValues<Number> &b,
                const NodeValues<Number> &x,
                Number                   *s) const;

    SweepTriangles<n_components, Number> triangles;
    SweepTurns                           turns;
    /** Of nodes that are relaxed alone, without lines and patches. */
    AlignedVector<Number> inverse_diagonal;
    /** With lines or patches, those of one node among them, in the order of
     * the sweep. */
    LineFactors<n_components, Number>  line_factors;
    PatchFactors<n_components, Number> patch_factors;
    /** The right hand side of a line or a patch. */
    mutable std::vector<Number> remainder;
  };
} // namespace StickSlip

#endif
