// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_fault_parameters_h
#define stickslip_friction_fault_parameters_h

#include <stickslip/friction/friction_parameters.h>
#include <stickslip/parameters/stress_field.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Source of the normal stress in the friction law.
   */
  enum class NormalStressSource
  {
    /** Contact force of the static equilibrium with the faults stuck. */
    initial_equilibrium,
    /** Weight of what lies above: sum of rho g times thickness. */
    lithostatic,
    /** A given function of position, Pa, compression positive. */
    function
  };

  /**
   * A part of a fault with friction of its own.
   */
  struct FrictionRegion
  {
    std::string name;

    /** The region is where this is greater than zero. */
    SpatialField where = 1.;

    FrictionParameters friction;
  };

  /**
   * Points of a fault at which the same parameters of friction hold, among some
   * points.
   */
  struct FaultPart
  {
    const FrictionParameters *friction;

    /** The subsection of its entries, for messages. */
    std::string section;

    /** Positions of these points among all, in ascending order. */
    std::vector<unsigned int> positions;

    /** Values that belong to the part, of those that there are for all points.
     */
    template <typename Value>
    std::vector<Value>
    select(const std::vector<Value> &values) const
    {
      std::vector<Value> selected;
      for (const unsigned int k : positions)
        selected.push_back(values[k]);
      return selected;
    }
  };

  /**
   * Everything the scene says of one fault. Its friction is that of what no
   * region covers.
   */
  struct FaultParameters : FrictionParameters
  {
    std::string name;

    NormalStressSource normal_stress_source =
      NormalStressSource::initial_equilibrium;

    /** Normal stress, Pa, compression positive. */
    SpatialField normal_stress = 5e4;

    /** True if the normal stress changes with the contact force. */
    bool normal_stress_follows = false;

    /** Stress that acts on the fault and that the bodies do not carry. */
    StressField background_stress;

    /** Regions in their order: where several are, the last of them counts. */
    std::vector<FrictionRegion> regions;

    /** The subsection of its entries, for messages. */
    std::string
    section() const
    {
      return "Faults/" + name;
    }

    /** True if the sides of some part may part. */
    bool
    may_open() const;

    /** The parts that some points fall into: that of the fault itself first,
     * then the regions, each of which may be empty. Throws InputError, see
     * SpatialField::function(). */
    template <int dim>
    std::vector<FaultPart>
    parts(const std::vector<Point<dim>> &points) const;

    /** Declare the entries in the current subsection of @p prm, those of a
     * scene in @p dim dimensions. */
    void
    add_parameters(ParameterHandler &prm, const unsigned int dim);
  };
} // namespace StickSlip

#endif
