// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/output/energy_series.h>

namespace StickSlip
{
  TableColumns
  EnergySeries::columns(const unsigned int dim)
  {
    const std::string J = (dim == 2) ? "J/m" : "J";
    return {{"time", "s", "at the end of the step"},
            {"kinetic", J, "kinetic energy of all bodies"},
            {"elastic", J, "elastic energy of all bodies"},
            {"driven_sides",
             J,
             "work since the start of the forces on sides with prescribed "
             "velocities"},
            {"loads", J, "work since the start of gravity and tractions"},
            {"friction", J, "dissipated by friction since the start"},
            {"viscosity", J, "dissipated by viscosity since the start"},
            {"radiation", J, "taken by radiation damping since the start"},
            {"contact",
             J,
             "taken since the start by sides that come together and by bonds "
             "that break"},
            {"mappings", J, "added by new contact mappings since the start"},
            {"missing",
             J,
             "change of kinetic and elastic energy since the start that the "
             "work and what is dissipated do not explain"}};
  }



  EnergySeries::EnergySeries(const std::string &file_name,
                             const unsigned int dim)
    : file(file_name)
  {
    file << header_of(columns(dim));
    file.end_row();
  }



  EnergySeries::EnergySeries(const std::string &file_name,
                             const FileState   &earlier)
    : file(file_name, earlier)
  {}



  void
  EnergySeries::add(const EnergyRecord &record)
  {
    file << record.time << ',' << record.kinetic << ',' << record.elastic << ','
         << record.driven_sides << ',' << record.loads << ',' << record.friction
         << ',' << record.viscosity << ',' << record.radiation << ','
         << record.contact << ',' << record.mappings << ',' << record.missing;
    file.end_row();
  }
} // namespace StickSlip
