// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_turned_layers_h
#define stickslip_tests_turned_layers_h

#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "mesh_text.h"

namespace StickSlip::Tests
{
  enum class Cells
  {
    quadrilaterals,
    triangles
  };

  /** Two layers of 2 m x 0.5 m whose cells do not match, turned about the
   * origin by an angle. */
  inline MeshText
  turned_layers(const double angle, const Cells cells)
  {
    MeshText mesh;
    mesh.groups = {{2, 1, "lower"},
                   {2, 2, "upper"},
                   {1, 11, "bottom"},
                   {1, 12, "lower_fault"},
                   {1, 21, "upper_fault"},
                   {1, 22, "top"},
                   {1, 31, "ends"}};
    for (const int body : {1, 2})
      {
        const int columns = body == 1 ? 8 : 6, rows = 2;
        const int first = mesh.nodes.size() + 1;
        for (int j = 0; j <= rows; ++j)
          for (int i = 0; i <= columns; ++i)
            {
              const double x = -1. + 2. * i / columns;
              const double y = 0.5 * (body - 2) + 0.5 * j / rows;
              mesh.nodes.push_back({{std::cos(angle) * x - std::sin(angle) * y,
                                     std::sin(angle) * x + std::cos(angle) * y,
                                     0.}});
            }
        const auto node = [=](const int i, const int j) {
          return first + j * (columns + 1) + i;
        };
        for (int j = 0; j < rows; ++j)
          for (int i = 0; i < columns; ++i)
            {
              const int a = node(i, j), b = node(i + 1, j),
                        c = node(i + 1, j + 1), d = node(i, j + 1);
              if (cells == Cells::quadrilaterals)
                mesh.elements.push_back({3, body, {a, b, c, d}});
              else
                {
                  mesh.elements.push_back({2, body, {a, b, c}});
                  mesh.elements.push_back({2, body, {a, c, d}});
                }
            }
        for (int i = 0; i < columns; ++i)
          for (const int j : {0, rows})
            mesh.elements.push_back(
              {1, 10 * body + (j > 0 ? 2 : 1), {node(i, j), node(i + 1, j)}});
        for (int j = 0; j < rows; ++j)
          for (const int i : {0, columns})
            mesh.elements.push_back({1, 31, {node(i, j), node(i, j + 1)}});
      }
    return mesh;
  }



  /** A scene of these layers in the file layers.msh: the lower one is held, the
   * upper one driven at the velocity of its top that is given elsewhere. In
   * place of nx and ny stand the components of the normal. */
  inline const std::string layers = R"(
subsection Bodies
  set Names     = lower, upper
  set Mesh file = layers.msh
  subsection lower
    set Uniform refinements = 2
    set Refinement passes   = 1
    set Refine where        = 0.2 - abs(x * nx + y * ny)
  end
  subsection upper
    set Uniform refinements = 2
    set Refinement passes   = 1
    set Refine where        = 0.2 - abs(x * nx + y * ny)
  end
end
subsection Faults
  set Names = fault
  subsection fault
    set Between                = lower lower_fault, upper upper_fault
    set Characteristic slip    = 4e-6
    set Normal stress          = function
    set Normal stress function = 2e4
  end
end
subsection Boundary conditions
  set Sides = lower bottom, upper top
  subsection lower bottom
    set x condition = fixed
    set y condition = fixed
  end
  subsection upper top
    set x condition = velocity
    set y condition = velocity
  end
end
subsection Time
  set End time             = 5
  set Rate-state tolerance = 1e-9
end
subsection TNNMG
  set Tolerance = 1e-10
end
)";



  /** The scene of layers turned by an angle, about which cells are refined. */
  inline std::string
  turned_scene(const double angle)
  {
    std::string scene = layers;
    for (const auto &[name, value] :
         std::map<std::string, double>{{"nx", -std::sin(angle)},
                                       {"ny", std::cos(angle)}})
      for (std::size_t at; (at = scene.find(name)) != std::string::npos;)
        scene.replace(at, name.size(), "(" + shortest_form(value) + ")");
    return scene;
  }
} // namespace StickSlip::Tests

#endif
