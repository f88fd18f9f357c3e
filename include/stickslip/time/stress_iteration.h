// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_time_stress_iteration_h
#define stickslip_time_stress_iteration_h

#include <vector>

namespace StickSlip
{
  /**
   * The fixed-point iteration for the normal stress of friction: with the one
   * that has been tried the bodies press their sides together by the one that
   * is found, which is tried next.
   *
   * Slip of bodies that lean or rock without being held may press the sides
   * together by more than the friction that it takes: each error is followed by
   * a larger one then. Where the changes have not shrunk for a while
   * the one tried next is the combination of the last ones whose changes
   * cancel best (Anderson 1965; the form is that of Walker and Ni 2011).
   */
  class StressIteration
  {
  public:
    /** @p weights: of the nodes, of which sums of squares are formed; must live
     * longer. */
    explicit StressIteration(const std::vector<double> &weights)
      : weights(weights)
    {}

    /** The stress to try next after @p tried, Pa, none negative, has led to @p
     * found; @p change: the size of their difference. */
    std::vector<double>
    next(const std::vector<double> &tried,
         const std::vector<double> &found,
         const double               change);

  private:
    std::vector<double>
    combination(const std::vector<double> &found) const;

    const std::vector<double> &weights;
    bool                       is_slow = false;
    std::vector<double>        changes;
    /** The last ones, newest first: what was found, and less what was tried. */
    std::vector<std::vector<double>> all_found, all_differences;
  };
} // namespace StickSlip

#endif
