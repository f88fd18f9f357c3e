// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/fault_parameters.h>
#include <stickslip/parameters/entries.h>
#include <stickslip/parameters/name_list.h>

#include <algorithm>

namespace StickSlip
{
  void
  FaultParameters::add_parameters(ParameterHandler &prm, const unsigned int dim)
  {
    FrictionParameters::add_parameters(prm, dim);
    add_choice(prm,
               "Normal stress",
               normal_stress_source,
               {{NormalStressSource::initial_equilibrium,
                 "initial equilibrium"},
                {NormalStressSource::lithostatic, "lithostatic"},
                {NormalStressSource::function, "function"}},
               "Normal stress in the friction law: from the contact force of "
               "the initial equilibrium, from the weight of the bodies above, "
               "or a given function.");
    add_field(prm,
              "Normal stress function",
              normal_stress,
              NumberRange().at_least(0).in("Pa"),
              "The given normal stress, in Pa, compression positive. Used only "
              "with 'Normal stress = function'.");
    add_switch(prm,
               "Normal stress follows",
               normal_stress_follows,
               "Whether the normal stress changes by as much as the contact "
               "pressure has changed since the start; it stays as it is "
               "otherwise.");
    background_stress.add_parameters(
      prm,
      "Background stress",
      dim,
      "A stress S, in Pa, tension positive, that is there before the bodies "
      "deform and that they do not carry; it is resolved on the fault with the "
      "normal n and the tangents t of each node. -n.S n is added to what "
      "'Normal stress' says, and t.S n to the shear traction of the bodies. "
      "Empty: none.");

    prm.enter_subsection("Regions");
    std::vector<std::string> names;
    for (const FrictionRegion &region : regions)
      names.push_back(region.name);
    prm.declare_entry("Names",
                      join_names(names),
                      NameList(),
                      "Names of parts of the fault with friction of their own; "
                      "none if empty. Each has a subsection of its name with "
                      "'Where' and the entries of the fault from 'Friction' to "
                      "'State while open'; those not set there are as in "
                      "the fault.");
    for (FrictionRegion &region : regions)
      {
        prm.enter_subsection(region.name);
        add_field(prm,
                  "Where",
                  region.where,
                  NumberRange().in_any_unit(),
                  "The region is where this is greater than 0, as in 'abs(x) < "
                  "1', x in m. Where several are, the last named counts.");
        region.friction.add_parameters(prm, dim);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }



  bool
  FaultParameters::may_open() const
  {
    return opening.may_open() ||
           std::any_of(regions.begin(),
                       regions.end(),
                       [](const FrictionRegion &region) {
                         return region.friction.opening.may_open();
                       });
  }



  template <int dim>
  std::vector<FaultPart>
  FaultParameters::parts(const std::vector<Point<dim>> &points) const
  {
    std::vector<FaultPart>    result = {{this, section(), {}}};
    std::vector<unsigned int> part_of_point(points.size(), 0);
    for (const FrictionRegion &region : regions)
      {
        const std::string region_section =
          section() + "/Regions/" + region.name;
        const std::vector<double> inside =
          region.where.values(points, region_section);
        for (unsigned int k = 0; k < points.size(); ++k)
          if (inside[k] > 0.)
            part_of_point[k] = result.size();
        result.push_back({&region.friction, region_section, {}});
      }
    for (unsigned int k = 0; k < points.size(); ++k)
      result[part_of_point[k]].positions.push_back(k);
    return result;
  }



  template std::vector<FaultPart>
  FaultParameters::parts(const std::vector<Point<2>> &) const;
  template std::vector<FaultPart>
  FaultParameters::parts(const std::vector<Point<3>> &) const;
} // namespace StickSlip
