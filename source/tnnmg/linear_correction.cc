// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/mumps_factorisation.h>
#include <stickslip/algebra/umfpack_factorisation.h>
#include <stickslip/tnnmg/amg_correction.h>
#include <stickslip/tnnmg/direct_correction.h>
#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/multigrid_correction.h>

namespace StickSlip
{
  namespace
  {
    /** No correction at all. */
    template <int n_components>
    class ZeroCorrection : public LinearCorrection<n_components>
    {
    public:
      void
      linearise(const std::vector<Tensor<2, n_components>> &,
                const NodeMask &) override
      {}

      unsigned int
      solve(NodalVector &x, NodalVector &A_x, NodalVector &) override
      {
        x   = 0.;
        A_x = 0.;
        return 0;
      }
    };
  } // namespace



  template <int n_components>
  std::unique_ptr<LinearCorrection<n_components>>
  make_linear_correction(LevelHierarchy<n_components>   &hierarchy,
                         const TNNMGParameters          &parameters,
                         const std::vector<NodalVector> &near_null_space)
  {
    const LinearCorrectionType type = parameters.linear_correction;
    AssertThrow(!is_serial(type) ||
                  Utilities::MPI::n_mpi_processes(
                    hierarchy.finest().nodes.communicator()) == 1,
                ExcMessage("This linear correction runs on one process only."));
    switch (type)
      {
        case LinearCorrectionType::umfpack:
          return std::make_unique<DirectCorrection<n_components>>(
            hierarchy, std::make_unique<UmfpackFactorisation<n_components>>());
        case LinearCorrectionType::mumps:
          return std::make_unique<DirectCorrection<n_components>>(
            hierarchy, std::make_unique<MumpsFactorisation<n_components>>());
        case LinearCorrectionType::amg:
          return std::make_unique<AMGCorrection<n_components>>(hierarchy,
                                                               parameters,
                                                               near_null_space);
        case LinearCorrectionType::none:
          return std::make_unique<ZeroCorrection<n_components>>();
        case LinearCorrectionType::multigrid:
          break;
      }
    return std::make_unique<MultigridCorrection<n_components>>(hierarchy,
                                                               parameters);
  }



  template <int n_components>
  BlockMatrix<n_components>
  linearised_matrix(const LevelHierarchy<n_components>         &hierarchy,
                    const std::vector<Tensor<2, n_components>> &hessians)
  {
    BlockMatrix<n_components>        result = hierarchy.matrix();
    const std::vector<unsigned int> &nodes = hierarchy.finest().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      result.set_diagonal_block(nodes[k],
                                result.diagonal_block(nodes[k]) + hessians[k]);
    return result;
  }



  bool
  is_serial(const LinearCorrectionType type)
  {
    return type == LinearCorrectionType::umfpack ||
           type == LinearCorrectionType::mumps ||
           type == LinearCorrectionType::amg;
  }



#define STICKSLIP_INSTANTIATE(n_components)                               \
  template class LinearCorrection<n_components>;                          \
  template std::unique_ptr<LinearCorrection<n_components>>                \
  make_linear_correction<n_components>(LevelHierarchy<n_components> &,    \
                                       const TNNMGParameters &,           \
                                       const std::vector<NodalVector> &); \
  template BlockMatrix<n_components> linearised_matrix<n_components>(     \
    const LevelHierarchy<n_components> &,                                 \
    const std::vector<Tensor<2, n_components>> &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
