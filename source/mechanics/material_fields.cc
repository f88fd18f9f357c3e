// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/material_fields.h>
#include <stickslip/parameters/entries.h>

namespace StickSlip
{
  bool
  MaterialFields::are_constant() const
  {
    return youngs_modulus.is_constant() && poissons_ratio.is_constant() &&
           density.is_constant() && shear_viscosity.is_constant() &&
           bulk_viscosity.is_constant();
  }



  bool
  MaterialFields::is_viscous() const
  {
    const auto is_zero = [](const SpatialField &viscosity) {
      return viscosity.is_constant() && viscosity.constant() == 0.;
    };
    return !is_zero(shear_viscosity) || !is_zero(bulk_viscosity);
  }



  Material
  MaterialFields::constants() const
  {
    return {youngs_modulus.constant(),
            poissons_ratio.constant(),
            density.constant(),
            shear_viscosity.constant(),
            bulk_viscosity.constant(),
            volumetric_strain};
  }



  template <int dim>
  std::function<Material(const Point<dim> &)>
  MaterialFields::function() const
  {
    if (are_constant())
      return [material = constants()](const Point<dim> &) { return material; };
    return [E      = youngs_modulus.function<dim>(section),
            nu     = poissons_ratio.function<dim>(section),
            rho    = density.function<dim>(section),
            eta    = shear_viscosity.function<dim>(section),
            zeta   = bulk_viscosity.function<dim>(section),
            strain = volumetric_strain](const Point<dim> &point) -> Material {
      return {E(point), nu(point), rho(point), eta(point), zeta(point), strain};
    };
  }



  void
  MaterialFields::add_parameters(ParameterHandler &prm)
  {
    add_field(prm,
              "Young modulus",
              youngs_modulus,
              NumberRange().above(0).in("Pa"),
              "Young's modulus E, in Pa.");
    add_field(prm,
              "Poisson ratio",
              poissons_ratio,
              NumberRange().above(-1).below(0.5),
              "Poisson's ratio nu, without unit. Incompressible bodies, nu = "
              "0.5, are out of the method's reach.");
    add_field(prm,
              "Density",
              density,
              NumberRange().above(0).in("kg/m^3"),
              "Mass density rho, in kg/m^3.");
    add_field(prm,
              "Shear viscosity",
              shear_viscosity,
              NumberRange().at_least(0).in("Pa s"),
              "Viscosity eta against change of shape, in Pa s.");
    add_field(prm,
              "Bulk viscosity",
              bulk_viscosity,
              NumberRange().at_least(0).in("Pa s"),
              "Viscosity zeta against change of volume, in Pa s.");
    add_choice(prm,
               "Volumetric strain",
               volumetric_strain,
               {{VolumetricStrain::full, "full"},
                {VolumetricStrain::patch_mean, "patch mean"}},
               "What resists the change of volume: that at each point (full), "
               "or its mean over the cells that a coarser one was refined into "
               "(patch mean). The latter is for nearly incompressible bodies, "
               "from a Poisson ratio of about 0.45 on, which are far too stiff "
               "in bending otherwise.");
  }



  template std::function<Material(const Point<2> &)>
  MaterialFields::function<2>() const;
  template std::function<Material(const Point<3> &)>
  MaterialFields::function<3>() const;
} // namespace StickSlip
