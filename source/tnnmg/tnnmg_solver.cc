// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/line_search.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    block(const NodalVector &vector, const unsigned int node)
    {
      Tensor<1, dim> values;
      for (unsigned int c = 0; c < dim; ++c)
        values[c] = vector.local_element(node * dim + c);
      return values;
    }



    /** phi(w) - phi(v) summed term by term, so that little cancels; over all
     * processes. */
    template <int dim>
    double
    increase(const NonsmoothFunctional<dim> &functional,
             const NodalVector              &w,
             const NodalVector              &v)
    {
      double                           sum   = 0;
      const std::vector<unsigned int> &nodes = functional.nodes();
      for (unsigned int k = 0; k < nodes.size(); ++k)
        sum += functional.value(k, block<dim>(w, nodes[k])) -
               functional.value(k, block<dim>(v, nodes[k]));
      return Utilities::MPI::sum(sum, w.get_mpi_communicator());
    }



    /** The derivative of phi at w + t d in direction d, over all processes. */
    template <int dim>
    double
    slope_of(const NonsmoothFunctional<dim> &functional,
             const NodalVector              &w,
             const NodalVector              &d,
             const double                    t)
    {
      double                           sum   = 0;
      const std::vector<unsigned int> &nodes = functional.nodes();
      for (unsigned int k = 0; k < nodes.size(); ++k)
        {
          const Tensor<1, dim> direction = block<dim>(d, nodes[k]);
          sum += functional.directional_derivative(
            k, block<dim>(w, nodes[k]) + t * direction, direction);
        }
      return Utilities::MPI::sum(sum, w.get_mpi_communicator());
    }
  } // namespace



  template <int dim>
  TNNMGSolver<dim>::TNNMGSolver(LevelHierarchy<dim>   &hierarchy,
                                const TNNMGParameters &parameters)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , linear_correction(make_linear_correction(hierarchy, parameters))
    , residual(hierarchy.finest().nodes.make_vector())
    , previous(residual)
    , smoothed_residual(residual)
    , correction(residual)
    , A_correction(residual)
    , scratch(residual)
  {}



  template <int dim>
  SolveSummary
  TNNMGSolver<dim>::solve(const NonsmoothFunctional<dim> &functional,
                          const NodalVector              &b,
                          NodalVector                    &w)
  {
    SolveSummary summary;
    start(b, w);
    while (!summary.converged &&
           summary.iterations.size() < parameters.max_iterations)
      {
        summary.iterations.push_back(iterate(functional, b, w));
        if (!std::isfinite(summary.iterations.back().correction_norm))
          break;
        summary.converged = has_converged(summary.iterations.back());
      }
    return summary;
  }



  template <int dim>
  void
  TNNMGSolver<dim>::start(const NodalVector &b, const NodalVector &w)
  {
    hierarchy.matrix().residual(residual, b, w);
  }



  template <int dim>
  IterationSummary
  TNNMGSolver<dim>::iterate(const NonsmoothFunctional<dim> &functional,
                            const NodalVector              &b,
                            NodalVector                    &w)
  {
    IterationSummary                 summary;
    const std::vector<unsigned int> &nodes = functional.nodes();
    previous                               = w;

    smooth(functional, b, w, summary);
    summary.n_truncated = linearise(functional, w);

    NodalVector &rhs = scratch;
    rhs              = smoothed_residual;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, dim> gradient =
          functional.gradient(k, block<dim>(w, nodes[k]));
        for (unsigned int c = 0; c < dim; ++c)
          rhs.local_element(nodes[k] * dim + c) -= gradient[c];
      }
    active.apply(rhs);
    summary.cycles = linear_correction->solve(correction, A_correction, rhs);

    const double linear = correction * smoothed_residual;
    const double square = correction * A_correction;
    const auto   slope  = [&](const double t) {
      return slope_of(functional, w, correction, t) - linear + t * square;
    };
    const LineSearchResult line_search = find_step_length(slope);
    const double           t           = line_search.step_length;
    summary.step_length                = t;
    summary.line_search_evaluations    = line_search.evaluations;

    // Not only for speed: zero times NaN would spoil the iterate.
    if (t > 0.)
      {
        NodalVector &smoothed = scratch;
        smoothed              = w;
        w.add(t, correction);
        summary.correction_decrease =
          t * linear - 0.5 * t * t * square - increase(functional, w, smoothed);
        smoothed_residual.add(-t, A_correction);
      }

    // |d|^2 = d . A d = d . (r_old - r_new) for the change d of the whole
    // iteration; positive but for rounding.
    NodalVector &change = previous;
    change.sadd(-1., 1., w);
    residual -= smoothed_residual;
    summary.correction_norm = std::sqrt(std::abs(change * residual));
    residual                = smoothed_residual;

    NodalVector &A_w = scratch;
    A_w              = b;
    A_w -= residual;
    summary.iterate_norm = std::sqrt(std::abs(w * A_w));
    return summary;
  }



  template <int dim>
  void
  TNNMGSolver<dim>::smooth(const NonsmoothFunctional<dim> &functional,
                           const NodalVector              &b,
                           NodalVector                    &w,
                           IterationSummary               &summary)
  {
    nonlinear_gauss_seidel(hierarchy, functional, b, w);
    hierarchy.matrix().residual(smoothed_residual, b, w);

    // With r = b - A w, the quadratic part of J changes by
    // -d . (r_old + r_new) / 2 over a change d of w.
    correction = w;
    correction -= previous;
    const double old_part = correction * residual,
                 new_part = correction * smoothed_residual;
    summary.smoother_decrease =
      0.5 * (old_part + new_part) - increase(functional, w, previous);

    // Where processes move neighbours at the same time they may go too far
    // together. A d = r_old - r_new.
    if (residual.get_partitioner()->n_mpi_processes() == 1 ||
        summary.smoother_decrease >= 0. || !std::isfinite(old_part + new_part))
      return;
    const double t               = find_step_length([&](const double s) {
                       return slope_of(functional, previous, correction, s) -
                              old_part + s * (old_part - new_part);
                     }).step_length;
    summary.smoother_step_length = t;
    w                            = previous;
    w.add(t, correction);
    smoothed_residual.sadd(t, 1. - t, residual);
    summary.smoother_decrease = t * old_part -
                                0.5 * t * t * (old_part - new_part) -
                                increase(functional, w, previous);
  }



  template <int dim>
  bool
  TNNMGSolver<dim>::has_converged(const IterationSummary &summary) const
  {
    return summary.relative_correction() <= parameters.tolerance;
  }



  template <int dim>
  unsigned int
  TNNMGSolver<dim>::linearise(const NonsmoothFunctional<dim> &functional,
                              const NodalVector              &w)
  {
    const std::vector<unsigned int> &nodes = functional.nodes();
    const NodeMask                  &fixed = hierarchy.finest().fixed;

    active                   = fixed;
    unsigned int n_truncated = 0;
    hessians.assign(nodes.size(), Tensor<2, dim>());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const unsigned int   i        = nodes[k];
        const Tensor<1, dim> v        = block<dim>(w, i);
        const Tensor<2, dim> diagonal = hierarchy.matrix().diagonal_block(i);

        bool smooth = functional.is_smooth(k, v);
        if (smooth)
          {
            hessians[k] = functional.hessian(k, v);
            for (unsigned int c = 0; c < dim; ++c)
              // Written so that a NaN is not smooth.
              if (!(hessians[k][c][c] <=
                    parameters.truncation_factor * diagonal[c][c]))
                smooth = false;
          }
        if (!smooth)
          {
            hessians[k] = 0.;
            for (unsigned int c = 0; c < dim; ++c)
              if (functional.acts_on(k, c) && fixed.is_active(i, c))
                {
                  active.mask(i, c);
                  ++n_truncated;
                }
          }
      }
    linear_correction->linearise(hessians, active);
    return Utilities::MPI::sum(n_truncated, w.get_mpi_communicator());
  }



  template class TNNMGSolver<2>;
  template class TNNMGSolver<3>;
} // namespace StickSlip
