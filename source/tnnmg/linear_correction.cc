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
    template <int dim>
    class ZeroCorrection : public LinearCorrection<dim>
    {
    public:
      void
      linearise(const std::vector<Tensor<2, dim>> &, const NodeMask &) override
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



  template <int dim>
  std::unique_ptr<LinearCorrection<dim>>
  make_linear_correction(LevelHierarchy<dim>            &hierarchy,
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
          return std::make_unique<DirectCorrection<dim>>(
            hierarchy, std::make_unique<UmfpackFactorisation<dim>>());
        case LinearCorrectionType::mumps:
          return std::make_unique<DirectCorrection<dim>>(
            hierarchy, std::make_unique<MumpsFactorisation<dim>>());
        case LinearCorrectionType::amg:
          return std::make_unique<AMGCorrection<dim>>(hierarchy,
                                                      parameters,
                                                      near_null_space);
        case LinearCorrectionType::none:
          return std::make_unique<ZeroCorrection<dim>>();
        case LinearCorrectionType::multigrid:
          break;
      }
    return std::make_unique<MultigridCorrection<dim>>(hierarchy, parameters);
  }



  template <int dim>
  BlockMatrix<dim>
  linearised_matrix(const LevelHierarchy<dim>         &hierarchy,
                    const std::vector<Tensor<2, dim>> &hessians)
  {
    BlockMatrix<dim>                 result = hierarchy.matrix();
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



#define STICKSLIP_INSTANTIATE(dim)                                             \
  template class LinearCorrection<dim>;                                        \
  template std::unique_ptr<LinearCorrection<dim>> make_linear_correction<dim>( \
    LevelHierarchy<dim> &,                                                     \
    const TNNMGParameters &,                                                   \
    const std::vector<NodalVector> &);                                         \
  template BlockMatrix<dim> linearised_matrix<dim>(                            \
    const LevelHierarchy<dim> &, const std::vector<Tensor<2, dim>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
