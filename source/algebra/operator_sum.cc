// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/operator_sum.h>

#include <algorithm>

namespace StickSlip
{
  template <int n_components>
  OperatorSum<n_components>::OperatorSum(
    const Unknowns                       &unknowns,
    std::vector<TermMatrix<n_components>> terms)
    : unknowns_of_problem(unknowns)
    , summands(std::move(terms))
    , A(summands.at(0).shared_sparsity())
  {}



  template <int n_components>
  void
  OperatorSum<n_components>::combine(const std::vector<double> &coefficients)
  {
    AssertThrow(coefficients.size() == summands.size(),
                ExcDimensionMismatch(coefficients.size(), summands.size()));
    if (coefficients == current_coefficients)
      return;
    current_coefficients = coefficients;
    versions.emplace(coefficients, versions.size() + 1);
    // Few rows at a time, so that all terms are added to them in the cache.
    constexpr unsigned int n_rows = 128;
    for (unsigned int begin = 0; begin < A.n_rows(); begin += n_rows)
      TermMatrix<n_components>::combine(
        coefficients, summands, begin, std::min(begin + n_rows, A.n_rows()), A);
  }



  template <int n_components>
  unsigned long
  OperatorSum<n_components>::version() const
  {
    const auto version = versions.find(current_coefficients);
    return version == versions.end() ? 0 : version->second;
  }



  template <int n_components>
  void
  OperatorSum<n_components>::with_hessians(
    const std::vector<Tensor<2, n_components>>                   &hessians,
    const std::function<void(const BlockMatrix<n_components> &)> &action)
  {
    const std::vector<unsigned int> &nodes = unknowns().nonsmooth_nodes;
    AssertDimension(hessians.size(), nodes.size());
    std::vector<Tensor<2, n_components>> diagonal(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        diagonal[k] = A.diagonal_block(nodes[k]);
        A.set_diagonal_block(nodes[k], diagonal[k] + hessians[k]);
      }
    const auto remove_hessians = [&]() {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        A.set_diagonal_block(nodes[k], diagonal[k]);
    };
    try
      {
        action(A);
      }
    catch (...)
      {
        remove_hessians();
        throw;
      }
    remove_hessians();
  }



  template <int n_components>
  void
  OperatorSum<n_components>::add_hessians(
    NodalVector                                &y,
    const double                                factor,
    const std::vector<Tensor<2, n_components>> &hessians,
    const NodalVector                          &x) const
  {
    const std::vector<unsigned int> &nodes = unknowns().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          y.local_element(nodes[k] * n_components + c) +=
            factor * hessians[k][c][d] *
            x.local_element(nodes[k] * n_components + d);
  }



  template <int n_components>
  std::size_t
  OperatorSum<n_components>::memory_consumption() const
  {
    std::size_t bytes =
      A.memory_consumption() + A.sparsity().memory_consumption();
    for (const TermMatrix<n_components> &term : summands)
      bytes += term.memory_consumption();
    return bytes;
  }



  template class OperatorSum<1>;
  template class OperatorSum<2>;
  template class OperatorSum<3>;
} // namespace StickSlip
