// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/fault_norm.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  double
  fault_norm(const FaultNodes<dim>     &faults,
             const NodeLaws            &laws,
             const std::vector<double> &values)
  {
    AssertDimension(values.size(), faults.size());
    const std::vector<unsigned int> &first   = faults.first_of_fault();
    const std::vector<double>       &weights = faults.weights();

    double sum_of_means = 0.;
    for (unsigned int f = 0; f + 1 < first.size(); ++f)
      {
        double sum = 0., area = 0.;
        for (unsigned int k = first[f]; k < first[f + 1]; ++k)
          if (faults.in_contact(k) && !laws[k].is_prescribed)
            {
              sum += weights[k] * values[k] * values[k];
              area += weights[k];
            }
        if (area > 0.)
          sum_of_means += sum / area;
      }
    return std::sqrt(sum_of_means);
  }



  template double
  fault_norm(const FaultNodes<2> &,
             const NodeLaws &,
             const std::vector<double> &);
  template double
  fault_norm(const FaultNodes<3> &,
             const NodeLaws &,
             const std::vector<double> &);
} // namespace StickSlip
