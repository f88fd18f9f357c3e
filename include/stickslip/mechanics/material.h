// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_material_h
#define stickslip_mechanics_material_h

#include <cmath>

namespace StickSlip
{
  /**
   * The change of volume in the stiffness and viscosity.
   */
  enum class VolumetricStrain
  {
    /** tr(eps) as it is, at each point; the default. */
    full,
    /** Its mean over a patch of cells, for nearly incompressible bodies. */
    patch_mean
  };

  /**
   * An isotropic Kelvin-Voigt solid,
   *
   *   sigma = 2 mu eps(u) + lambda tr(eps(u)) I
   *         + 2 eta dev(eps(u_t)) + zeta tr(eps(u_t)) I,
   *
   * with shear viscosity eta and bulk viscosity zeta. Two-dimensional bodies
   * are in plane strain. The parameters are those at one point; MaterialFields
   * has those of a body.
   */
  struct Material
  {
    /** Young's modulus E, Pa. */
    double youngs_modulus = 4.12e7;

    /** Poisson's ratio nu. */
    double poissons_ratio = 0.3;

    /** Density rho, kg/m^3. */
    double density = 5e3;

    /** Shear viscosity eta, Pa s. */
    double shear_viscosity = 1e3;

    /** Bulk viscosity zeta, Pa s. */
    double bulk_viscosity = 1e3;

    /** Discretisation of the change of volume. */
    VolumetricStrain volumetric_strain = VolumetricStrain::full;

    /** First Lame parameter lambda = E nu / ((1 + nu)(1 - 2 nu)), Pa. */
    double
    lame_lambda() const
    {
      return youngs_modulus * poissons_ratio /
             ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
    }

    /** Shear modulus mu = E / (2 (1 + nu)), Pa. */
    double
    shear_modulus() const
    {
      return youngs_modulus / (2. * (1. + poissons_ratio));
    }

    /** Bulk modulus kappa = E / (3 (1 - 2 nu)), Pa. */
    double
    bulk_modulus() const
    {
      return youngs_modulus / (3. * (1. - 2. * poissons_ratio));
    }

    /** Impedance of shear waves sqrt(rho mu), Pa s/m. */
    double
    shear_impedance() const
    {
      return std::sqrt(density * shear_modulus());
    }
  };
} // namespace StickSlip

#endif
