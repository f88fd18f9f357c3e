// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_dense_minimisation_h
#define stickslip_tests_dense_minimisation_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>

#include <algorithm>
#include <cmath>
#include <vector>

/**
 * Minimisation of 1/2 w.Aw - b.w + phi(w) with dense matrices in extended
 * precision. Shares no code with the solvers under test.
 */
namespace StickSlip::Reference
{
  using Real = long double;

  /**
   * One term load * Phi(|v_t|), with the derivative mu of Phi that belongs to
   * Coulomb's or to either form of rate-and-state friction.
   */
  struct Term
  {
    enum Kind
    {
      coulomb,
      truncated,
      arcsinh
    };

    unsigned int node;
    Kind         kind;
    Real         load;
    Real         a       = 1;
    Real         log_min = 0;

    Real
    potential(const Real V) const
    {
      const Real V_min = std::exp(log_min);
      if (kind == coulomb)
        return load * V;
      if (kind == truncated)
        return V <= V_min ?
                 0 :
                 load * a * (V * (std::log(V) - log_min) - V + V_min);
      return load * a *
             (V * std::asinh(V / (2 * V_min)) -
              V * V / (std::hypot(V, 2 * V_min) + 2 * V_min));
    }

    /** load * mu at V = exp(log_V). */
    Real
    force(const Real log_V) const
    {
      if (kind == coulomb)
        return load;
      if (kind == truncated)
        return load * a * std::max(Real(0), log_V - log_min);
      return load * a * std::asinh(std::exp(log_V - log_min) / 2);
    }

    /** The minimiser of c/2 v^2 - r v + load Phi(|v|), by bisection in ln v. */
    Real
    minimiser(const Real c, const Real r) const
    {
      Real lower = -11000, upper = std::log(std::abs(r) / c);
      if (r == 0 || std::exp(lower) * c + force(lower) >= std::abs(r))
        return 0;
      for (unsigned int i = 0; i < 90; ++i)
        {
          const Real y = (lower + upper) / 2;
          (c * std::exp(y) + force(y) < std::abs(r) ? lower : upper) = y;
        }
      return std::copysign(std::exp((lower + upper) / 2), r);
    }
  };



  /**
   * The condition that the last component of a node, times the sign, is at
   * least this value.
   */
  struct Bound
  {
    unsigned int node;
    int          sign;
    Real         value;
  };



  /**
   * The value of the functional, and a bound for the sums it consists of, by
   * which rounding is measured.
   */
  struct Value
  {
    Real value = 0, size = 0;
  };

