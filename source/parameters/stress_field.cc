// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/utilities.h>

#include <stickslip/parameters/stress_field.h>

#include <algorithm>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** The names of the components and their indices in the tensor. */
    const std::vector<std::pair<std::string, std::array<unsigned int, 2>>> &
    component_list(const unsigned int dim)
    {
      static const std::vector<
        std::pair<std::string, std::array<unsigned int, 2>>>
        in_a_plane = {{"sxx", {{0, 0}}}, {"syy", {{1, 1}}}, {"sxy", {{0, 1}}}},
        in_space   = {{"sxx", {{0, 0}}},
                      {"syy", {{1, 1}}},
                      {"szz", {{2, 2}}},
                      {"sxy", {{0, 1}}},
                      {"syz", {{1, 2}}},
                      {"sxz", {{0, 2}}}};
      return dim == 2 ? in_a_plane : in_space;
    }



    /** The parts of a list between commas that are not within brackets. */
    std::vector<std::string>
    split_list(const std::string &text)
    {
      std::vector<std::string> parts = {""};
      int                      depth = 0;
      for (const char c : text)
        {
          depth += (c == '(') - (c == ')');
          if (c == ',' && depth == 0)
            parts.emplace_back();
          else
            parts.back() += c;
        }
      for (std::string &part : parts)
        part = Utilities::trim(part);
      return parts;
    }



    /** Pattern of all components, or none. */
    class StressPattern : public Patterns::PatternBase
    {
    public:
      explicit StressPattern(const unsigned int dim)
        : dim(dim)
      {}

      virtual bool
      match(const std::string &text) const override
      {
        if (Utilities::trim(text).empty())
          return true;
        const std::vector<std::string> parts = split_list(text);
        return parts.size() == component_list(dim).size() &&
               std::none_of(parts.begin(),
                            parts.end(),
                            [](const std::string &part) {
                              return part.empty();
                            });
      }

      virtual std::string
      description(const OutputStyle) const override
      {
        std::string names;
        for (const auto &component : component_list(dim))
          names += (names.empty() ? "" : ", ") + component.first;
        return "nothing, or " + std::to_string(component_list(dim).size()) +
               " components, each " + StressField::each_component + names +
               NumberRange::before_unit + "Pa" + NumberRange::after_unit;
      }

      virtual std::unique_ptr<PatternBase>
      clone() const override
      {
        return std::make_unique<StressPattern>(*this);
      }

    private:
      const unsigned int dim;
    };
  } // namespace



  void
  StressField::add_parameters(ParameterHandler  &prm,
                              const std::string &entry,
                              const unsigned int dim,
                              const std::string &documentation)
  {
    prm.declare_entry(entry, text, StressPattern(dim), documentation);
    prm.add_action(entry, [this, entry, dim](const std::string &value) {
      text = Utilities::trim(value);
      components.clear();
      if (text.empty())
        return;
      const std::vector<std::string> parts = split_list(text);
      for (unsigned int c = 0; c < parts.size(); ++c)
        {
          components.emplace_back();
          components.back().describe(entry + " (" +
                                       component_list(dim)[c].first + ")",
                                     NumberRange().in("Pa"));
          components.back().set(parts[c]);
        }
    });
  }



  std::string
  StressField::with_absolute_paths(const std::string &text,
                                   const std::string &folder)
  {
    std::string result;
    for (const std::string &part : split_list(text))
      result += (result.empty() ? "" : ", ") +
                SpatialField::with_absolute_path(part, folder);
    return result;
  }



  template <int dim>
  std::vector<SymmetricTensor<2, dim>>
  StressField::values(const std::vector<Point<dim>> &points,
                      const std::string             &section) const
  {
    std::vector<SymmetricTensor<2, dim>> stresses(points.size());
    for (unsigned int c = 0; c < components.size(); ++c)
      {
        const std::vector<double> values =
          components[c].values(points, section);
        const auto &[i, j] = component_list(dim)[c].second;
        for (unsigned int k = 0; k < points.size(); ++k)
          stresses[k][i][j] = values[k];
      }
    return stresses;
  }



  template std::vector<SymmetricTensor<2, 2>>
  StressField::values(const std::vector<Point<2>> &, const std::string &) const;
  template std::vector<SymmetricTensor<2, 3>>
  StressField::values(const std::vector<Point<3>> &, const std::string &) const;
} // namespace StickSlip
