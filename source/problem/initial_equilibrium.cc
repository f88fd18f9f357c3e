// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_control.h>

#include <stickslip/base/agreed_failure.h>
#include <stickslip/faults/contact_pressure.h>
#include <stickslip/problem/initial_equilibrium.h>
#include <stickslip/problem/stiffness_solution.h>

namespace StickSlip
{
  namespace
  {
    /** Friction resists what the reaction holds. */
    template <int dim>
    std::vector<Tensor<1, dim - 1>>
    shear_tractions(const JumpBasis<dim> &basis,
                    const NodePartition  &nodes,
                    const NodalVector    &reaction)
    {
      std::vector<Tensor<1, dim - 1>> tractions;
      for (const FaultContact<dim> &contact : basis.faults())
        {
          const std::vector<Tensor<1, dim>> forces =
            gather_nodes<dim>(reaction, nodes, contact.slave.nodes);
          for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
            {
              tractions.emplace_back();
              if (contact.coupling.active[k])
                for (unsigned int d = 0; d < dim - 1; ++d)
                  tractions.back()[d] =
                    -forces[k][d] / contact.coupling.weight[k];
            }
        }
      return tractions;
    }
  } // namespace



  template <int dim, int n_components>
  unsigned int
  solve_with_known_jumps(SpatialProblem<dim, n_components> &problem,
                         const NodalVector                 &load,
                         NodalVector                       &w)
  {
    constexpr double reduction = 1e-12;

    const LevelDescription<n_components> &finest = problem.hierarchy().finest();

    NodeMask active = finest.fixed;
    for (const unsigned int p : finest.nonsmooth_nodes)
      active.mask_node(p);
    const std::string failure =
      "The static equilibrium at the start was not found: ";
    try
      {
        return solve_stiffness(problem, active, load, reduction, w);
      }
    catch (const SingularCoarseMatrix &error)
      {
        throw AgreedFailure(failure + error.what() +
                            ". Sizes and materials of the bodies must not be "
                            "out of all proportion.");
      }
    catch (const SolverControl::NoConvergence &)
      {
        throw AgreedFailure(failure +
                            "the boundary conditions must hold every body.");
      }
  }



  template <int dim, int n_components>
  InitialEquilibrium<dim>
  solve_initial_equilibrium(SpatialProblem<dim, n_components> &problem)
  {
    const NodePartition &nodes = problem.hierarchy().finest().nodes;
    const NodalVector    load  = problem.load(0.);
    NodalVector          w     = problem.make_vector();

    InitialEquilibrium<dim> result;
    result.iterations = solve_with_known_jumps(problem, load, w);

    NodalVector reaction = problem.make_vector();
    problem.operators().matrix().residual(reaction, load, w);
    reaction *= -1.;
    result.contact_pressure =
      contact_pressures(problem.jump_basis(), nodes, reaction);
    result.shear_traction =
      shear_tractions(problem.jump_basis(), nodes, reaction);
    result.displacement = problem.make_nodal_vector();
    problem.to_nodal(result.displacement, w);
    return result;
  }



  template decltype(solve_with_known_jumps<2>)    solve_with_known_jumps<2>;
  template decltype(solve_with_known_jumps<3>)    solve_with_known_jumps<3>;
  template decltype(solve_with_known_jumps<2, 1>) solve_with_known_jumps<2, 1>;
  template decltype(solve_initial_equilibrium<2>) solve_initial_equilibrium<2>;
  template decltype(solve_initial_equilibrium<3>) solve_initial_equilibrium<3>;
  template decltype(solve_initial_equilibrium<2, 1>)
    solve_initial_equilibrium<2, 1>;
} // namespace StickSlip
