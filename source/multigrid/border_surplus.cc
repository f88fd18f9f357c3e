// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>

#include <stickslip/multigrid/border_surplus.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int n>
    double
    two_norm(const Tensor<2, n> &A)
    {
      const auto values = eigenvalues(symmetrize(transpose(A) * A));
      return std::sqrt(std::max(0., values[0]));
    }
  } // namespace



  template <int n_components>
  double
  border_surplus(const Tensor<2, n_components>              &inverse,
                 const std::vector<Tensor<2, n_components>> &couplings,
                 const bool                                  has_lines)
  {
    double                  sum_of_norms = 0.;
    Tensor<2, n_components> sum;
    for (const Tensor<2, n_components> &coupling : couplings)
      {
        sum += coupling;
        if (!has_lines)
          sum_of_norms += two_norm(inverse * coupling);
      }
    return std::max(0.,
                    has_lines ? (two_norm(inverse * sum) - 0.2) / 2. :
                                (sum_of_norms - 1.) / 2.);
  }



  template double
  border_surplus(const Tensor<2, 1> &,
                 const std::vector<Tensor<2, 1>> &,
                 const bool);
  template double
  border_surplus(const Tensor<2, 2> &,
                 const std::vector<Tensor<2, 2>> &,
                 const bool);
  template double
  border_surplus(const Tensor<2, 3> &,
                 const std::vector<Tensor<2, 3>> &,
                 const bool);
} // namespace StickSlip
