// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/expression.h>
#include <stickslip/scene/load_breaks.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int n_intervals = 20000;

    /** Sides of mesh files have many vertices; so many of them are looked at.
     */
    constexpr unsigned int most_points = 9;

    /** Times closer than this over the whole time are the same. */
    constexpr double resolution = 1e-12;

    /** Differences of this much over the largest value may be rounding. */
    constexpr double rounding = 1e-9;



    /** The place in an interval that a straight line between its ends fits
     * least, found by halving. */
    double
    worst_place(const std::function<double(const double)> &f,
                double                                     left,
                double                                     right,
                const double                               width)
    {
      double of_left = f(left), of_right = f(right);
      while (right - left > width)
        {
          const double middle = 0.5 * (left + right), of_middle = f(middle);
          const double in_left  = std::abs(f(0.5 * (left + middle)) -
                                          0.5 * (of_left + of_middle)),
                       in_right = std::abs(f(0.5 * (middle + right)) -
                                           0.5 * (of_middle + of_right));
          // A kink in the middle.
          if (std::max(in_left, in_right) <=
              1e-13 * (std::abs(of_left) + std::abs(of_right)))
            return middle;
          if (in_left > in_right)
            {
              right    = middle;
              of_right = of_middle;
            }
          else
            {
              left    = middle;
              of_left = of_middle;
            }
        }
      return left;
    }
  } // namespace



  std::vector<double>
  breaks_of(const std::function<double(const double)> &function,
            const double                               end,
            const double                               tolerance)
  {
    // Intervals that round numbers are not the ends of.
    constexpr double    shift = 0.381966;
    const double        size  = end / n_intervals;
    std::vector<double> ends(1, function(0.)), deviations;
    const auto          time = [&](const unsigned int i) {
      return i == 0 ? 0. : std::min(end, (i - 1 + shift) * size);
    };
    double largest = std::abs(ends[0]);
    for (unsigned int i = 1; i <= n_intervals + 1; ++i)
      {
        ends.push_back(function(time(i)));
        const double middle = function(0.5 * (time(i - 1) + time(i)));
        deviations.push_back(std::abs(middle - 0.5 * (ends[i - 1] + ends[i])));
        largest = std::max({largest, std::abs(middle), std::abs(ends[i])});
      }

    // Intervals where the function is less straight than in the next ones, or
    // where it is far from straight.
    const auto is_suspicious = [&](const unsigned int i) {
      const double before = deviations[i > 0 ? i - 1 : i + 1],
                   after =
                     deviations[i + 1 < deviations.size() ? i + 1 : i - 1];
      return deviations[i] > tolerance * largest ||
             (deviations[i] > rounding * largest &&
              deviations[i] > 3. * std::min(before, after));
    };
    std::vector<double> result;
    for (unsigned int i = 0; i < deviations.size(); ++i)
      if (is_suspicious(i))
        {
          const double place =
            worst_place(function, time(i), time(i + 1), resolution / 4. * end);
          const auto second_difference = [&](const double distance) {
            return std::abs(function(place + distance) - 2. * function(place) +
                            function(place - distance));
          };
          // Second differences do not depend on the distance at a jump, are
          // proportional to it at a kink, and to its square elsewhere.
          const double distance = size / 32.;
          if (place - distance >= 0. && place + distance <= end &&
              second_difference(distance / 8.) >
                second_difference(distance) / 20.)
            result.push_back(place);
        }
    return result;
  }



  template <int dim>
  std::vector<double>
  load_breaks(const SceneParameters<dim> &scene)
  {
    const double        end    = scene.time.end_time;
    std::vector<double> result = scene.time.load_times;
    for (const BoundaryCondition<dim> &condition : scene.boundary_conditions)
      for (unsigned int c = 0; c < condition.n_components; ++c)
        if (condition.varies_in_time(c))
          {
            const Expression<dim>         load(condition.expression[c], true);
            const std::vector<Point<dim>> points =
              side_points(scene, condition);
            const std::size_t every =
              (points.size() + most_points - 1) / most_points;
            for (std::size_t k = 0; k < points.size(); k += every)
              for (const double time : breaks_of(
                     [&](const double t) { return load.value(points[k], t); },
                     end,
                     scene.time.loading_tolerance))
                result.push_back(time);
          }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(),
                             result.end(),
                             [&](const double a, const double b) {
                               return b - a < resolution * end;
                             }),
                 result.end());
    return result;
  }



  template decltype(load_breaks<2>) load_breaks<2>;
  template decltype(load_breaks<3>) load_breaks<3>;
} // namespace StickSlip
