// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/magnitude.h>
#include <stickslip/time/energy_balance.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    bool
    has_viscosity(const SpatialProblem<dim> &problem)
    {
      const auto &values =
        problem.hierarchy().term(SpatialProblem<dim>::damping).values();
      const bool here = std::any_of(values.begin(),
                                    values.end(),
                                    [](const double x) { return x != 0.; });
      return Utilities::MPI::max(
               here ? 1 : 0,
               problem.hierarchy().finest().nodes.communicator()) > 0;
    }



    /** One component of one row of A x. */
    template <int dim>
    double
    row_product(const BlockMatrix<dim> &A,
                const unsigned int      row,
                const unsigned int      component,
                const NodalVector      &x)
    {
      const BlockSparsity &sparsity = A.sparsity();
      double               sum      = 0.;
      for (unsigned int position = sparsity.row_start[row];
           position < sparsity.row_start[row + 1];
           ++position)
        for (unsigned int d = 0; d < dim; ++d)
          sum += A.block(position)[component * dim + d] *
                 x.local_element(sparsity.column[position] * dim + d);
      return sum;
    }
  } // namespace



  double
  EnergyTerms::gain() const
  {
    return loads + driven_sides - viscosity - friction;
  }



  void
  EnergyTerms::add(const double factor, const EnergyTerms &other)
  {
    loads += factor * other.loads;
    driven_sides += factor * other.driven_sides;
    viscosity += factor * other.viscosity;
    friction += factor * other.friction;
  }



  template <int dim>
  EnergyBalance<dim>::EnergyBalance(SpatialProblem<dim>    &problem,
                                    const FaultNodes<dim>  &faults,
                                    const SystemState<dim> &start)
    : problem(problem)
    , faults(faults)
    , is_viscous(has_viscosity(problem))
    , initial_energy(kinetic_energy(start) + elastic_energy(start))
  {
    reinit(start);
  }



  template <int dim>
  void
  EnergyBalance<dim>::add(const SystemState<dim> &state)
  {
    const double half_step = 0.5 * (state.time - last_time);
    total.add(half_step, last_powers);
    reinit(state);
    total.add(half_step, last_powers);
  }



  template <int dim>
  void
  EnergyBalance<dim>::reinit(const SystemState<dim> &state)
  {
    last_time   = state.time;
    last_powers = powers(state);
  }



  template <int dim>
  const EnergyTerms &
  EnergyBalance<dim>::work() const
  {
    return total;
  }



  template <int dim>
  double
  EnergyBalance<dim>::kinetic_energy(const SystemState<dim> &state) const
  {
    return quadratic_form(SpatialProblem<dim>::mass, state.velocity);
  }



  template <int dim>
  double
  EnergyBalance<dim>::elastic_energy(const SystemState<dim> &state) const
  {
    return quadratic_form(SpatialProblem<dim>::stiffness, state.displacement);
  }



  template <int dim>
  double
  EnergyBalance<dim>::defect(const SystemState<dim> &state) const
  {
    return kinetic_energy(state) + elastic_energy(state) - initial_energy -
           total.gain();
  }



  template <int dim>
  EnergyTerms
  EnergyBalance<dim>::powers(const SystemState<dim> &state) const
  {
    const LevelHierarchy<dim> &hierarchy = problem.hierarchy();
    NodalVector v = problem.make_vector(), u = v, a = v, product = v;
    problem.to_jumps(v, state.velocity);
    problem.to_jumps(u, state.displacement);
    problem.to_jumps(a, state.acceleration);
    const NodalVector f = problem.load(state.time);

    EnergyTerms result;
    result.loads = f * v;
    if (is_viscous)
      {
        hierarchy.term(SpatialProblem<dim>::damping).vmult(product, v);
        result.viscosity = product * v;
      }

    // Prescribed velocities are the only ones that are not zero where a
    // component is fixed.
    const LevelDescription<dim>             &finest  = hierarchy.finest();
    const std::array<const NodalVector *, 3> factors = {{&a, &v, &u}};
    for (const NodalVector *factor : factors)
      update_ghosts(*factor);
    double driven = 0.;
    for (unsigned int i = 0; i < finest.nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double velocity = v.local_element(i * dim + c);
          if (finest.fixed.is_active(i, c) || velocity == 0.)
            continue;
          double force = -f.local_element(i * dim + c);
          for (unsigned int k = 0; k < 3; ++k)
            force += row_product(hierarchy.term(k), i, c, *factors[k]);
          driven += force * velocity;
        }
    result.driven_sides =
      Utilities::MPI::sum(driven, finest.nodes.communicator());

    // The same on all processes.
    for (unsigned int k = 0; k < faults.size(); ++k)
      {
        const FrictionLaw &law = *faults.law(k).friction;
        const double       V   = magnitude(state.slip_rate[k]);
        if (faults.weights()[k] > 0. && V > 0.)
          result.friction += faults.weights()[k] * faults.normal_stress()[k] *
                             law.coefficient(V, law.node_data(state.alpha[k])) *
                             V;
      }
    return result;
  }



  template <int dim>
  double
  EnergyBalance<dim>::quadratic_form(const unsigned int term,
                                     const NodalVector &x) const
  {
    NodalVector w = problem.make_vector(), product = w;
    problem.to_jumps(w, x);
    problem.hierarchy().term(term).vmult(product, w);
    return 0.5 * (w * product);
  }



  template class EnergyBalance<2>;
  template class EnergyBalance<3>;
} // namespace StickSlip
