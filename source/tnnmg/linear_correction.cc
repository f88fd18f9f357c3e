// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/mumps_factorisation.h>
#include <stickslip/algebra/umfpack_factorisation.h>
#include <stickslip/tnnmg/direct_correction.h>
#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/multigrid_correction.h>

namespace StickSlip
{
  template <int n_components>
  std::unique_ptr<LinearCorrection<n_components>>
  make_linear_correction(LevelHierarchy<n_components> &hierarchy,
                         const TNNMGParameters        &parameters)
  {
    const LinearCorrectionType type = parameters.linear_correction;
    AssertThrow(!is_serial(type) ||
                  Utilities::MPI::n_mpi_processes(
                    hierarchy.finest().nodes.communicator()) == 1,
                ExcMessage("This linear correction runs on one process only."));
    if (type == LinearCorrectionType::umfpack)
      return std::make_unique<DirectCorrection<n_components>>(
        hierarchy.operators(),
        std::make_unique<UmfpackFactorisation<n_components>>());
    if (type == LinearCorrectionType::mumps)
      return std::make_unique<DirectCorrection<n_components>>(
        hierarchy.operators(),
        std::make_unique<MumpsFactorisation<n_components>>());
    return std::make_unique<MultigridCorrection<n_components>>(hierarchy,
                                                               parameters);
  }



  bool
  is_serial(const LinearCorrectionType type)
  {
    return type != LinearCorrectionType::multigrid;
  }



#define STICKSLIP_INSTANTIATE(n_components)                            \
  template class LinearCorrection<n_components>;                       \
  template std::unique_ptr<LinearCorrection<n_components>>             \
  make_linear_correction<n_components>(LevelHierarchy<n_components> &, \
                                       const TNNMGParameters &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
