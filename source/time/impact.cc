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
    template <int n_components>
    struct MaskedMatrix
    {
      const TermMatrix<n_components> &matrix;
      const NodeMask                 &active;

      void
      vmult(NodalVector &y, const NodalVector &x) const
      {
        matrix.vmult(y, x);
        active.apply(y);
      }
    };



    /** The inverse of the diagonal, which may be zero where it is masked. */
    template <int n_components>
    struct InverseDiagonal
    {
      const TermMatrix<n_components> &matrix;
      const NodeMask                 &active;

      void
      vmult(NodalVector &y, const NodalVector &x) const
      {
        for (unsigned int i = 0; i < matrix.n_rows(); ++i)
          {
            const Tensor<2, n_components> block = matrix.diagonal_block(i);
            for (unsigned int c = 0; c < n_components; ++c)
              y.local_element(i * n_components + c) =
                active.is_active(i, c) ?
                  x.local_element(i * n_components + c) / block[c][c] :
                  0.;
          }
      }
    };
  } // namespace



  template <int dim, int n_components>
  double
  stop_impacts(const SpatialProblem<dim, n_components> &problem,
               const FaultNodes<dim>                   &faults,
               const std::vector<bool>                 &touching,
               NodalVector                             &w)
  {
    constexpr double       reduction      = 1e-12;
    constexpr unsigned int max_iterations = 1000;

    NodeMask    active = problem.hierarchy().finest().fixed;
    NodalVector change = problem.make_vector();
    bool        is_any = false;
    for (const unsigned int k : faults.owned_contact())
      if (touching[k])
        {
          const unsigned int position = faults.node(k) * n_components + dim - 1;
          change.local_element(position) = -w.local_element(position);
          is_any = is_any || w.local_element(position) != 0.;
          active.mask(faults.node(k), dim - 1);
        }
    if (Utilities::MPI::max(static_cast<int>(is_any),
                            w.get_mpi_communicator()) == 0)
      return 0.;

    const TermMatrix<n_components> &mass =
      problem.term(SpatialProblem<dim, n_components>::mass);
    const NodalVector jumps = change;
    NodalVector       rhs = change, product = change;
    mass.vmult(rhs, jumps);
    rhs *= -1.;
    active.apply(rhs);
    change = 0.;
    // There is nothing to solve where nothing else moves with the jumps.
    if (const double norm = rhs.l2_norm(); norm > 0.)
      {
        SolverControl control(max_iterations, reduction * norm);
        SolverCG<NodalVector>(control).solve(
          MaskedMatrix<n_components>{mass, active},
          change,
          rhs,
          InverseDiagonal<n_components>{mass, active});
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
  template double
  stop_impacts<2, 1>(const SpatialProblem<2, 1> &,
                     const FaultNodes<2> &,
                     const std::vector<bool> &,
                     NodalVector &);
} // namespace StickSlip
