// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_level_hierarchy_h
#define stickslip_multigrid_level_hierarchy_h

#include <stickslip/multigrid/v_cycle.h>

#include <map>
#include <vector>

namespace StickSlip
{
  /**
   * The levels of a multigrid method for operators
   *
   *   A = sum_k coefficients[k] * terms[k],    plus S (A + H) S,
   *
   * where H is the second derivative of a nonsmooth functional, block diagonal
   * at the nonsmooth nodes, and S sets the masked and the truncated components
   * to zero. Coarse operators are Galerkin products. Those of the terms are
   * computed once, when the first cycle is prepared; a change of the
   * coefficients costs a linear combination on each level, a change of H or S
   * the products of the rows near the nonsmooth nodes where it happens; on
   * several processes, near all of them.
   *
   * All member functions that compute are collective. Gauss-Seidel acts on the
   * nodes of each process, with the values of the others as they were before
   * the sweep. The coarsest level must belong to one process.
   */
  template <int n_components>
  class LevelHierarchy
  {
  public:
    /** The coarsest level first. */
    explicit LevelHierarchy(
      std::vector<LevelDescription<n_components>> descriptions);

    LevelHierarchy(const LevelHierarchy &) = delete;

    LevelHierarchy &
    operator=(const LevelHierarchy &) = delete;

    /** The terms on the finest level; all share one sparsity. */
    void
    set_terms(std::vector<BlockMatrix<n_components>> terms);

    /**
     * Replace the levels by others of the same sizes, and the terms. Where the
     * products of the levels are updates of the present ones, only their
     * updated rows are computed.
     */
    void
    update(std::vector<LevelDescription<n_components>> new_levels,
           std::vector<BlockMatrix<n_components>>      new_terms);

    /** Give a term away, so that its memory is free before the next one is
     * replaced. Until update() there is no operator then. */
    BlockMatrix<n_components>
    release_term(const unsigned int k);

    /** Set the operator A. */
    void
    combine(const std::vector<double> &coefficients);

    /**
     * Set H, one block for each nonsmooth node of the finest level, and the
     * components that take part in the linear problem (none of the fixed
     * ones). The coarse levels, which only precondition, may keep an earlier H,
     * see set_coarse_update_threshold(). Throws SingularCoarseMatrix; the
     * operator A is as before then.
     */
    void
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active);

    /** x = approximation of (S (A + H) S)^-1 b by one V-cycle, symmetric. */
    void
    v_cycle(NodalVector &x, const NodalVector &b);

    /** y = S (A + H) S x for x = S x. */
    void
    vmult_linearised(NodalVector &y, const NodalVector &x) const;

    /** The operator A on the finest level. */
    const BlockMatrix<n_components> &
    matrix() const;

    /** A number for the operator A: another one for other terms or
     * coefficients, the same again where the coefficients return. */
    unsigned long
    operator_version() const;

    /** One of the terms on the finest level. */
    const BlockMatrix<n_components> &
    term(const unsigned int k) const;

    /** Inverses of the diagonal blocks on the finest level, restricted to the
     * components that are not fixed; n_components * n_components numbers a
     * node. Of no meaning at nonsmooth nodes. */
    const AlignedVector<double> &
    inverse_diagonal() const;

    const LevelDescription<n_components> &
    finest() const;

    const LevelDescription<n_components> &
    description(const unsigned int l) const;

    /** A copy of the operator on level @p l; below the finest one that of the
     * last linearisation near the nonsmooth nodes. linearise() comes first. */
    BlockMatrix<n_components>
    level_matrix(const unsigned int l) const;

    unsigned int
    n_levels() const;

    /** Number of sweeps before and after the coarse grid correction. */
    void
    set_smoothing_sweeps(const unsigned int sweeps);

    /** The coarse levels are given those blocks of H anew that have changed by
     * more than this fraction since the last time; 0, from the start:
     * always. */
    void
    set_coarse_update_threshold(const double threshold);

    /** How the coarsest level is solved; by factorisation from the start. Asks
     * for a new linearisation if this is another one, like the next. */
    void
    set_coarse_solver(const CoarseSolverType type);

    /** The precision of the cycle; single from the start. */
    void
    set_cycle_precision(const CyclePrecision precision);

    /** Number of V-cycles since the construction. */
    unsigned long
    n_cycles() const;

    /** Bytes on this process. */
    std::size_t
    memory_consumption() const;

  private:
    /** Make the cycle with all that it needs of the terms. */
    void
    prepare_cycle();

    /** The operator A in the rows begin <= i < end. */
    void
    combine_rows(const unsigned int begin, const unsigned int end);

    /** The coarse levels have no H and no truncation any more. */
    void
    forget_linearisation();

    /** Positions of the nonsmooth nodes whose truncation is another one on the
     * coarse levels, or whose part in H differs by more than this fraction. */
    std::vector<unsigned int>
    outdated_on_coarse_levels(const double threshold) const;

    /** Bring these up to date there. */
    void
    linearise_coarse_levels(const std::vector<unsigned int> &outdated);

    bool
    on_all_processes(const bool condition) const;

    std::vector<LevelDescription<n_components>> levels;
    std::vector<BlockMatrix<n_components>>      terms;
    BlockMatrix<n_components>                   A;
    AlignedVector<double>                       inverse_diagonals;
    NodeMask                                    active;

    CoarseSolverType coarse_solver = CoarseSolverType::direct;
    CyclePrecision   precision     = CyclePrecision::single_precision;
    std::unique_ptr<VCycle<n_components>> cycle;
    std::vector<double>                   current_coefficients;
    /** By the coefficients, for the present terms. */
    std::map<std::vector<double>, unsigned long> versions;
    unsigned long                                last_version = 0;
    std::vector<Tensor<2, n_components>>         current_hessians;
    /** What the coarse levels have been given. */
    std::vector<Tensor<2, n_components>> coarse_hessians;
    NodeMask                             coarse_active;
    double                               coarse_update_threshold = 0;
    bool                                 is_linearised           = false;
    /** Whether the coarsest level has been factorised as well. */
    bool          coarse_levels_set = false;
    unsigned int  sweeps            = 1;
    unsigned long cycle_count       = 0;
  };

  /** y += factor H x with H block diagonal at the @p nodes. */
  template <int n_components>
  void
  add_hessians(NodalVector                                &y,
               const double                                factor,
               const std::vector<unsigned int>            &nodes,
               const std::vector<Tensor<2, n_components>> &hessians,
               const NodalVector                          &x);
} // namespace StickSlip

#endif
