// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/energy_summary.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  template <int dim>
  void
  summarise_energy(RunSummary               &summary,
                   const EnergyBalance<dim> &energy,
                   const SystemState<dim>   &state,
                   const Inertia             inertia)
  {
    const std::string unit = (dim == 2) ? "J/m" : "J";
    const auto        add  = [&](const std::string &key, const double value) {
      summary.add("Energy", key, value, unit);
    };
    const EnergyTerms &work   = energy.work();
    const double       defect = energy.defect(state);
    if (inertia == Inertia::dynamic)
      add("kinetic, at the end", energy.kinetic_energy(state));
    add("elastic, at the end", energy.elastic_energy(state));
    add("work of driven sides", work.driven_sides);
    add("work of gravity and tractions", work.loads);
    add("dissipated by friction", work.friction);
    add("dissipated by viscosity", work.viscosity);
    if (inertia == Inertia::quasi_dynamic)
      add("dissipated by radiation damping", work.radiation);
    add("missing", defect);

    const double largest = std::max({std::abs(work.driven_sides),
                                     std::abs(work.loads),
                                     work.friction,
                                     work.viscosity,
                                     work.radiation});
    if (largest > 0.)
      summary.add("Energy", "missing, over the largest work", defect / largest);
  }



  template void
  summarise_energy<2>(RunSummary &,
                      const EnergyBalance<2> &,
                      const SystemState<2> &,
                      const Inertia);
  template void
  summarise_energy<3>(RunSummary &,
                      const EnergyBalance<3> &,
                      const SystemState<3> &,
                      const Inertia);
} // namespace StickSlip
