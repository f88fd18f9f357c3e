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
     * are. */
    template <int dim>
    constexpr unsigned int normal_component = dim - 1;

    template <int dim>
    Tensor<1, dim - 1>
    tangential_part(const Tensor<1, dim> &v)
    {
      Tensor<1, dim - 1> v_t;
      for (unsigned int i = 0; i < dim - 1; ++i)
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
                        const Tensor<2, 1>        &A,
                        const Tensor<1, 1>        &r,
                        const std::array<bool, 1> &active,
                        Tensor<1, 1>              &v)
    {
      if (active[0])
        v[0] = minimise_local(law, data, A[0][0], r[0], load);
    }

    void
    minimise_tangential(const FrictionLaw         &law,
                        const double               data,
                        const double               load,
                        const Tensor<2, 2>        &A,
                        const Tensor<1, 2>        &r,
                        const std::array<bool, 2> &active,
                        Tensor<1, 2>              &v)
    {
      if (active[0] && active[1])
        v = minimise_local(law, data, A, r, load);
      else
        for (unsigned int i = 0; i < 2; ++i)
          if (active[i])
            v[i] =
              minimise_local_beside(law, data, A[i][i], r[i], load, v[1 - i]);
    }
  } // namespace



  template <int dim>
  FaultFriction<dim>::FaultFriction(
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



  template <int dim>
  void
  FaultFriction<dim>::set_state(const std::vector<double> &alpha)
  {
    AssertDimension(alpha.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      terms[k].data = terms[k].law->node_data(alpha[k]);
  }



  template <int dim>
  void
  FaultFriction<dim>::set_normal_stresses(
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



  template <int dim>
  void
  FaultFriction<dim>::set_damping(const std::vector<double> &damping)
  {
    AssertDimension(damping.size(), terms.size());
    for (unsigned int k = 0; k < terms.size(); ++k)
      {
        Assert(damping[k] >= 0., ExcMessage("Damping must not be negative."));
        terms[k].damping = weights[k] * damping[k];
      }
  }



  template <int dim>
  void
  FaultFriction<dim>::set_opening(const std::vector<int> &signs)
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



  template <int dim>
  void
  FaultFriction<dim>::set_opening_bounds(const std::vector<double> &new_bounds)
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



  template <int dim>
  bool
  FaultFriction<dim>::is_in_contact(const unsigned int    k,
                                    const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    return bounds.empty() || bounds[k].sign == 0. ||
           v[normal_component<dim>] == bounds[k].value;
  }



  template <int dim>
  bool
  FaultFriction<dim>::has_bounds() const
  {
    return has_openings;
  }



  template <int dim>
  Tensor<1, dim>
  FaultFriction<dim>::project(const unsigned int    k,
                              const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    constexpr unsigned int n      = normal_component<dim>;
    Tensor<1, dim>         result = v;
    if (!bounds.empty() && bounds[k].is_beyond(v[n]))
      result[n] = bounds[k].value;
    return result;
  }



  template <int dim>
  bool
  FaultFriction<dim>::is_at_bound(const unsigned int    k,
                                  const Tensor<1, dim> &v,
                                  const unsigned int    component) const
  {
    AssertIndexRange(k, terms.size());
    return component == normal_component<dim> && !bounds.empty() &&
           bounds[k].sign != 0. && v[component] == bounds[k].value;
  }



  template <int dim>
  double
  FaultFriction<dim>::slip_rate(const Tensor<1, dim> &v)
  {
    return magnitude(tangential_part(v));
  }



  template <int dim>
  double
  FaultFriction<dim>::value(const unsigned int k, const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term  &term = terms[k];
    const double V    = slip_rate(v);
    return term.load * term.law->potential(V, term.data) +
           0.5 * term.damping * V * V;
  }



  template <int dim>
  double
  FaultFriction<dim>::directional_derivative(
    const unsigned int    k,
    const Tensor<1, dim> &v,
    const Tensor<1, dim> &direction) const
  {
    AssertIndexRange(k, terms.size());
    const Term              &term = terms[k];
    const Tensor<1, dim - 1> v_t  = tangential_part(v);
    const Tensor<1, dim - 1> d_t  = tangential_part(direction);
    const double             V    = magnitude(v_t);
    // Divide first, the product of two small numbers may underflow.
    const double change = (V == 0.) ? magnitude(d_t) : (v_t / V) * d_t;
    return (change == 0.) ? 0. :
                            (term.load * term.law->coefficient(V, term.data) +
                             term.damping * V) *
                              change;
  }



  template <int dim>
  Tensor<1, dim>
  FaultFriction<dim>::gradient(const unsigned int    k,
                               const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term    &term = terms[k];
    const double   V    = slip_rate(v);
    Tensor<1, dim> result;
    if (V == 0.)
      return result;

    const double force =
      term.load * term.law->coefficient(V, term.data) + term.damping * V;
    for (unsigned int i = 0; i < dim; ++i)
      if (i != normal_component<dim>)
        result[i] = force * (v[i] / V);
    return result;
  }



  template <int dim>
  Tensor<2, dim>
  FaultFriction<dim>::hessian(const unsigned int    k,
                              const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    const Term &term = terms[k];
    return hessian_with(term, v, term.law->derivative(slip_rate(v), term.data));
  }



  template <int dim>
  Tensor<2, dim>
  FaultFriction<dim>::secant_hessian(const unsigned int    k,
                                     const Tensor<1, dim> &v,
                                     const Tensor<1, dim> &force) const
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



  template <int dim>
  Tensor<2, dim>
  FaultFriction<dim>::hessian_with(const Term           &term,
                                   const Tensor<1, dim> &v,
                                   const double          slope)
  {
    Tensor<2, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      if (i != normal_component<dim>)
        result[i][i] = term.damping;
    // The derivatives of the law may be infinite.
    if (term.load == 0.)
      return result;

    const auto   bounded = [](const double x) { return std::min(x, 1e200); };
    const double V       = slip_rate(v);
    const double radial  = bounded(term.load * slope);
    const double across =
      (V == 0.) ?
        radial :
        bounded(term.load * (term.law->coefficient(V, term.data) / V));

    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        if (i != normal_component<dim> && j != normal_component<dim>)
          {
            const double tt = (V == 0.) ? 0. : (v[i] / V) * (v[j] / V);
            result[i][j] += radial * tt + across * ((i == j ? 1. : 0.) - tt);
          }
    return result;
  }



  template <int dim>
  bool
  FaultFriction<dim>::is_smooth(const unsigned int    k,
                                const Tensor<1, dim> &v) const
  {
    AssertIndexRange(k, terms.size());
    return terms[k].law->is_smooth(slip_rate(v), terms[k].data);
  }



  template <int dim>
  bool
  FaultFriction<dim>::acts_on(const unsigned int,
                              const unsigned int component) const
  {
    AssertIndexRange(component, dim);
    return component != normal_component<dim>;
  }



  template <int dim>
  Tensor<1, dim>
  FaultFriction<dim>::minimise(const unsigned int           k,
                               const Tensor<2, dim>        &A,
                               const Tensor<1, dim>        &r,
                               const std::array<bool, dim> &active,
                               const Tensor<1, dim>        &start) const
  {
    AssertIndexRange(k, terms.size());
    constexpr unsigned int n    = normal_component<dim>;
    const Term            &term = terms[k];
    if (bounds.empty() || bounds[k].sign == 0. || !active[n])
      return minimise_unbounded(term, A, r, active, start);

    const Bound &bound    = bounds[k];
    const auto   at_bound = [&]() {
      std::array<bool, dim> others = active;
      others[n]                    = false;
      Tensor<1, dim> start_there = start, r_there = r;
      start_there[n] = bound.value;
      for (unsigned int i = 0; i < n; ++i)
        r_there[i] -= A[i][n] * bound.value;
      return minimise_unbounded(term, A, r_there, others, start_there);
    };

    // The state of the start is the likely one.
    const bool     starts_at_bound = (start[n] == bound.value);
    Tensor<1, dim> v_at_bound;
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
    const Tensor<1, dim> v = minimise_unbounded(term, A, r, active, start);
    if (!bound.is_beyond(v[n]))
      return v;
    return starts_at_bound ? v_at_bound : at_bound();
  }



  template <int dim>
  Tensor<1, dim>
  FaultFriction<dim>::minimise_unbounded(const Term                  &term,
                                         const Tensor<2, dim>        &A,
                                         const Tensor<1, dim>        &r,
                                         const std::array<bool, dim> &active,
                                         const Tensor<1, dim>        &start)
  {
    constexpr unsigned int n = normal_component<dim>;

    // Take the normal component out: there the functional is quadratic.
    Tensor<2, dim - 1>        A_t;
    Tensor<1, dim - 1>        r_t      = tangential_part(r);
    Tensor<1, dim - 1>        v_t      = tangential_part(start);
    std::array<bool, dim - 1> active_t = {};
    for (unsigned int i = 0; i < dim - 1; ++i)
      {
        active_t[i]           = active[i];
        const double transfer = active[n] ? A[i][n] / A[n][n] : 0.;
        r_t[i] -= transfer * r[n];
        for (unsigned int j = 0; j < dim - 1; ++j)
          A_t[i][j] = A[i][j] - transfer * A[n][j];
        A_t[i][i] += term.damping;
      }

    minimise_tangential(
      *term.law, term.data, term.load, A_t, r_t, active_t, v_t);

    Tensor<1, dim> v = start;
    for (unsigned int i = 0; i < dim - 1; ++i)
      v[i] = v_t[i];
    if (active[n])
      {
        // The right hand side already holds the inactive components.
        double force = r[n];
        for (unsigned int i = 0; i < dim - 1; ++i)
          if (active[i])
            force -= A[n][i] * v[i];
        v[n] = force / A[n][n];
      }
    return v;
  }



  template class FaultFriction<2>;
  template class FaultFriction<3>;
} // namespace StickSlip