  template <int dim>
  Value
  functional(const BlockMatrix<dim>  &A,
             const NodalVector       &b,
             const std::vector<Term> &terms,
             const NodalVector       &w)
  {
    Value                J;
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const Real w_i = w.local_element(i * dim + c);
          const Real b_i = b.local_element(i * dim + c);
          J.value -= b_i * w_i;
          J.size += std::abs(b_i * w_i);
          for (unsigned int k = sparsity.row_start[i];
               k < sparsity.row_start[i + 1];
               ++k)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const Real product =
                  w_i * A.block(k)[c * dim + d] *
                  w.local_element(sparsity.column[k] * dim + d) / 2;
                J.value += product;
                J.size += std::abs(product);
              }
        }
    for (const Term &term : terms)
      {
        Real V = 0;
        for (unsigned int c = 0; c + 1 < dim; ++c)
          V = std::hypot(V, Real(w.local_element(term.node * dim + c)));
        J.value += term.potential(V);
        J.size += term.potential(V);
      }
    return J;
  }



  /** The lower triangular L with A = L L^T, in place. */
  inline void
  factorise(std::vector<std::vector<Real>> &A)
  {
    for (unsigned int i = 0; i < A.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          Real sum = A[i][j];
          for (unsigned int k = 0; k < j; ++k)
            sum -= A[i][k] * A[j][k];
          A[i][j] = (i == j) ? std::sqrt(sum) : sum / A[j][j];
        }
  }



  /** x = A^-1 b from the factor. */
  inline std::vector<Real>
  solve(const std::vector<std::vector<Real>> &L, std::vector<Real> x)
  {
    const unsigned int n = x.size();
    for (unsigned int i = 0; i < n; ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
          x[i] -= L[i][j] * x[j];
        x[i] /= L[i][i];
      }
    for (unsigned int i = n; i-- > 0;)
      {
        for (unsigned int j = i + 1; j < n; ++j)
          x[i] -= L[j][i] * x[j];
        x[i] /= L[i][i];
      }
    return x;
  }



  /**
   * A problem with its free components in a row.
   */
  template <int dim>
  class DenseProblem
  {
  public:
    /** The components that are not free have the values of @p given; the
     * @p bounds are those of free ones. */
    DenseProblem(const BlockMatrix<dim>   &A,
                 const NodeMask           &fixed,
                 const NodalVector        &b,
                 const NodalVector        &given,
                 const std::vector<Term>  &terms,
                 const std::vector<Bound> &bounds = {})
      : terms(terms)
      , bounds(bounds)
    {
      const BlockSparsity      &sparsity = A.sparsity();
      std::vector<unsigned int> position(sparsity.n_rows() * dim, -1);
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          if (fixed.is_active(i, c))
            {
              position[i * dim + c] = free.size();
              free.push_back(i * dim + c);
            }
      matrix.assign(free.size(), std::vector<Real>(free.size()));
      for (const unsigned int entry : free)
        {
          const unsigned int i = entry / dim, c = entry % dim;
          rhs.push_back(b.local_element(entry));
          for (unsigned int k = sparsity.row_start[i];
               k < sparsity.row_start[i + 1];
               ++k)
            for (unsigned int d = 0; d < dim; ++d)
              {
                const unsigned int column = sparsity.column[k] * dim + d;
                const Real         value  = A.block(k)[c * dim + d];
                if (position[column] == (unsigned int)(-1))
                  rhs.back() -= value * given.local_element(column);
                else
                  matrix[rhs.size() - 1][position[column]] = value;
              }
        }
      for (const Term &term : terms)
        for (unsigned int c = 0; c + 1 < dim; ++c)
          tangential.push_back(position[term.node * dim + c]);
      for (const Bound &bound : bounds)
        bounded.push_back(position[bound.node * dim + dim - 1]);
      factor = matrix;
      factorise(factor);
    }



    /** sqrt(v.Av) over the free components. */
    Real
    energy_norm(const std::vector<Real> &v) const
    {
      Real sum = 0;
      for (unsigned int i = 0; i < v.size(); ++i)
        for (unsigned int j = 0; j < v.size(); ++j)
          sum += v[i] * matrix[i][j] * v[j];
      return std::sqrt(sum);
    }



    std::vector<Real>
    free_components(const NodalVector &w) const
    {
      std::vector<Real> v;
      for (const unsigned int entry : free)
        v.push_back(w.local_element(entry));
      return v;
    }



    /**
     * An upper bound for the distance of w from the minimiser in the energy
     * norm: |A^-1 g| for the subgradient g in w, since the functional is as
     * convex as its quadratic part. Not for terms at rest that have a
     * threshold.
     */
    Real
    distance_from_minimiser(const NodalVector &w) const
    {
      const std::vector<Real> v = free_components(w);
      std::vector<Real>       g = rhs;
      for (unsigned int i = 0; i < v.size(); ++i)
        for (unsigned int j = 0; j < v.size(); ++j)
          g[i] -= matrix[i][j] * v[j];
      for (unsigned int k = 0; k < terms.size(); ++k)
        {
          const unsigned int *const t = &tangential[k * (dim - 1)];
          Real                      V = 0;
          for (unsigned int c = 0; c + 1 < dim; ++c)
            V = std::hypot(V, v[t[c]]);
          for (unsigned int c = 0; c + 1 < dim && V > 0; ++c)
            g[t[c]] -= terms[k].force(std::log(V)) * v[t[c]] / V;
        }
      // At a bound there is a reaction.
      for (unsigned int k = 0; k < bounds.size(); ++k)
        if (bounds[k].sign * v[bounded[k]] == bounds[k].value &&
            bounds[k].sign * g[bounded[k]] < 0)
          g[bounded[k]] = 0;
      return energy_norm(solve(factor, g));
    }



    /**
     * The minimiser: condensation onto the components with a term or a bound,
     * and there Gauss-Seidel until nothing moves any more.
     */
    std::vector<Real>
    minimise() const
    {
      static_assert(dim == 2, "One tangential component a node");
      // The inverse of the Schur complement is a part of the inverse.
      std::vector<unsigned int> kept = tangential;
      kept.insert(kept.end(), bounded.begin(), bounded.end());
      const unsigned int             n = kept.size();
      std::vector<std::vector<Real>> responses, S;
      for (unsigned int k = 0; k < n; ++k)
        {
          std::vector<Real> unit(free.size());
          unit[kept[k]] = 1;
          responses.push_back(solve(factor, unit));
        }
      std::vector<std::vector<Real>> F(n, std::vector<Real>(n));
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int m = 0; m < n; ++m)
          F[k][m] = responses[m][kept[k]];
      factorise(F);
      for (unsigned int k = 0; k < n; ++k)
        {
          std::vector<Real> unit(n);
          unit[k] = 1;
          S.push_back(solve(F, unit));
        }
      const std::vector<Real> frictionless = solve(factor, rhs);
      std::vector<Real>       j(n), load(n);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int m = 0; m < n; ++m)
          load[k] += S[k][m] * frictionless[kept[m]];

      Real change = 1, size = 0;
      for (unsigned int sweep = 0; sweep < 10000 && change > 1e-17L * size;
           ++sweep)
        {
          change = size = 0;
          for (unsigned int k = 0; k < n; ++k)
            {
              Real r = load[k];
              for (unsigned int m = 0; m < n; ++m)
                if (m != k)
                  r -= S[k][m] * j[m];
              const Real v = minimiser(k, S[k][k], r);
              change       = std::max(change, std::abs(v - j[k]));
              size         = std::max(size, std::abs(v));
              j[k]         = v;
            }
        }

      // The rest follows from the forces S (j - frictionless).
      std::vector<Real> v = frictionless;
      for (unsigned int k = 0; k < n; ++k)
        {
          Real force = -load[k];
          for (unsigned int m = 0; m < n; ++m)
            force += S[k][m] * j[m];
          for (unsigned int i = 0; i < v.size(); ++i)
            v[i] += responses[k][i] * force;
        }
      for (unsigned int k = 0; k < n; ++k)
        v[kept[k]] = j[k];
      return v;
    }

    /** Positions of the tangential components among the free ones. */
    std::vector<unsigned int> tangential;

  private:
    /** The minimiser of c/2 v^2 - r v for the k-th component that is kept. */
    Real
    minimiser(const unsigned int k, const Real c, const Real r) const
    {
      if (k < terms.size())
        return terms[k].minimiser(c, r);
      const Bound &bound = bounds[k - terms.size()];
      return bound.sign * std::max(bound.sign * r / c, bound.value);
    }

    const std::vector<Term>        terms;
    const std::vector<Bound>       bounds;
    std::vector<unsigned int>      free, bounded;
    std::vector<std::vector<Real>> matrix, factor;
    std::vector<Real>              rhs;
  };
} // namespace StickSlip::Reference

#endif
