// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_geometry_fault_topology_h
#define stickslip_geometry_fault_topology_h

#include <deal.II/base/types.h>

#include <array>
#include <set>
#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The boundary faces of one body's mesh that have one indicator.
   */
  struct BodySide
  {
    unsigned int       body;
    types::boundary_id side;

    bool
    operator==(const BodySide &other) const
    {
      return body == other.body && side == other.side;
    }
  };

  /**
   * A surface along which bodies slip. The normal points from the first side to
   * the second one, and slip is the motion of the second relative to the first.
   */
  struct Fault
  {
    std::string name;

    /** The parts of the boundaries of bodies that make up each side. */
    std::array<std::vector<BodySide>, 2> sides;

    /** In three dimensions, the direction next to which slip has its first
     * component; of any length, zero: chosen by make_fault_axes(). */
    std::array<double, 3> strike = {{0., 0., 0.}};

    /** True if the sides need not touch where they are in the meshes. */
    bool may_be_apart = false;
  };

  /**
   * The bodies of a scene and the faults between them: a graph with any number
   * of faults at a body and no order of the bodies. Both sides of a fault may
   * be on one body.
   */
  class FaultTopology
  {
  public:
    FaultTopology() = default;

    /**
     * Throws InputError if a side of a fault is empty or on a body that is not
     * there, or if a part of a boundary is used twice.
     */
    FaultTopology(const std::vector<std::string> &body_names,
                  const std::vector<Fault>       &faults);

    /** Names of all bodies, in the order in which they are numbered. */
    const std::vector<std::string> &
    body_names() const
    {
      return bodies;
    }

    const std::vector<Fault> &
    faults() const
    {
      return all_faults;
    }

    /** Set the direction of the first component of the slip of a fault. */
    void
    set_strike(const unsigned int fault, const std::array<double, 3> &strike)
    {
      all_faults[fault].strike = strike;
    }

    /** The boundary indicators of a body's sides at faults. */
    std::set<types::boundary_id>
    sides_at_faults(const unsigned int body) const;

    bool
    is_at_fault(const unsigned int body, const types::boundary_id side) const;

  private:
    std::vector<std::string> bodies;
    std::vector<Fault>       all_faults;
  };

  /**
   * The topology of a stack of bricks, named from bottom to top: fault i lies
   * between the upper side of body i, which is its first side, and the lower
   * side of body i+1. One fault less than there are bodies.
   */
  template <int dim>
  FaultTopology
  stack_topology(const std::vector<std::string> &body_names,
                 const std::vector<std::string> &fault_names);
} // namespace StickSlip

#endif
