// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_coulomb_functional_h
#define stickslip_tests_coulomb_functional_h

#include <stickslip/tnnmg/nonsmooth_functional.h>

#include <algorithm>

namespace StickSlip::Tests
{
  /**
   * The functional sum_k load_k |v_t|, with a kink at zero that rate-and-state
   * friction does not have. The last component is normal.
   */
  template <int dim>
  class CoulombFunctional : public NonsmoothFunctional<dim>
  {
  public:
    CoulombFunctional(const std::vector<unsigned int> &nodes,
                      const std::vector<double>       &loads)
      : node_indices(nodes)
      , loads(loads)
    {}

    const std::vector<unsigned int> &
    nodes() const override
    {
      return node_indices;
    }

    double
    value(const unsigned int k, const Tensor<1, dim> &v) const override
    {
      return loads[k] * tangential(v).norm();
    }

    double
    directional_derivative(const unsigned int    k,
                           const Tensor<1, dim> &v,
                           const Tensor<1, dim> &direction) const override
    {
      const double V = tangential(v).norm();
      return V == 0. ? value(k, direction) :
                       loads[k] * (tangential(v) / V * direction);
    }

    Tensor<1, dim>
    gradient(const unsigned int k, const Tensor<1, dim> &v) const override
    {
      const Tensor<1, dim> v_t = tangential(v);
      return v_t.norm() == 0. ? Tensor<1, dim>() : loads[k] / v_t.norm() * v_t;
    }

    Tensor<2, dim>
    hessian(const unsigned int k, const Tensor<1, dim> &v) const override
    {
      const Tensor<1, dim> t = tangential(v) / tangential(v).norm();
      Tensor<2, dim>       H = -outer_product(t, t);
      for (unsigned int c = 0; c + 1 < dim; ++c)
        H[c][c] += 1.;
      return loads[k] / tangential(v).norm() * H;
    }

    bool
    is_smooth(const unsigned int, const Tensor<1, dim> &v) const override
    {
      return tangential(v).norm() > 0.;
    }

    bool
    acts_on(const unsigned int, const unsigned int component) const override
    {
      return component + 1 < dim;
    }

    /** Tangential components must be active, the normal one need not be. */
    Tensor<1, dim>
    minimise(const unsigned int           k,
             const Tensor<2, dim>        &A,
             const Tensor<1, dim>        &r,
             const std::array<bool, dim> &active,
             const Tensor<1, dim>        &start) const override
    {
      constexpr unsigned int n = dim - 1;
      Tensor<1, dim>         v = start;
      Tensor<2, dim - 1>     A_t;
      Tensor<1, dim - 1>     r_t;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double factor = active[n] ? A[i][n] / A[n][n] : 0.;
          r_t[i]              = r[i] - factor * r[n];
          for (unsigned int j = 0; j < n; ++j)
            A_t[i][j] = A[i][j] - factor * A[n][j];
        }

      // (A + load/V) v = r with V = |v|, by bisection for V.
      Tensor<1, dim - 1> v_t;
      if (r_t.norm() > loads[k])
        {
          const auto at = [&](const double V) {
            Tensor<2, dim - 1> B = A_t;
            for (unsigned int i = 0; i < n; ++i)
              B[i][i] += loads[k] / V;
            return invert(B) * r_t;
          };
          double lower = 0, upper = (invert(A_t) * r_t).norm();
          for (unsigned int i = 0; i < 200; ++i)
            {
              const double V                     = (lower + upper) / 2;
              (at(V).norm() > V ? lower : upper) = V;
            }
          v_t = at((lower + upper) / 2);
        }
      for (unsigned int i = 0; i < n; ++i)
        v[i] = v_t[i];
      if (active[n])
        {
          v[n] = r[n];
          for (unsigned int i = 0; i < n; ++i)
            v[n] -= A[n][i] * v[i];
          v[n] /= A[n][n];
        }
      return v;
    }

  private:
    static Tensor<1, dim>
    tangential(Tensor<1, dim> v)
    {
      v[dim - 1] = 0.;
      return v;
    }

    const std::vector<unsigned int> node_indices;
    const std::vector<double>       loads;
  };
} // namespace StickSlip::Tests

#endif
