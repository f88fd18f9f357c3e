// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/known_velocities.h>

namespace StickSlip
{
  template <int dim, int n_components>
  NodalVector
  known_velocities(SpatialProblem<dim, n_components> &problem,
                   const double                       time)
  {
    NodalVector nodal = problem.make_nodal_vector(), w = problem.make_vector();
    problem.boundary_values().set_velocities(time, nodal);
    problem.to_jumps(w, nodal);
    problem.set_known_jumps(time, w);
    NodalVector free = w;
    problem.operators().unknowns().fixed.apply(free);
    w -= free;
    return w;
  }



  template <int dim, int n_components>
  bool
  velocities_stay(SpatialProblem<dim, n_components> &problem, const double time)
  {
    return problem.boundary_values().velocities_become_constant() &&
           time >= problem.longest_ramp();
  }



  std::vector<unsigned int>
  fixed_entries(const Unknowns &unknowns)
  {
    const unsigned int        n_components = unknowns.fixed.n_components();
    std::vector<unsigned int> result;
    for (unsigned int i = 0; i < unknowns.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        if (!unknowns.fixed.is_active(i, c))
          result.push_back(i * n_components + c);
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim, n_components)                             \
  template NodalVector known_velocities(SpatialProblem<dim, n_components> &, \
                                        const double);                       \
  template bool        velocities_stay(SpatialProblem<dim, n_components> &,  \
                                       const double);

  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
  STICKSLIP_INSTANTIATE(2, 1)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
