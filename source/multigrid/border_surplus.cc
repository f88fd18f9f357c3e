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



  template <int n_components, typename Number>
  BorderSurplus<n_components, Number>::BorderSurplus(
    const BlockSparsity &sparsity,
    const bool           has_lines)
    : has_lines(has_lines)
  {
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      if (std::any_of(sparsity.column.begin() + sparsity.row_start[i],
                      sparsity.column.begin() + sparsity.row_start[i + 1],
                      [&](const unsigned int j) {
                        return j >= sparsity.n_rows();
                      }))
        rows.push_back(i);
    rows.shrink_to_fit();
    blocks.resize(rows.size() * n_components * n_components);
  }



  template <int n_components, typename Number>
  bool
  BorderSurplus<n_components, Number>::has_row(const unsigned int i) const
  {
    return std::binary_search(rows.begin(), rows.end(), i);
  }



  template <int n_components, typename Number>
  double
  BorderSurplus<n_components, Number>::set(
    const unsigned int                          i,
    const Tensor<2, n_components>              &block,
    const Tensor<2, n_components>              &inverse,
    const std::vector<Tensor<2, n_components>> &couplings)
  {
    double                  sum_of_norms = 0.;
    Tensor<2, n_components> sum;
    for (const Tensor<2, n_components> &coupling : couplings)
      {
        sum += coupling;
        if (!has_lines)
          sum_of_norms += two_norm(inverse * coupling);
      }
    const double s        = has_lines ? (two_norm(inverse * sum) - 0.2) / 2. :
                                        (sum_of_norms - 1.) / 2.;
    const double positive = std::max(0., s);

    const auto found = std::lower_bound(rows.begin(), rows.end(), i);
    Assert(found != rows.end() && *found == i, ExcInternalError());
    Number *S =
      blocks.data() + (found - rows.begin()) * n_components * n_components;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        S[c * n_components + d] = positive * block[c][d];
    return 1. + positive;
  }



  template <int n_components, typename Number>
  void
  BorderSurplus<n_components, Number>::add_product(const Number *x,
                                                   Number       *r) const
  {
    const Number *S = blocks.data();
    for (const unsigned int i : rows)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d, ++S)
          r[std::size_t(i) * n_components + c] +=
            *S * x[std::size_t(i) * n_components + d];
  }



  template <int n_components, typename Number>
  const Number *
  BorderSurplus<n_components, Number>::shifted(const Number     *b,
                                               const Number     *x,
                                               const std::size_t n_values) const
  {
    if (is_empty())
      return b;
    right_hand_side.resize_fast(n_values);
    std::copy_n(b, n_values, right_hand_side.data());
    add_product(x, right_hand_side.data());
    return right_hand_side.data();
  }



  template <int n_components, typename Number>
  std::size_t
  BorderSurplus<n_components, Number>::memory_consumption() const
  {
    return sizeof(unsigned int) * rows.capacity() +
           sizeof(Number) * (blocks.capacity() + right_hand_side.capacity());
  }



  template class BorderSurplus<1, float>;
  template class BorderSurplus<2, float>;
  template class BorderSurplus<3, float>;
  template class BorderSurplus<1, double>;
  template class BorderSurplus<2, double>;
  template class BorderSurplus<3, double>;
} // namespace StickSlip
