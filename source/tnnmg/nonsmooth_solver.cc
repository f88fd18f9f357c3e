// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/local_products.h>
#include <stickslip/tnnmg/line_search.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

#include <cmath>

namespace StickSlip
{
  template <int n_components>
  NonsmoothSolver<n_components>::NonsmoothSolver(
    const Unknowns        &unknowns,
    const TNNMGParameters &parameters)
    : unknowns(unknowns)
    , parameters(parameters)
    , residual(unknowns.nodes.make_vector())
    , new_residual(residual)
    , force(residual)
    , correction(residual)
    , A_correction(residual)
  {}



  template <int n_components>
  SolveSummary
  NonsmoothSolver<n_components>::solve(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    SolveSummary summary;
    project(functional, functional.nodes(), w);
    begin(functional, b, w);
    while (!summary.converged &&
           summary.iterations.size() < parameters.max_iterations)
      {
        summary.iterations.push_back(iterate(functional, b, w));
        if (!std::isfinite(summary.iterations.back().correction_norm))
          break;
        const auto last   = summary.iterations.rbegin();
        summary.converged = has_converged(
          *last, summary.iterations.size() > 1 ? &*std::next(last) : nullptr);
      }
    finish(b, w);
    return summary;
  }



  template <int n_components>
  void
  NonsmoothSolver<n_components>::begin(
    const NonsmoothFunctional<n_components> &,
    const NodalVector &b,
    NodalVector       &w)
  {
    start(b, w);
  }



  template <int n_components>
  bool
  NonsmoothSolver<n_components>::has_converged(
    const IterationSummary &last,
    const IterationSummary *before) const
  {
    return last.relative_error(before) <= parameters.tolerance;
  }



  template <int n_components>
  IterationSummary
  NonsmoothSolver<n_components>::carry_out_steps(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    const std::vector<unsigned int> &nodes        = unknowns.nonsmooth_nodes;
    const MPI_Comm                   communicator = w.get_mpi_communicator();
    IterationSummary                 summary;
    // The cache of one process holds the matrix of so few nodes: sweeps over
    // all of them cost little.
    constexpr types::global_dof_index few_nodes = 5000;
    sweeps_everywhere = last_was_slow || unknowns.nodes.n_global() < few_nodes;
    // Until there is a correction, its place serves the smoother.
    NodalVector &before = A_correction;
    for_each_swept_entry([&](const unsigned int i) {
      before.local_element(i) = w.local_element(i);
    });
    new_residual = residual;
    if (parameters.nonlinear_smoothing)
      sweep(functional, sweeps_everywhere, w, new_residual);
    summary.sweeps_everywhere = sweeps_everywhere;

    LinearProblem problem = truncate(functional, w);

    // The quadratic part of J changes by -d . r + d . A d / 2 over a change d
    // of w, where r = b - A w, and A d is the change of -r.
    const auto [downwards_here, square_here] = find_smoothing(before, w);

    const auto [downwards,
                change_square,
                increase_of_all,
                square_of_problem,
                n_outdated] = sums<5>({{downwards_here,
                                        square_here,
                                        increase(functional, nodes, w, before),
                                        problem.square,
                                        double(problem.is_outdated)}},
                                      communicator);

    problem.square      = square_of_problem;
    problem.is_outdated = n_outdated > 0.;
    summary.smoother_decrease =
      downwards - 0.5 * change_square - increase_of_all;

    std::vector<BoundComponent> at_bound;
    summary.cycles = find_correction(functional, w, problem, at_bound);

    // Everything that the line search begins with, and the norms after a full
    // step, in one message.
    const auto slope_here = [&](const double t) {
      return slope_of(functional, nodes, w, correction, t);
    };
    const std::array<double, 2> full = squares_after(b, w, 1.);
    auto [linear,
          curvature,
          slope_at_start,
          slope_at_end,
          n_truncated,
          change_of_all,
          iterate_of_all] = sums<7>({{local_product(correction, new_residual),
                                      local_product(correction, A_correction),
                                      slope_here(0.),
                                      slope_here(1.),
                                      double(problem.n_truncated),
                                      full[0],
                                      full[1]}},
                                    communicator);
    summary.n_truncated   = std::lround(n_truncated);
    const auto slope      = [&](const double t) {
      return Utilities::MPI::sum(slope_here(t), communicator) - linear +
             t * curvature;
    };
    const LineSearchResult line_search =
      find_step_length(slope,
                       slope_at_start - linear,
                       slope_at_end - linear + curvature);
    const double t                  = line_search.step_length;
    summary.step_length             = t;
    summary.line_search_evaluations = line_search.evaluations;
    if (t != 1.)
      {
        const auto shorter = sums<2>(squares_after(b, w, t), communicator);
        change_of_all      = shorter[0];
        iterate_of_all     = shorter[1];
      }
    summary.correction_norm = std::sqrt(std::abs(change_of_all));
    summary.iterate_norm = std::sqrt(std::abs(square_of_rest + iterate_of_all));
    last_was_slow =
      t < 0.5 || summary.correction_norm > 0.5 * last_correction_norm;
    last_correction_norm = summary.correction_norm;

    // The condition is not only for speed: zero times NaN would spoil the
    // iterate.
    if (t > 0.)
      {
        NodalVector &before_step = force;
        copy_blocks<n_components>(nodes, w, before_step);
        w.add(t, correction);
        project(functional, nodes, w);
        if (t == 1.)
          for (const BoundComponent &bound : at_bound)
            w.local_element(bound.node * n_components + bound.component) =
              bound.value;
        new_residual.add(-t, A_correction);
        if (with_correction_decrease)
          summary.correction_decrease =
            t * linear - 0.5 * t * t * curvature -
            Utilities::MPI::sum(increase(functional, nodes, w, before_step),
                                communicator);
      }
    residual.swap(new_residual);
    return summary;
  }



