// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/agreed_failure.h>
#include <stickslip/problem/initial_equilibrium.h>

#include <algorithm>
#include <numeric>
#include <sstream>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  constexpr auto free_side = BoundaryType::free;
  constexpr auto fixed     = BoundaryType::fixed;



  SpatialScene<2>
  held_below(const std::vector<BodyGeometry<2>> &bodies)
  {
    std::vector<Material> materials(bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      materials[b].density += 300. * b;
    return SpatialScene<2>(
      bodies,
      {make_side<2>("0", BodyMesh<2>::lower_side, {{fixed, fixed}})},
      materials,
      9.81);
  }



  /** The bodies from @p first on slid along x. */
  NodalVector
  slide(const SpatialScene<2> &scene,
        const double           distance,
        const unsigned int     first = 1)
  {
    return interpolate(scene.meshes.finest(),
                       [&](const unsigned int b, const Point<2> &) {
                         return Tensor<1, 2>({b >= first ? distance : 0., 0.});
                       });
  }



  double
  sum(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.);
  }



  /**
   * Integrate psi_p (u_s - u_m) over a fault whose faces are all covered:
   * on each slave face psi = 2 phi_p - phi_q, integrated between the nodes of
   * both sides. Positions ascend.
   */
  std::vector<double>
  dual_integrals(const std::vector<double> &x_slave,
                 const std::vector<double> &u_slave,
                 const std::vector<double> &x_master,
                 const std::vector<double> &u_master)
  {
    const auto evaluate = [](const std::vector<double> &x,
                             const std::vector<double> &u,
                             const double               at) {
      unsigned int i = 0;
      while (i + 2 < x.size() && x[i + 1] < at)
        ++i;
      const double t = (at - x[i]) / (x[i + 1] - x[i]);
      return (1. - t) * u[i] + t * u[i + 1];
    };
    std::vector<double> breakpoints = x_slave;
    breakpoints.insert(breakpoints.end(), x_master.begin(), x_master.end());
    std::sort(breakpoints.begin(), breakpoints.end());

    std::vector<double> result(x_slave.size(), 0.);
    for (unsigned int k = 0; k + 1 < breakpoints.size(); ++k)
      {
        const double h      = breakpoints[k + 1] - breakpoints[k];
        const double middle = breakpoints[k] + 0.5 * h;
        if (h < 1e-12)
          continue;
        unsigned int face = 0;
        while (x_slave[face + 1] < middle)
          ++face;
        // Three points: psi, u and their product are of degree two at most.
        for (const double g : {-std::sqrt(0.6), 0., std::sqrt(0.6)})
          {
            const double x      = middle + 0.5 * g * h;
            const double weight = h * (g == 0. ? 8. : 5.) / 18.;
            const double t =
              (x - x_slave[face]) / (x_slave[face + 1] - x_slave[face]);
            const double jump =
              evaluate(x_slave, u_slave, x) - evaluate(x_master, u_master, x);
            result[face] += weight * (2. - 3. * t) * jump;
            result[face + 1] += weight * (3. * t - 1.) * jump;
          }
      }
    return result;
  }
} // namespace



TEST(Contact, NoJumpUnknownsMeanNoNormalJump)
{
  for (const auto &bodies :
       {spring_slider_bodies(), nonmatching_bodies(), layered_bodies()})
    {
      SpatialScene<2>     scene = held_below(bodies);
      const MeshLevel<2> &level = scene.meshes.finest();
      std::mt19937        random(23);
      NodalVector         w = random_values(level, random), u = w;
      const JumpBasis<2> &basis = scene.problem.jump_basis();
      for (const unsigned int p : basis.contact_nodes())
        w.local_element(p * 2 + 1) = 0.;
      scene.problem.to_nodal(u, w);

      for (unsigned int f = 0; f < basis.faults().size(); ++f)
        {
          const FaultContact<2> &fault     = basis.faults()[f];
          const auto             positions = [&](const unsigned int side,
                                     const unsigned int component) {
            std::pair<std::vector<double>, std::vector<double>> result;
            const FaultSurface<2> &surface = level.surface(f, side);
            for (unsigned int k = 0; k < surface.nodes.size(); ++k)
              {
                result.first.push_back(surface.points[k][0]);
                result.second.push_back(
                  u.local_element(surface.nodes[k] * 2 + component));
              }
            return result;
          };
          for (const unsigned int component : {0u, 1u})
            {
              const auto slave     = positions(fault.sides.slave, component);
              const auto master    = positions(fault.sides.master, component);
              const auto integrals = dual_integrals(slave.first,
                                                    slave.second,
                                                    master.first,
                                                    master.second);
              // The normal jumps vanish, the tangential ones are the unknowns.
              for (unsigned int k = 0; k < integrals.size(); ++k)
                EXPECT_NEAR(integrals[k],
                            fault.coupling.weight[k] *
                              w.local_element(fault.slave.nodes[k] * 2 +
                                              component),
                            1e-15);
            }
        }
    }
}



