// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "contact_closed_forms.h"
#include "opening_scene.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** A slender bar above a rigid wall that nothing but its velocity brings
   * there. */
  const char *const bar_on_wall = R"(
subsection Bodies
  set Names          = wall, bar
  set Base elevation = -1
  subsection wall
    set Lower lateral corner = 0
    set Upper lateral corner = 1
    set Thickness            = 1
    set Rigid                = true
  end
  subsection bar
    set Lower lateral corner = 0
    set Thickness            = 1
    set Uniform refinements  = 0
    set Refinement passes    = 0
    subsection Material
      set Young modulus   = 100
      set Poisson ratio   = 0
      set Density         = 1
      set Bulk viscosity  = 0
      set Shear viscosity = 0
    end
  end
end
subsection Faults
  set Names = contact
  subsection contact
    set Friction = frictionless
    set Contact  = unilateral
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set End time = 1
  set Step size control = constant
end
subsection TNNMG
  set Tolerance = 1e-11
end
subsection Output
  set Event start slip rate = 1
end
)";



  /** The bar in exact numbers: waves of 10 m/s, an impact of 10 Pa. */
  FlyingBar
  exact_bar(const double gap)
  {
    return {1., 100., 1., 1., gap};
  }



  /** The bar with so many cells along it, flying at 1 m/s. */
  struct Bar : public OpeningScene<2>
  {
    Bar(const unsigned int n_cells, const double gap)
      : OpeningScene<2>(
          bar_on_wall,
          {"Bodies/bar/Upper lateral corner=" + std::to_string(1. / n_cells),
           "Bodies/bar/Coarse cells=1, " + std::to_string(n_cells),
           "Faults/contact/Initial gap=" + std::to_string(gap)})
      , exact(exact_bar(gap))
    {
      start_free([](const unsigned int body, const Point<2> &) {
        Tensor<1, 2> v;
        v[1] = body == 1 ? -1. : 0.;
        return v;
      });
    }

    /** Difference of the displacements, root of the mean square over the
     * length, m. */
    double
    error() const
    {
      const MeshLevel<2> &level     = meshes.finest();
      const auto          positions = level.bodies[1]->node_positions();
      double              sum       = 0.;
      for (unsigned int i = 0; i < positions.size(); ++i)
        {
          const double u = state.displacement.local_element(
            level.nodes.local_index(level.global_node(1, i)) * 2 + 1);
          sum += Utilities::fixed_power<2>(
            u - exact.displacement(positions[i][1], state.time));
        }
      return std::sqrt(sum / positions.size());
    }

    FlyingBar exact;
  };



  /** The bounce of a bar, with steps of one size. */
  struct Bounce
  {
    /** Energy taken, over that at the start; pressure in the middle half of the
     * contact, root mean square of the difference over the exact one; largest
     * error of the displacement, m. */
    double loss = 0., pressure = 0., error = 0.;

    Bounce(const unsigned int n_cells, const double cfl, const double phase)
    {
      const double     tau = cfl / n_cells / 10.;
      Bar              bar(n_cells, (std::ceil(0.01 / tau) + phase) * tau);
      const FlyingBar &exact = bar.exact;
      const double     start = bar.total_energy();
      double           sum   = 0.;
      unsigned int     n     = 0;
      while (bar.state.time < exact.impact() + 1.25 * exact.duration())
        {
          const StepResult<2> step = bar.advance(tau);
          EXPECT_TRUE(step.converged) << step.failure;
          if (!step.converged)
            return;
          EXPECT_GE(step.contact_energy.lost, -1e-12 * start);
          loss += step.contact_energy.lost / start;
          error = std::max(error, bar.error());
          // Pressures are means over a step.
          const double part =
            (bar.state.time - tau / 2. - exact.impact()) / exact.duration();
          if (part < 0.25 || part > 0.75)
            continue;
          for (const double p : bar.state.contact_pressure)
            sum += Utilities::fixed_power<2>(
              p / exact.pressure(bar.state.time - tau / 2.) - 1.);
          n += bar.state.contact_pressure.size();
        }
      // The missing energy is the one that the contact has taken.
      EXPECT_NEAR(bar.total_energy() / start, 1. - loss, 1e-9);
      pressure = std::sqrt(sum / n);
    }
  };



  /** Bounces that hit at several phases of a step: mean of the losses, over
   * that of a cell of the bar, and the largest of everything. */
  struct Bounces
  {
    double mean_loss = 0., loss = 0., pressure = 0., error = 0.;

    Bounces(const unsigned int n_cells, const double cfl)
    {
      constexpr unsigned int n_phases = 3;
      for (unsigned int i = 0; i < n_phases; ++i)
        {
          const Bounce bounce(n_cells, cfl, (i + 0.5) / n_phases);
          mean_loss += bounce.loss * n_cells / n_phases;
          loss     = std::max(loss, bounce.loss * n_cells);
          pressure = std::max(pressure, bounce.pressure);
          error    = std::max(error, bounce.error);
        }
    }
  };
} // namespace



