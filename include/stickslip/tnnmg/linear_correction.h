// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_linear_correction_h
#define stickslip_tnnmg_linear_correction_h

#include <stickslip/multigrid/level_hierarchy.h>
#include <stickslip/tnnmg/solver_parameters.h>

namespace StickSlip
{
  /**
   * An exact or approximate solution x of the linearised problem
   *
   *   S (A + H) S x = S r,
   *
   * with the operator A of an OperatorSum, the second derivative H of a
   * nonsmooth functional, block diagonal at the nonsmooth nodes, and S, which
   * sets the components that do not take part to zero.
   *
   * All member functions are collective. What processes have to agree on comes
   * from the caller, who has other sums to form.
   */
  template <int n_components>
  class LinearCorrection
  {
  public:
    virtual ~LinearCorrection() = default;

    /**
     * Announce the first correction of a new problem. Iterations far from the
     * solution or from a good prediction may then take less than later ones.
     */
    virtual void
    start()
    {}

    /**
     * Set H, one block for each nonsmooth node of the finest level, and the
     * components that take part, of owned nodes (none of the fixed ones).
     * Returns whether this process has something to bring up to date in
     * solve(). Throws SingularMatrix; A is as before then.
     */
    virtual bool
    linearise(const std::vector<Tensor<2, n_components>> &hessians,
              const NodeMask                             &active) = 0;

    /**
     * Find @p x and its product @p A_x with A alone, in all components of the
     * owned nodes. @p r holds S r at first, of @p norm on all processes, and is
     * work space after that. @p is_outdated: what linearise() has returned on
     * any process. Returns the multigrid cycles, applications of a
     * preconditioner or direct solves spent. Throws SingularMatrix; A is as
     * before then.
     */
    virtual unsigned int
    solve(NodalVector &x,
          NodalVector &A_x,
          NodalVector &r,
          const double norm,
          const bool   is_outdated) = 0;

    /** Linearisations kept for later problems, see NonsmoothSolver. */
    virtual std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const
    {
      return {};
    }

    virtual void
    recall(const KeptLinearisation<n_components> &)
    {}

    /** The hierarchy on whose coarse levels a problem may begin, see
     * add_coarse_minimiser(); null without one. */
    virtual LevelHierarchy<n_components> *
    hierarchy_to_begin_on()
    {
      return nullptr;
    }
  };

  /**
   * The correction that the parameters ask for; they and the hierarchy must
   * live longer than the result. Throws where this correction does not run on
   * as many processes.
   */
  template <int n_components>
  std::unique_ptr<LinearCorrection<n_components>>
  make_linear_correction(LevelHierarchy<n_components> &hierarchy,
                         const TNNMGParameters        &parameters);

  /** Return whether a correction runs on one process only. */
  bool
  is_serial(const LinearCorrectionType type);
} // namespace StickSlip

#endif
