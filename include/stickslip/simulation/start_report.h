// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_start_report_h
#define stickslip_simulation_start_report_h

#include <stickslip/scene/scene_parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Lines on what will happen in a run, and warnings of one sentence each: size
   * and memory of the meshes; of each fault its size and faces, and of its part
   * with b > a the stiffness of the bodies over the critical one, the
   * nucleation length and the process zone (instability.h); the shear stress
   * over the normal stress at the start; the fewest steps and output.
   *
   * Stresses and the stiffness are those of the same scene on a coarser mesh of
   * some thousand unknowns, or on the unrefined one of blocks and mesh files;
   * nothing is said of them where that has more than 400,000 unknowns in two
   * dimensions or 100,000 in three. Not collective: for one process, while
   * others wait.
   *
   * @param more_warnings are printed first.
   *
   * @return the sentence of an InputError with which the coarser mesh is
   * refused, of which nothing is printed; empty if it is not.
   */
  template <int dim>
  std::string
  report_start(const SceneParameters<dim>     &scene,
               const unsigned int              n_processes,
               const std::vector<std::string> &more_warnings,
               std::ostream                   &out);
} // namespace StickSlip

#endif
