// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/condensed/condensed_operator.h>

#include <algorithm>
#include <numeric>

namespace StickSlip
{
  template <int n_components>
  CondensedEntries<n_components>::CondensedEntries(const Unknowns &unknowns)
  {
    for (const unsigned int node : unknowns.nonsmooth_nodes)
      {
        of_node.emplace_back();
        of_node.back().fill(numbers::invalid_unsigned_int);
        for (unsigned int c = 0; c < n_components; ++c)
          if (unknowns.fixed.is_active(node, c))
            {
              of_node.back()[c] = positions.size();
              positions.push_back(node * n_components + c);
              positions_at_nodes.push_back((of_node.size() - 1) * n_components +
                                           c);
            }
      }
  }



  namespace
  {
    /** Calls action(i, j, value) for each entry of the block diagonal H. */
    template <int n_components, typename Action>
    void
    for_each_entry(const CondensedEntries<n_components>       &entries,
                   const std::vector<Tensor<2, n_components>> &H,
                   const Action                               &action)
    {
      for (unsigned int k = 0; k < H.size(); ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            {
              const unsigned int i = entries.of_node[k][c],
                                 j = entries.of_node[k][d];
              if (i != numbers::invalid_unsigned_int &&
                  j != numbers::invalid_unsigned_int)
                action(i, j, H[k][c][d]);
            }
    }



    double
    dot(const std::vector<double> &a, const std::vector<double> &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }
  } // namespace



  template <int n_components>
  CondensedOperator<n_components>::CondensedOperator(
    const CondensedEntries<n_components> &entries)
    : entries(entries)
    , bulk(entries.positions)
  {}



  template <int n_components>
  void
  CondensedOperator<n_components>::set_matrix(
    const BlockMatrix<n_components> &A,
    const NodeMask                  &fixed)
  {
    /** Up to this number of unknowns UMFPACK solves faster than MUMPS. */
    constexpr unsigned int small_size = 100000;

    factors.clear();
    factor = 1.;
    bulk.set_matrix(A, fixed);
    if (A.n_rows() * n_components > small_size)
      return;
    NodeMask eliminated = fixed;
    for (const unsigned int position : entries.positions)
      eliminated.mask(position / n_components, position % n_components);
    if (!small_bulk)
      small_bulk = std::make_unique<UmfpackFactorisation<n_components>>();
    small_bulk->set_matrix(A, eliminated);
  }



