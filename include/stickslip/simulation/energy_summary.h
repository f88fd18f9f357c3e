// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_energy_summary_h
#define stickslip_simulation_energy_summary_h

#include <stickslip/output/run_summary.h>
#include <stickslip/time/energy_balance.h>
#include <stickslip/time/time_parameters.h>

namespace StickSlip
{
  /**
   * Kinetic and elastic energy at @p state, the work since the start, those of
   * them that the model with this @p inertia has, and what is missing between
   * them, in J, in two dimensions for 1 m of the third one. Collective.
   */
  template <int dim>
  void
  summarise_energy(RunSummary               &summary,
                   const EnergyBalance<dim> &energy,
                   const SystemState<dim>   &state,
                   const Inertia             inertia);
} // namespace StickSlip

#endif
