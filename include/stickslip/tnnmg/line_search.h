// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tnnmg_line_search_h
#define stickslip_tnnmg_line_search_h

#include <functional>

namespace StickSlip
{
  /**
   * The outcome of a line search.
   */
  struct LineSearchResult
  {
    double       step_length = 0;
    unsigned int evaluations = 0;
  };

  /**
   * Step length along a direction of descent of a convex function, from its
   * directional derivative @p slope at step lengths in [0, 1], which is
   * @p at_start at 0 and @p at_end at 1: the values of
   * the function itself drown in rounding near the minimum.
   *
   * Returns 1 if the function still decreases there, else a length at which
   * it has not begun to increase and where the slope has fallen to a tenth of
   * that at 0, or the minimum is bracketed to rounding. Since the slope of a
   * convex function is monotone, every returned length decreases the
   * function; it is 0 if the direction is none of descent.
   */
  LineSearchResult
  find_step_length(const std::function<double(double)> &slope,
                   const double                         at_start,
                   const double                         at_end);
} // namespace StickSlip

#endif
