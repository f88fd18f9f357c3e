// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_problem_partner_force_h
#define stickslip_problem_partner_force_h

#include <stickslip/algebra/node_partition.h>

#include <algorithm>

namespace StickSlip
{
  /**
   * A force on the bodies that makes up for the partners of slave nodes, which
   * go on while a contact mapping stays. It changes linearly from its first
   * value, with which tractions are those with the mapping before, to its last
   * one, and stays there.
   */
  struct PartnerForce
  {
    /** Dual vectors of the jump basis, N; empty for none. */
    NodalVector first, last;

    /** The time of the first value, s, and the part of the way to the last one
     * in a second, 1/s. */
    double start = 0, rate = 0;

    bool
    is_there() const
    {
      return first.size() > 0;
    }

    /** The time of the last value, s. */
    double
    end() const
    {
      return start + 1. / rate;
    }

    /** Add @p factor times the force at @p time to a dual vector. */
    void
    add(const double time, const double factor, NodalVector &dual) const
    {
      const double part = std::clamp(rate * (time - start), 0., 1.);
      dual.add(factor * (1. - part), first, factor * part, last);
    }

    /** Call @p action with each vector, in a fixed order. */
    template <typename Force, typename Action>
    static void
    for_each_vector(Force &force, const Action &action)
    {
      action(force.first);
      action(force.last);
    }

    /** Everything but the vectors to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &start &rate;
    }
  };
} // namespace StickSlip

#endif
