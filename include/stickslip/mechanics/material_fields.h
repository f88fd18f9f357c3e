// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_material_fields_h
#define stickslip_mechanics_material_fields_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/mechanics/material.h>
#include <stickslip/parameters/spatial_field.h>

#include <functional>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The material of a body, whose parameters may vary in space: those of
   * Material as functions of the reference position.
   */
  struct MaterialFields
  {
    SpatialField youngs_modulus  = Material().youngs_modulus;
    SpatialField poissons_ratio  = Material().poissons_ratio;
    SpatialField density         = Material().density;
    SpatialField shear_viscosity = Material().shear_viscosity;
    SpatialField bulk_viscosity  = Material().bulk_viscosity;

    /** Discretisation of the change of volume. */
    VolumetricStrain volumetric_strain = Material().volumetric_strain;

    /** The subsection of the entries, for messages. */
    std::string section = "Material";

    MaterialFields() = default;

    /** Constant parameters. */
    MaterialFields(const Material &material)
      : youngs_modulus(material.youngs_modulus)
      , poissons_ratio(material.poissons_ratio)
      , density(material.density)
      , shear_viscosity(material.shear_viscosity)
      , bulk_viscosity(material.bulk_viscosity)
      , volumetric_strain(material.volumetric_strain)
    {}

    /** True if all parameters are numbers. */
    bool
    are_constant() const;

    /** True if there may be any viscosity. */
    bool
    is_viscous() const;

    /** The numbers; only if are_constant(). */
    Material
    constants() const;

    /** The parameters as a function of the position, which throws InputError,
     * see SpatialField::function(). */
    template <int dim>
    std::function<Material(const Point<dim> &)>
    function() const;

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
