// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_box_layers_h
#define stickslip_tests_box_layers_h

#include <algorithm>
#include <array>
#include <functional>

#include "mesh_text.h"

namespace StickSlip::Tests
{
  enum class SolidCells
  {
    hexahedra,
    tetrahedra
  };

  /** Two layers, lower and upper, of 2 m x 2 m x 0.5 m each, with the group
   * fault between them at z = 0, and bottom, top and ends around; all positions
   * moved by @p move. Each cube of 0.5 m is one hexahedron, or six tetrahedra
   * around its diagonal. */
  inline MeshText
  box_layers(
    const SolidCells                                                    cells,
    const std::function<std::array<double, 3>(double, double, double)> &move)
  {
    constexpr int n = 4, layers = 2;
    MeshText      mesh;
    mesh.groups = {{3, 1, "lower"},
                   {3, 2, "upper"},
                   {2, 11, "bottom"},
                   {2, 12, "fault"},
                   {2, 13, "top"},
                   {2, 14, "ends"}};
    for (int k = 0; k <= layers; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          mesh.nodes.push_back(
            move(-1. + 2. * i / n, -1. + 2. * j / n, 0.5 * (k - 1)));
    const auto node = [](const std::array<int, 3> &place) {
      return 1 + (place[2] * (n + 1) + place[1]) * (n + 1) + place[0];
    };
    const auto corner = [](std::array<int, 3> place, const int bits) {
      for (unsigned int d = 0; d < 3; ++d)
        place[d] += (bits >> d) & 1;
      return place;
    };
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          {
            const auto at = [&](const int bits) {
              return node(corner({{i, j, k}}, bits));
            };
            if (cells == SolidCells::hexahedra)
              mesh.elements.push_back(
                {5,
                 k + 1,
                 {at(0), at(1), at(3), at(2), at(4), at(5), at(7), at(6)}});
            else
              {
                // One for each order of the steps from corner to corner.
                std::array<int, 3> steps = {{1, 2, 4}};
                do
                  {
                    const bool is_even = (steps[0] < steps[1]) +
                                           (steps[1] < steps[2]) +
                                           (steps[2] < steps[0]) ==
                                         2;
                    const int a = at(steps[0]), b = at(steps[0] + steps[1]);
                    mesh.elements.push_back(
                      {4,
                       k + 1,
                       {at(0), is_even ? a : b, is_even ? b : a, at(7)}});
                  }
                while (std::next_permutation(steps.begin(), steps.end()));
              }
          }
    // Faces with their lowest corner and two directions.
    const auto add_face = [&](const int                 group,
                              const std::array<int, 3> &place,
                              const int                 d,
                              const int                 e) {
      const int a = node(place), b = node(corner(place, d)),
                c = node(corner(place, d + e)), f = node(corner(place, e));
      if (cells == SolidCells::hexahedra)
        mesh.elements.push_back({3, group, {a, b, c, f}});
      else
        {
          mesh.elements.push_back({2, group, {a, b, c}});
          mesh.elements.push_back({2, group, {a, c, f}});
        }
    };
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (int k = 0; k <= layers; ++k)
          add_face(11 + k, {{i, j, k}}, 1, 2);
    for (int k = 0; k < layers; ++k)
      for (int i = 0; i < n; ++i)
        for (const int end : {0, n})
          {
            add_face(14, {{i, end, k}}, 1, 4);
            add_face(14, {{end, i, k}}, 2, 4);
          }
    return mesh;
  }
} // namespace StickSlip::Tests

#endif
