// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_creeping_of_any_dimension_h
#define stickslip_tests_creeping_of_any_dimension_h

#include <stickslip/scene/scene_reader.h>

#include <sstream>
#include <string>
#include <vector>

#include "creeping_scene.h"
#include "temporary_folder.h"

namespace StickSlip::Tests
{
  /** Corners of the creeping bodies; their coarse cells are left to the test.
   */
  inline const std::vector<std::string> in_the_plane = {
    "Bodies/lower/Lower lateral corner=-1",
    "Bodies/upper/Lower lateral corner=-1",
    "Bodies/lower/Upper lateral corner=1",
    "Bodies/upper/Upper lateral corner=1"};

  /** The plane scene, extended along y. */
  inline const std::vector<std::string> in_space = {
    "Dimension=3",
    "Bodies/lower/Lower lateral corner=-1, 0",
    "Bodies/upper/Lower lateral corner=-1, 0",
    "Bodies/lower/Upper lateral corner=1, 1",
    "Bodies/upper/Upper lateral corner=1, 1",
    "Boundary conditions/lower bottom/z condition=fixed"};



  /** The creeping bodies with @p settings, which have to say all that has as
   * many numbers as the space has dimensions. */
  template <int dim>
  SceneParameters<dim>
  creeping_bodies_with(const std::vector<std::vector<std::string>> &settings)
  {
    std::istringstream lines(creeping_bodies);
    std::string        text;
    for (std::string line; std::getline(lines, line);)
      if (line.find("corner") == std::string::npos &&
          line.find("Coarse cells") == std::string::npos)
        text += line + "\n";
    std::vector<std::string> overrides;
    for (const std::vector<std::string> &more : settings)
      overrides.insert(overrides.end(), more.begin(), more.end());
    const TemporaryFolder folder;
    return SceneReader(folder.write("scene.prm", text), overrides)
      .template read<dim>();
  }
} // namespace StickSlip::Tests

#endif
