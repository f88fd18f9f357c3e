// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/dense_symmetric.h>
#include <stickslip/algebra/singular_matrix.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/condensed/condensed_solver.h>
#include <stickslip/tnnmg/functional_sums.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    /** The nonsmooth nodes alone, as unknowns of one process. */
    Unknowns
    nonsmooth_part(const Unknowns &all, const unsigned int n_components)
    {
      const std::vector<unsigned int> &nodes = all.nonsmooth_nodes;
      const unsigned int               n     = nodes.size();
      Unknowns                         part;
      part.nodes = NodePartition(complete_index_set(n),
                                 IndexSet(n),
                                 n_components,
                                 all.nodes.communicator());
      part.fixed = NodeMask(n, n_components);
      part.nonsmooth_nodes.resize(n);
      std::iota(part.nonsmooth_nodes.begin(), part.nonsmooth_nodes.end(), 0u);
      for (unsigned int k = 0; k < n; ++k)
        for (unsigned int c = 0; c < n_components; ++c)
          if (!all.fixed.is_active(nodes[k], c))
            part.fixed.mask(k, c);
      return part;
    }



    /** Forces on the entries outside of F, all added up, over those on F, that
     * are taken for none: what passes on to F is no more than they are. */
    constexpr double negligible = 1e-11;



    /** The number of operators kept: those between which a caller goes back
     * and forth, in 256 MiB at most. */
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
    const OperatorSum<n_components> &operators,
    const TNNMGParameters           &parameters)
    : NonsmoothSolver<n_components>(nonsmooth_part(operators.unknowns(),
                                                   n_components),
                                    parameters)
    , operators(operators)
    , entries(operators.unknowns())
    , base(operators.unknowns().nodes.make_vector())
    , load(base)
    , scratch(base)
    , bulk(base)
    , g(this->residual)
    , z(this->residual)
    , z_of_base(this->residual)
  {
    AssertThrow(Utilities::MPI::n_mpi_processes(
                  operators.unknowns().nodes.communicator()) == 1,
                ExcMessage("The condensed problem is solved on one process "
                           "only."));
    if (entries.size() > max_entries)
      throw AgreedFailure(
        "A condensed problem has at most " + std::to_string(max_entries) +
        " unknowns at nonsmooth nodes, since its matrix is dense, but here are " +
        std::to_string(entries.size()) + ".");
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::find_operator()
  {
    // A single term only scales, and is condensed once.
    if (operators.terms().size() == 1)
      {
        if (condensed_operators.empty())
          condensed_operators.emplace_front(entries);
        if (Operator &only = condensed_operators.front(); only.version == 0)
          {
            only.condensed.set_matrix(operators.terms()[0].block_matrix(),
                                      operators.unknowns().fixed);
            only.version = 1;
            ++condensations;
          }
        if (operators.coefficients()[0] == 0.)
          throw SingularMatrix("the condensed matrix");
        condensed_operators.front().condensed.set_factor(
          operators.coefficients()[0]);
        return;
      }

    const unsigned long version = operators.version();
    const auto          known   = std::find_if(condensed_operators.begin(),
                                    condensed_operators.end(),
                                    [&](const Operator &candidate) {
                                      return candidate.version == version;
                                    });
    if (known != condensed_operators.end())
      {
        condensed_operators.splice(condensed_operators.begin(),
                                   condensed_operators,
                                   known);
        return;
      }
    if (condensed_operators.size() < n_operators_kept(entries.size()))
      condensed_operators.emplace_front(entries);
    else
      // The part that depends on the sparsity alone is of use again.
      condensed_operators.splice(condensed_operators.begin(),
                                 condensed_operators,
                                 --condensed_operators.end());
    Operator &present = condensed_operators.front();
    // The number of no operator, as long as this one is incomplete.
    present.version = 0;
    present.condensed.set_matrix(operators.matrix(),
                                 operators.unknowns().fixed);
    present.version      = version;
    present.coefficients = operators.coefficients();
    ++condensations;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::start(const NodalVector &b,
                                       const NodalVector &w)
  {
    find_operator();

    // All outside of F is made minimal for the values that w has on F.
    base = w;
    operators.matrix().residual(load, b, base);
    scratch = load;
    restrict_to_eliminated(scratch);
    double on_faults = 0.;
    for (const unsigned int position : entries.positions)
      on_faults += std::abs(b.local_element(position));
    if (!(scratch.l1_norm() <= negligible * on_faults))
      {
        // Values that are not in balance may be large and wrong: none of them
        // is kept but the fixed ones.
        scratch = w;
        operators.unknowns().fixed.apply(scratch);
        base -= scratch;
        operators.matrix().residual(load, b, base);
        scratch = load;
        restrict_to_eliminated(scratch);
        condensed_operators.front().condensed.solve_eliminated(bulk, scratch);
        restrict_to_eliminated(bulk);
        base += bulk;
        operators.matrix().residual(load, b, base);
      }

    gather(base, z_of_base);
    vmult(g, z_of_base);
    for (unsigned int i = 0; i < entries.size(); ++i)
      g.local_element(entries.positions_at_nodes[i]) +=
        load.local_element(entries.positions[i]);

    scratch = b;
    scratch -= load;
    this->square_of_rest = base * scratch;
  }



  template <int n_components>
  IterationSummary
  CondensedSolver<n_components>::iterate(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector &,
    NodalVector &w)
  {
    gather(w, z);
    // The residual is formed anew each time, so that rounding from a bad start
    // is left behind.
    vmult(this->residual, z);
    this->residual.sadd(-1., 1., g);
    const IterationSummary summary = this->carry_out_steps(functional, g, z);
    for (unsigned int i = 0; i < entries.size(); ++i)
      w.local_element(entries.positions[i]) =
        z.local_element(entries.positions_at_nodes[i]);
    return summary;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::sweep(
    const NonsmoothFunctional<n_components> &functional,
    const bool,
    NodalVector &z,
    NodalVector &r)
  {
    const unsigned int                     n = entries.size();
    const CondensedOperator<n_components> &S =
      condensed_operators.front().condensed;
    std::vector<double> rest = entries_of(r);
    for (unsigned int k = 0; k < entries.of_node.size(); ++k)
      {
        const Tensor<1, n_components>  start = block<n_components>(z, k);
        Tensor<1, n_components>        residual_of_node;
        std::array<bool, n_components> takes_part;
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int i = entries.of_node[k][c];
            takes_part[c]        = (i != numbers::invalid_unsigned_int);
            if (takes_part[c])
              residual_of_node[c] = rest[i];
          }
        const Tensor<1, n_components> v =
          minimiser_at<n_components>(functional,
                                     k,
                                     diagonal_block(k),
                                     residual_of_node,
                                     takes_part,
                                     start);
        for (unsigned int c = 0; c < n_components; ++c)
          if (takes_part[c] && v[c] != start[c])
            {
              const double  change = v[c] - start[c];
              const double *column = S.row(entries.of_node[k][c]);
              z.local_element(k * n_components + c) = v[c];
              add_multiple(rest.data(),
                           -change * S.present_factor(),
                           column,
                           n);
            }
      }
    set_entries(r, rest);
  }



  template <int n_components>
  Tensor<2, n_components>
  CondensedSolver<n_components>::diagonal_block(const unsigned int k) const
  {
    const CondensedOperator<n_components> &S =
      condensed_operators.front().condensed;
    Tensor<2, n_components> result;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        {
          const unsigned int i = entries.of_node[k][c],
                             j = entries.of_node[k][d];
          result[c][d]         = (i != numbers::invalid_unsigned_int &&
                          j != numbers::invalid_unsigned_int) ?
                                   S.present_factor() * S.row(i)[j] :
                                   (c == d ? 1. : 0.);
        }
    return result;
  }



  template <int n_components>
  unsigned int
  CondensedSolver<n_components>::correct(NodalVector &x,
                                         NodalVector &S_x,
                                         NodalVector &r,
                                         const double,
                                         const bool)
  {
    std::vector<bool> is_active(entries.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const unsigned int position = entries.positions_at_nodes[i];
        is_active[i] = this->active.is_active(position / n_components,
                                              position % n_components);
      }
    std::vector<double> direction;
    condensed_operators.front().condensed.solve_linearised(direction,
                                                           entries_of(r),
                                                           this->hessians,
                                                           is_active);
    set_entries(x, direction);
    vmult(S_x, x);
    return 0;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::finish(const NodalVector &, NodalVector &w)
  {
    scratch = 0.;
    for (const unsigned int position : entries.positions)
      scratch.local_element(position) =
        w.local_element(position) - base.local_element(position);
    w = base;
    w += scratch;
    operators.matrix().vmult(load, scratch);
    restrict_to_eliminated(load);
    condensed_operators.front().condensed.solve_eliminated(bulk, load);
    restrict_to_eliminated(bulk);
    w -= bulk;
  }



  template <int n_components>
  std::vector<KeptLinearisation<n_components>>
  CondensedSolver<n_components>::kept_linearisations() const
  {
    std::vector<KeptLinearisation<n_components>> result;
    for (auto known = condensed_operators.rbegin();
         known != condensed_operators.rend();
         ++known)
      if (known->version != 0)
        {
          result.push_back(known->condensed.factorised());
          result.back().coefficients =
            operators.terms().size() == 1 ?
              std::vector<double>{known->condensed.factor_of_factorised()} :
              known->coefficients;
        }
    return result;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::recall(
    const KeptLinearisation<n_components> &kept)
  {
    find_operator();
    condensed_operators.front().condensed.recall(kept);
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::gather(const NodalVector &w,
                                        NodalVector       &z) const
  {
    const std::vector<unsigned int> &nodes =
      operators.unknowns().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        z.local_element(k * n_components + c) =
          w.local_element(nodes[k] * n_components + c);
  }



  template <int n_components>
  std::vector<double>
  CondensedSolver<n_components>::entries_of(const NodalVector &z) const
  {
    std::vector<double> values(entries.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      values[i] = z.local_element(entries.positions_at_nodes[i]);
    return values;
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::set_entries(
    NodalVector               &z,
    const std::vector<double> &values) const
  {
    for (unsigned int i = 0; i < values.size(); ++i)
      z.local_element(entries.positions_at_nodes[i]) = values[i];
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::vmult(NodalVector       &y,
                                       const NodalVector &x) const
  {
    std::vector<double> product;
    condensed_operators.front().condensed.vmult(product, entries_of(x));
    set_entries(y, product);
  }



  template <int n_components>
  void
  CondensedSolver<n_components>::restrict_to_eliminated(
    NodalVector &vector) const
  {
    operators.unknowns().fixed.apply(vector);
    for (const unsigned int position : entries.positions)
      vector.local_element(position) = 0.;
  }



  template class CondensedSolver<1>;
  template class CondensedSolver<2>;
  template class CondensedSolver<3>;
} // namespace StickSlip
