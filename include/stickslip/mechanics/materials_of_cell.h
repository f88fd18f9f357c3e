// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mechanics_materials_of_cell_h
#define stickslip_mechanics_materials_of_cell_h

#include <deal.II/fe/fe_values.h>

#include <stickslip/mechanics/material_fields.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** Quantities to evaluate, besides @p flags, for parameters that vary. */
  inline UpdateFlags
  with_points(const UpdateFlags                  flags,
              const std::vector<MaterialFields> &materials)
  {
    const bool all_are_constant =
      std::all_of(materials.begin(),
                  materials.end(),
                  [](const MaterialFields &m) { return m.are_constant(); });
    return all_are_constant ? flags : flags | update_quadrature_points;
  }



  /**
   * The materials of all bodies at the quadrature points of a cell.
   */
  template <int dim>
  class MaterialsOfCell
  {
  public:
    explicit MaterialsOfCell(const std::vector<MaterialFields> &fields)
    {
      for (const MaterialFields &field : fields)
        if (field.are_constant())
          {
            functions.emplace_back();
            materials.push_back({field.constants()});
          }
        else
          {
            functions.push_back(field.function<dim>());
            materials.emplace_back();
          }
    }

    /** At the points of a cell of a body. */
    void
    reinit(const unsigned int body, const FEValues<dim> &fe_values)
    {
      current = body;
      if (!varies())
        return;
      materials[body].clear();
      for (const Point<dim> &point : fe_values.get_quadrature_points())
        materials[body].push_back(functions[body](point));
    }

    bool
    varies() const
    {
      return static_cast<bool>(functions[current]);
    }

    /** At a quadrature point. */
    const Material &
    operator[](const unsigned int q) const
    {
      return materials[current][varies() ? q : 0];
    }

  private:
    /** None for bodies whose parameters are numbers. */
    std::vector<std::function<Material(const Point<dim> &)>> functions;
    /** One for each quadrature point, or only one. */
    std::vector<std::vector<Material>> materials;
    unsigned int                       current = 0;
  };
} // namespace StickSlip

#endif
