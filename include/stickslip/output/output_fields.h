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
   * Fields of a fault over time in faults.h5 and in its VTU files.
   */
  enum class FaultField
  {
    slip,
    slip_rate,
    shear_traction,
    normal_stress,
    state,
    contact_pressure,
    contact_weight,
    gap,
    opening_rate,
    contact_state,
    position
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
  inline const std::vector<std::pair<FaultField, std::string>> &
  fault_field_names()
  {
    static const std::vector<std::pair<FaultField, std::string>> names = {
      {FaultField::slip, "slip"},
      {FaultField::slip_rate, "slip_rate"},
      {FaultField::shear_traction, "shear_traction"},
      {FaultField::normal_stress, "normal_stress"},
      {FaultField::state, "state"},
      {FaultField::contact_pressure, "contact_pressure"},
      {FaultField::contact_weight, "contact_weight"},
      {FaultField::gap, "gap"},
      {FaultField::opening_rate, "opening_rate"},
      {FaultField::contact_state, "contact_state"},
      {FaultField::position, "position"}};
    return names;
  }

  inline const std::vector<std::pair<VolumeField, std::string>> &
  volume_field_names()
  {
    static const std::vector<std::pair<VolumeField, std::string>> names = {
      {VolumeField::displacement, "displacement"},
      {VolumeField::velocity, "velocity"},
      {VolumeField::acceleration, "acceleration"},
      {VolumeField::stress, "stress"},
      {VolumeField::strain, "strain"},
      {VolumeField::body, "body"},
      {VolumeField::material, "material"}};
    return names;
  }

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
