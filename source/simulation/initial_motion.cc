// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/base/magnitude.h>
#include <stickslip/friction/common_parameters.h>
#include <stickslip/problem/initial_equilibrium.h>
#include <stickslip/problem/known_velocities.h>
#include <stickslip/simulation/initial_motion.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    InputError
    with_place(const InputError          &error,
               const FaultPart           &part,
               const Point<dim>          &point,
               const GivenStart<dim - 1> &given)
    {
      std::string position;
      for (unsigned int d = 0; d < dim; ++d)
        position += (d == 0 ? "" : ", ") + shortest_form(point[d]);
      const LawParameter entry = given.shear_stress ?
                                   CommonParameters::initial_shear_stress(0) :
                                   CommonParameters::initial_slip_rate(0);
      return InputError("'" + part.section + "/" + entry.entry + "' at (" +
                        position + ") m: " + error.what() + ".");
    }



    /** Starts at each slave node, completed, slave relative to master;
     * nothing at nodes that start at rest. */
    template <int dim>
    std::vector<std::optional<InitialSliding<dim - 1>>>
    initial_sliding(const SceneParameters<dim> &scene,
                    const JumpBasis<dim>       &basis,
                    const NodeLaws             &laws,
                    const std::vector<double>  &normal_stress)
    {
      std::vector<std::optional<InitialSliding<dim - 1>>> result(
        normal_stress.size());
      unsigned int first = 0;
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const std::vector<Point<dim>> &points =
            basis.faults()[f].slave.points;
          for (const FaultPart &part : scene.faults[f].parts(points))
            {
              const std::vector<GivenStart<dim - 1>> given =
                part.friction->given_starts(part.select(points), part.section);
              for (unsigned int i = 0; i < given.size(); ++i)
                {
                  if (!given[i].has_motion())
                    continue;
                  const unsigned int k   = first + part.positions[i];
                  const FaultLaw    &law = laws[k];
                  try
                    {
                      result[k] = complete_start(given[i],
                                                 *law.friction,
                                                 law.state_law != nullptr,
                                                 normal_stress[k],
                                                 law.radiation_damping);
                    }
                  catch (const InputError &error)
                    {
                      throw with_place(error,
                                       part,
                                       points[part.positions[i]],
                                       given[i]);
                    }
                  const double sign = basis.faults()[f].sides.sign();
                  result[k]->slip_rate *= sign;
                  result[k]->shear_stress *= sign;
                }
            }
          first += points.size();
        }
      return result;
    }



    /** The velocities of bodies in equilibrium at all times, in the jump basis,
     * where slip rates and conditions of sides are those of the start. */
    template <int dim, int n_components>
    NodalVector
    steady_velocity(SpatialProblem<dim, n_components> &problem,
                    const FaultNodes<dim>             &faults,
                    const SystemState<dim>            &state)
    {
      NodalVector w = known_velocities(problem, state.time);
      for (const unsigned int k : faults.owned_contact())
        for (unsigned int d = 0; d < dim - 1; ++d)
          w.local_element(faults.node(k) * n_components + d) =
            state.slip_rate[k][d];
      solve_with_known_jumps(problem, problem.make_vector(), w);
      return w;
    }
  } // namespace



  template <int dim, int n_components>
  std::vector<Tensor<1, dim - 1>>
  start_motion(const SceneParameters<dim>        &scene,
               const FaultNodes<dim>             &faults,
               const NodeLaws                    &laws,
               SpatialProblem<dim, n_components> &problem,
               SystemState<dim>                  &state)
  {
    using Problem = SpatialProblem<dim, n_components>;

    const auto start =
      initial_sliding(scene, problem.jump_basis(), laws, state.normal_stress);
    if (std::none_of(start.begin(), start.end(), [](const auto &node) {
          return node.has_value();
        }))
      return {};

    NodalVector known = problem.make_vector();
    problem.set_known_jumps(state.time, known);
    const std::vector<Tensor<1, dim - 1>> known_rates =
      faults.tangential_jumps(known);
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (laws[k].is_prescribed)
        state.slip_rate[k] = known_rates[k];
      else if (start[k] && faults.in_contact(k))
        {
          state.slip_rate[k] = start[k]->slip_rate;
          if (laws[k].state_law)
            state.alpha[k] = start[k]->log_state;
        }
    const bool is_moving =
      std::any_of(state.slip_rate.begin(),
                  state.slip_rate.end(),
                  [](const auto &rate) { return magnitude(rate) > 0.; });

    // Tractions of the bodies on the slave sides.
    NodalVector w = problem.make_vector(), forces = w, product = w;
    problem.to_jumps(w, state.displacement);
    problem.term(Problem::stiffness).residual(forces, problem.load(0.), w);
    if (is_moving)
      {
        const NodalVector rates = steady_velocity(problem, faults, state);
        problem.to_nodal(state.velocity, rates);
        if (problem.has(Problem::damping))
          {
            problem.term(Problem::damping).vmult(product, rates);
            forces -= product;
          }
      }
    std::vector<Tensor<1, dim - 1>> tractions = faults.tangential_jumps(forces);
    std::vector<Tensor<1, dim - 1>> prestress(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (start[k] && faults.in_contact(k) && !laws[k].is_prescribed)
        {
          prestress[k] =
            start[k]->shear_stress - tractions[k] / faults.weights()[k];
          state.balancing_traction[k] = start[k]->shear_stress;
        }
    problem.set_prestress(prestress);
    return prestress;
  }



  template decltype(start_motion<2>)    start_motion<2>;
  template decltype(start_motion<3>)    start_motion<3>;
  template decltype(start_motion<2, 1>) start_motion<2, 1>;
} // namespace StickSlip
