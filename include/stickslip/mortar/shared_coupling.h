// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_shared_coupling_h
#define stickslip_mortar_shared_coupling_h

#include <mpi.h>
#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/side_gaps.h>

namespace StickSlip
{
  /**
   * The coupling that build_mortar_coupling() finds, of which each process
   * finds an equal part. All of them have the surfaces as a whole, and the
   * result. Throws AgreedFailure where that function throws. Collective.
   */
  template <int dim>
  MortarCoupling<dim>
  build_shared_coupling(const FaultSurface<dim>       &slave,
                        const std::vector<Point<dim>> &slave_positions,
                        const FaultSurface<dim>       &master,
                        const std::vector<Point<dim>> &master_positions,
                        const std::vector<bool>       &excluded,
                        const MPI_Comm                &communicator);

  /**
   * The gaps that side_gaps() finds, in the same way.
   */
  template <int dim>
  std::vector<double>
  find_shared_gaps(const FaultSurface<dim>       &slave,
                   const std::vector<Point<dim>> &slave_positions,
                   const FaultSurface<dim>       &master,
                   const std::vector<Point<dim>> &master_positions,
                   const MPI_Comm                &communicator);
} // namespace StickSlip

#endif
