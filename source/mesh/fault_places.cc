// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mesh/fault_places.h>

#include <algorithm>
#include <unordered_map>

namespace StickSlip
{
  template <int dim>
  std::vector<unsigned int>
  places_on_finer(const FaultSurface<dim> &coarse,
                  const FaultSurface<dim> &fine,
                  const NodalProlongation &prolongation)
  {
    std::unordered_map<types::global_dof_index, unsigned int> fine_place;
    for (unsigned int k = 0; k < fine.nodes.size(); ++k)
      if (const GlobalRow row = prolongation.row(fine.nodes[k]);
          row.size() == 1)
        fine_place[row.front().first] = k;

    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < coarse.nodes.size(); ++c)
      {
        const auto place = fine_place.find(coarse.nodes[c]);
        if (place != fine_place.end())
          result.push_back(place->second);
        else
          // The next one, where meshes are not nested.
          result.push_back(
            std::min_element(fine.points.begin(),
                             fine.points.end(),
                             [&](const auto &a, const auto &b) {
                               return coarse.points[c].distance(a) <
                                      coarse.points[c].distance(b);
                             }) -
            fine.points.begin());
      }
    return result;
  }



  template decltype(places_on_finer<2>) places_on_finer<2>;
  template decltype(places_on_finer<3>) places_on_finer<3>;
} // namespace StickSlip
