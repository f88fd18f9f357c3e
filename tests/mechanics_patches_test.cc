// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/mechanics/patch_volumes.h>
#include <stickslip/output/volume_writer.h>

#include <algorithm>
#include <map>
#include <set>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  /** A brick of 5 by 1 m that couples its patches. */
  CoarseBody<2>
  make_brick(const std::array<unsigned int, 2> &cells,
             const unsigned int                 refinements,
             const unsigned int                 passes = 0)
  {
    BodyGeometry<2> geometry     = make_body<2>(1., cells, passes);
    geometry.uniform_refinements = refinements;
    CoarseBody<2> body           = coarse_brick(stack<2>({geometry})[0]);
    body.couples_patches         = true;
    return body;
  }



  MeshHierarchy<2>
  make_meshes(const CoarseBody<2> &body)
  {
    return MeshHierarchy<2>({body},
                            stack_topology<2>({"0"}, {}),
                            MPI_COMM_WORLD);
  }



  Material
  nearly_incompressible(const double poissons_ratio)
  {
    Material material;
    material.poissons_ratio    = poissons_ratio;
    material.volumetric_strain = VolumetricStrain::patch_mean;
    return material;
  }
} // namespace



TEST(CellPatches, AreWhatCellsWereRefinedInto)
{
  // Four passes towards the upper side: families of four, pairs whose siblings
  // are refined, and coarse cells.
  const BodyMesh<2>                    mesh(make_brick({{10, 2}}, 0, 4),
                         {BodyMesh<2>::upper_side});
  std::map<unsigned int, unsigned int> n_of_size;
  std::vector<bool>      is_kept(mesh.triangulation().n_active_cells(), false);
  std::set<unsigned int> seen;
  mesh.patches().for_each(mesh.dof_handler(), [&](const auto &cells) {
    ++n_of_size[cells.size()];
    for (const auto &cell : cells)
      {
        EXPECT_TRUE(seen.insert(cell->active_cell_index()).second);
        if (cells.size() > 1)
          {
            EXPECT_EQ(cell->parent()->index(), cells[0]->parent()->index());
            EXPECT_EQ(cell->level(), cells[0]->level());
          }
        else
          {
            EXPECT_EQ(cell->level(), 0);
          }
      }
    if (cells.size() == 4 || cells[0]->at_boundary())
      for (const auto &cell : cells)
        is_kept[cell->active_cell_index()] = true;
  });
  EXPECT_EQ(seen.size(), mesh.triangulation().n_active_cells());
  EXPECT_EQ(n_of_size.size(), 3u);
  EXPECT_EQ(n_of_size[4], 80u);
  EXPECT_EQ(n_of_size[2], 10u * (1 + 2 + 4));
  EXPECT_EQ(n_of_size[1], 10u);

  // Patches of a part are those of the whole.
  const BodyMesh<2> part(mesh, is_kept);
  unsigned int      n_fours = 0;
  part.patches().for_each(part.dof_handler(), [&](const auto &cells) {
    n_fours += (cells.size() == 4);
    double width = 0.;
    for (const auto &cell : cells)
      width = std::max(width, cells[0]->center().distance(cell->center()));
    EXPECT_LT(width, 1.5 * cells[0]->diameter());
  });
  EXPECT_EQ(n_fours, 80u);
}



TEST(CellPatches, OnlyTheirMeanChangeOfVolumeIsResisted)
{
  // The divergence of x y e_x is y: its mean over cells of 1 m that were
  // refined once is 1/2.
  const MeshHierarchy<2> meshes   = make_meshes(make_brick({{5, 1}}, 1));
  const Material         material = nearly_incompressible(0.499999);
  const NodalVector      u =
    interpolate(meshes.finest(), [](const unsigned int, const Point<2> &x) {
      return Tensor<1, 2>({x[0] * x[1], 0.});
    });
  const auto  matrices = assemble_elastic_matrices(meshes.finest(), {material});
  NodalVector Ku       = u;
  matrices.stiffness.vmult(Ku, u);
  const double kappa = material.bulk_modulus();
  EXPECT_NEAR(0.5 * (u * Ku), 0.5 * kappa * 5. / 4., 1e-4 * kappa);

  const std::vector<double> dilatations =
    patch_dilatations(meshes.finest(), 0, u);
  ASSERT_EQ(dilatations.size(), 20u);
  for (const double dilatation : dilatations)
    EXPECT_NEAR(dilatation, 0.5, 1e-12);
}



TEST(CellPatches, StressIsThatOfTheirMeanStrain)
{
  // A column that is held on all sides but the top, pressed by its weight.
  const Material   material = nearly_incompressible(0.4999);
  MeshHierarchy<2> meshes   = make_meshes(make_brick({{10, 2}}, 2));
  std::vector<BoundaryCondition<2>> conditions;
  for (const unsigned int side : {0, 1})
    conditions.push_back(
      make_side<2>("0", side, {{BoundaryType::fixed, BoundaryType::free}}));
  conditions.push_back(make_side<2>(
    "0", BodyMesh<2>::lower_side, {{BoundaryType::free, BoundaryType::fixed}}));
  BoundaryValues<2> boundary(meshes, conditions, {"0"});
  const double      gravity = 9.81;
  SpatialProblem<2> problem(meshes,
                            {material},
                            boundary,
                            Tensor<1, 2>({0., -gravity}));
  NodalVector       u = problem.make_vector();
  solve_linear(problem,
               {0., 0., 1.},
               stuck_mask(problem.hierarchy()),
               problem.load(0.),
               u,
               1e-12);
  NodalVector nodal = problem.make_nodal_vector();
  problem.to_nodal(nodal, u);
  const VolumeState state = {nodal, nodal, nodal};
  VolumeMaterial<2> of_volume;
  of_volume.lame_parameters = [&](const Point<2> &) {
    return std::make_pair(material.lame_lambda(), material.shear_modulus());
  };
  of_volume.dilatations = [&](const NodalVector &displacement) {
    return patch_dilatations(meshes.finest(), 0, displacement);
  };
  const VolumeContent content =
    own_volume(meshes.finest(), state, {of_volume}, {VolumeField::stress});
  const auto values = [&](const std::string &name) -> const auto &
  {
    return std::find_if(content.of_cells.begin(),
                        content.of_cells.end(),
                        [&](const auto &field) { return field.name == name; })
      ->values;
  };
  // The weight above the cell is balanced, by a deviator inside of the patch.
  const double weight = material.density * gravity;
  meshes.finest().bodies[0]->patches().for_each(
    meshes.finest().bodies[0]->dof_handler(), [&](const auto &cells) {
      double height = 0.;
      for (const auto &cell : cells)
        height += cell->center()[1] / cells.size();
      for (const auto &cell : cells)
        {
          const unsigned int i  = cell->active_cell_index();
          const double       yy = values("stress_yy")[i],
                       mean     = (values("stress_xx")[i] + yy +
                               values("stress_zz")[i]) /
                              3.;
          EXPECT_NEAR(yy, -weight * (1. - cell->center()[1]), 1e-6 * weight);
          EXPECT_NEAR(mean, -weight * (1. - height), 1e-3 * weight);
        }
    });
}
