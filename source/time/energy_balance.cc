// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/magnitude.h>
#include <stickslip/time/energy_balance.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  namespace
  {
    /** One component of one row of A x. */
    template <int n_components>
    double
    row_product(const BlockMatrix<n_components> &A,
                const unsigned int               row,
                const unsigned int               component,
                const NodalVector               &x)
    {
      const BlockSparsity &sparsity = A.sparsity();
      double               sum      = 0.;
      for (unsigned int position = sparsity.row_start[row];
           position < sparsity.row_start[row + 1];
           ++position)
        for (unsigned int d = 0; d < n_components; ++d)
          sum += A.block(position)[component * n_components + d] *
                 x.begin()[sparsity.column[position] * n_components + d];
      return sum;
    }
  } // namespace



  void
  EnergyTerms::add(const double factor, const EnergyTerms &other)
  {
    loads += factor * other.loads;
    driven_sides += factor * other.driven_sides;
    viscosity += factor * other.viscosity;
    friction += factor * other.friction;
    radiation += factor * other.radiation;
    contact += factor * other.contact;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::start(const SystemState<dim> &state)
  {
    account                = EnergyAccount();
    account.initial_energy = kinetic_energy(state) + elastic_energy(state);
    restart(state);
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::add(const SystemState<dim> &state,
                                        const double            tau,
                                        const ContactEnergy    &contact)
  {
    account.work.add(tau / 2., account.last_powers);
    restart(state);
    account.work.add(tau / 2., account.last_powers);
    account.work.contact += contact.lost;
    account.work.loads += contact.of_offset;
  }



  template <int dim, int n_components>
  void
  EnergyBalance<dim, n_components>::restart(const SystemState<dim> &state)
  {
    account.last_powers = powers(state);
  }



  template <int dim, int n_components>
  EnergyTerms
  EnergyBalance<dim, n_components>::powers(const SystemState<dim> &state) const
  {
    NodalVector v = problem.make_vector(), u = v;
    problem.to_jumps(v, state.velocity);
    problem.to_jumps(u, state.displacement);
    const NodalVector f = problem.load(state.time);

    // Terms of the equation and the vectors they are applied to.
    std::vector<
      std::pair<const BlockMatrix<n_components> *, const NodalVector *>>
                forces;
    NodalVector a;
    if (problem.has(SpatialProblem<dim, n_components>::mass))
      {
        a = problem.make_vector();
        problem.to_jumps(a, state.acceleration);
        forces.emplace_back(
          &problem.term(SpatialProblem<dim, n_components>::mass), &a);
      }
    if (problem.has(SpatialProblem<dim, n_components>::damping))
      forces.emplace_back(
        &problem.term(SpatialProblem<dim, n_components>::damping), &v);
    forces.emplace_back(
      &problem.term(SpatialProblem<dim, n_components>::stiffness), &u);

    EnergyTerms result;
    result.loads = f * v;
    if (problem.has(SpatialProblem<dim, n_components>::damping))
      {
        NodalVector product = problem.make_vector();
        problem.term(SpatialProblem<dim, n_components>::damping)
          .vmult(product, v);
        result.viscosity = product * v;
      }

    // Prescribed velocities are the only ones that are not zero where a
    // component is fixed.
    const LevelDescription<n_components> &finest = problem.hierarchy().finest();
    for (const auto &force : forces)
      update_ghosts(*force.second);
    double driven = 0.;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        {
          const double velocity = v.local_element(i * n_components + c);
          if (finest.fixed.is_active(i, c) || velocity == 0.)
            continue;
          double force = -f.local_element(i * n_components + c);
          for (const auto &[matrix, factor] : forces)
            force += row_product(*matrix, i, c, *factor);
          driven += force * velocity;
        }
    result.driven_sides =
      Utilities::MPI::sum(driven, finest.nodes.communicator());

    // Every process has all nodes.
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        const FrictionLaw &law = *laws[k].friction;
        const double       V   = magnitude(state.slip_rate[k]);
        if (faults.weights()[k] > 0. && V > 0.)
          {
            result.friction +=
              faults.weights()[k] * state.normal_stress[k] *
              law.coefficient(V, law.node_data(state.alpha[k])) * V;
            // Forces at nodes of known slip rate are those of driven sides.
            if (!laws[k].is_prescribed)
              result.radiation +=
                faults.weights()[k] * laws[k].radiation_damping * V * V;
          }
      }
    return result;
  }



  template <int dim, int n_components>
  double
  EnergyBalance<dim, n_components>::quadratic_form(
    const typename SpatialProblem<dim, n_components>::Term term,
    const NodalVector                                     &x) const
  {
    NodalVector w = problem.make_vector(), product = w;
    problem.to_jumps(w, x);
    problem.term(term).vmult(product, w);
    return 0.5 * (w * product);
  }



  template class EnergyBalance<2>;
  template class EnergyBalance<3>;
  template class EnergyBalance<2, 1>;
} // namespace StickSlip