  template <int n_components>
  const double *
  CondensedOperator<n_components>::row(const unsigned int i) const
  {
    return bulk.schur_complement().data() + std::size_t(i) * entries.size();
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::vmult(std::vector<double>       &y,
                                         const std::vector<double> &x) const
  {
    multiply_symmetric(y, factor, bulk.schur_complement(), x);
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::solve_eliminated(NodalVector       &x,
                                                    const NodalVector &b)
  {
    if (small_bulk)
      small_bulk->solve(x, b);
    else
      bulk.solve(x, b);
    if (factor != 1.)
      x /= factor;
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::solve_linearised(
    std::vector<double>                        &x,
    const std::vector<double>                  &r,
    const std::vector<Tensor<2, n_components>> &H,
    const std::vector<bool>                    &active)
  {
    if (!factors.empty() && solve_by_cg(x, r, H, active))
      return;
    factorise(H, active);
    apply_factors(x, r, active);
  }



  template <int n_components>
  bool
  CondensedOperator<n_components>::solve_by_cg(
    std::vector<double>                        &x,
    const std::vector<double>                  &r,
    const std::vector<Tensor<2, n_components>> &H,
    const std::vector<bool>                    &active)
  {
    constexpr double reduction = 1e-4;
    // So many steps take about as long as a factorisation.
    const unsigned int n         = entries.size();
    const unsigned int max_steps = std::max(4u, n / 50);

    std::vector<double> residual(n), z(n), direction(n), product(n);
    for (unsigned int i = 0; i < n; ++i)
      residual[i] = active[i] ? r[i] : 0.;
    x.assign(n, 0.);
    double rz_old = 0., rz_small = 0.;
    for (unsigned int step = 0;; ++step)
      {
        apply_factors(z, residual, active);
        const double rz = dot(residual, z);
        if (step == 0)
          rz_small = reduction * reduction * rz;
        if (rz <= rz_small)
          return true;
        // A NaN ends here, too.
        if (step == max_steps || !(rz > 0.))
          return false;
        for (unsigned int i = 0; i < n; ++i)
          direction[i] = z[i] + (step == 0 ? 0. : rz / rz_old * direction[i]);
        vmult(product, direction);
        for_each_entry(entries,
                       H,
                       [&](const unsigned int i,
                           const unsigned int j,
                           const double       value) {
                         product[i] += value * direction[j];
                       });
        const double curvature = dot(direction, product);
        if (!(curvature > 0.))
          return false;
        for (unsigned int i = 0; i < n; ++i)
          {
            x[i] += rz / curvature * direction[i];
            if (active[i])
              residual[i] -= rz / curvature * product[i];
          }
        rz_old = rz;
      }
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::factorise(
    const std::vector<Tensor<2, n_components>> &H,
    const std::vector<bool>                    &active)
  {
    const unsigned int n = entries.size();
    factors.assign(std::size_t(n) * n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      if (active[i])
        {
          const double *const S_i = row(i);
          for (unsigned int j = i; j < n; ++j)
            if (active[j])
              factors[std::size_t(i) * n + j] = factor * S_i[j];
        }
      else
        // The right size for the time when the entry is active again.
        factors[std::size_t(i) * n + i] = factor * row(i)[i];
    for_each_entry(entries,
                   H,
                   [&](const unsigned int i,
                       const unsigned int j,
                       const double       value) {
                     if (i <= j && active[i] && active[j])
                       factors[std::size_t(i) * n + j] += value;
                   });
    try
      {
        factorise_symmetric(factors, n, "the condensed matrix");
      }
    catch (const SingularMatrix &)
      {
        factors.clear();
        throw;
      }
    factorised_hessians = H;
    factorised_active   = active;
    factorised_factor   = factor;
  }



  template <int n_components>
  KeptLinearisation<n_components>
  CondensedOperator<n_components>::factorised() const
  {
    KeptLinearisation<n_components> kept;
    kept.is_set = !factors.empty();
    if (!kept.is_set)
      return kept;
    kept.hessians = factorised_hessians;
    kept.active   = NodeMask(entries.of_node.size(), n_components);
    for (unsigned int k = 0; k < entries.of_node.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const unsigned int i = entries.of_node[k][c];
          if (i == numbers::invalid_unsigned_int || !factorised_active[i])
            kept.active.mask(k, c);
        }
    return kept;
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::recall(
    const KeptLinearisation<n_components> &kept)
  {
    // Another solver's says nothing here.
    if (!kept.is_set || kept.active.n_nodes() != entries.of_node.size())
      return;
    std::vector<bool> active(entries.size());
    for (unsigned int k = 0; k < entries.of_node.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        if (entries.of_node[k][c] != numbers::invalid_unsigned_int)
          active[entries.of_node[k][c]] = kept.active.is_active(k, c);
    factorise(kept.hessians, active);
  }



  template <int n_components>
  void
  CondensedOperator<n_components>::apply_factors(
    std::vector<double>       &x,
    const std::vector<double> &b,
    const std::vector<bool>   &active) const
  {
    const unsigned int n = entries.size();
    x.resize(n);
    for (unsigned int i = 0; i < n; ++i)
      x[i] = active[i] ? b[i] : 0.;
    solve_factorised(factors, x);
    for (unsigned int i = 0; i < n; ++i)
      if (!active[i])
        x[i] = 0.;
  }



#define STICKSLIP_INSTANTIATE(n_components)       \
  template struct CondensedEntries<n_components>; \
  template class CondensedOperator<n_components>;

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
