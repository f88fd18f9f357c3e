// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_geometric_multigrid_h
#define stickslip_contrib_geometric_multigrid_h

#include <deal.II/base/mg_level_object.h>
// Before mg_constrained_dofs.h, which does not include it in deal.II 9.6.
#include <deal.II/fe/component_mask.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/multigrid/mg_constrained_dofs.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_transfer.h>
#include <deal.II/multigrid/multigrid.h>

#include <memory>

#include "welded_problem.h"

namespace Measure
{
  /**
   * The geometric multigrid method of deal.II as its tutorial programs step-16
   * and step-50 use it: level matrices assembled, edge matrices at refinement
   * edges, one step of SOR before and after, symmetric, and a factorisation of
   * the coarsest matrix.
   */
  template <int dim>
  class GeometricMultigrid
  {
  public:
    explicit GeometricMultigrid(WeldedProblem<dim> &problem);

    /** Assemble the matrices of all levels. */
    void
    assemble_levels();

    /** Smoothers, transfer and the factorisation of the coarsest matrix. */
    void
    set_up();

    void
    vmult(Vector<double> &y, const Vector<double> &x) const
    {
      preconditioner->vmult(y, x);
    }

  private:
    struct CoarseSolver : public MGCoarseGridBase<Vector<double>>
    {
      SparseDirectUMFPACK factorisation;

      void
      operator()(const unsigned int,
                 Vector<double>       &x,
                 const Vector<double> &b) const override
      {
        factorisation.vmult(x, b);
      }
    };

    using Smoother =
      mg::SmootherRelaxation<PreconditionSOR<SparseMatrix<double>>,
                             Vector<double>>;
    using Transfer = MGTransferPrebuilt<Vector<double>>;

    WeldedProblem<dim>                 &problem;
    MGConstrainedDoFs                   mg_constrained_dofs;
    MGLevelObject<SparsityPattern>      sparsities, interface_sparsities;
    MGLevelObject<SparseMatrix<double>> matrices, interface_matrices;
    mg::Matrix<Vector<double>>          mg_matrix, mg_interface;
    CoarseSolver                        coarse;
    /** Forwards and backwards; set_symmetric() would need an even number of
     * steps for that. */
    Smoother                                   pre_smoother, post_smoother;
    Transfer                                   transfer;
    std::unique_ptr<Multigrid<Vector<double>>> multigrid;
    std::unique_ptr<PreconditionMG<dim, Vector<double>, Transfer>>
      preconditioner;
  };
} // namespace Measure

#endif
