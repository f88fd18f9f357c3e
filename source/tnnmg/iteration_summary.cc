// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/iteration_summary.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The factor by which corrections shrink from one to the next, or 1 if
     * nothing tells that they do, see IterationSummary::relative_error(). */
    double
    reduction(const IterationSummary *before, const IterationSummary &last)
    {
      constexpr double small = 0.1, fast = 0.1, fastest = 0.02;
      // Written so that a NaN and zero over zero make no difference.
      if (before && before->relative_correction() < small &&
          last.correction_norm < fast * before->correction_norm)
        return std::max(last.correction_norm / before->correction_norm,
                        fastest);
      return 1.;
    }
  } // namespace



  double
  IterationSummary::relative_correction() const
  {
    // An iterate of norm zero is exact if it does not move.
    return correction_norm == 0. ? 0. : correction_norm / iterate_norm;
  }



  double
  IterationSummary::relative_error(const IterationSummary *before) const
  {
    const double q = reduction(before, *this);
    if (q == 1.)
      return relative_correction();
    const double of_this = cycles < before->cycles ?
                             std::pow(q, double(cycles) / before->cycles) :
                             q;
    return of_this / (1. - of_this) * relative_correction();
  }



  unsigned int
  IterationSummary::sufficient_cycles(const IterationSummary *before,
                                      const double            tolerance) const
  {
    constexpr unsigned int any = std::numeric_limits<unsigned int>::max();
    const double           q   = reduction(before, *this);
    if (q == 1.)
      return any;
    // The next correction will be as large as the error, and the factor f has
    // to be such that f / (1 - f) times the error is the tolerance.
    const double f      = tolerance / (tolerance + relative_error(before));
    const double number = std::ceil(std::log(f) / std::log(q) * cycles);
    // Written so that a NaN counts as too large.
    constexpr double many = 1000.;
    return number < many ? std::max(1., number) : any;
  }



  unsigned int
  SolveSummary::n_cycles() const
  {
    unsigned int sum = 0;
    for (const IterationSummary &iteration : iterations)
      sum += iteration.cycles;
    return sum;
  }



  std::ostream &
  operator<<(std::ostream &out, const IterationSummary &summary)
  {
    const auto flags     = out.flags();
    const auto precision = out.precision();
    out << std::scientific << std::setprecision(3) << "decrease "
        << summary.smoother_decrease << " + " << summary.correction_decrease
        << ", relative correction " << summary.relative_correction()
        << ", truncated " << summary.n_truncated << ", step length "
        << std::fixed << summary.step_length << " ("
        << summary.line_search_evaluations << " slopes), cycles "
        << summary.cycles
        << (summary.sweeps_everywhere ? ", sweep everywhere" : "");
    out.flags(flags);
    out.precision(precision);
    return out;
  }



  std::ostream &
  operator<<(std::ostream &out, const SolveSummary &summary)
  {
    for (unsigned int k = 0; k < summary.iterations.size(); ++k)
      out << "  TNNMG " << k + 1 << ": " << summary.iterations[k] << '\n';
    return out;
  }
} // namespace StickSlip
