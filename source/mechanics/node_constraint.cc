// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/node_constraint.h>

namespace StickSlip
{
  namespace
  {
    /** The part of a vector that is orthogonal to an orthonormal basis; twice,
     * against rounding. */
    template <int dim>
    Tensor<1, dim>
    orthogonal_part(Tensor<1, dim>                     vector,
                    const std::vector<Tensor<1, dim>> &basis)
    {
      for (unsigned int pass = 0; pass < 2; ++pass)
        for (const Tensor<1, dim> &q : basis)
          vector -= (vector * q) * q;
      return vector;
    }
  } // namespace



  template <int dim>
  bool
  NodeConstraint<dim>::add(const Tensor<1, dim> &direction)
  {
    constexpr double     least = 1e-3;
    const Tensor<1, dim> part  = orthogonal_part(direction, basis);
    if (basis.size() == dim || part.norm() < least)
      return false;
    directions.push_back(direction);
    basis.push_back(part / part.norm());
    return true;
  }



  template <int dim>
  Tensor<2, dim>
  NodeConstraint<dim>::axes() const
  {
    std::vector<Tensor<1, dim>> all = basis;
    while (all.size() < dim)
      {
        // The axis of space that is farthest from those that there are; the
        // first one where several are.
        Tensor<1, dim> farthest;
        for (unsigned int d = 0; d < dim; ++d)
          {
            Tensor<1, dim> axis;
            axis[d]                   = 1.;
            const Tensor<1, dim> part = orthogonal_part(axis, all);
            if (part.norm() > farthest.norm() + 1e-8)
              farthest = part;
          }
        all.push_back(farthest / farthest.norm());
      }
    Tensor<2, dim> result;
    for (unsigned int k = 0; k < dim; ++k)
      for (unsigned int d = 0; d < dim; ++d)
        // Prescribed directions are the first of all, and the last columns.
        result[d][(k + dim - basis.size()) % dim] = all[k][d];
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  NodeConstraint<dim>::impose(const Tensor<1, dim>          &u,
                              const std::array<double, dim> &values) const
  {
    // The prescribed part by forward substitution, the rest that of u.
    Tensor<1, dim> result = orthogonal_part(u, basis);
    Tensor<1, dim> prescribed;
    for (unsigned int k = 0; k < basis.size(); ++k)
      prescribed += (values[k] - directions[k] * prescribed) /
                    (directions[k] * basis[k]) * basis[k];
    return result + prescribed;
  }



  template class NodeConstraint<1>;
  template class NodeConstraint<2>;
  template class NodeConstraint<3>;
} // namespace StickSlip
