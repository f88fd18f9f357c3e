// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <Epetra_LinearProblem.h>
#include <Epetra_MultiVector.h>
#include <Epetra_RowMatrix.h>
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#include <stickslip/tnnmg/amg_correction.h>

namespace StickSlip
{
  template <int dim>
  AMGCorrection<dim>::AMGCorrection(
    LevelHierarchy<dim>            &hierarchy,
    const TNNMGParameters          &parameters,
    const std::vector<NodalVector> &near_null_space)
    : hierarchy(hierarchy)
    , parameters(parameters)
    , n_modes(near_null_space.size())
    , cg(hierarchy)
  {
    for (const NodalVector &mode : near_null_space)
      null_space.insert(null_space.end(),
                        mode.begin(),
                        mode.begin() + mode.locally_owned_size());
  }



  template <int dim>
  AMGCorrection<dim>::~AMGCorrection() = default;



  template <int dim>
  bool
  AMGCorrection<dim>::is_close(const std::vector<Tensor<2, dim>> &new_hessians,
                               const NodeMask &new_active) const
  {
    const LevelDescription<dim> &finest = hierarchy.finest();
    if (!cycles || version != hierarchy.operator_version() ||
        !active.is_equal(new_active, finest.nodes.n_owned()))
      return false;
    for (unsigned int k = 0; k < new_hessians.size(); ++k)
      {
        const double size =
          hessians[k].norm() +
          hierarchy.matrix().diagonal_block(finest.nonsmooth_nodes[k]).norm();
        // Written so that a NaN is not close.
        if (!((new_hessians[k] - hessians[k]).norm() <=
              parameters.coarse_update_threshold * size))
          return false;
      }
    return true;
  }



  template <int dim>
  void
  AMGCorrection<dim>::linearise(const std::vector<Tensor<2, dim>> &new_hessians,
                                const NodeMask                    &new_active)
  {
    cg.linearise(new_hessians, new_active);
    if (is_close(new_hessians, new_active))
      return;
    version  = hierarchy.operator_version();
    active   = new_active;
    hessians = new_hessians;

    const SilentErrors silence;
    // They refer to the matrix.
    cycles.reset();
    linearised                             = hierarchy.matrix();
    const std::vector<unsigned int> &nodes = hierarchy.finest().nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      linearised.set_diagonal_block(nodes[k],
                                    linearised.diagonal_block(nodes[k]) +
                                      hessians[k]);
    system.set_matrix(linearised, active);

    Teuchos::ParameterList list;
    ML_Epetra::SetDefaults("SA", list);
    list.set("ML output", 0);
    list.set("PDE equations", dim);
    // As the preconditioner of conjugate gradients must be: symmetric.
    list.set("smoother: type", "symmetric Gauss-Seidel");
    list.set("smoother: sweeps", 1);
    list.set("coarse: type", "Amesos-KLU");
    if (n_modes > 0)
      {
        list.set("null space: type", "pre-computed");
        list.set("null space: dimension", static_cast<int>(n_modes));
        list.set("null space: vectors", null_space.data());
      }
    cycles = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(
      system.matrix(), list, /*ComputePrec=*/false);
    if (cycles->ComputePreconditioner() != 0)
      {
        cycles.reset();
        throw SingularMatrix("the linearised matrix");
      }
  }



  template <int dim>
  void
  AMGCorrection<dim>::apply_cycle(NodalVector &x, const NodalVector &b)
  {
    system.set_rhs(b);
    const int error = cycles->ApplyInverse(*system.problem().GetRHS(),
                                           *system.problem().GetLHS());
    AssertThrow(error == 0, ExcMessage("The cycle of ML failed."));
    system.get_solution(x);
    active.apply(x);
  }



  template <int dim>
  unsigned int
  AMGCorrection<dim>::solve(NodalVector &x, NodalVector &A_x, NodalVector &r)
  {
    constexpr unsigned int max_steps = 200;

    return cg.solve([&](NodalVector       &z,
                        const NodalVector &b) { apply_cycle(z, b); },
                    max_steps,
                    parameters.amg_tolerance,
                    x,
                    A_x,
                    r);
  }



  template class AMGCorrection<2>;
  template class AMGCorrection<3>;
} // namespace StickSlip
