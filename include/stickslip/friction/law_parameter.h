// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_law_parameter_h
#define stickslip_friction_law_parameter_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/parameters/spatial_field.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * A parameter of friction: an entry of the parameter file. Declaration,
   * reading, checks, evaluation at nodes and writing all go by what is said
   * here.
   */
  struct LawParameter
  {
    /** Name of the entry. */
    std::string entry;

    /** Documentation of the entry, without unit and full stop. */
    std::string documentation;

    /** SI unit, 1 for a number without unit; empty for a choice of words. */
    std::string unit;

    /** Values allowed everywhere on the fault. */
    NumberRange range;

    double default_value = 0.;

    /** True if the value may differ from node to node; else it is one number.
     */
    bool varies = true;

    /** Words to choose from, for a choice: its value is the position of the
     * word. Empty for a number. */
    std::vector<std::string> words = {};

    /** Dimension of the scenes that have the entry, at least. */
    unsigned int least_dimension = 2;

    /** True if the entry may be empty, so that nothing is given. */
    bool optional = false;

    /** Parameter that may vary along the fault. */
    static LawParameter
    field(const std::string &entry,
          const std::string &documentation,
          const std::string &unit,
          const NumberRange &range,
          const double       default_value)
    {
      return {entry, documentation, unit, range, default_value};
    }

    /** Parameter that may vary along the fault, and that need not be given. */
    static LawParameter
    optional_field(const std::string &entry,
                   const std::string &documentation,
                   const std::string &unit,
                   const NumberRange &range,
                   const double       value_if_empty)
    {
      LawParameter parameter =
        field(entry, documentation, unit, range, value_if_empty);
      parameter.optional = true;
      return parameter;
    }

    /** Parameter that is one number for all nodes. */
    static LawParameter
    number(const std::string &entry,
           const std::string &documentation,
           const std::string &unit,
           const NumberRange &range,
           const double       default_value)
    {
      return {entry, documentation, unit, range, default_value, false};
    }

    /** Choice among words, of which the first one is the default. */
    static LawParameter
    choice(const std::string              &entry,
           const std::string              &documentation,
           const std::vector<std::string> &words)
    {
      return {entry, documentation, "", {}, 0., false, words};
    }

    /** Documentation of the entry, with its unit. */
    std::string
    full_documentation() const;

    /** Mistake in the parameter itself: no name, documentation or unit,
     * or a default value that is not allowed. Empty if nothing is. */
    std::string
    mistake() const;

    /** Declare the entry in the current subsection of @p prm: @p value is its
     * default, and is set where the entry is. It must stay where it is for as
     * long as @p prm is used. */
    void
    declare(ParameterHandler &prm, SpatialField &value) const;
  };

  /** True if two parameters are the same entry with the same meaning. */
  bool
  operator==(const LawParameter &one, const LawParameter &other);



  /**
   * The values of some parameters at one node.
   */
  class LawValues
  {
  public:
    /** @p values: one for each of the @p parameters, which must live longer. */
    LawValues(const std::vector<LawParameter> &parameters,
              const std::vector<double>       &values);

    /** The value of a parameter. Throws std::logic_error if it is not among
     * the parameters. */
    double
    operator[](const LawParameter &parameter) const;

    /** All values in the order of the parameters. */
    const std::vector<double> &
    all() const
    {
      return values;
    }

  private:
    const std::vector<LawParameter> &parameters;
    std::vector<double>              values;
  };

} // namespace StickSlip

#endif
