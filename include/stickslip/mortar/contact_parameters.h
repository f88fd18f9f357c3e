// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_contact_parameters_h
#define stickslip_mortar_contact_parameters_h

#include <deal.II/base/parameter_handler.h>

namespace StickSlip
{
  using namespace dealii;

  /**
   * Reasons to build the contact mapping of the two sides of a fault anew.
   */
  struct ContactParameters
  {
    /** False: small slip, the mapping of the reference positions is kept. */
    bool follow_slip = true;

    /**
     * The mapping is rebuilt as soon as some node has slid farther since the
     * last build than this fraction of the smallest face at any fault; zero:
     * see fraction().
     */
    double rebuild_fraction = 0.;

    /** The fraction for a fault that bends or does not. */
    double
    fraction(const bool is_bent) const
    {
      return rebuild_fraction > 0. ? rebuild_fraction :
             is_bent               ? 1. / 16. :
                                     0.25;
    }

    /** Declare the entries in the current subsection of @p prm. */
    void
    add_parameters(ParameterHandler &prm);
  };
} // namespace StickSlip

#endif
