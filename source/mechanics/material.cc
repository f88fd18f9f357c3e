// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/material.h>
#include <stickslip/parameters/entries.h>

#include <cmath>

namespace StickSlip
{
  double
  Material::lame_lambda() const
  {
    return youngs_modulus * poissons_ratio /
           ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
  }



  double
  Material::shear_modulus() const
  {
    return youngs_modulus / (2. * (1. + poissons_ratio));
  }



  double
  Material::bulk_modulus() const
  {
    return youngs_modulus / (3. * (1. - 2. * poissons_ratio));
  }



  double
  Material::shear_impedance() const
  {
    return std::sqrt(density * shear_modulus());
  }



  bool
  Material::is_viscous() const
  {
    return shear_viscosity > 0. || bulk_viscosity > 0.;
  }



  void
  Material::add_parameters(ParameterHandler &prm)
  {
    add_number(prm,
               "Young modulus",
               youngs_modulus,
               NumberRange().above(0),
               "Young's modulus E, in Pa.");
    add_number(prm,
               "Poisson ratio",
               poissons_ratio,
               NumberRange().above(-1).below(0.5),
               "Poisson's ratio nu, without unit. Incompressible bodies, nu = "
               "0.5, are out of the method's reach.");
    add_number(prm,
               "Density",
               density,
               NumberRange().above(0),
               "Mass density rho, in kg/m^3.");
    add_number(prm,
               "Shear viscosity",
               shear_viscosity,
               NumberRange().at_least(0),
               "Viscosity eta against change of shape, in Pa s.");
    add_number(prm,
               "Bulk viscosity",
               bulk_viscosity,
               NumberRange().at_least(0),
               "Viscosity zeta against change of volume, in Pa s.");
    add_choice(prm,
               "Volumetric strain",
               volumetric_strain,
               {{VolumetricStrain::full, "full"},
                {VolumetricStrain::cell_mean, "cell mean"}},
               "What resists the change of volume in a cell: that at each "
               "point (full), or its mean over the cell (cell mean). The "
               "latter is for nearly incompressible bodies, from a Poisson "
               "ratio of about 0.45 on, which are far too stiff in bending "
               "otherwise.");
  }
} // namespace StickSlip
