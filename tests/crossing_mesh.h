// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_crossing_mesh_h
#define stickslip_tests_crossing_mesh_h

#include <string>

#include "mesh_text.h"

namespace StickSlip::Tests
{
  /** A block of 8 m x 8 m about the origin, of square cells of half a metre,
   * with up to eight faults in it, "1" to "8": the first one of 7 m along y =
   * 0, the others upright, of 3 m, through it at x = 1, -1, 2, -2, 3, -3 and 0
   * m. Its outside is the group "sides". */
  inline MeshText
  crossing_faults_mesh(const unsigned int n_faults)
  {
    constexpr int n    = 16;
    const auto    node = [](const int x, const int y) {
      return (n + 1) * y + x + 1;
    };
    MeshText mesh;
    mesh.groups = {{2, 1, "block"}, {1, 10, "sides"}};
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x)
        mesh.nodes.push_back({{0.5 * x - 4., 0.5 * y - 4., 0.}});
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        mesh.elements.push_back(
          {3,
           1,
           {node(x, y), node(x + 1, y), node(x + 1, y + 1), node(x, y + 1)}});
    for (int i = 0; i < n; ++i)
      for (const int end : {0, n})
        {
          mesh.elements.push_back({1, 10, {node(i, end), node(i + 1, end)}});
          mesh.elements.push_back({1, 10, {node(end, i), node(end, i + 1)}});
        }
    for (unsigned int f = 1; f <= n_faults; ++f)
      {
        mesh.groups.push_back({1, int(f), std::to_string(f)});
        // 1, -1, 2, -2, 3, -3 and 0 m, in cells.
        const int place = n / 2 + (f == 8     ? 0 :
                                   f % 2 == 0 ? int(f) :
                                                1 - int(f));
        if (f == 1)
          for (int i = 1; i + 1 < n; ++i)
            mesh.elements.push_back(
              {1, 1, {node(i, n / 2), node(i + 1, n / 2)}});
        else
          for (int i = n / 2 - 3; i < n / 2 + 3; ++i)
            mesh.elements.push_back(
              {1, int(f), {node(place, i), node(place, i + 1)}});
      }
    return mesh;
  }
} // namespace StickSlip::Tests

#endif
