// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/machine_memory.h>
#include <stickslip/condensed/condensed_operator.h>
#include <stickslip/time/rate_solver_choice.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace StickSlip
{
  std::string
  text_of(const RateSolverChoice &choice)
  {
    return (choice.solver == RateSolver::condensed_newton ? "condensed Newton" :
                                                            "TNNMG") +
           (", since " + choice.reason);
  }



  double
  condensed_memory(const RateProblemSize &size)
  {
    // Factors of the bodies, twice, which grow a little faster than this.
    constexpr double bytes_an_unknown = 5000.;
    constexpr double n_sizes          = 12.;
    const double     on_faults        = size.n_on_faults,
                 dense   = 2. * sizeof(double) * on_faults * on_faults,
                 factors = bytes_an_unknown * size.n_unknowns;
    return (size.has_one_operator ? 1. : n_sizes) * (dense + factors);
  }



  double
  condensed_over_tnnmg(const RateProblemSize &size)
  {
    // Numbers of unknowns over those of the published spring slider.
    const double n = size.n_unknowns / 1754., on_faults = size.n_on_faults;
    // Two solutions with the bodies, dense matrices, and an operator for each
    // step size.
    double result =
      0.24 * std::pow(n, 0.25) + 0.03 * on_faults * on_faults / size.n_unknowns;
    if (!size.has_one_operator)
      result += 0.65 * std::sqrt(n);
    // Newton's method with exact corrections converges quadratically.
    const double digits = std::max(6., -std::log10(size.tolerance));
    return result * std::pow(6. / digits, 1.5);
  }



  RateSolverChoice
  choose_rate_solver(const RateProblemSize &size)
  {
    // Nothing beyond these pays that has been measured.
    constexpr double most_unknowns = 20000., most_on_faults = 1000.;
    constexpr double part_of_memory = 0.25;
    // TNNMG is the one that suits all scenes.
    constexpr double clearly_faster = 0.8;

    std::ostringstream reason;
    reason.precision(2);
    const auto tnnmg = [&]() {
      return RateSolverChoice{RateSolver::tnnmg, reason.str()};
    };
    if (size.n_processes > 1)
      {
        reason << "there are " << size.n_processes << " processes";
        return tnnmg();
      }
    reason << size.n_on_faults << " of " << size.n_unknowns
           << " unknowns are on faults";
    if (size.dimension == 3)
      reason << ", in three dimensions";
    if (size.dimension == 3 || size.n_on_faults == 0 ||
        size.n_on_faults > most_on_faults || size.n_unknowns > most_unknowns)
      return tnnmg();
    if (condensed_memory(size) > part_of_memory * size.memory)
      {
        reason << ", whose dense matrices and factors would take "
               << static_cast<unsigned int>(condensed_memory(size) / 1048576.)
               << " MiB";
        return tnnmg();
      }
    const double ratio = condensed_over_tnnmg(size);
    reason << (size.has_one_operator ? ", all step sizes have one operator" :
                                       "")
           << ": condensed Newton is expected to take " << ratio
           << " of the time of TNNMG";
    return {ratio < clearly_faster ? RateSolver::condensed_newton :
                                     RateSolver::tnnmg,
            reason.str()};
  }



  template <int dim, int n_components>
  RateSolverChoice
  choose_rate_solver(const TimeParameters                    &parameters,
                     const TNNMGParameters                   &tnnmg,
                     const SpatialProblem<dim, n_components> &problem)
  {
    if (parameters.rate_solver != RateSolver::automatic)
      return {parameters.rate_solver, ""};
    // Explicit steps have no rate problem.
    if (parameters.control == StepSizeControl::runge_kutta ||
        parameters.control == StepSizeControl::central_differences)
      return {RateSolver::tnnmg, ""};
    if (tnnmg.linear_correction != LinearCorrectionType::multigrid)
      return {RateSolver::tnnmg, "'TNNMG/Linear correction' is not multigrid"};
    const Unknowns &unknowns     = problem.operators().unknowns();
    const MPI_Comm  communicator = unknowns.nodes.communicator();
    RateProblemSize size;
    size.dimension   = dim;
    size.n_processes = Utilities::MPI::n_mpi_processes(communicator);
    size.n_unknowns  = unknowns.nodes.n_owned() * n_components -
                      unknowns.fixed.n_masked(unknowns.nodes.n_owned());
    size.n_on_faults      = CondensedEntries<n_components>(unknowns).size();
    size.has_one_operator = problem.operators().terms().size() == 1;
    size.tolerance        = tnnmg.tolerance;
    size.memory           = machine_memory();
    return choose_rate_solver(size);
  }



#define STICKSLIP_INSTANTIATE(dim, n_components) \
  template RateSolverChoice choose_rate_solver(  \
    const TimeParameters &,                      \
    const TNNMGParameters &,                     \
    const SpatialProblem<dim, n_components> &);

  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
  STICKSLIP_INSTANTIATE(2, 1)
} // namespace StickSlip
