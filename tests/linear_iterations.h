// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_linear_iterations_h
#define stickslip_tests_linear_iterations_h

#include <stickslip/multigrid/level_hierarchy.h>

namespace StickSlip::Tests
{
  /** CG steps with one V-cycle each that reduce the residual @p r by 1e-8, at
   * most 200. */
  template <int dim>
  unsigned int
  cg_iterations(LevelHierarchy<dim> &hierarchy, NodalVector r)
  {
    NodalVector  z = r, p = r, Ap = r;
    const double target = 1e-8 * r.l2_norm();
    double       rz     = 0;
    for (unsigned int k = 0; k < 200; ++k)
      {
        if (r.l2_norm() <= target)
          return k;
        hierarchy.v_cycle(z, r);
        const double rz_new = r * z;
        if (k == 0)
          p = z;
        else
          p.sadd(rz_new / rz, 1., z);
        rz = rz_new;
        hierarchy.vmult_linearised(Ap, p);
        r.add(-rz / (p * Ap), Ap);
      }
    return 200;
  }
} // namespace StickSlip::Tests

#endif
