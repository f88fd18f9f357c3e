// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_fault_snapshots_h
#define stickslip_tests_fault_snapshots_h

#include <stickslip/problem/shear_traction.h>
#include <stickslip/simulation/fault_snapshots.h>
#include <stickslip/simulation/simulation.h>

namespace StickSlip::Tests
{
  /** The faults of a simulation as they are now. */
  template <int dim, int n_components>
  std::vector<FaultSnapshot<dim>>
  snapshots(Simulation<dim, n_components>  &simulation,
            const std::vector<std::string> &names = {"fault"})
  {
    return make_fault_snapshots(simulation.state(),
                                simulation.fault_nodes(),
                                shear_tractions(simulation.fault_nodes(),
                                                simulation.node_laws(),
                                                simulation.state()),
                                simulation.spatial_problem().jump_basis(),
                                names);
  }
} // namespace StickSlip::Tests

#endif