  template <int n_components>
  template <typename Action>
  void
  NonsmoothSolver<n_components>::for_each_swept_entry(
    const Action &action) const
  {
    if (!sweeps_everywhere)
      for_each_entry<n_components>(unknowns.nonsmooth_nodes, action);
    else
      for (unsigned int i = 0; i < residual.locally_owned_size(); ++i)
        action(i);
  }



  template <int n_components>
  std::pair<double, double>
  NonsmoothSolver<n_components>::find_smoothing(const NodalVector &before,
                                                const NodalVector &w)
  {
    smoothing.resize(sweeps_everywhere ?
                       w.locally_owned_size() :
                       unknowns.nonsmooth_nodes.size() * n_components);
    double *swept = smoothing.data();
    for_each_swept_entry([&](const unsigned int i) {
      *swept++ = w.local_element(i) - before.local_element(i);
    });
    // A loop of its own, in which sums stay in registers.
    const double *change    = smoothing.data();
    double        downwards = 0., square = 0.;
    for_each_swept_entry([&](const unsigned int i) {
      downwards += *change * residual.local_element(i);
      square +=
        *change * (residual.local_element(i) - new_residual.local_element(i));
      ++change;
    });
    return {downwards, square};
  }



  template <int n_components>
  typename NonsmoothSolver<n_components>::LinearProblem
  NonsmoothSolver<n_components>::truncate(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &w)
  {
    const std::vector<unsigned int> &nodes = unknowns.nonsmooth_nodes;
    force                                  = new_residual;
    subtract_gradient(functional, nodes, w, force);
    diagonal_blocks.clear();
    for (unsigned int k = 0; k < nodes.size(); ++k)
      diagonal_blocks.push_back(diagonal_block(k));
    active = unknowns.fixed;
    LinearProblem result;
    result.n_truncated = linearise(functional,
                                   nodes,
                                   parameters,
                                   diagonal_blocks,
                                   w,
                                   force,
                                   hessians,
                                   active);
    active.apply(force);
    result.square      = local_product(force, force);
    result.is_outdated = take_linearisation();
    return result;
  }



