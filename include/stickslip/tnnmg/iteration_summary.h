// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_iteration_summary_h
#define stickslip_tnnmg_iteration_summary_h

#include <ostream>
#include <vector>

namespace StickSlip
{
  /**
   * The work and the success of one iteration.
   */
  struct IterationSummary
  {
    /** Decrease of the functional by the smoother and by the linear
     * correction, not negative up to rounding; the latter is zero unless
     * somebody has asked for it, see
     * NonsmoothSolver::find_correction_decrease(). */
    double smoother_decrease   = 0;
    double correction_decrease = 0;

    /** True if the smoother went over all nodes. */
    bool sweeps_everywhere = false;

    /** Energy norms of the change of the iterate and of the iterate. */
    double correction_norm = 0;
    double iterate_norm    = 0;

    /** Components left out of the linearisation. */
    unsigned int n_truncated = 0;

    /** Length of the linear correction, and the slopes evaluated for it. */
    double       step_length             = 0;
    unsigned int line_search_evaluations = 0;

    /** V-cycles spent. */
    unsigned int cycles = 0;

    /** Size of the change relative to the iterate, in the energy norm. */
    double
    relative_correction() const;

    /**
     * Estimate of the error that is left, relative to the iterate, in the
     * energy norm: what a sequence of corrections that go on to shrink by the
     * factor q of the last two adds up to, q / (1 - q) times the last one. That
     * is trusted where q < 0.1 and the correction @p before this was below a
     * tenth of the iterate, and not for q below 0.02, with which a few cycles
     * go on at best; elsewhere, and without a correction before, it is the size
     * of this one.
     */
    double
    relative_error(const IterationSummary *before) const;
  };

  /**
   * The iterations of one solve.
   */
  struct SolveSummary
  {
    bool                          converged = false;
    std::vector<IterationSummary> iterations;

    unsigned int
    n_cycles() const;
  };

  /** A line for each iteration. */
  std::ostream &
  operator<<(std::ostream &out, const SolveSummary &summary);

  std::ostream &
  operator<<(std::ostream &out, const IterationSummary &summary);
} // namespace StickSlip

#endif
