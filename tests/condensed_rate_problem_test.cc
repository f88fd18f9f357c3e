// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/friction/rate_and_state.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>
#include <stickslip/time/newmark.h>
#include <stickslip/tnnmg/tnnmg_solver.h>

#include "condensed_newton.h"
#include "project_directories.h"

using namespace StickSlip;

namespace
{
  std::string
  source_file(const std::string &name)
  {
    return std::string(STICKSLIP_SOURCE_DIR "/") + name;
  }



  /**
   * The published spring slider, run up to moments of interest.
   */
  class SpringSlider : public ::testing::Test
  {
  protected:
    SpringSlider()
      : scene(
          SceneReader(source_file("parameters/spring_slider.prm")).read<2>())
      , simulation(scene, MPI_COMM_WORLD)
    {
      simulation.set_up();
    }

    void
    advance()
    {
      const double time = simulation.state().time;
      simulation.advance();
      step_size = simulation.state().time - time;
    }

    double
    max_slip_rate() const
    {
      double V = 0;
      for (const auto &v : simulation.state().slip_rate)
        V = std::max(V, v.norm());
      return V;
    }

    double
    mean_slip_rate()
    {
      double sum = 0, area = 0;
      for (unsigned int k = 0; k < simulation.fault_nodes().size(); ++k)
        {
          const double weight = simulation.fault_nodes().weights()[k];
          sum += weight * simulation.state().slip_rate[k].norm();
          area += weight;
        }
      return sum / area;
    }



    /** Solve the rate problem of the next step in both ways and compare. */
    void
    compare(const Regularisation regularisation);

    const SceneParameters<2> scene;
    Simulation<2>            simulation;
    double                   step_size = 0;
  };



