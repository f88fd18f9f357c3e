// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/common_parameters.h>
#include <stickslip/scene/automatic_limits.h>
#include <stickslip/scene/loading_rate.h>
#include <stickslip/scene/side_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    // Runs of the laboratory, s.
    constexpr double long_run = 1000.;



    /** The least characteristic slip of all faults, m; infinity without
     * friction. */
    template <int dim>
    double
    least_characteristic_slip(const SceneParameters<dim> &scene)
    {
      const std::string entry = CommonParameters::characteristic_slip().entry;
      double            least = std::numeric_limits<double>::infinity();
      for (unsigned int f = 0; f < scene.faults.size(); ++f)
        {
          const std::vector<Point<dim>> points = fault_points(scene, f);
          for (const FaultPart &part : scene.faults[f].parts(points))
            if (part.friction->has_state())
              for (const double slip :
                   (*part.friction)[entry].values(part.select(points),
                                                  part.section))
                least = std::min(least, slip);
        }
      return least;
    }



    /** True if one Gauss-Seidel sweep leaves a cycle slow: beside jumps that
     * are free, and on tetrahedra. */
    template <int dim>
    bool
    is_hard_to_smooth(const SceneParameters<dim> &scene)
    {
      for (const FaultParameters &fault : scene.faults)
        if (fault.may_open())
          return true;
      if (dim == 3 && scene.mesh)
        for (const BodyCells<dim> &body : scene.mesh->bodies)
          if (body.cells.front().vertices.size() == dim + 1)
            return true;
      return false;
    }



    template <int dim>
    std::vector<AutomaticNumber *>
    automatic_numbers(SceneParameters<dim> &scene)
    {
      return {&scene.time.largest_step,
              &scene.tnnmg.smoothing_sweeps,
              &scene.output.fault_cadence.slip_interval,
              &scene.output.fault_cadence.longest_interval,
              &scene.output.station_cadence.slip_interval,
              &scene.output.station_cadence.longest_interval,
              &scene.output.volume_cadence.slip_interval,
              &scene.output.volume_cadence.longest_interval};
    }
  } // namespace



  template <int dim>
  void
  derive_limits(SceneParameters<dim> &scene)
  {
    TimeParameters &time   = scene.time;
    const double    length = std::max(1., time.end_time / long_run);
    const double    slip_of_loading =
      largest_prescribed_velocity(scene) * time.end_time;

    double largest_step = 0.5 * length;
    if (slip_of_loading > 0.)
      largest_step = std::min(largest_step,
                              5. * least_characteristic_slip(scene) *
                                time.end_time / slip_of_loading);
    time.largest_step.derive(
      std::max({0.5, largest_step, time.initial_step, time.smallest_step}));

    scene.tnnmg.smoothing_sweeps.derive(is_hard_to_smooth(scene) ? 2. : 1.);

    const auto derive = [&](CadenceParameters &cadence,
                            const double       slip,
                            const double       part_of_slip,
                            const double       interval) {
      cadence.slip_interval.derive(
        length > 1. ? std::max(slip, part_of_slip * slip_of_loading) : slip);
      cadence.longest_interval.derive(
        std::max(interval * length, cadence.shortest_interval));
    };
    derive(scene.output.fault_cadence, 1e-5, 1. / 2000., 0.5);
    derive(scene.output.station_cadence, 1e-5, 1. / 2000., 0.5);
    derive(scene.output.volume_cadence, 1e-4, 1. / 100., 5.);
  }



  template <int dim>
  void
  fix_limits(SceneParameters<dim> &scene)
  {
    for (AutomaticNumber *const number : automatic_numbers(scene))
      number->fix();
  }



  template decltype(derive_limits<2>) derive_limits<2>;
  template decltype(derive_limits<3>) derive_limits<3>;
  template decltype(fix_limits<2>)    fix_limits<2>;
  template decltype(fix_limits<3>)    fix_limits<3>;
} // namespace StickSlip
