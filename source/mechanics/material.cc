// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mechanics/material.h>

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
} // namespace StickSlip
