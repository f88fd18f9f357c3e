// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/multigrid_correction.h>

namespace StickSlip
{
  template <int dim>
  MultigridCorrection<dim>::MultigridCorrection(
    LevelHierarchy<dim>   &hierarchy,
    const TNNMGParameters &parameters)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , direction(hierarchy.finest().nodes.make_vector())
    , A_direction(direction)
    , preconditioned(direction)
  {
    hierarchy.set_smoothing_sweeps(parameters.smoothing_sweeps);
    hierarchy.set_coarse_update_threshold(parameters.coarse_update_threshold);
    hierarchy.set_coarse_solver(parameters.coarse_solver);
    hierarchy.set_cycle_precision(parameters.cycle_precision);
  }



  template <int dim>
  void
  MultigridCorrection<dim>::linearise(
    const std::vector<Tensor<2, dim>> &new_hessians,
    const NodeMask                    &new_active)
  {
    hessians = new_hessians;
    active   = new_active;
    hierarchy.linearise(hessians, active);
  }



  template <int dim>
  unsigned int
  MultigridCorrection<dim>::solve(NodalVector &x,
                                  NodalVector &A_x,
                                  NodalVector &r)
  {
    x                   = 0.;
    A_x                 = 0.;
    double       rz_old = 0.;
    unsigned int cycles = 0;
    while (cycles < parameters.cycles_per_correction)
      {
        hierarchy.v_cycle(preconditioned, r);
        ++cycles;
        const double rz = r * preconditioned;
        if (!(rz > 0.))
          break;
        if (cycles == 1)
          direction = preconditioned;
        else
          direction.sadd(rz / rz_old, 1., preconditioned);

        hierarchy.matrix().vmult(A_direction, direction);
        add_hessians(A_direction, 1., direction);
        const double curvature = direction * A_direction;
        if (!(curvature > 0.))
          break;
        const double length = rz / curvature;
        x.add(length, direction);
        A_x.add(length, A_direction);
        rz_old = rz;
        // Nothing needs the residual of the last step.
        if (cycles < parameters.cycles_per_correction)
          {
            active.apply(A_direction);
            r.add(-length, A_direction);
          }
      }
    // So far it is (A + H) x.
    add_hessians(A_x, -1., x);
    return cycles;
  }



  template <int dim>
  void
  MultigridCorrection<dim>::add_hessians(NodalVector       &y,
                                         const double       factor,
                                         const NodalVector &x) const
  {
    const std::vector<unsigned int> &nodes = hierarchy.finest().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          y.local_element(nodes[k] * dim + c) +=
            factor * hessians[k][c][d] * x.local_element(nodes[k] * dim + d);
  }



  template class MultigridCorrection<2>;
  template class MultigridCorrection<3>;
} // namespace StickSlip