TEST(Contact, NodesSlidOffTheEndCarryNothing)
{
  for (const auto &bodies : {spring_slider_bodies(),
                             stack<2>({make_body<2>(1., {{10, 2}}, 3),
                                       make_body<2>(1., {{13, 2}}, 3)}),
                             stack<2>({make_body<2>(1., {{13, 2}}, 3),
                                       make_body<2>(1., {{10, 2}}, 3)})})
    for (const double distance : {0.5, -0.5, 0.51})
      {
        SpatialScene<2> scene = held_below(bodies);
        scene.problem.build_contact(slide(scene, distance));

        const JumpBasis<2>    &basis    = scene.problem.jump_basis();
        const FaultContact<2> &fault    = basis.faults()[0];
        const auto            &coupling = fault.coupling;
        const double           overlap  = 5. - std::abs(distance);
        EXPECT_NEAR(coupling.covered_area, overlap, 1e-12);
        EXPECT_NEAR(sum(coupling.weight), overlap, 1e-12);

        unsigned int n_off = 0, n_active = 0;
        for (unsigned int k = 0; k < fault.slave.nodes.size(); ++k)
          {
            const bool   upper = fault.sides.slave_is_second();
            const double x     = fault.slave.points[k][0];
            // The place on the other side opposite to the node.
            const double opposite = x + (upper ? distance : -distance);
            n_active += coupling.active[k];
            if (std::abs(opposite) > 2.5 + 1e-10)
              {
                ++n_off;
                EXPECT_FALSE(coupling.active[k] &&
                             std::abs(opposite) > 2.5 + fault.smallest_face);
                EXPECT_EQ(coupling.active[k], coupling.weight[k] > 0.);
              }
            else if (std::abs(opposite) < 2.5 - 1e-10)
              {
                EXPECT_TRUE(coupling.active[k]) << x;
              }
            EXPECT_EQ(std::binary_search(basis.contact_nodes().begin(),
                                         basis.contact_nodes().end(),
                                         fault.slave.nodes[k]),
                      coupling.active[k]);
            // Off contact the unknowns are nodal values that nothing fixes.
            EXPECT_EQ(scene.problem.hierarchy().finest().fixed.is_active(
                        fault.slave.nodes[k], 1),
                      !coupling.active[k]);
          }
        EXPECT_GT(n_off, 7u);
        EXPECT_EQ(n_active, basis.contact_nodes().size());
      }
}



TEST(Contact, ForcesCarryTheWeightAbove)
{
  for (const auto &bodies :
       {spring_slider_bodies(), nonmatching_bodies(), layered_bodies()})
    for (const double distance : {0., 0.5, -0.37})
      {
        SpatialScene<2>    scene = held_below(bodies);
        const unsigned int first_slid =
          bodies.size() == 2 ? 1 : bodies.size() - 2;
        if (distance != 0.)
          scene.problem.build_contact(slide(scene, distance, first_slid));
        const auto  equilibrium = solve_initial_equilibrium(scene.problem);
        const auto &faults      = scene.problem.jump_basis().faults();

        unsigned int node = 0;
        for (unsigned int f = 0; f < faults.size(); ++f)
          {
            // Turning all that lies above, slid bodies where they are now,
            // gives the lever of each contact force.
            NodalVector lever =
              interpolate(scene.meshes.finest(),
                          [&](const unsigned int b, const Point<2> &x) {
                            Tensor<1, 2> value;
                            if (b > f)
                              value[1] =
                                x[0] + (b >= first_slid ? distance : 0.);
                            return value;
                          });
            const NodalVector nodal = lever;
            scene.problem.to_jumps(lever, nodal);

            double weight = 0., weight_moment = 0.;
            for (unsigned int b = f + 1; b < bodies.size(); ++b)
              {
                const double of_body =
                  scene.materials[b].density * 9.81 * 5. * bodies[b].thickness;
                weight += of_body;
                weight_moment += b >= first_slid ? of_body * distance : 0.;
              }
            const auto  &coupling = faults[f].coupling;
            const double sign     = faults[f].sides.sign();
            double       force = 0., moment = 0.;
            for (unsigned int k = 0; k < coupling.weight.size(); ++k, ++node)
              {
                const double of_node =
                  coupling.weight[k] * equilibrium.contact_pressure[node];
                force += of_node;
                moment += sign * of_node *
                          lever.local_element(faults[f].slave.nodes[k] * 2 + 1);
              }
            EXPECT_NEAR(force / weight, 1., 1e-10)
              << "fault " << f << " of " << faults.size() << ", slid "
              << distance;
            EXPECT_NEAR(moment / weight, weight_moment / weight, 1e-10)
              << "fault " << f << " of " << faults.size() << ", slid "
              << distance;
          }
        EXPECT_EQ(node, equilibrium.contact_pressure.size());

        // The settlement is downwards, and of the right size.
        double lowest = 0.;
        for (unsigned int i = 1; i < equilibrium.displacement.size(); i += 2)
          lowest = std::min(lowest, equilibrium.displacement.local_element(i));
        EXPECT_LT(lowest, -1e-3);
        EXPECT_GT(lowest, -2e-2);
      }
}



TEST(Contact, LosingItIsAnError)
{
  SpatialScene<2> scene = held_below(spring_slider_bodies());
  for (const double distance : {6., -5.1, 4.9999})
    try
      {
        scene.problem.build_contact(slide(scene, distance));
        ADD_FAILURE() << "no error after a slip of " << distance << " m";
      }
    catch (const AgreedFailure &error)
      {
        EXPECT_NE(std::string(error.what()).find("the fault '1' do not touch"),
                  std::string::npos)
          << error.what();
      }

  SpatialScene<2> layers = held_below(layered_bodies());
  try
    {
      layers.problem.build_contact(slide(layers, 5.5, 3));
      ADD_FAILURE() << "no error";
    }
  catch (const AgreedFailure &error)
    {
      EXPECT_NE(std::string(error.what()).find("the fault '3'"),
                std::string::npos)
        << error.what();
    }
}