TEST(OpeningBar, BouncesOffARigidWall)
{
  // Courant numbers, with what one-dimensional prototypes of the scheme have
  // on 128 cells: energy that the contact takes over that of the bar, error of
  // the pressure and of the displacement over 0.1 m, the compression.
  const std::array<double, 3> courant  = {{0.5, 2., 8.}},
                              loss     = {{0.003, 0.006, 0.021}},
                              pressure = {{2e-4, 1e-3, 0.013}},
                              error    = {{0.008, 0.020, 0.055}};
  std::array<double, 3> mean_losses;
  for (unsigned int i = 0; i < 3; ++i)
    {
      SCOPED_TRACE(courant[i]);
      const Bounces coarse(64, courant[i]), fine(128, courant[i]);
      mean_losses[i] = fine.mean_loss;
      EXPECT_LE(fine.mean_loss / 128, 1.2 * loss[i]);
      EXPECT_LE(fine.pressure, 1.2 * pressure[i]);
      EXPECT_LE(fine.error, 0.1 * error[i]);
      // At first order with step and cell.
      EXPECT_NEAR(fine.mean_loss, coarse.mean_loss, 0.05 * fine.mean_loss);
      EXPECT_GE(std::log2(coarse.error / fine.error), 0.6);
      EXPECT_LE(std::log2(coarse.error / fine.error), 1.2);
      if (courant[i] == 0.5)
        {
          // At any phase.
          EXPECT_LE(fine.loss, 1.2 * 0.7);
          EXPECT_LE(coarse.loss, 1.2 * 0.7);
          EXPECT_LE(coarse.pressure, 1e-3);
        }
    }
  // With the step alone, as long as a wave crosses more than a cell in it.
  EXPECT_GT(mean_losses[2], 3. * mean_losses[1]);
  EXPECT_GT(mean_losses[1], 2. * mean_losses[0]);
}



TEST(OpeningBar, StepsThatCloseGapsAreSplit)
{
  constexpr unsigned int n_cells = 64, n_phases = 3;
  for (const double cfl : {2., 8.})
    {
      SCOPED_TRACE(cfl);
      const double tau     = cfl / n_cells / 10.;
      double       lost[2] = {0., 0.};
      for (unsigned int i = 0; i < n_phases; ++i)
        for (const bool split : {false, true})
          {
            Bar bar(n_cells,
                    (std::ceil(0.01 / tau) + (i + 0.5) / n_phases) * tau);
            bar.scene.time.impact_tolerance = split ? 1e-3 : 1e9;
            bar.scene.time.largest_step     = tau;
            const double start              = bar.total_energy();
            const auto   controller =
              make_step_size_controller(*bar.step,
                                        bar.scene.time,
                                        bar.boundary_values);
            StepMemory<2> memory;
            while (bar.state.time < bar.exact.impact() + 2. * tau)
              for (auto &step : controller->advance(bar.state, memory))
                {
                  lost[split] += step.contact_energy.lost / start / n_phases;
                  bar.state = step.state;
                }
          }
      EXPECT_GT(lost[0], 1e-3);
      EXPECT_LT(lost[1], 2. / 3. * lost[0]);
    }
}
