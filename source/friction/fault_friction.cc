// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/friction/fault_friction.h>
#include <stickslip/friction/local_problem.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace StickSlip
{
  namespace
  {
    /** Tangential components of a node's block come first, whatever its axes
     * are; a single one is tangential. */
    template <int n_components>
    constexpr int n_tangential = n_components == 1 ? 1 : n_components - 1;

    /** The component behind them, if there is one. */
    template <int n_components>
    constexpr unsigned int normal_component = n_tangential<n_components>;

    template <int n_components>
    constexpr bool has_normal = n_tangential<n_components> < n_components;

    template <int n_components>
    Tensor<1, n_tangential<n_components>>
    tangential_part(const Tensor<1, n_components> &v)
    {
      Tensor<1, n_tangential<n_components>> v_t;
      for (unsigned int i = 0; i < normal_component<n_components>; ++i)
        v_t[i] = v[i];
      return v_t;
    }

    /**
     * Minimise over the active ones of the tangential components.
     */
    void
    minimise_tangential(const FrictionLaw         &law,
                        const double               data,
                        const double               load,
                        const double               threshold,
                        const Tensor<2, 1>        &A,
                        const Tensor<1, 1>        &r,
                        const std::array<bool, 1> &active,
                        Tensor<1, 1>              &v)
    {
      if (active[0])
        v[0] = minimise_local(law, data, A[0][0], r[0], load, threshold);
    }

    void
    minimise_tangential(const FrictionLaw         &law,
                        const double               data,
                        const double               load,
                        const double               threshold,
                        const Tensor<2, 2>        &A,
                        const Tensor<1, 2>        &r,
                        const std::array<bool, 2> &active,
                        Tensor<1, 2>              &v)
    {
      if (active[0] && active[1])
        v = minimise_local(law, data, A, r, load, threshold);
      else
        for (unsigned int i = 0; i < 2; ++i)
          if (active[i])
            v[i] = minimise_local_beside(
              law, data, A[i][i], r[i], load, v[1 - i], threshold);
    }
  } // namespace



  template <int n_components>
  FaultFriction<n_components>::FaultFriction(
    const std::vector<unsigned int>                       &nodes,
    const std::vector<double>                             &weights,
    const std::vector<double>                             &normal_stresses,
    const std::vector<std::shared_ptr<const FrictionLaw>> &laws,
    const std::vector<unsigned int>                       &law_indices)
    : node_indices(nodes)
    , weights(weights)
    , laws(laws)
    , terms(nodes.size())
  {
    AssertDimension(weights.size(), nodes.size());
    AssertDimension(law_indices.size(), nodes.size());
    Assert(std::adjacent_find(nodes.begin(),
                              nodes.end(),
                              std::greater_equal<unsigned int>()) ==
             nodes.end(),
           ExcMessage("The nodes must be in ascending order."));

    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        AssertIndexRange(law_indices[k], laws.size());
        Assert(weights[k] > 0., ExcMessage("The weights must be positive."));
        terms[k].law     = laws[law_indices[k]].get();
        terms[k].damping = 0.;
      }
    set_normal_stresses(normal_stresses);
    set_state(std::vector<double>(nodes.size(), 0.));
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_state(const std::vector<double> &alpha)
  {
    AssertDimension(alpha.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      terms[k].data = terms[k].law->node_data(alpha[k]);
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_normal_stresses(
    const std::vector<double> &normal_stresses)
  {
    AssertDimension(normal_stresses.size(), terms.size());
    for (const double sigma : normal_stresses)
      AssertThrow(sigma >= 0. && std::isfinite(sigma),
                  ExcMessage("The normal stress on a fault must be a pressure, "
                             "zero or positive, but is " +
                             std::to_string(sigma) + " Pa at some node."));

    for (unsigned int k = 0; k < terms.size(); ++k)
      terms[k].load = weights[k] * normal_stresses[k];
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_cohesion(const std::vector<double> &cohesion)
  {
    AssertDimension(cohesion.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        Assert(cohesion[k] >= 0., ExcMessage("Cohesion must not be negative."));
        terms[k].threshold = weights[k] * cohesion[k];
      }
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_damping(const std::vector<double> &damping)
  {
    AssertDimension(damping.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        Assert(damping[k] >= 0., ExcMessage("Damping must not be negative."));
        terms[k].damping = weights[k] * damping[k];
      }
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_opening(const std::vector<int> &signs)
  {
    AssertDimension(signs.size(), terms.size());
    has_openings = true;
    bounds.resize(terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        Assert(-1 <= signs[k] && signs[k] <= 1, ExcMessage("Not a sign."));
        bounds[k].sign  = signs[k];
        bounds[k].value = 0.;
      }
  }



  template <int n_components>
  void
  FaultFriction<n_components>::set_opening_bounds(
    const std::vector<double> &new_bounds)
  {
    Assert(has_bounds(), ExcMessage("set_opening() comes first."));
    AssertDimension(new_bounds.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      if (bounds[k].sign != 0.)
        {
          Assert(std::isfinite(new_bounds[k]),
                 ExcMessage("Bounds must be finite."));
          bounds[k].value = bounds[k].sign * new_bounds[k];
        }
  }



  template <int n_components>
  bool
  FaultFriction<n_components>::has_bounds() const
  {
    return has_openings;
  }



  template <int n_components>
  Tensor<1, n_components>
  FaultFriction<n_components>::project(const unsigned int             k,
                                       const Tensor<1, n_components> &v) const
  {
    AssertIndexRange(k, terms.size());
    constexpr unsigned int  n      = normal_component<n_components>;
    Tensor<1, n_components> result = v;
    if (has_normal<n_components> && !bounds.empty() &&
        bounds[k].is_beyond(v[n]))
      result[n] = bounds[k].value;
    return result;
  }



  template <int n_components>
  bool
  FaultFriction<n_components>::is_at_bound(const unsigned int             k,
                                           const Tensor<1, n_components> &v,
                                           const unsigned int component) const
  {
    AssertIndexRange(k, terms.size());
    return component == normal_component<n_components> && !bounds.empty() &&
           bounds[k].sign != 0. && v[component] == bounds[k].value;
  }



  template <int n_components>
  double
  FaultFriction<n_components>::slip_rate(const Tensor<1, n_components> &v)
  {
    return magnitude(tangential_part(v));
  }



  template <int n_components>
  double
  FaultFriction<n_components>::value(const unsigned int             k,
                                     const Tensor<1, n_components> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term  &term = terms[k];
    const double V    = slip_rate(v);
    return term.load * term.law->potential(V, term.data) + term.threshold * V +
           0.5 * term.damping * V * V;
  }



  template <int n_components>
  double
  FaultFriction<n_components>::directional_derivative(
    const unsigned int             k,
    const Tensor<1, n_components> &v,
    const Tensor<1, n_components> &direction) const
  {
    AssertIndexRange(k, terms.size());
    const Term                                 &term = terms[k];
    const Tensor<1, n_tangential<n_components>> v_t  = tangential_part(v);
    const Tensor<1, n_tangential<n_components>> d_t =
      tangential_part(direction);
    const double V = magnitude(v_t);
    // Divide first, the product of two small numbers may underflow.
    const double change = (V == 0.) ? magnitude(d_t) : (v_t / V) * d_t;
    return (change == 0.) ? 0. :
                            (term.load * term.law->coefficient(V, term.data) +
                             term.threshold + term.damping * V) *
                              change;
  }



  template <int n_components>
  Tensor<1, n_components>
  FaultFriction<n_components>::gradient(const unsigned int             k,
                                        const Tensor<1, n_components> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term             &term = terms[k];
    const double            V    = slip_rate(v);
    Tensor<1, n_components> result;
    if (V == 0.)
      return result;

    const double force = term.load * term.law->coefficient(V, term.data) +
                         term.threshold + term.damping * V;
    for (unsigned int i = 0; i < n_components; ++i)
      if (i != normal_component<n_components>)
        result[i] = force * (v[i] / V);
    return result;
  }



  template <int n_components>
  Tensor<2, n_components>
  FaultFriction<n_components>::hessian(const unsigned int             k,
                                       const Tensor<1, n_components> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term &term = terms[k];
    return hessian_with(term, v, term.law->derivative(slip_rate(v), term.data));
  }



  template <int n_components>
  Tensor<2, n_components>
  FaultFriction<n_components>::secant_hessian(
    const unsigned int             k,
    const Tensor<1, n_components> &v,
    const Tensor<1, n_components> &force) const
  {
    AssertIndexRange(k, terms.size());
    const Term  &term = terms[k];
    const double V    = slip_rate(v);
    if (V == 0. || term.load == 0.)
      return hessian(k, v);
    // Linear terms take no part in the chord.
    const double along = (tangential_part(v) / V) * tangential_part(force);
    return hessian_with(term,
                        v,
                        term.law->chord(V, along / term.load, term.data));
  }



  template <int n_components>
  Tensor<2, n_components>
  FaultFriction<n_components>::hessian_with(const Term                    &term,
                                            const Tensor<1, n_components> &v,
                                            const double slope)
  {
    Tensor<2, n_components> result;
    for (unsigned int i = 0; i < n_components; ++i)
      if (i != normal_component<n_components>)
        result[i][i] = term.damping;
    // The derivatives of the law may be infinite.
    if (term.load == 0. && term.threshold == 0.)
      return result;

    const auto   bounded = [](const double x) { return std::min(x, 1e200); };
    const double V       = slip_rate(v);
    const double radial  = (term.load == 0.) ? 0. : bounded(term.load * slope);
    double       across  = radial;
    if (V > 0.)
      across = bounded(term.load * (term.law->coefficient(V, term.data) / V) +
                       term.threshold / V);

    for (unsigned int i = 0; i < n_components; ++i)
      for (unsigned int j = 0; j < n_components; ++j)
        if (i != normal_component<n_components> &&
            j != normal_component<n_components>)
          {
            const double tt = (V == 0.) ? 0. : (v[i] / V) * (v[j] / V);
            result[i][j] += radial * tt + across * ((i == j ? 1. : 0.) - tt);
          }
    return result;
  }



  template <int n_components>
  bool
  FaultFriction<n_components>::is_smooth(const unsigned int             k,
                                         const Tensor<1, n_components> &v) const
  {
    AssertIndexRange(k, terms.size());
    const double V = slip_rate(v);
    return (V > 0. || terms[k].threshold == 0.) &&
           terms[k].law->is_smooth(V, terms[k].data);
  }



  template <int n_components>
  bool
  FaultFriction<n_components>::acts_on(const unsigned int,
                                       const unsigned int component) const
  {
    AssertIndexRange(component, n_components);
    return component != normal_component<n_components>;
  }



  template <int n_components>
  Tensor<1, n_components>
  FaultFriction<n_components>::minimise(
    const unsigned int                    k,
    const Tensor<2, n_components>        &A,
    const Tensor<1, n_components>        &r,
    const std::array<bool, n_components> &active,
    const Tensor<1, n_components>        &start) const
  {
    AssertIndexRange(k, terms.size());
    constexpr unsigned int n    = normal_component<n_components>;
    const Term            &term = terms[k];
    if (!has_normal<n_components> || bounds.empty() || bounds[k].sign == 0. ||
        !active[n])
      return minimise_unbounded(term, A, r, active, start);

    const Bound &bound    = bounds[k];
    const auto   at_bound = [&]() {
      std::array<bool, n_components> others = active;
      others[n]                             = false;
      Tensor<1, n_components> start_there = start, r_there = r;
      start_there[n] = bound.value;
      for (unsigned int i = 0; i < n; ++i)
        r_there[i] -= A[i][n] * bound.value;
      return minimise_unbounded(term, A, r_there, others, start_there);
    };

    // The state of the start is the likely one.
    const bool              starts_at_bound = (start[n] == bound.value);
    Tensor<1, n_components> v_at_bound;
    if (starts_at_bound)
      {
        v_at_bound   = at_bound();
        double force = r[n] - A[n][n] * bound.value;
        for (unsigned int i = 0; i < n; ++i)
          if (active[i])
            force -= A[n][i] * v_at_bound[i];
        if (bound.sign * force <= 0.)
          return v_at_bound;
      }
    const Tensor<1, n_components> v =
      minimise_unbounded(term, A, r, active, start);
    if (!bound.is_beyond(v[n]))
      return v;
    return starts_at_bound ? v_at_bound : at_bound();
  }



  template <int n_components>
  Tensor<1, n_components>
  FaultFriction<n_components>::minimise_unbounded(
    const Term                           &term,
    const Tensor<2, n_components>        &A,
    const Tensor<1, n_components>        &r,
    const std::array<bool, n_components> &active,
    const Tensor<1, n_components>        &start)
  {
    constexpr unsigned int n = normal_component<n_components>;

    // Take the normal component out: there the functional is quadratic.
    const bool with_normal = has_normal<n_components> && active[n];
    Tensor<2, n_tangential<n_components>>        A_t;
    Tensor<1, n_tangential<n_components>>        r_t = tangential_part(r);
    Tensor<1, n_tangential<n_components>>        v_t = tangential_part(start);
    std::array<bool, n_tangential<n_components>> active_t = {};
    for (unsigned int i = 0; i < normal_component<n_components>; ++i)
      {
        active_t[i]           = active[i];
        const double transfer = with_normal ? A[i][n] / A[n][n] : 0.;
        if (has_normal<n_components>)
          r_t[i] -= transfer * r[n];
        for (unsigned int j = 0; j < normal_component<n_components>; ++j)
          A_t[i][j] =
            A[i][j] - (has_normal<n_components> ? transfer * A[n][j] : 0.);
        A_t[i][i] += term.damping;
      }

    minimise_tangential(
      *term.law, term.data, term.load, term.threshold, A_t, r_t, active_t, v_t);

    Tensor<1, n_components> v = start;
    for (unsigned int i = 0; i < normal_component<n_components>; ++i)
      v[i] = v_t[i];
    if (with_normal)
      {
        // The right hand side already holds the inactive components.
        double force = r[n];
        for (unsigned int i = 0; i < normal_component<n_components>; ++i)
          if (active[i])
            force -= A[n][i] * v[i];
        v[n] = force / A[n][n];
      }
    return v;
  }



  template class FaultFriction<1>;
  template class FaultFriction<2>;
  template class FaultFriction<3>;
} // namespace StickSlip