  template <int n_components>
  typename NonsmoothSolver<n_components>::LinearProblem
  NonsmoothSolver<n_components>::agreed(LinearProblem here) const
  {
    const auto [square, n_outdated] =
      sums<2>({{here.square, double(here.is_outdated)}},
              unknowns.nodes.communicator());
    here.square      = square;
    here.is_outdated = n_outdated > 0.;
    return here;
  }



  template <int n_components>
  unsigned int
  NonsmoothSolver<n_components>::find_correction(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &w,
    const LinearProblem                     &problem,
    std::vector<BoundComponent>             &at_bound)
  {
    const std::vector<unsigned int> &nodes   = unknowns.nonsmooth_nodes;
    const auto                       correct = [&](const LinearProblem &its) {
      return this->correct(correction,
                           A_correction,
                           force,
                           std::sqrt(its.square),
                           its.is_outdated);
    };
    if (!functional.has_bounds())
      return correct(problem);

    NodalVector  right_hand_side = force;
    unsigned int cycles          = correct(problem);
    at_bound          = project_step(functional, nodes, w, correction);
    const auto on_any = [&](const bool condition) {
      return Utilities::MPI::max(int(condition), w.get_mpi_communicator()) > 0;
    };
    if (!on_any(!at_bound.empty()))
      return cycles;

    // Components that are shortened keep their corrections, and the others are
    // found anew for them.
    NodalVector given = correction;
    given             = 0.;
    for (const BoundComponent &bound : at_bound)
      {
        const unsigned int i   = bound.node * n_components + bound.component;
        given.local_element(i) = correction.local_element(i);
        active.mask(bound.node, bound.component);
      }
    NodalVector A_given = given;
    vmult(A_given, given);
    right_hand_side -= A_given;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Tensor<1, n_components> change =
          hessians[k] * block<n_components>(given, nodes[k]);
        for (unsigned int c = 0; c < n_components; ++c)
          right_hand_side.local_element(nodes[k] * n_components + c) -=
            change[c];
      }
    active.apply(right_hand_side);
    force.swap(right_hand_side);
    LinearProblem rest;
    rest.square      = local_product(force, force);
    rest.is_outdated = take_linearisation();
    cycles += correct(agreed(rest));
    correction += given;
    A_correction += A_given;

    bool is_cut = false;
    for (const BoundComponent &bound :
         project_step(functional, nodes, w, correction))
      // The others of them are beyond their bounds by rounding only.
      if (active.is_active(bound.node, bound.component))
        {
          at_bound.push_back(bound);
          is_cut = true;
        }
    if (on_any(is_cut))
      vmult(A_correction, correction);
    return cycles;
  }



  template <int n_components>
  std::array<double, 2>
  NonsmoothSolver<n_components>::squares_after(const NodalVector &b,
                                               const NodalVector &w,
                                               const double       t) const
  {
    // A times the change is that of -r. Steps of length zero may be no numbers.
    const auto step_of = [t](const NodalVector &vector, const unsigned int i) {
      return t > 0. ? t * vector.local_element(i) : 0.;
    };
    const auto r_after = [&](const unsigned int i) {
      return new_residual.local_element(i) - step_of(A_correction, i);
    };
    const unsigned int    n      = w.locally_owned_size();
    std::array<double, 2> result = {{0., 0.}};
    for (unsigned int i = 0; i < n; ++i)
      {
        const double step = step_of(correction, i), r = r_after(i);
        result[0] += step * (residual.local_element(i) - r);
        result[1] += (w.local_element(i) + step) * (b.local_element(i) - r);
      }
    auto swept = smoothing.begin();
    for_each_swept_entry([&](const unsigned int i) {
      result[0] += *swept++ * (residual.local_element(i) - r_after(i));
    });
    return result;
  }



  template class NonsmoothSolver<1>;
  template class NonsmoothSolver<2>;
  template class NonsmoothSolver<3>;
} // namespace StickSlip
