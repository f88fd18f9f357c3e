// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/parameters/input_error.h>
#include <stickslip/simulation/initial_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace StickSlip
{
  namespace
  {
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
  NodeLaws
  make_node_laws(const SceneParameters<dim> &scene, const JumpBasis<dim> &basis)
  {
    NodeLaws result;
    for (unsigned int f = 0; f < scene.faults.size(); ++f)
      {
        const FaultParameters                        &fault = scene.faults[f];
        std::map<std::array<double, 5>, unsigned int> known;
        const double                                  radiation_damping =
          scene.time.inertia == Inertia::quasi_dynamic ?
                                             1. / (radiation_compliance(scene.bodies[f]) +
                  radiation_compliance(scene.bodies[f + 1])) :
                                             0.;
        for (const RateAndStateParameters &p :
             fault.rate_and_state.values(basis.faults()[f].slave_surface.points,
                                         fault.section()))
          {
            const auto [place, is_new] =
              known.emplace(std::array<double, 5>{{p.a,
                                                   p.b,
                                                   p.reference_friction,
                                                   p.reference_slip_rate,
                                                   p.characteristic_slip}},
                            result.laws.size());
            result.of_node.push_back(place->second);
            if (is_new)
              result.laws.push_back(
                {std::make_shared<const RateAndStateLaw>(p,
                                                         fault.regularisation),
                 fault.state_law,
                 p.characteristic_slip,
                 p.b,
                 p.a,
                 radiation_damping});
          }
      }
    return result;
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
        const FaultParameters         &fault = scene.faults[f];
        const std::vector<Point<dim>> &points =
          basis.faults()[f].slave_surface.points;
        std::vector<double> given;
        if (fault.normal_stress_source == NormalStressSource::lithostatic)
          for (const Point<dim> &point : points)
            given.push_back(weight_above(scene, f, point));
        else if (fault.normal_stress_source == NormalStressSource::function)
          given = fault.normal_stress.values(points, fault.section());
        const unsigned int first = k;
        for (unsigned int i = 0; i < points.size(); ++i)
          {
            if (fault.normal_stress_source !=
                NormalStressSource::initial_equilibrium)
              stress[k] = given[i];
            if (stress[k] < 0.)
              {
                stress[k] = 0.;
                ++n_in_tension;
              }
            ++k;
          }
        if (fault.normal_stress_source != NormalStressSource::function &&
            std::none_of(stress.begin() + first,
                         stress.begin() + k,
                         [](const double sigma) { return sigma > 0.; }))
          throw InputError(
            fault.section() +
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
      for (const double theta : scene.faults[f].initial_state.values(
             basis.faults()[f].slave_surface.points, scene.faults[f].section()))
        state.alpha.push_back(std::log(theta));
    state.slip.resize(state.alpha.size());
    state.slip_rate.resize(state.alpha.size());
    state.balancing_traction = equilibrium.shear_traction;
    return state;
  }



#define STICKSLIP_INSTANTIATE(dim)                                               \
  template NodeLaws            make_node_laws<dim>(const SceneParameters<dim> &, \
                                        const JumpBasis<dim> &);      \
  template std::vector<double> make_normal_stress<dim>(                          \
    const SceneParameters<dim> &,                                                \
    const JumpBasis<dim> &,                                                      \
    const InitialEquilibrium<dim> &,                                             \
    unsigned int &);                                                             \
  template SystemState<dim> make_initial_state<dim>(                             \
    const SceneParameters<dim> &,                                                \
    const JumpBasis<dim> &,                                                      \
    const InitialEquilibrium<dim> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
