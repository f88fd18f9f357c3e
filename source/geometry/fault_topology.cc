// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/coarse_body.h>
#include <stickslip/geometry/fault_topology.h>

#include <utility>

namespace StickSlip
{
  FaultTopology::FaultTopology(const std::vector<std::string> &body_names,
                               const std::vector<Fault>       &faults)
    : bodies(body_names)
    , all_faults(faults)
  {
    std::set<std::pair<unsigned int, types::boundary_id>> used;
    for (const Fault &fault : faults)
      for (const std::vector<BodySide> &side : fault.sides)
        {
          if (side.empty())
            throw InputError("The fault '" + fault.name +
                             "' has one side only; each of its two sides must "
                             "be on a body.");
          for (const BodySide &part : side)
            {
              if (part.body >= bodies.size())
                throw InputError(
                  "The fault '" + fault.name + "' is on body number " +
                  std::to_string(part.body + 1) + ", but there are only " +
                  std::to_string(bodies.size()) + ".");
              if (!used.emplace(part.body, part.side).second)
                throw InputError("The fault '" + fault.name + "' uses side " +
                                 std::to_string(part.side) + " of the body '" +
                                 bodies[part.body] +
                                 "', which is a side of a fault already.");
            }
        }
  }



  std::set<types::boundary_id>
  FaultTopology::sides_at_faults(const unsigned int body) const
  {
    std::set<types::boundary_id> result;
    for (const Fault &fault : all_faults)
      for (const std::vector<BodySide> &side : fault.sides)
        for (const BodySide &part : side)
          if (part.body == body)
            result.insert(part.side);
    return result;
  }



  bool
  FaultTopology::is_at_fault(const unsigned int       body,
                             const types::boundary_id side) const
  {
    return sides_at_faults(body).count(side) > 0;
  }



  template <int dim>
  FaultTopology
  stack_topology(const std::vector<std::string> &body_names,
                 const std::vector<std::string> &fault_names)
  {
    AssertDimension(fault_names.size() + 1, body_names.size());
    std::vector<Fault> faults;
    for (unsigned int i = 0; i < fault_names.size(); ++i)
      faults.push_back({fault_names[i],
                        {{{{i, CoarseBody<dim>::upper_side}},
                          {{i + 1, CoarseBody<dim>::lower_side}}}}});
    return FaultTopology(body_names, faults);
  }



  template FaultTopology
  stack_topology<2>(const std::vector<std::string> &,
                    const std::vector<std::string> &);
  template FaultTopology
  stack_topology<3>(const std::vector<std::string> &,
                    const std::vector<std::string> &);
} // namespace StickSlip
