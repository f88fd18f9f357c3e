// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_frozen_faults_h
#define stickslip_contrib_frozen_faults_h

#include <stickslip/multigrid/level_hierarchy.h>
#include <stickslip/tnnmg/nonsmooth_functional.h>

#include <limits>

namespace Measure
{
  using namespace StickSlip;

  /**
   * A functional that lets no jump change: all of them are truncated, and the
   * nonsmooth problem is a linear one.
   */
  template <int dim>
  class FrozenFaults : public NonsmoothFunctional<dim>
  {
  public:
    explicit FrozenFaults(const std::vector<unsigned int> &nonsmooth_nodes)
      : nonsmooth_nodes(nonsmooth_nodes)
    {}

    const std::vector<unsigned int> &
    nodes() const override
    {
      return nonsmooth_nodes;
    }

    double
    value(const unsigned int, const Tensor<1, dim> &) const override
    {
      return 0.;
    }

    double
    directional_derivative(const unsigned int,
                           const Tensor<1, dim> &,
                           const Tensor<1, dim> &) const override
    {
      return 0.;
    }

    Tensor<1, dim>
    gradient(const unsigned int, const Tensor<1, dim> &) const override
    {
      return Tensor<1, dim>();
    }

    /** None: a node with a second derivative could be quadratic. */
    Tensor<2, dim>
    hessian(const unsigned int, const Tensor<1, dim> &) const override
    {
      Tensor<2, dim> none;
      for (unsigned int c = 0; c < dim; ++c)
        none[c][c] = std::numeric_limits<double>::infinity();
      return none;
    }

    bool
    is_smooth(const unsigned int, const Tensor<1, dim> &) const override
    {
      return false;
    }

    bool
    acts_on(const unsigned int, const unsigned int) const override
    {
      return true;
    }

    Tensor<1, dim>
    minimise(const unsigned int,
             const Tensor<2, dim> &,
             const Tensor<1, dim> &,
             const std::array<bool, dim> &,
             const Tensor<1, dim> &start) const override
    {
      return start;
    }

  private:
    std::vector<unsigned int> nonsmooth_nodes;
  };
} // namespace Measure

#endif
