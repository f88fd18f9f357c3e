// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/output/event_source.h>

#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <typename Vector>
    std::vector<double>
    flattened(const std::vector<Vector> &vectors)
    {
      std::vector<double> result;
      result.reserve(vectors.size() * Vector::dimension);
      for (const Vector &vector : vectors)
        for (unsigned int d = 0; d < Vector::dimension; ++d)
          result.push_back(vector[d]);
      return result;
    }



    std::vector<double>
    interpolated(const std::vector<double> &before,
                 const std::vector<double> &after,
                 const double               part)
    {
      AssertDimension(before.size(), after.size());
      std::vector<double> result(after.size());
      for (unsigned int i = 0; i < result.size(); ++i)
        result[i] = before[i] + part * (after[i] - before[i]);
      return result;
    }
  } // namespace



  template <int dim>
  FaultMotion::FaultMotion(const FaultSnapshot<dim> &fault)
    : slip(flattened(fault.slip))
    , shear_traction(flattened(fault.shear_traction))
  {}



  FaultMotion::FaultMotion(const FaultMotion &before,
                           const FaultMotion &after,
                           const double       part)
    : slip(interpolated(before.slip, after.slip, part))
    , shear_traction(
        interpolated(before.shear_traction, after.shear_traction, part))
  {}



  template <int dim>
  double
  moment_rate(const FaultSnapshot<dim>  &fault,
              const std::vector<double> &rigidity)
  {
    if (rigidity.empty())
      return EventSource::nan;
    double sum = 0.;
    for (std::size_t k = 0; k < fault.weights.size(); ++k)
      if (fault.weights[k] > 0.)
        sum += fault.weights[k] * rigidity[k] * magnitude(fault.slip_rate[k]);
    return sum;
  }



  EventSource::EventSource(const FaultMotion         &start,
                           const FaultMotion         &end,
                           const std::vector<double> &weights,
                           const std::vector<double> &rigidity,
                           const std::vector<char>   &has_ruptured)
  {
    AssertDimension(start.slip.size(), end.slip.size());
    AssertDimension(has_ruptured.size(), weights.size());
    if (weights.empty())
      return;
    const std::size_t n_components = end.slip.size() / weights.size();
    double            potency = 0., of_rigidity = 0., work = 0.;
    for (std::size_t k = 0; k < weights.size(); ++k)
      {
        if (!(weights[k] > 0.))
          continue;
        double square = 0., product = 0.;
        for (std::size_t i = k * n_components; i < (k + 1) * n_components; ++i)
          {
            const double slip = end.slip[i] - start.slip[i];
            square += slip * slip;
            product += (start.shear_traction[i] - end.shear_traction[i]) * slip;
          }
        const double of_node = weights[k] * std::sqrt(square);
        potency += of_node;
        if (!rigidity.empty())
          of_rigidity += rigidity[k] * of_node;
        work += weights[k] * product;
        if (has_ruptured[k])
          ruptured_area += weights[k];
      }
    if (!rigidity.empty())
      moment = of_rigidity;
    if (potency > 0.)
      stress_drop = work / potency;
  }



  double
  EventSource::magnitude() const
  {
    return (std::log10(moment) - 9.1) / 1.5;
  }



  template double
  moment_rate(const FaultSnapshot<2> &, const std::vector<double> &);
  template double
  moment_rate(const FaultSnapshot<3> &, const std::vector<double> &);
  template FaultMotion::FaultMotion(const FaultSnapshot<2> &);
  template FaultMotion::FaultMotion(const FaultSnapshot<3> &);
} // namespace StickSlip
