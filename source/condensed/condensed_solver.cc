// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/line_search.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    double
    dot(const std::vector<double> &a, const std::vector<double> &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }



    /** How many operators are kept: those of the step sizes between which a
     * run goes back and forth, in 256 MiB at most. */
    unsigned int
    n_operators_kept(const unsigned int n)
    {
      constexpr double bytes = 256. * 1024 * 1024;
      return std::clamp<double>(bytes / (16. * n * n + 1.), 1., 12.);
    }
  } // namespace



  template <int n_components>
  CondensedSolver<n_components>::Operator::Operator(
    const CondensedEntries<n_components> &entries)
    : condensed(entries)
  {}



  template <int n_components>
  CondensedSolver<n_components>::CondensedSolver(
    const LevelHierarchy<n_components> &hierarchy,
    const TNNMGParameters              &parameters)
    : NonsmoothSolver<n_components>(parameters)
    , hierarchy(hierarchy)
    , entries(hierarchy.finest().nonsmooth_nodes, hierarchy.finest().fixed)
    , prescribed(hierarchy.finest().nodes.make_vector())
    , load(prescribed)
    , previous(prescribed)
    , correction(prescribed)
    , scratch(prescribed)
    , bulk(prescribed)
  {
    AssertThrow(Utilities::MPI::n_mpi_processes(
                  hierarchy.finest().nodes.communicator()) == 1,
                ExcMessage("The condensed problem is solved on one process "
                           "only."));
    if (entries.size() > max_entries)
      throw AgreedFailure(
        "The rate solver 'condensed Newton' is for at most " +
        std::to_string(max_entries) +
        " unknowns on the faults, since its matrix is dense, but there are " +
        std::to_string(entries.size()) + "; use 'Time/Rate solver' = 'TNNMG'.");
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::find_operator()
  {
    const unsigned long version = hierarchy.operator_version();
    const auto          known   = std::find_if(operators.begin(),
                                    operators.end(),
                                    [&](const Operator &candidate) {
                                      return candidate.version == version;
                                    });
    if (known != operators.end())
      {
        operators.splice(operators.begin(), operators, known);
        return;
      }
    if (operators.size() < n_operators_kept(entries.size()))
      operators.emplace_front(entries);
    else
      // What depends on the sparsity alone is of use again.
      operators.splice(operators.begin(), operators, --operators.end());
    Operator &present = operators.front();
    // Of no operator as long as it is incomplete.
    present.version = 0;
    present.condensed.set_matrix(hierarchy.matrix(), hierarchy.finest().fixed);
    present.version = version;
    ++condensations;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::start(const NodalVector &b,
                                       const NodalVector &w)
  {
    find_operator();

    // With zero on F and everything outside minimal for that. Nothing depends
    // on the free components of w, which may be large and wrong.
    scratch = w;
    hierarchy.finest().fixed.apply(scratch);
    prescribed = w;
    prescribed -= scratch;
    hierarchy.matrix().residual(load, b, prescribed);
    scratch = load;
    restrict_to_eliminated(scratch);
    operators.front().condensed.solve_eliminated(bulk, scratch);
    restrict_to_eliminated(bulk);
    hierarchy.matrix().vmult(scratch, bulk);
    scratch.sadd(-1., 1., load);
    condensed_load = values_of(scratch);

    bulk += prescribed;
    scratch.sadd(-1., 1., b);
    square_at_zero = bulk * scratch;
  }



  template <int n_components>
  IterationSummary
  CondensedSolver<n_components>::iterate(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector &,
    NodalVector &w)
  {
    const unsigned int               n = entries.size();
    CondensedOperator<n_components> &S = operators.front().condensed;
    IterationSummary                 summary;
    const std::vector<double>        old_values = values_of(w);
    previous                                    = w;

    // Anew each time, so that rounding from a bad start is left behind.
    S.vmult(residual, old_values);
    for (unsigned int i = 0; i < n; ++i)
      residual[i] = condensed_load[i] - residual[i];
    const std::vector<double> old_residual = residual;

    diagonal_blocks.clear();
    for (unsigned int k = 0; k < functional.nodes().size(); ++k)
      diagonal_blocks.push_back(diagonal_block(k));

    // The quadratic part changes by -d . (r_old + r_new) / 2 over a change d.
    std::vector<double> change(n), sum(n);
    if (this->parameters.nonlinear_smoothing)
      {
        smooth(functional, w);
        change = values_of(w);
        for (unsigned int i = 0; i < n; ++i)
          {
            change[i] -= old_values[i];
            sum[i] = old_residual[i] + residual[i];
          }
        summary.smoother_decrease =
          0.5 * dot(change, sum) - increase(functional, w, previous);
      }

    scratch = 0.;
    for (unsigned int i = 0; i < n; ++i)
      scratch.local_element(entries.positions[i]) = residual[i];
    subtract_gradient(functional, w, scratch);
    active              = hierarchy.finest().fixed;
    summary.n_truncated = linearise(functional,
                                    this->parameters,
                                    diagonal_blocks,
                                    w,
                                    scratch,
                                    hessians,
                                    active);
    std::vector<bool> is_active(n);
    for (unsigned int i = 0; i < n; ++i)
      is_active[i] = active.is_active(entries.positions[i] / n_components,
                                      entries.positions[i] % n_components);
    std::vector<double> direction, S_direction;
    S.solve_linearised(direction, values_of(scratch), hessians, is_active);
    correction = 0.;
    for (unsigned int i = 0; i < n; ++i)
      correction.local_element(entries.positions[i]) = direction[i];
    if (project_step(functional, w, correction))
      direction = values_of(correction);
    S.vmult(S_direction, direction);

    const double           linear      = dot(direction, residual);
    const double           square      = dot(direction, S_direction);
    const LineSearchResult line_search = find_step_length([&](const double t) {
      return slope_of(functional, w, correction, t) - linear + t * square;
    });
    const double           t           = line_search.step_length;
    summary.step_length                = t;
    summary.line_search_evaluations    = line_search.evaluations;
    // Not only for speed: zero times NaN would spoil the iterate.
    if (t > 0.)
      {
        scratch = w;
        w.add(t, correction);
        project(functional, w);
        summary.correction_decrease =
          t * linear - 0.5 * t * t * square - increase(functional, w, scratch);
        for (unsigned int i = 0; i < n; ++i)
          residual[i] -= t * S_direction[i];
      }

    const std::vector<double> values = values_of(w);
    double change_square = 0., iterate_square = square_at_zero;
    for (unsigned int i = 0; i < n; ++i)
      {
        change_square +=
          (values[i] - old_values[i]) * (old_residual[i] - residual[i]);
        iterate_square += values[i] * (condensed_load[i] - residual[i]);
      }
    summary.correction_norm = std::sqrt(std::abs(change_square));
    summary.iterate_norm    = std::sqrt(std::abs(iterate_square));
    return summary;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::smooth(
    const NonsmoothFunctional<n_components> &functional,
    NodalVector                             &w)
  {
    const unsigned int                     n = entries.size();
    const CondensedOperator<n_components> &S = operators.front().condensed;
    for (unsigned int k = 0; k < functional.nodes().size(); ++k)
      {
        // Moving the part of this node to the left leaves what the minimiser
        // is asked for.
        const unsigned int             node  = functional.nodes()[k];
        const Tensor<1, n_components>  start = block<n_components>(w, node);
        Tensor<1, n_components>        r;
        std::array<bool, n_components> takes_part;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int i = entries.of_node[k][c];
            takes_part[c]        = (i != numbers::invalid_unsigned_int);
            if (!takes_part[c])
              continue;
            r[c] = residual[i];
            for (unsigned int d = 0; d < n_components; ++d)
              if (entries.of_node[k][d] != numbers::invalid_unsigned_int)
                r[c] += diagonal_blocks[k][c][d] * start[d];
          }
        const Tensor<1, n_components> v =
          functional.minimise(k, diagonal_blocks[k], r, takes_part, start);
        for (unsigned int c = 0; c < n_components; ++c)
          if (takes_part[c] && v[c] != start[c])
            {
              const double  change = v[c] - start[c];
              const double *column = S.row(entries.of_node[k][c]);
              w.local_element(node * n_components + c) = v[c];
              for (unsigned int i = 0; i < n; ++i)
                residual[i] -= change * column[i];
            }
      }
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::finish(const NodalVector &, NodalVector &w)
  {
    const std::vector<double> values = values_of(w);
    scratch                          = 0.;
    for (unsigned int i = 0; i < entries.size(); ++i)
      scratch.local_element(entries.positions[i]) = values[i];
    hierarchy.matrix().vmult(bulk, scratch);
    bulk.sadd(-1., 1., load);
    restrict_to_eliminated(bulk);
    operators.front().condensed.solve_eliminated(scratch, bulk);
    w = scratch;
    restrict_to_eliminated(w);
    w += prescribed;
    for (unsigned int i = 0; i < entries.size(); ++i)
      w.local_element(entries.positions[i]) = values[i];
  }



  template <int n_components>
  unsigned int
  CondensedSolver<n_components>::n_condensed() const
  {
    return condensations;
  }



  template <int n_components>
  std::vector<double>
  CondensedSolver<n_components>::values_of(const NodalVector &vector) const
  {
    std::vector<double> values(entries.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] = vector.local_element(entries.positions[i]);
    return values;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::restrict_to_eliminated(
    NodalVector &vector) const
  {
    hierarchy.finest().fixed.apply(vector);
    for (const unsigned int position : entries.positions)
      vector.local_element(position) = 0.;
  }



  template <int n_components>
  Tensor<2, n_components>
  CondensedSolver<n_components>::diagonal_block(const unsigned int k) const
  {
    const CondensedOperator<n_components> &S = operators.front().condensed;
    Tensor<2, n_components>                result;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        {
          const unsigned int i = entries.of_node[k][c],
                             j = entries.of_node[k][d];
          result[c][d]         = (i != numbers::invalid_unsigned_int &&
                          j != numbers::invalid_unsigned_int) ?
                                   S.row(i)[j] :
                                   (c == d ? 1. : 0.);
        }
    return result;
  }



  template class CondensedSolver<1>;
  template class CondensedSolver<2>;
  template class CondensedSolver<3>;
} // namespace StickSlip
