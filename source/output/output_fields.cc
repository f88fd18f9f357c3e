// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/output_fields.h>

namespace StickSlip
{
  const std::vector<std::pair<FaultField, std::string>> &
  fault_field_names()
  {
    static const std::vector<std::pair<FaultField, std::string>> names = {
      {FaultField::slip, "slip"},
      {FaultField::slip_rate, "slip_rate"},
      {FaultField::shear_traction, "shear_traction"},
      {FaultField::normal_stress, "normal_stress"},
      {FaultField::state, "state"},
      {FaultField::contact_pressure, "contact_pressure"},
      {FaultField::contact_weight, "contact_weight"}};
    return names;
  }



  const std::vector<std::pair<VolumeField, std::string>> &
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
} // namespace StickSlip
