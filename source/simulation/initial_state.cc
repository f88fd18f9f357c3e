// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/function_parser.h>

#include <stickslip/parameters/expression.h>
#include <stickslip/parameters/input_error.h>
#include <stickslip/simulation/initial_state.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    template <int dim>
    void
    initialize(FunctionParser<dim> &function, const std::string &expression)
    {
      function.initialize(expression_variables<dim>(false),
                          expression,
                          expression_constants());
    }



    /** The slip rate of one side of a fault for a unit of traction that it
     * radiates, m/(Pa s); a rigid body does not yield. */
    template <int dim>
    double
    radiation_compliance(const BodyParameters<dim> &body)
    {
      return body.geometry.rigid ? 0. : 1. / body.material.shear_impedance();
    }



    /** How much the weight of what lies above a point of fault @p f presses on
     * it, Pa. */
    template <int dim>
    double
    weight_above(const SceneParameters<dim> &scene,
                 const unsigned int          f,
                 const Point<dim>           &point)
    {
      double density_times_thickness = 0;
      for (unsigned int i = f + 1; i < scene.bodies.size(); ++i)
        density_times_thickness += scene.bodies[i].material.density *
                                   scene.bodies[i].geometry.thickness_at(point);
      return -scene.gravity_vector()[dim - 1] * density_times_thickness;
    }
  } // namespace



  template <int dim>
  std::vector<FaultLaw>
  make_fault_laws(const SceneParameters<dim> &scene)
  {
    std::vector<FaultLaw> laws;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const FaultParameters &fault = scene.faults[f];
        FaultLaw               law;
        law.friction =
          std::make_shared<const RateAndStateLaw>(fault.rate_and_state,
                                                  fault.regularisation);
        law.state_law           = fault.state_law;
        law.characteristic_slip = fault.rate_and_state.characteristic_slip;
        law.a                   = fault.rate_and_state.a;
        law.b                   = fault.rate_and_state.b;
        if (scene.time.inertia == Inertia::quasi_dynamic)
          law.radiation_damping =
            1. / (radiation_compliance(scene.bodies[f]) +
                  radiation_compliance(scene.bodies[f + 1]));
        laws.push_back(law);
      }
    return laws;
  }



  template <int dim>
  std::vector<double>
  make_normal_stress(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium,
                     unsigned int                  &n_in_tension)
  {
    std::vector<double> stress = equilibrium.contact_pressure;
    unsigned int        k      = 0;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        FunctionParser<dim> function;
        initialize(function, scene.faults[f].normal_stress);
        const unsigned int first = k;
        for (const Point<dim> &point : basis.faults()[f].slave_surface.points)
          {
            if (scene.faults[f].normal_stress_source ==
                NormalStressSource::lithostatic)
              stress[k] = weight_above(scene, f, point);
            else if (scene.faults[f].normal_stress_source ==
                     NormalStressSource::function)
              {
                stress[k] = function.value(point);
                if (!(stress[k] >= 0.))
                  throw InputError(
                    "Faults/" + scene.faults[f].name +
                    "/Normal stress function = '" +
                    scene.faults[f].normal_stress + "' is " +
                    std::to_string(stress[k]) +
                    " Pa at x = " + std::to_string(point[0]) +
                    "; it must be at least 0 all along the fault.");
              }
            if (stress[k] < 0.)
              {
                stress[k] = 0.;
                ++n_in_tension;
              }
            ++k;
          }
        if (scene.faults[f].normal_stress_source !=
              NormalStressSource::function &&
            std::none_of(stress.begin() + first,
                         stress.begin() + k,
                         [](const double sigma) { return sigma > 0.; }))
          throw InputError(
            "Faults/" + scene.faults[f].name +
            "/Normal stress: nothing presses this fault together; it must be "
            "'function', or there must be gravity or a boundary traction that "
            "does.");
      }
    return stress;
  }



  template <int dim>
  SystemState<dim>
  make_initial_state(const SceneParameters<dim>    &scene,
                     const JumpBasis<dim>          &basis,
                     const InitialEquilibrium<dim> &equilibrium)
  {
    SystemState<dim> state;
    state.displacement = equilibrium.displacement;
    state.velocity     = equilibrium.displacement;
    state.velocity     = 0.;
    if (scene.time.inertia == Inertia::dynamic)
      state.acceleration = state.velocity;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        FunctionParser<dim> theta;
        initialize(theta, scene.faults[f].initial_state);
        for (const Point<dim> &point : basis.faults()[f].slave_surface.points)
          {
            const double value = theta.value(point);
            if (!(value > 0.) || !std::isfinite(value))
              throw InputError("Faults/" + scene.faults[f].name +
                               "/Initial state = '" +
                               scene.faults[f].initial_state + "' is " +
                               std::to_string(value) +
                               " s at x = " + std::to_string(point[0]) +
                               "; it must be greater than 0 all along the "
                               "fault.");
            state.alpha.push_back(std::log(value));
          }
      }
    state.slip.resize(state.alpha.size());
    state.slip_rate.resize(state.alpha.size());
    state.balancing_traction = equilibrium.shear_traction;
    return state;
  }



#define STICKSLIP_INSTANTIATE(dim)                      \
  template std::vector<FaultLaw> make_fault_laws<dim>(  \
    const SceneParameters<dim> &);                      \
  template std::vector<double> make_normal_stress<dim>( \
    const SceneParameters<dim> &,                       \
    const JumpBasis<dim> &,                             \
    const InitialEquilibrium<dim> &,                    \
    unsigned int &);                                    \
  template SystemState<dim> make_initial_state<dim>(    \
    const SceneParameters<dim> &,                       \
    const JumpBasis<dim> &,                             \
    const InitialEquilibrium<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
