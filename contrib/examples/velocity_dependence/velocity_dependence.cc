// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// A study of a parameter with the whole library: a block is dragged over a
// rigid plate at several velocities until it slides steadily, and the friction
// coefficient is compared with that of the law at steady state,
// mu0 + (a - b) ln(V/V0).

#include <stickslip/base/input_error.h>
#include <stickslip/base/libraries.h>
#include <stickslip/problem/shear_traction.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
  using namespace StickSlip;

  constexpr double a = 0.02, b = 0.012, mu0 = 0.6, V0 = 1e-4, L = 1e-4;

  const std::string file_name = "velocity_dependence.prm";



  /** A scene as text, where a number of the program is needed. */
  std::string
  scene_text()
  {
    std::ostringstream text;
    text << R"(
subsection Bodies
  set Names = plate, block
  subsection plate
    set Rigid = true
  end
  subsection block
    set Lower lateral corner = -0.5
    set Upper lateral corner = 0.5
    set Thickness            = 0.2
    set Coarse cells         = 4, 1
    set Refinement passes    = 1
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set a                              = )"
         << a << R"(
    set b                              = )"
         << b << R"(
    set Reference friction coefficient = )"
         << mu0 << R"(
    set Reference slip rate            = )"
         << V0 << R"( m/s
    set Characteristic slip            = )"
         << L << R"( m
    set Normal stress                  = function
    set Normal stress function         = 20 kPa
  end
end
subsection Boundary conditions
  set Sides = block top
  subsection block top
    set x condition = velocity
    set y condition = fixed
    set Ramp length = 0
  end
end
subsection Gravity
  set Acceleration = 0
end
subsection Time
  set Inertia = quasi-static
end
)";
    return text.str();
  }



  /** The mean friction coefficient of the fault after it has slid by
   * @p distance, m, at this velocity of the block's top, m/s. */
  double
  friction_coefficient(const double velocity, const double distance)
  {
    // Entries that change act after the file, as with --set.
    std::ostringstream value, end;
    value << "Boundary conditions/block top/x value=" << velocity;
    end << "Time/End time=" << distance / velocity;
    const SceneReader reader(file_name,
                             {value.str(),
                              end.str(),
                              "Time/Largest step=" +
                                std::to_string(distance / velocity / 20.)});
    Simulation<2>     simulation(reader.read<2>(), MPI_COMM_WORLD);
    // In place of run(), which writes files.
    simulation.set_up();
    while (!simulation.is_finished())
      simulation.advance();

    const FaultNodes<2> &nodes    = simulation.fault_nodes();
    double               traction = 0., normal_stress = 0.;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double weight = nodes.weights()[k];
        traction += weight * shear_traction(nodes,
                                            simulation.node_laws(),
                                            simulation.state(),
                                            k)[0];
        normal_stress += weight * simulation.state().normal_stress[k];
      }
    return std::abs(traction / normal_stress);
  }
} // namespace



int
main()
{
  try
    {
      const Libraries libraries;
      std::ofstream(file_name) << scene_text();
      std::cout << "| velocity | friction | steady state |\n";
      for (const double velocity : {1e-5, 1e-4, 1e-3, 1e-2})
        std::cout << "| " << velocity << " | " << std::setprecision(6)
                  << friction_coefficient(velocity, 40. * L) << " | "
                  << mu0 + (a - b) * std::log(velocity / V0) << " |"
                  << std::endl;
      return 0;
    }
  catch (const InputError &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
}
