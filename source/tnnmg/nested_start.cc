// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/local_products.h>
#include <stickslip/tnnmg/nested_start.h>
#include <stickslip/tnnmg/sampled_functional.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include <algorithm>
#include <numeric>

namespace StickSlip
{
  namespace
  {
    constexpr unsigned int none = numbers::invalid_unsigned_int;



    /** For the owned nonsmooth nodes of a level: the term of the finest level
     * in the place of each, and for how many of its terms it stands. */
    struct Sample
    {
      std::vector<unsigned int> terms;
      std::vector<double>       factors;

      /** True if all nodes have a term. */
      bool
      is_complete() const
      {
        return std::count(terms.begin(), terms.end(), none) == 0 &&
               std::all_of(factors.begin(),
                           factors.end(),
                           [](const double factor) { return factor > 0.; });
      }
    };



    /** The sample of the level below @p fine; nodes have no term if the fine
     * node in their place belongs to another process. Collective among
     * neighbours. */
    template <int n_components>
    Sample
    coarsened(const Sample                         &sample,
              const LevelDescription<n_components> &fine,
              const LevelDescription<n_components> &coarse)
    {
      const TransferMatrix             &P    = fine.to_coarser->prolongation();
      const TransferMatrix::Compressed &rows = P.matrix();
      NodalVector                       fine_factors = fine.nodes.make_vector(),
                  coarse_factors = coarse.nodes.make_vector();

      std::vector<unsigned int> term_at(coarse.nodes.n_local(), none);
      // The row of a fine node in the same place has no other entry than 1.
      std::vector<double> weight(coarse.nodes.n_local(), 0.5);
      for (unsigned int k = 0; k < fine.nonsmooth_nodes.size(); ++k)
        {
          const unsigned int i = fine.nonsmooth_nodes[k];
          fine_factors.local_element(i * n_components) = sample.factors[k];
          for (unsigned int e = rows.row_start[i]; e < rows.row_start[i + 1];
               ++e)
            if (const unsigned int I = rows.column[e];
                rows.value[e] > weight[I])
              {
                weight[I]  = rows.value[e];
                term_at[I] = sample.terms[k];
              }
        }
      P.restrict_to(coarse_factors, fine_factors, n_components);

      Sample result;
      for (const unsigned int I : coarse.nonsmooth_nodes)
        {
          result.terms.push_back(term_at[I]);
          result.factors.push_back(
            coarse_factors.local_element(I * n_components));
        }
      return result;
    }



    /** A level and its sample. */
    struct StartLevel
    {
      unsigned int level;
      Sample       sample;
    };

    /** The finest level with at most 1/32 of the nodes, or that above it below
     * which the sample is not complete or there is one level only.
     * Collective. */
    template <int n_components>
    StartLevel
    find_start_level(const LevelHierarchy<n_components> &hierarchy)
    {
      const NodePartition &finest  = hierarchy.finest().nodes;
      const std::size_t    n_terms = hierarchy.finest().nonsmooth_nodes.size();
      StartLevel           start{hierarchy.n_levels() - 1,
                       {std::vector<unsigned int>(n_terms),
                                  std::vector<double>(n_terms, 1.)}};
      std::iota(start.sample.terms.begin(), start.sample.terms.end(), 0);
      while (start.level > 1 &&
             hierarchy.description(start.level).nodes.n_global() >
               finest.n_global() / 32)
        {
          Sample coarser = coarsened(start.sample,
                                     hierarchy.description(start.level),
                                     hierarchy.description(start.level - 1));
          if (Utilities::MPI::min(int(coarser.is_complete()),
                                  finest.communicator()) == 0)
            break;
          start.sample = std::move(coarser);
          --start.level;
        }
      return start;
    }



    /** The sum of the diagonal on a level at the nonsmooth nodes of this
     * process. */
    template <int n_components>
    double
    nonsmooth_trace(const LevelHierarchy<n_components> &hierarchy,
                    const unsigned int                  level)
    {
      double sum = 0.;
      for (const unsigned int i : hierarchy.description(level).nonsmooth_nodes)
        sum += trace(hierarchy.diagonal_on_level(level, i));
      return sum;
    }
  } // namespace



  template <int n_components>
  bool
  add_coarse_minimiser(const LevelHierarchy<n_components>      &hierarchy,
                       const NonsmoothFunctional<n_components> &functional,
                       const TNNMGParameters                   &parameters,
                       const NodalVector                       &residual,
                       NodalVector                             &w)
  {
    const unsigned int finest                    = hierarchy.n_levels() - 1;
    const auto [level, sample]                   = find_start_level(hierarchy);
    const LevelDescription<n_components> &coarse = hierarchy.description(level);
    if (coarse.nodes.n_global() > hierarchy.finest().nodes.n_global() / 12)
      return false;

    // From a level to the next coarser one the trace of a mass is doubled in
    // all dimensions, that of a stiffness halved.
    const auto [trace_here, trace_above] =
      sums<2>({{nonsmooth_trace(hierarchy, level),
                nonsmooth_trace(hierarchy, level + 1)}},
              coarse.nodes.communicator());
    if (trace_here > 0.6 * trace_above || trace_above == 0.)
      return false;

    std::vector<LevelDescription<n_components>> levels;
    for (unsigned int l = 0; l <= level; ++l)
      levels.push_back(hierarchy.description(l));
    OperatorSum<n_components> operators(coarse,
                                        {hierarchy.operator_on_level(level)});
    operators.combine({1.});
    LevelHierarchy<n_components> coarse_hierarchy(operators, levels);
    TNNMGParameters              coarse_parameters = parameters;
    coarse_parameters.tolerance                    = 1e-2;
    coarse_parameters.print_iterations             = false;
    TNNMGSolver<n_components> solver(coarse_hierarchy, coarse_parameters);

    std::vector<NodalVector> values(finest + 1);
    values[finest] = residual;
    hierarchy.finest().fixed.apply(values[finest]);
    for (unsigned int l = finest; l > level; --l)
      {
        values[l - 1] = hierarchy.description(l - 1).nodes.make_vector();
        hierarchy.description(l).to_coarser->prolongation().restrict_to(
          values[l - 1], values[l], n_components);
      }
    NodalVector minimiser = coarse.nodes.make_vector();
    solver.solve(SampledFunctional<n_components>(functional,
                                                 coarse.nonsmooth_nodes,
                                                 sample.terms,
                                                 sample.factors),
                 values[level],
                 minimiser);
    values[level].swap(minimiser);
    for (unsigned int l = level + 1; l <= finest; ++l)
      hierarchy.description(l).to_coarser->prolongation().prolongate(
        values[l], values[l - 1], n_components);
    hierarchy.finest().fixed.apply(values[finest]);
    w += values[finest];
    return true;
  }



#define STICKSLIP_INSTANTIATE(n)                                     \
  template bool add_coarse_minimiser(const LevelHierarchy<n> &,      \
                                     const NonsmoothFunctional<n> &, \
                                     const TNNMGParameters &,        \
                                     const NodalVector &,            \
                                     NodalVector &);
  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
