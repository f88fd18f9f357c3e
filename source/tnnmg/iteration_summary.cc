// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/iteration_summary.h>

#include <algorithm>
#include <iomanip>

namespace StickSlip
{
  double
  IterationSummary::relative_correction() const
  {
    // An iterate of norm zero is exact if it does not move.
    return correction_norm == 0. ? 0. : correction_norm / iterate_norm;
  }



  double
  IterationSummary::relative_error(const IterationSummary *before) const
  {
    constexpr double small = 0.1, fast = 0.1, fastest = 0.02;
    // Written so that a NaN and zero over zero make no difference.
    if (before && before->relative_correction() < small &&
        correction_norm < fast * before->correction_norm)
      {
        const double q =
          std::max(correction_norm / before->correction_norm, fastest);
        return q / (1. - q) * relative_correction();
      }
    return relative_correction();
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
