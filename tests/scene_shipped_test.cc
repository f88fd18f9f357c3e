// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/scene/scene_reader.h>
#include <stickslip/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "project_directories.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** The files of the project's folder parameters/, whichever are there. */
  std::vector<std::filesystem::path>
  shipped_scenes()
  {
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::recursive_directory_iterator(
           STICKSLIP_SOURCE_DIR "/parameters"))
      if (entry.path().extension() == ".prm")
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
  }



  template <int dim, int n_components>
  void
  expect_steps(const SceneParameters<dim> &scene)
  {
    Simulation<dim, n_components> simulation(scene, MPI_COMM_WORLD);
    simulation.set_up();
    for (unsigned int step = 0; step < 3; ++step)
      {
        ASSERT_FALSE(simulation.is_finished());
        simulation.advance();
      }
    EXPECT_GT(simulation.state().time, 0.);
    const double speed = simulation.state().velocity.linfty_norm();
    EXPECT_TRUE(std::isfinite(speed));
    // The load has begun.
    EXPECT_GT(speed, 0.);
  }
} // namespace



TEST(ShippedScenes, AreReadAndTakeSteps)
{
  const auto files = shipped_scenes();
  ASSERT_GE(files.size(), 8u);
  for (const auto &file : files)
    {
      SCOPED_TRACE(file.string());
      try
        {
          const SceneReader reader(file.string());
          if (reader.dimension() == 3)
            expect_steps<3, 3>(reader.read<3>());
          else if (const auto scene = reader.read<2>();
                   scene.deformation == Deformation::antiplane)
            expect_steps<2, 1>(scene);
          else
            expect_steps<2, 2>(scene);
        }
      catch (const std::exception &problem)
        {
          ADD_FAILURE() << problem.what();
        }
    }
}



TEST(ShippedScenes, AreDescribed)
{
  const std::string page = content_of(STICKSLIP_SOURCE_DIR "/doc/scenes.md");
  for (const auto &file : shipped_scenes())
    EXPECT_NE(page.find(
                std::filesystem::relative(file, STICKSLIP_SOURCE_DIR).string()),
              std::string::npos)
      << file << " is missing in doc/scenes.md.";
}
