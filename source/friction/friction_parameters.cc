// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/friction_parameters.h>
#include <stickslip/parameters/name_list.h>

#include <cmath>

namespace StickSlip
{
  FrictionParameters::FrictionParameters()
    : chosen_kind(&law_registry().kinds().front())
  {
    for (const LawParameter &parameter : law_registry().parameters())
      {
        SpatialField &field = parameters[parameter.entry];
        field               = parameter.default_value;
        if (parameter.optional)
          field.make_optional(parameter.default_value);
        if (parameter.words.empty())
          field.describe(parameter.entry, parameter.range);
      }
  }



  void
  FrictionParameters::add_parameters(ParameterHandler  &prm,
                                     const unsigned int dim)
  {
    std::vector<std::string> names, formulas;
    for (const LawKind &kind : law_registry().kinds())
      {
        names.push_back(kind.name);
        formulas.push_back(kind.formula + " (" + kind.name + ")");
      }
    prm.declare_entry("Friction",
                      chosen_kind->name,
                      Patterns::Selection(join_names(names, "|")),
                      "What resists the slip: " + join_names(formulas, "; ") +
                        ". Entries that a kind does not use have no effect.");
    prm.add_action("Friction", [this](const std::string &name) {
      chosen_kind = &law_registry().kind(name);
    });
    for (const LawParameter &parameter : law_registry().parameters())
      if (parameter.least_dimension <= dim)
        parameter.declare(prm, parameters.at(parameter.entry));
    opening.add_parameters(prm);
  }



  template <int dim>
  std::vector<LawValues>
  FrictionParameters::law_values(const std::vector<Point<dim>> &points,
                                 const std::string             &section) const
  {
    std::vector<std::vector<double>> values(points.size());
    for (const LawParameter &parameter : chosen_kind->parameters)
      {
        const std::vector<double> of_parameter =
          parameters.at(parameter.entry).values(points, section);
        for (unsigned int k = 0; k < points.size(); ++k)
          values[k].push_back(of_parameter[k]);
      }
    std::vector<LawValues> result;
    for (const std::vector<double> &of_point : values)
      result.emplace_back(chosen_kind->parameters, of_point);
    return result;
  }



  template <int dim>
  std::vector<double>
  FrictionParameters::initial_states(const std::vector<Point<dim>> &points,
                                     const std::string &section) const
  {
    return parameters.at(CommonParameters::initial_state().entry)
      .values(points, section);
  }



  template <int dim>
  std::vector<GivenStart<dim - 1>>
  FrictionParameters::given_starts(const std::vector<Point<dim>> &points,
                                   const std::string             &section) const
  {
    std::vector<GivenStart<dim - 1>> result(points.size());
    if (has_prescribed_slip())
      return result;
    const auto given = [this](const LawParameter &parameter) {
      return parameters.at(parameter.entry).is_given();
    };
    if (has_state() && given(CommonParameters::initial_state()))
      {
        const std::vector<double> theta = initial_states(points, section);
        for (unsigned int k = 0; k < points.size(); ++k)
          result[k].log_state = std::log(theta[k]);
      }
    // A vector is given where one of its components is.
    const auto set_vectors =
      [&](std::optional<Tensor<1, dim - 1>> GivenStart<dim - 1>::*member,
          LawParameter (*parameter)(const unsigned int)) {
        bool is_given = false;
        for (unsigned int axis = 0; axis + 1 < dim; ++axis)
          is_given = is_given || given(parameter(axis));
        for (unsigned int axis = 0; axis + 1 < dim && is_given; ++axis)
          {
            const std::vector<double> values =
              parameters.at(parameter(axis).entry).values(points, section);
            for (unsigned int k = 0; k < points.size(); ++k)
              {
                if (axis == 0)
                  (result[k].*member).emplace();
                (*(result[k].*member))[axis] = values[k];
              }
          }
      };
    set_vectors(&GivenStart<dim - 1>::slip_rate,
                CommonParameters::initial_slip_rate);
    set_vectors(&GivenStart<dim - 1>::shear_stress,
                CommonParameters::initial_shear_stress);
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  FrictionParameters::prescribed_slip_rates(
    const std::vector<Point<dim>> &points,
    const std::string             &section) const
  {
    std::vector<Tensor<1, dim - 1>> rates(points.size());
    for (unsigned int axis = 0; axis + 1 < dim; ++axis)
      for (const LawParameter &parameter : chosen_kind->parameters)
        if (parameter == CommonParameters::slip_rate(axis))
          {
            const std::vector<double> values =
              parameters.at(parameter.entry).values(points, section);
            for (unsigned int k = 0; k < points.size(); ++k)
              rates[k][axis] = values[k];
          }
    return rates;
  }



  double
  FrictionParameters::slip_rate_ramp_length() const
  {
    return parameters.at(CommonParameters::slip_rate_ramp_length().entry)
      .constant();
  }



  template <int dim>
  std::vector<std::string>
  FrictionParameters::tables_elsewhere(
    const std::vector<Point<dim>> &points) const
  {
    std::vector<std::string> names;
    for (const auto &[entry, field] : parameters)
      if (field.is_table_elsewhere(points))
        names.push_back(entry);
    return names;
  }



  template <int dim>
  void
  FrictionParameters::check(const std::vector<Point<dim>> &points,
                            const std::string             &section) const
  {
    law_values(points, section);
    if (has_state())
      initial_states(points, section);
    given_starts(points, section);
    if (opening.may_open())
      for (const SpatialField *field :
           {&opening.tensile_strength, &opening.cohesion, &opening.initial_gap})
        field->values(points, section);
  }



#define STICKSLIP_INSTANTIATE(dim)                                             \
  template std::vector<LawValues> FrictionParameters::law_values<dim>(         \
    const std::vector<Point<dim>> &, const std::string &) const;               \
  template std::vector<double> FrictionParameters::initial_states<dim>(        \
    const std::vector<Point<dim>> &, const std::string &) const;               \
  template std::vector<GivenStart<dim - 1>>                                    \
  FrictionParameters::given_starts<dim>(const std::vector<Point<dim>> &,       \
                                        const std::string &) const;            \
  template std::vector<Tensor<1, dim - 1>>                                     \
  FrictionParameters::prescribed_slip_rates<dim>(                              \
    const std::vector<Point<dim>> &, const std::string &) const;               \
  template std::vector<std::string> FrictionParameters::tables_elsewhere<dim>( \
    const std::vector<Point<dim>> &) const;                                    \
  template void FrictionParameters::check<dim>(                                \
    const std::vector<Point<dim>> &, const std::string &) const;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