  void
  SpringSlider::compare(const Regularisation regularisation)
  {
    SpatialProblem<2>     &problem = simulation.spatial_problem();
    const SystemState<2>  &state   = simulation.state();
    const FaultNodes<2>   &faults  = simulation.fault_nodes();
    const MeshLevel<2>    &level   = simulation.meshes().finest();
    const FaultContact<2> &contact = problem.jump_basis().faults()[0];
    const std::vector<MaterialFields> materials = {scene.bodies[0].material,
                                                   scene.bodies[1].material};

    // The Newmark step in the nodal basis, bodies apart.
    ElasticMatrices<2> matrices = assemble_elastic_matrices(level, materials);
    BlockMatrix<2>     A(matrices.mass.shared_sparsity());
    TermMatrix<2>::combine({2. / step_size, 1., step_size / 2.},
                           {matrices.mass,
                            matrices.damping,
                            matrices.stiffness},
                           0,
                           A.n_rows(),
                           A);
    NodalVector f = assemble_gravity(level, materials, scene.gravity_vector());
    NodalVector v = state.acceleration, product = v;
    v.add(2. / step_size, state.velocity);
    matrices.mass.vmult(product, v);
    f += product;
    v = state.displacement;
    v.add(step_size / 2., state.velocity);
    matrices.stiffness.vmult(product, v);
    f -= product;
    NodalVector given = problem.make_vector();
    problem.boundary_values().set_velocities(state.time + step_size, given);
    const unsigned int finest = simulation.meshes().n_levels() - 1;
    const Reference::CondensedNewton newton(
      level,
      problem.jump_basis(),
      A,
      f,
      problem.boundary_values().dirichlet_mask(finest),
      given);

    // The friction of each node from the formula.
    const RateAndStateParameters law =
      dynamic_cast<const RateAndStateLaw &>(*simulation.node_laws()[0].friction)
        .get_parameters();
    std::vector<Reference::FrictionCurve> curves;
    std::vector<double>                   start, weights, stresses, alpha;
    for (unsigned int k = 0; k < faults.size(); ++k)
      if (faults.in_contact(k))
        {
          Reference::FrictionCurve curve;
          curve.is_truncated = regularisation == Regularisation::truncated;
          curve.load_times_a =
            contact.coupling.weight[k] * state.normal_stress[k] * law.a;
          curve.log_min =
            std::log(law.reference_slip_rate) -
            (law.reference_friction +
             law.b * (state.alpha[k] + std::log(law.reference_slip_rate /
                                                law.characteristic_slip))) /
              law.a;
          curves.push_back(curve);
          start.push_back(state.slip_rate[k][0]);
        }
    const Reference::CondensedNewton::Solution reference =
      newton.minimise(curves, start);
    ASSERT_TRUE(reference.converged);

    // TNNMG solves the same problem, whose functional has its nodes in
    // ascending order.
    const std::vector<unsigned int> &nodes =
      problem.jump_basis().contact_nodes();
    for (const unsigned int node : nodes)
      for (unsigned int k = 0; k < faults.size(); ++k)
        if (faults.node(k) == node)
          {
            weights.push_back(contact.coupling.weight[k]);
            stresses.push_back(state.normal_stress[k]);
            alpha.push_back(state.alpha[k]);
          }
    FaultFriction<2> friction(
      nodes,
      weights,
      stresses,
      {std::make_shared<RateAndStateLaw>(law, regularisation)},
      std::vector<unsigned int>(nodes.size(), 0));
    friction.set_state(alpha);
    problem.combine(Newmark<2>().operator_coefficients(step_size));
    const NodalVector b =
      Newmark<2>().right_hand_side(problem, state, step_size);
    NodalVector w = problem.make_vector(), u = state.velocity;
    problem.boundary_values().set_velocities(state.time + step_size, u);
    problem.to_jumps(w, u);
    for (unsigned int i = 0; i < w.locally_owned_size() / 2; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        if (!problem.hierarchy().finest().fixed.is_active(i, c) &&
            std::binary_search(nodes.begin(), nodes.end(), i))
          w.local_element(2 * i + c) = 0.;
    TNNMGParameters parameters = scene.tnnmg;
    parameters.tolerance       = 1e-9;
    const SolveSummary summary =
      TNNMGSolver<2>(problem.hierarchy(), parameters).solve(friction, b, w);
    EXPECT_TRUE(summary.converged) << summary;
    problem.to_nodal(u, w);

    // Slip rates, and their logarithms, which at stuck nodes say more.
    constexpr double tolerance = 1e-7;
    double           fastest = 0, largest_coefficient = 0;
    for (unsigned int k = 0; k < curves.size(); ++k)
      {
        fastest = std::max(fastest, std::abs(reference.jumps[k]));
        largest_coefficient =
          std::max(largest_coefficient,
                   std::abs(reference.forces[k]) / curves[k].load_times_a);
      }
    for (unsigned int k = 0; k < curves.size(); ++k)
      {
        const double jump = w.local_element(2 * newton.slave_nodes[k]);
        EXPECT_NEAR(jump, reference.jumps[k], tolerance * fastest) << k;
        EXPECT_NEAR(curves[k].parameter_at(jump),
                    reference.parameters[k],
                    tolerance * largest_coefficient)
          << k;
      }

    // Velocities at all nodes but the hanging ones, which have none.
    NodeMask hanging(u.locally_owned_size() / 2, 2);
    for (unsigned int body = 0; body < level.bodies.size(); ++body)
      for (const auto &line : level.bodies[body]->bound_nodes().get_lines())
        hanging.mask_node(level.node(body, line.index));
    hanging.apply(u);
    const double largest = u.linfty_norm();
    for (unsigned int i = 0; i < u.locally_owned_size(); ++i)
      if (hanging.is_active(i / 2, i % 2))
        {
          EXPECT_NEAR(u.local_element(i),
                      reference.velocity(i),
                      tolerance * largest)
            << i;
        }
  }
} // namespace



TEST_F(SpringSlider, VelocitiesAreThoseOfCondensedNewton)
{
  while (simulation.state().time < 15.)
    advance();
  EXPECT_LT(max_slip_rate(), 1e-8);
  compare(Regularisation::truncated);

  while (max_slip_rate() < 1e-5)
    advance();
  compare(Regularisation::truncated);
  compare(Regularisation::arcsinh);

  while (mean_slip_rate() < 1e-3)
    advance();
  compare(Regularisation::truncated);
}
