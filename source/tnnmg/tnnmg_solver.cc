// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/line_search.h>
#include <stickslip/tnnmg/nonlinear_gauss_seidel.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <cmath>

namespace StickSlip
{
  template <int n_components>
  TNNMGSolver<n_components>::TNNMGSolver(
    LevelHierarchy<n_components>   &hierarchy,
    const TNNMGParameters          &parameters,
    const std::vector<NodalVector> &near_null_space)
    : NonsmoothSolver<n_components>(parameters)
    , hierarchy(hierarchy)
    , linear_correction(
        make_linear_correction(hierarchy, parameters, near_null_space))
    , residual(hierarchy.finest().nodes.make_vector())
    , previous(residual)
    , smoothed_residual(residual)
    , correction(residual)
    , A_correction(residual)
    , scratch(residual)
  {}



  template <int n_components>
  void
  TNNMGSolver<n_components>::start(const NodalVector &b, const NodalVector &w)
  {
    hierarchy.matrix().residual(residual, b, w);
    linear_correction->start();
  }



  template <int n_components>
  IterationSummary
  TNNMGSolver<n_components>::iterate(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    IterationSummary summary;
    previous = w;

    if (this->parameters.nonlinear_smoothing)
      smooth(functional, b, w, summary);
    else
      smoothed_residual = residual;

    NodalVector &rhs = scratch;
    rhs              = smoothed_residual;
    subtract_gradient(functional, w, rhs);
    summary.n_truncated = linearise(functional, w, rhs);
    active.apply(rhs);
    summary.cycles = linear_correction->solve(correction, A_correction, rhs);
    if (project_step(functional, w, correction))
      hierarchy.matrix().vmult(A_correction, correction);

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
        project(functional, w);
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



  template <int n_components>
  void
  TNNMGSolver<n_components>::smooth(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w,
    IterationSummary                        &summary)
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
    project(functional, w);
    smoothed_residual.sadd(t, 1. - t, residual);
    summary.smoother_decrease = t * old_part -
                                0.5 * t * t * (old_part - new_part) -
                                increase(functional, w, previous);
  }



  template <int n_components>
  unsigned int
  TNNMGSolver<n_components>::linearise(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &w,
    const NodalVector                       &force)
  {
    diagonal_blocks.clear();
    for (const unsigned int i : functional.nodes())
      diagonal_blocks.push_back(hierarchy.matrix().diagonal_block(i));
    active                         = hierarchy.finest().fixed;
    const unsigned int n_truncated = StickSlip::linearise(functional,
                                                          this->parameters,
                                                          diagonal_blocks,
                                                          w,
                                                          force,
                                                          hessians,
                                                          active);
    linear_correction->linearise(hessians, active);
    return Utilities::MPI::sum(n_truncated, w.get_mpi_communicator());
  }



  template <int n_components>
  void
  TNNMGSolver<n_components>::finish(const NodalVector &, NodalVector &)
  {}



  template class TNNMGSolver<1>;
  template class TNNMGSolver<2>;
  template class TNNMGSolver<3>;
} // namespace StickSlip
