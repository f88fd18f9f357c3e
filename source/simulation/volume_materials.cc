// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/patch_volumes.h>
#include <stickslip/simulation/volume_materials.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace StickSlip
{
  template <int dim>
  std::vector<VolumeMaterial<dim>>
  volume_materials(const SceneParameters<dim> &scene,
                   const MeshLevel<dim>       &level)
  {
    using Entry =
      std::tuple<std::string, std::string, SpatialField MaterialFields::*>;
    static const std::vector<Entry> entries = {
      {"youngs_modulus", "Pa", &MaterialFields::youngs_modulus},
      {"poissons_ratio", "1", &MaterialFields::poissons_ratio},
      {"density", "kg/m^3", &MaterialFields::density},
      {"shear_viscosity", "Pa s", &MaterialFields::shear_viscosity},
      {"bulk_viscosity", "Pa s", &MaterialFields::bulk_viscosity}};

    std::vector<VolumeMaterial<dim>> result;
    for (const BodyParameters<dim> &body : scene.bodies)
      {
        result.emplace_back();
        result.back().lame_parameters =
          [at =
             body.material.template function<dim>()](const Point<dim> &point) {
            const Material material = at(point);
            return std::make_pair(material.lame_lambda(),
                                  material.shear_modulus());
          };
        // Displacements out of the plane change no volume.
        if (body.material.volumetric_strain == VolumetricStrain::patch_mean &&
            level.nodes.n_components() == dim)
          result.back().dilatations =
            [&level, b = result.size() - 1](const NodalVector &displacement) {
              return patch_dilatations(level, b, displacement);
            };
      }
    for (const auto &[name, units, field] : entries)
      if (std::any_of(scene.bodies.begin(),
                      scene.bodies.end(),
                      [field = field](const BodyParameters<dim> &body) {
                        return !(body.material.*field).is_constant();
                      }))
        for (unsigned int b = 0; b < scene.bodies.size(); ++b)
          {
            const MaterialFields &material = scene.bodies[b].material;
            result[b].fields.push_back(
              {name,
               units,
               (material.*field).template function<dim>(material.section)});
          }
    return result;
  }



  template std::vector<VolumeMaterial<2>>
  volume_materials<2>(const SceneParameters<2> &, const MeshLevel<2> &);
  template std::vector<VolumeMaterial<3>>
  volume_materials<3>(const SceneParameters<3> &, const MeshLevel<3> &);
} // namespace StickSlip
