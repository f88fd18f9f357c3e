// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/tnnmg/functional_sums.h>
#include <stickslip/tnnmg/nested_start.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

namespace StickSlip
{
  namespace
  {
    /** True if all components are zero that are not fixed. Collective. */
    template <int n_components>
    bool
    is_zero(const NodalVector &w, const Unknowns &unknowns)
    {
      bool is_zero_here = true;
      for (unsigned int i = 0; is_zero_here && i < unknowns.nodes.n_owned();
           ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          if (unknowns.fixed.is_active(i, c) &&
              w.local_element(i * n_components + c) != 0.)
            is_zero_here = false;
      return Utilities::MPI::min(int(is_zero_here), w.get_mpi_communicator()) >
             0;
    }
  } // namespace



  template <int n_components>
  TNNMGSolver<n_components>::TNNMGSolver(
    LevelHierarchy<n_components> &hierarchy,
    const TNNMGParameters        &parameters)
    : TNNMGSolver(hierarchy.operators(),
                  parameters,
                  make_linear_correction(hierarchy, parameters))
  {}



  template <int n_components>
  TNNMGSolver<n_components>::TNNMGSolver(
    const OperatorSum<n_components>                &operators,
    const TNNMGParameters                          &parameters,
    std::unique_ptr<LinearCorrection<n_components>> correction)
    : NonsmoothSolver<n_components>(operators.unknowns(), parameters)
    , operators(operators)
    , smoother(operators)
    , linear_correction(std::move(correction))
  {}



  template <int n_components>
  void
  TNNMGSolver<n_components>::start(const NodalVector &b, const NodalVector &w)
  {
    operators.matrix().residual(this->residual, b, w);
    linear_correction->start();
    this->restart();
  }



  template <int n_components>
  void
  TNNMGSolver<n_components>::begin(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    start(b, w);
    LevelHierarchy<n_components> *hierarchy =
      linear_correction->hierarchy_to_begin_on();
    if (!hierarchy || !this->parameters.nonlinear_smoothing ||
        !is_zero<n_components>(w, this->unknowns))
      return;
    hierarchy->take_over_operator();
    if (add_coarse_minimiser(
          *hierarchy, functional, this->parameters, this->residual, w))
      {
        project(functional, this->unknowns.nonsmooth_nodes, w);
        start(b, w);
      }
  }



  template <int n_components>
  IterationSummary
  TNNMGSolver<n_components>::iterate(
    const NonsmoothFunctional<n_components> &functional,
    const NodalVector                       &b,
    NodalVector                             &w)
  {
    const IterationSummary summary = this->carry_out_steps(functional, b, w);
    // Rounding from an iterate that was far too large stays in a residual that
    // follows.
    if (summary.correction_norm > 2. * summary.iterate_norm)
      operators.matrix().residual(this->residual, b, w);
    return summary;
  }



  template <int n_components>
  void
  TNNMGSolver<n_components>::sweep(
    const NonsmoothFunctional<n_components> &functional,
    const bool                               is_everywhere,
    NodalVector                             &w,
    NodalVector                             &r)
  {
    smoother.sweep(functional, is_everywhere, w, r);
  }



  template <int n_components>
  void
  TNNMGSolver<n_components>::vmult(NodalVector &y, const NodalVector &x) const
  {
    operators.matrix().vmult(y, x);
  }



  template <int n_components>
  Tensor<2, n_components>
  TNNMGSolver<n_components>::diagonal_block(const unsigned int k) const
  {
    return operators.matrix().diagonal_block(this->unknowns.nonsmooth_nodes[k]);
  }



  template <int n_components>
  bool
  TNNMGSolver<n_components>::take_linearisation()
  {
    return linear_correction->linearise(this->hessians, this->active);
  }



  template <int n_components>
  unsigned int
  TNNMGSolver<n_components>::correct(NodalVector &x,
                                     NodalVector &A_x,
                                     NodalVector &r,
                                     const double norm,
                                     const bool   is_outdated)
  {
    return linear_correction->solve(x, A_x, r, norm, is_outdated);
  }



  template <int n_components>
  void
  TNNMGSolver<n_components>::finish(const NodalVector &, NodalVector &)
  {}



  template class TNNMGSolver<1>;
  template class TNNMGSolver<2>;
  template class TNNMGSolver<3>;
} // namespace StickSlip
