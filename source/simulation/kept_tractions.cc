// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/shear_traction.h>
#include <stickslip/simulation/kept_tractions.h>

namespace StickSlip
{
  namespace
  {
    /** p = M w, with the lumped mass if there is one. */
    template <int dim, int n_components>
    void
    multiply_mass(const SpatialProblem<dim, n_components> &problem,
                  const LumpedMass<dim, n_components>     *lumped_mass,
                  const NodalVector                       &w,
                  NodalVector                             &p)
    {
      if (lumped_mass)
        lumped_mass->vmult(p, w);
      else
        problem.term(SpatialProblem<dim, n_components>::mass).vmult(p, w);
    }



    /** The forces that contact and sides balance, f - M a - C v - K u, N, a
     * dual vector of the jump basis. */
    template <int dim, int n_components>
    NodalVector
    balanced_forces(SpatialProblem<dim, n_components>   &problem,
                    const SystemState<dim>              &state,
                    const LumpedMass<dim, n_components> *lumped_mass)
    {
      using Problem      = SpatialProblem<dim, n_components>;
      NodalVector result = problem.make_vector(), w = result, product = result;
      problem.to_jumps(w, state.displacement);
      problem.term(Problem::stiffness)
        .residual(result, problem.load(state.time), w);
      if (problem.has(Problem::damping))
        {
          // Viscous forces of central differences lag by half a step.
          const bool lags = lumped_mass && state.mean_velocity.size() > 0;
          problem.to_jumps(w, lags ? state.mean_velocity : state.velocity);
          problem.term(Problem::damping).vmult(product, w);
          result -= product;
        }
      if (problem.has(Problem::mass))
        {
          problem.to_jumps(w, state.acceleration);
          multiply_mass(problem, lumped_mass, w, product);
          result -= product;
        }
      return result;
    }



    /** The traction at a slave node by laws and pressures. */
    template <int dim, int n_components>
    Tensor<1, n_components>
    traction_of_laws(const FaultNodes<dim>  &faults,
                     const NodeLaws         &laws,
                     const SystemState<dim> &state,
                     const unsigned int      k)
    {
      Tensor<1, n_components>  result;
      const Tensor<1, dim - 1> shear = written_traction(faults, laws, state, k);
      for (unsigned int d = 0; d < dim - 1; ++d)
        result[d] = shear[d];
      if constexpr (n_components == dim)
        result[dim - 1] = -faults.opening_sign(k) * state.contact_pressure[k];
      return result;
    }
  } // namespace



  template <int dim, int n_components>
  KeptTractions<dim, n_components>::KeptTractions(
    SpatialProblem<dim, n_components>   &problem,
    const FaultNodes<dim>               &faults,
    const NodeLaws                      &laws,
    const SystemState<dim>              &state,
    const LumpedMass<dim, n_components> *lumped_mass)
    : problem(problem)
    , faults(faults)
    , tractions(faults.size())
    , velocity(state.velocity)
    , acceleration(state.acceleration)
  {
    // Accelerations of faults that open are means over a step.
    const bool  ask_laws = !state.gap.empty() && problem.has(problem.mass);
    NodalVector forces   = problem.make_vector();
    if (!ask_laws)
      forces = balanced_forces(problem, state, lumped_mass);
    NodalVector of_nodes = problem.make_vector();
    for (const unsigned int k : faults.owned_contact())
      {
        const double       weight = faults.weights()[k];
        const unsigned int first  = faults.node(k) * n_components;
        if (ask_laws)
          tractions[k] =
            traction_of_laws<dim, n_components>(faults, laws, state, k);
        else
          for (unsigned int c = 0; c < n_components; ++c)
            tractions[k][c] = forces.local_element(first + c) / weight;
        for (unsigned int c = 0; c < n_components; ++c)
          of_nodes.local_element(first + c) = weight * tractions[k][c];
      }
    of_tractions = problem.to_nodal_forces(of_nodes);
    if (problem.partner_force().is_there())
      {
        of_nodes = 0.;
        problem.partner_force().add(state.time, 1., of_nodes);
        of_partners = problem.to_nodal_forces(of_nodes);
      }
  }



  template <int dim, int n_components>
  PartnerForce
  KeptTractions<dim, n_components>::force(
    const SystemState<dim>              &state,
    const LumpedMass<dim, n_components> *lumped_mass,
    const double                         part,
    const double                         rate) const
  {
    PartnerForce result;
    result.start = state.time;
    result.rate  = rate;

    NodalVector change = problem.to_dual(of_tractions);
    change *= -1.;
    for (const unsigned int k : faults.owned_contact())
      for (unsigned int c = 0; c < n_components; ++c)
        change.local_element(faults.node(k) * n_components + c) +=
          faults.weights()[k] * tractions[k][c];
    result.last = change;
    result.last *= -part;

    result.first = std::move(change);
    if (of_partners.size() > 0)
      result.first += problem.to_dual(of_partners);
    // Slave sides have followed their partners.
    NodalVector nodal, w = problem.make_vector(), product = w;
    if (problem.has(problem.damping))
      {
        nodal = state.velocity;
        nodal -= velocity;
        problem.to_jumps(w, nodal);
        problem.term(problem.damping).vmult(product, w);
        result.first += product;
      }
    if (problem.has(problem.mass) && state.gap.empty())
      {
        nodal = state.acceleration;
        nodal -= acceleration;
        problem.to_jumps(w, nodal);
        multiply_mass(problem, lumped_mass, w, product);
        result.first += product;
      }
    return result;
  }



  template class KeptTractions<2>;
  template class KeptTractions<3>;
  template class KeptTractions<2, 1>;
} // namespace StickSlip
