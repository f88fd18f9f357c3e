// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <stickslip/parameters/agreed_failure.h>
#include <stickslip/time/initial_equilibrium.h>
#include <stickslip/tnnmg/linearised_operator.h>

#include <limits>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    void
    set_contact_tractions(InitialEquilibrium<dim> &result,
                          const JumpBasis<dim>    &basis,
                          const NodePartition     &nodes,
                          const NodalVector       &reaction)
    {
      for (const FaultContact<dim> &contact : basis.faults())
        {
          const std::vector<Tensor<1, dim>> forces =
            gather_nodes<dim>(reaction, nodes, contact.slave_nodes);
          const MortarCoupling &coupling = contact.coupling;
          // The reaction pushes the slave side up if that is the upper one.
          const double       sign = contact.sides.slave_is_upper() ? 1. : -1.;
          const unsigned int n    = contact.slave_nodes.size();
          for (unsigned int k = 0; k < n; ++k)
            {
              unsigned int nearest  = k;
              double       distance = std::numeric_limits<double>::max();
              if (!coupling.active[k])
                for (unsigned int m = 0; m < n; ++m)
                  if (coupling.active[m] &&
                      contact.slave_surface.points[k].distance(
                        contact.slave_surface.points[m]) < distance)
                    {
                      nearest  = m;
                      distance = contact.slave_surface.points[k].distance(
                        contact.slave_surface.points[m]);
                    }
              // The unknown is averaging_factor times the jump of the node,
              // and so is the force on it times the weight.
              result.contact_pressure.push_back(
                sign * forces[nearest][dim - 1] / coupling.weight[nearest]);
              // Friction resists what the reaction holds.
              result.shear_traction.emplace_back();
              if (coupling.active[k])
                for (unsigned int d = 0; d < dim - 1; ++d)
                  result.shear_traction.back()[d] =
                    -forces[k][d] / coupling.weight[k];
            }
        }
    }
  } // namespace



  template <int dim>
  InitialEquilibrium<dim>
  solve_initial_equilibrium(SpatialProblem<dim> &problem)
  {
    constexpr double       reduction      = 1e-12;
    constexpr unsigned int max_iterations = 1000;

    LevelHierarchy<dim>         &hierarchy = problem.hierarchy();
    const LevelDescription<dim> &finest    = hierarchy.finest();

    std::vector<double> coefficients(3, 0.);
    coefficients[SpatialProblem<dim>::stiffness] = 1.;
    problem.combine(coefficients);
    NodeMask stuck = finest.fixed;
    for (const unsigned int p : finest.nonsmooth_nodes)
      stuck.mask_node(p);
    try
      {
        hierarchy.linearise(
          std::vector<Tensor<2, dim>>(finest.nonsmooth_nodes.size()), stuck);
      }
    catch (const SingularCoarseMatrix &error)
      {
        throw AgreedFailure("The static equilibrium at the start was not "
                            "found: " +
                            std::string(error.what()) +
                            ". Sizes and materials of the bodies must not be "
                            "out of all proportion.");
      }

    const NodalVector load = problem.load(0.);
    NodalVector       rhs  = load;
    stuck.apply(rhs);
    NodalVector w = problem.make_vector();

    InitialEquilibrium<dim> result;
    SolverControl           control(max_iterations, reduction * rhs.l2_norm());
    if (rhs.l2_norm() > 0.)
      try
        {
          SolverCG<NodalVector>(control).solve(
            LinearisedOperator<dim>{hierarchy},
            w,
            rhs,
            CyclePreconditioner<dim>{hierarchy});
        }
      catch (const SolverControl::NoConvergence &)
        {
          throw AgreedFailure("The static equilibrium at the start was not "
                              "found: the boundary conditions must hold every "
                              "body.");
        }
    // Without a load nothing was solved, and the control has no last step.
    if (rhs.l2_norm() > 0.)
      result.iterations = control.last_step();

    NodalVector reaction = problem.make_vector();
    hierarchy.matrix().residual(reaction, load, w);
    reaction *= -1.;
    set_contact_tractions(result, problem.jump_basis(), finest.nodes, reaction);
    result.displacement = problem.make_nodal_vector();
    problem.to_nodal(result.displacement, w);
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                                 \
  template struct InitialEquilibrium<dim>;                         \
  template InitialEquilibrium<dim> solve_initial_equilibrium<dim>( \
    SpatialProblem<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
