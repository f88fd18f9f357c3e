// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_node_constraint_h
#define stickslip_mechanics_node_constraint_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Components of a vector at one node that are prescribed along directions
   * d_k which need be neither axes of space nor orthogonal, as where two sides
   * that are not level meet:
   *
   *   d_k . u = value_k.
   */
  template <int dim>
  class NodeConstraint
  {
  public:
    /**
     * Prescribe the component along a unit vector. Returns false, and changes
     * nothing, where it lies within 1e-3 (radians) of the span of those
     * before.
     */
    bool
    add(const Tensor<1, dim> &direction);

    /** Number of independent directions. */
    unsigned int
    size() const
    {
      return directions.size();
    }

    /** Orthonormal axes, as columns: free directions first, those that span the
     * prescribed ones last. */
    Tensor<2, dim>
    axes() const;

    /** The vector next to @p u with these values, in the order of the
     * directions; entries behind size() mean nothing. */
    Tensor<1, dim>
    impose(const Tensor<1, dim>          &u,
           const std::array<double, dim> &values) const;

  private:
    std::vector<Tensor<1, dim>> directions;
    /** Directions made orthonormal, each to those before. */
    std::vector<Tensor<1, dim>> basis;
  };
} // namespace StickSlip

#endif
