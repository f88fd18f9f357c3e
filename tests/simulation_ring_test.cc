// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "mesh_text.h"
#include "simulation_scenes.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Radii of the inner side, the fault and the outer side, m. */
  constexpr double a = 0.5, b = 1., c = 2.;

  /** Angular velocity of the inner side, 1/s. */
  constexpr double omega = 1e-3;

  /** Two rings of quadrilaterals with nodes of their own at the fault. */
  MeshText
  two_rings(const std::array<int, 2> &around, const std::array<int, 2> &radial)
  {
    MeshText mesh;
    mesh.groups = {{2, 1, "inner"},
                   {2, 2, "outer"},
                   {1, 11, "axle"},
                   {1, 12, "inner_fault"},
                   {1, 21, "outer_fault"},
                   {1, 22, "rim"}};
    for (const int body : {0, 1})
      {
        const int    first = mesh.nodes.size() + 1, n = around[body];
        const double begin = body == 0 ? a : b, end = body == 0 ? b : c;
        for (int j = 0; j <= radial[body]; ++j)
          for (int i = 0; i < n; ++i)
            {
              const double angle = 2. * numbers::PI * i / n;
              const double r     = begin + (end - begin) * j / radial[body];
              mesh.nodes.push_back(
                {{r * std::cos(angle), r * std::sin(angle), 0.}});
            }
        const auto node = [=](const int i, const int j) {
          return first + j * n + i % n;
        };
        for (int j = 0; j < radial[body]; ++j)
          for (int i = 0; i < n; ++i)
            mesh.elements.push_back({3,
                                     body + 1,
                                     {node(i, j),
                                      node(i, j + 1),
                                      node(i + 1, j + 1),
                                      node(i + 1, j)}});
        for (const int j : {0, radial[body]})
          for (int i = 0; i < n; ++i)
            mesh.elements.push_back({1,
                                     10 * (body + 1) + (j > 0 ? 2 : 1),
                                     {node(i, j), node(i + 1, j)}});
      }
    return mesh;
  }



  const std::string rings = R"(
subsection Bodies
  set Names     = inner, outer
  set Mesh file = rings.msh
  subsection inner
    set Uniform refinements = 1
  end
  subsection outer
    set Uniform refinements = 1
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Between                = inner inner_fault, outer outer_fault
    set Shape                  = smooth
    set a                      = 0.02
    set b                      = 0.01
    set Characteristic slip    = 1e-4
    set Initial state          = 100
    set Normal stress          = function
    set Normal stress function = 1e4
  end
end
subsection Boundary conditions
  set Sides = inner axle, outer rim
  subsection inner axle
    set x condition = velocity
    set x value     = -1e-3 * y
    set y condition = velocity
    set y value     = 1e-3 * x
    set Ramp length = 0
  end
  subsection outer rim
    set x condition = fixed
    set y condition = fixed
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia  = quasi-static
  set End time = 4
end
)";



  /** Slip and slip rate of the fault at the end of the run, as one point: a
   * slider on the spring that the rings are, with the traction
   * k (omega b t - slip), by the method of Runge and Kutta. */
  std::array<double, 2>
  slider(const double shear_modulus, const double end)
  {
    const double k =
      2. * shear_modulus / (b * b * b * (1. / (a * a) - 1. / (c * c)));
    const double sigma = 1e4, mu0 = 0.6, A = 0.02, B = 0.01, V0 = 1e-6,
                 L = 1e-4;
    const auto rate =
      [&](const double t, const double slip, const double theta) {
        const double f = k * (omega * b * t - slip) / sigma;
        return V0 * std::exp((f - mu0 - B * std::log(V0 * theta / L)) / A);
      };
    using State       = std::array<double, 2>;
    const auto change = [&](const double t, const State &x) -> State {
      const double V = rate(t, x[0], x[1]);
      return {{V, 1. - V * x[1] / L}};
    };
    State              x = {{0., 100.}};
    const unsigned int n = 400000;
    const double       h = end / n;
    const auto moved     = [](const State &s, const double by, const State &d) {
      return State{{s[0] + by * d[0], s[1] + by * d[1]}};
    };
    for (unsigned int i = 0; i < n; ++i)
      {
        const double t  = i * h;
        const State  k1 = change(t, x),
                    k2  = change(t + h / 2., moved(x, h / 2., k1)),
                    k3  = change(t + h / 2., moved(x, h / 2., k2)),
                    k4  = change(t + h, moved(x, h, k3));
        for (const unsigned int d : {0, 1})
          x[d] += h / 6. * (k1[d] + 2. * k2[d] + 2. * k3[d] + k4[d]);
      }
    return {{x[0], rate(end, x[0], x[1])}};
  }
} // namespace



// The outer ring is finer, or the inner one.
TEST(TurnedRing, SlipsLikeASlider)
{
  for (const auto &around :
       {std::array<int, 2>{{40, 30}}, std::array<int, 2>{{40, 48}}})
    {
      const TemporaryFolder folder;
      folder.write("rings.msh", two_rings(around, {{4, 6}}).text());
      const auto scene =
        SceneReader(folder.write("rings.prm", rings)).read<2>();
      Simulation<2> simulation(scene, MPI_COMM_WORLD);
      simulation.set_up();
      while (!simulation.is_finished())
        simulation.advance();
      const FaultStatistics fault =
        fault_statistics(snapshots(simulation).front());
      const auto [slip, slip_rate] = slider(
        scene.bodies[0].material.function<2>()(Point<2>(a, 0.)).shear_modulus(),
        simulation.state().time);
      std::cout << "slip " << std::abs(fault.mean_slip) << ", exact " << slip
                << "; slip rate " << fault.min_slip_rate << " to "
                << fault.max_slip_rate << ", exact " << slip_rate << '\n';
      EXPECT_NEAR(std::abs(fault.mean_slip), slip, 2e-3 * slip);
      EXPECT_NEAR(fault.mean_slip_rate, slip_rate, 2e-3 * slip_rate);
      EXPECT_LT(fault.max_slip_rate / fault.min_slip_rate, 1.002);
    }
}
