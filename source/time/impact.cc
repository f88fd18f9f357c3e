// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_cg.h>

#include <stickslip/time/impact.h>

namespace StickSlip
{
  namespace
  {
    /** A matrix between components that are not masked. */
    template <int dim>
    struct MaskedMatrix
    {
      const BlockMatrix<dim> &matrix;
      const NodeMask         &active;

      void
      vmult(NodalVector &y, const NodalVector &x) const
      {
        matrix.vmult(y, x);
        active.apply(y);
      }
    };



    /** The inverse of the diagonal, which may be zero where it is masked. */
    template <int dim>
    struct InverseDiagonal
    {
      const BlockMatrix<dim> &matrix;
      const NodeMask         &active;

      void
      vmult(NodalVector &y, const NodalVector &x) const
      {
        for (unsigned int i = 0; i < matrix.n_rows(); ++i)
          {
            const double *block = matrix.block(matrix.sparsity().diagonal[i]);
            for (unsigned int c = 0; c < dim; ++c)
              y.local_element(i * dim + c) =
                active.is_active(i, c) ?
                  x.local_element(i * dim + c) / block[c * dim + c] :
                  0.;
          }
      }
    };
  } // namespace



  template <int dim>
  double
  stop_impacts(const SpatialProblem<dim> &problem,
               const FaultNodes<dim>     &faults,
               const std::vector<bool>   &touching,
               NodalVector               &w)
  {
    constexpr double       reduction      = 1e-12;
    constexpr unsigned int max_iterations = 1000;

    NodeMask    active = problem.hierarchy().finest().fixed;
    NodalVector change = problem.make_vector();
    bool        is_any = false;
    for (const unsigned int k : faults.owned_contact())
      if (touching[k])
        {
          const unsigned int position    = faults.node(k) * dim + dim - 1;
          change.local_element(position) = -w.local_element(position);
          is_any = is_any || w.local_element(position) != 0.;
          active.mask(faults.node(k), dim - 1);
        }
    if (Utilities::MPI::max(static_cast<int>(is_any),
                            w.get_mpi_communicator()) == 0)
      return 0.;

    const BlockMatrix<dim> &mass  = problem.term(SpatialProblem<dim>::mass);
    const NodalVector       jumps = change;
    NodalVector             rhs = change, product = change;
    mass.vmult(rhs, jumps);
    rhs *= -1.;
    active.apply(rhs);
    change = 0.;
    // There is nothing to solve where nothing else moves with the jumps.
    if (const double norm = rhs.l2_norm(); norm > 0.)
      {
        SolverControl control(max_iterations, reduction * norm);
        SolverCG<NodalVector>(control).solve(MaskedMatrix<dim>{mass, active},
                                             change,
                                             rhs,
                                             InverseDiagonal<dim>{mass,
                                                                  active});
      }
    change += jumps;

    // |w|^2 - |w + d|^2 = |d|^2 for a projection.
    mass.vmult(product, change);
    w += change;
    return 0.5 * (change * product);
  }



  template double
  stop_impacts<2>(const SpatialProblem<2> &,
                  const FaultNodes<2> &,
                  const std::vector<bool> &,
                  NodalVector &);
  template double
  stop_impacts<3>(const SpatialProblem<3> &,
                  const FaultNodes<3> &,
                  const std::vector<bool> &,
                  NodalVector &);
} // namespace StickSlip
