// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/time/stress_iteration.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  std::vector<double>
  StressIteration::next(const std::vector<double> &tried,
                        const std::vector<double> &found,
                        const double               change)
  {
    // Early changes are those of the rates, which have not settled either.
    constexpr unsigned int n_first = 12, n_between = 4, n_kept = 6;

    changes.push_back(change);
    const unsigned int n = changes.size();
    if (n >= n_first && changes[n - 1] > 0.5 * changes[n - 1 - n_between])
      is_slow = true;
    if (!is_slow)
      return found;

    all_found.insert(all_found.begin(), found);
    all_differences.insert(all_differences.begin(), found);
    for (unsigned int k = 0; k < tried.size(); ++k)
      all_differences.front()[k] -= tried[k];
    if (all_found.size() > n_kept)
      {
        all_found.pop_back();
        all_differences.pop_back();
      }
    std::vector<double> result = combination(found);
    for (unsigned int k = 0; k < result.size(); ++k)
      // Sides that have come apart do not press, whatever others do.
      result[k] = (found[k] == 0. || !std::isfinite(result[k])) ?
                    found[k] :
                    std::max(result[k], 0.);
    return result;
  }



  std::vector<double>
  StressIteration::combination(const std::vector<double> &found) const
  {
    // Steps between the differences that are kept, made orthogonal, with the
    // steps between what was found that belong to them.
    std::vector<double> result = found, rest = all_differences.front();
    const auto          product = [&](const std::vector<double> &a,
                             const std::vector<double> &b) {
      double sum = 0.;
      for (unsigned int k = 0; k < a.size(); ++k)
        sum += weights[k] * a[k] * b[k];
      return sum;
    };
    std::vector<std::vector<double>> directions, steps;
    for (unsigned int i = 1; i < all_found.size(); ++i)
      {
        std::vector<double> direction = all_differences[i - 1],
                            step      = all_found[i - 1];
        for (unsigned int k = 0; k < step.size(); ++k)
          {
            direction[k] -= all_differences[i][k];
            step[k] -= all_found[i][k];
          }
        const double size = product(direction, direction);
        for (unsigned int j = 0; j < directions.size(); ++j)
          {
            const double part = product(direction, directions[j]) /
                                product(directions[j], directions[j]);
            for (unsigned int k = 0; k < step.size(); ++k)
              {
                direction[k] -= part * directions[j][k];
                step[k] -= part * steps[j][k];
              }
          }
        const double square = product(direction, direction);
        // The rest of a direction that others have would be rounding.
        if (!(square > 1e-8 * size))
          continue;
        const double part = product(rest, direction) / square;
        for (unsigned int k = 0; k < step.size(); ++k)
          {
            rest[k] -= part * direction[k];
            result[k] -= part * step[k];
          }
        directions.push_back(std::move(direction));
        steps.push_back(std::move(step));
      }
    return result;
  }
} // namespace StickSlip
