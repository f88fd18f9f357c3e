// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_nodal_functional_h
#define stickslip_problem_nodal_functional_h

#include <utility>
#include <vector>

namespace StickSlip
{
  /** A linear functional of nodal values, as the value of a component at a
   * point: local indices, n_components * node + component, of entries of this
   * process, and their weights. */
  using NodalFunctional = std::vector<std::pair<unsigned int, double>>;

  /** The part of the value that the entries of this process have in. */
  template <typename Vector>
  double
  part_of_value(const NodalFunctional &functional, const Vector &values)
  {
    double sum = 0.;
    for (const auto &[entry, weight] : functional)
      sum += weight * values.local_element(entry);
    return sum;
  }

  /** The values of functionals of a displacement, m, and a velocity, m/s. */
  struct FunctionalValues
  {
    std::vector<double> of_displacement, of_velocity;
  };
} // namespace StickSlip

#endif
