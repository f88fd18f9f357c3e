// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_level_hierarchy_h
#define stickslip_multigrid_level_hierarchy_h

#include <stickslip/multigrid/kept_linearisation.h>
#include <stickslip/multigrid/v_cycle.h>

#include <vector>

namespace StickSlip
{
  /**
   * A multigrid preconditioner for operators
   *
   *   S (A + H) S,
   *
   * where A is an OperatorSum, H the second derivative of a nonsmooth
   * functional, block diagonal at the nonsmooth nodes, and S sets the fixed and
   * the truncated components to zero. Coarse operators are Galerkin products.
   * Products of the terms of A are formed once, with the first linearisation;
   * new coefficients cost a linear combination on each level, a new H or S the
   * products of the rows near the nonsmooth nodes where it changes; on several
   * processes, near all of them.
   *
   * All member functions that compute are collective. The coarsest level must
   * belong to one process.
   */
  template <int n_components>
  class LevelHierarchy
  {
  public:
    /** The coarsest level first, the unknowns of @p operators last, which must
     * outlive this object. */
    LevelHierarchy(OperatorSum<n_components>                  &operators,
                   std::vector<LevelDescription<n_components>> descriptions);

    LevelHierarchy(const LevelHierarchy &) = delete;

    LevelHierarchy &
    operator=(const LevelHierarchy &) = delete;

    /** Bring all levels in line with A, without H and truncation, if it is
     * another one than before. linearise() does this itself. */
    void
    take_over_operator();

    /**
     * Set H, one block for each nonsmooth node of the finest level, and the
     * components that take part in the linear problem (none of the fixed
     * ones), for the present operator A. The coarse levels, which only
     * precondition, may keep an earlier H, see set_coarse_update_threshold().
     * Throws SingularCoarseMatrix; A is as before then.
     */
    void
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active);

    /** The parts of linearise(), between which processes agree: set H and S on
     * the finest level, and return whether the coarse levels of this process
     * are out of date; then update them if those of any process are. */
    bool
    linearise_finest_level(const std::vector<Tensor<2, n_components>> &hessians,
                           const NodeMask                             &active);

    void
    linearise_coarse_levels(const bool are_outdated);

    /** The linearisation on the coarse levels; empty before the first. */
    KeptLinearisation<n_components>
    kept_linearisation() const;

    /** Set the coarse levels as @p kept by another hierarchy of the same levels
     * and operators, for the present operator A. */
    void
    recall(const KeptLinearisation<n_components> &kept);

    /** x = approximation of (S (A + H) S)^-1 b by one V-cycle, symmetric.
     * @p size: about that of the entries of b, on all processes; without it
     * they look for the largest one. */
    void
    v_cycle(NodalVector &x, const NodalVector &b);

    void
    v_cycle(NodalVector &x, const NodalVector &b, const double size);

    /** y = S (A + H) S x for x = S x. */
    void
    vmult_linearised(NodalVector &y, const NodalVector &x) const;

    /** The operator A and its terms. */
    OperatorSum<n_components> &
    operators() const
    {
      return A;
    }

    const LevelDescription<n_components> &
    finest() const
    {
      return levels.back();
    }

    const LevelDescription<n_components> &
    description(const unsigned int l) const
    {
      return levels[l];
    }

    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    /** A copy of the operator on level @p l; below the finest one that of the
     * last linearisation near the nonsmooth nodes. linearise() comes first. */
    BlockMatrix<n_components>
    level_matrix(const unsigned int l) const;

    /** The operator A on level @p l, without H and truncation.
     * take_over_operator() comes first. */
    BlockMatrix<n_components>
    operator_on_level(const unsigned int l) const;

    /** The diagonal block of a row of that. */
    Tensor<2, n_components>
    diagonal_on_level(const unsigned int l, const unsigned int row) const;

    /** Number of sweeps before and after the coarse grid correction. */
    void
    set_smoothing_sweeps(const unsigned int sweeps);

    /** The coarse levels are given those blocks of H anew that have changed by
     * more than this fraction since the last time; 0, from the start:
     * always. */
    void
    set_coarse_update_threshold(const double threshold);

    /** The solver of the coarsest level; factorisation from the start. Asks
     * for a new linearisation if this is another one, like the next. */
    void
    set_coarse_solver(const CoarseSolverType type);

    /** The precision of the cycle; single from the start. */
    void
    set_cycle_precision(const CyclePrecision precision);

    /** Bytes on this process, of the operator A as well. */
    std::size_t
    memory_consumption() const;

  private:
    /** Positions of the nonsmooth nodes whose truncation is another one on the
     * coarse levels, or whose part in H differs by more than this fraction. */
    std::vector<unsigned int>
    outdated_on_coarse_levels(const double threshold) const;

    /** The coarsest level must be exact where it is the only one. */
    double
    update_threshold() const
    {
      return levels.size() > 1 ? coarse_update_threshold : 0.;
    }

    /** Bring these up to date there. */
    void
    form_coarse_levels(const std::vector<unsigned int> &outdated);

    OperatorSum<n_components>                  &A;
    std::vector<LevelDescription<n_components>> levels;

    unsigned int                          sweeps = 1;
    CoarseSolverType                      coarse_solver;
    CyclePrecision                        precision;
    std::unique_ptr<VCycle<n_components>> cycle;
    /** The operator in the cycle. */
    unsigned long       version = 0;
    std::vector<double> coefficients;

    bool                                 is_linearised = false;
    std::vector<Tensor<2, n_components>> current_hessians;
    NodeMask                             active;

    /** The linearisation on the coarse levels. */
    std::vector<Tensor<2, n_components>> coarse_hessians;
    NodeMask                             coarse_active;
    double                               coarse_update_threshold = 0;
    /** True once the coarsest level has been factorised as well. */
    bool coarse_levels_set = false;
  };
} // namespace StickSlip

#endif
