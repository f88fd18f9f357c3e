// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_output_fields_h
#define stickslip_output_output_fields_h

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Fields of a fault over time in faults.h5.
   */
  enum class FaultField
  {
    slip,
    slip_rate,
    shear_traction,
    normal_stress,
    state,
    contact_pressure,
    contact_weight
  };

  /**
   * Fields of the bodies in the VTU files.
   */
  enum class VolumeField
  {
    displacement,
    velocity,
    acceleration,
    stress,
    strain,
    body,
    material
  };

  /**
   * All fields, with their names in the parameter file and in the files that
   * are written.
   */
  const std::vector<std::pair<FaultField, std::string>> &
  fault_field_names();

  const std::vector<std::pair<VolumeField, std::string>> &
  volume_field_names();

  /**
   * True if a field is among those asked for.
   */
  template <typename Field>
  bool
  has_field(const std::vector<Field> &fields, const Field field)
  {
    return std::find(fields.begin(), fields.end(), field) != fields.end();
  }
} // namespace StickSlip

#endif
