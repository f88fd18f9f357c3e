// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_cycle_operators_h
#define stickslip_multigrid_cycle_operators_h

#include <stickslip/multigrid/block_gauss_seidel.h>
#include <stickslip/multigrid/cut_patches.h>
#include <stickslip/multigrid/level_description.h>
#include <stickslip/multigrid/middle_nodes.h>

#include <vector>

namespace StickSlip
{
  /**
   * The operators of a V-cycle: those of the coarse levels as Galerkin
   * products, formed anew where truncation and the nonsmooth term change them,
   * and all in the form of the smoother, the finest one as a copy. See VCycle,
   * whose functions of the same names these serve.
   *
   * Smoothers relax cells where bodies are nearly incompressible, and
   * transfers move the nodes in the middle of coarse cells.
   */
  template <int n_components, typename Number>
  class CycleOperators
  {
  public:
    /** @p descriptions, the coarsest level first, must outlive the object.
     * Collective, like all functions that compute. */
    CycleOperators(
      const std::vector<LevelDescription<n_components>> &descriptions,
      const std::vector<TermMatrix<n_components>>       &terms);

    void
    set_operator(const OperatorSum<n_components> &A);

    void
    set_finest_diagonal(const unsigned int             i,
                        const Tensor<2, n_components> &block,
                        const NodeMask                &active);

    void
    set_coarse_levels(const BlockMatrix<n_components> &A,
                      const NodeMask                  &active,
                      const std::vector<unsigned int> &changed);

    /** Factorise the lines and patches that have changed, before a cycle. */
    void
    factorise_smoothers();

    std::vector<std::vector<unsigned int>>
    formed_rows() const;

    void
    recall_coarse_levels(const BlockMatrix<n_components>              &A,
                         const NodeMask                               &active,
                         const std::vector<std::vector<unsigned int>> &formed);

    /** The smoother of any level but the coarsest. */
    const BlockGaussSeidel<n_components, Number> &
    smoother(const unsigned int l) const;

    /** The patches of the smoother that several processes share. */
    const CutPatches<n_components, Number> &
    cut_patches(const unsigned int l) const;

    /** The part of the transfer to the level below @p l that is not one number
     * for each pair of nodes. */
    const MiddleNodes<n_components> &
    middle_nodes(const unsigned int l) const;

    /** The operator on a coarse level. */
    const BlockMatrix<n_components, Number> &
    coarse_matrix(const unsigned int l) const;

    /** The sum of the terms on a coarse level. */
    void
    combine_coarse(const unsigned int                 l,
                   const std::vector<double>         &coefficients,
                   BlockMatrix<n_components, Number> &sum) const;

    /** The diagonal block of a row of that sum. */
    Tensor<2, n_components>
    combine_coarse_diagonal(const unsigned int         l,
                            const std::vector<double> &coefficients,
                            const unsigned int         row) const;

    /** The components that take part on a coarse level. */
    const NodeMask &
    active(const unsigned int l) const;

    /** Bytes on this process. */
    std::size_t
    memory_consumption() const;

  private:
    struct Level
    {
      BlockGaussSeidel<n_components, Number> smoother;
      CutPatches<n_components, Number>       cuts;
      StiffVolumes                           stiff_volumes;
      /** Of the transfer to the next coarser level. */
      MiddleNodes<n_components> middles;

      /** Terms, and all that follows, of coarse levels only. */
      std::vector<BlockMatrix<n_components, Number>> terms;
      BlockMatrix<n_components, Number>              matrix;
      /** On several processes: the owned rows that a change of the
       * nonsmooth term or of the truncation can touch. */
      std::vector<unsigned int> strip;
      /** On one process: rows formed since the operator was set. */
      std::vector<bool> formed;
      NodeMask          active;
    };

    /** Set the smoother of level @p l, with the lines or patches that its @p
     * terms and stiff volumes have, and its middle nodes. */
    template <typename Matrix>
    void
    set_up_level(const unsigned int l, const std::vector<Matrix> &terms);

    /** The terms on the level below @p l. */
    template <typename FineMatrix>
    void
    compute_coarser_terms(const unsigned int             l,
                          const std::vector<FineMatrix> &fine_terms);

    /** @p sparsity is that of the finest level. */
    void
    find_strips(const BlockSparsity &sparsity);

    /** The operator on the level below @p l from that on it, where that has
     * changed; replaces the @p changed rows by those of the coarser
     * level. */
    template <typename FineNumber>
    void
    set_coarser_level(const unsigned int                           l,
                      const BlockMatrix<n_components, FineNumber> &matrix,
                      const NodeMask                              &active,
                      std::vector<unsigned int>                   &changed);

    /** Take over rows of a coarse level that have been formed. */
    void
    set_smoother(const unsigned int l, const std::vector<unsigned int> &rows);

    /** Form rows of the operator on the level below @p l, at least those
     * that depend on the @p changed ones; returns which. */
    template <typename FineNumber>
    std::vector<unsigned int>
    form_coarse_rows(const unsigned int                           l,
                     const BlockMatrix<n_components, FineNumber> &matrix,
                     const NodeMask                              &active,
                     const std::vector<unsigned int>             &changed);

    const std::vector<LevelDescription<n_components>> &descriptions;
    /** True on several processes. */
    const bool is_shared;
    /** True if there are stiff volumes on any process. */
    bool               has_stiff_volumes;
    std::vector<Level> levels;
  };
} // namespace StickSlip

#endif
