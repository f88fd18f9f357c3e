// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_instability_h
#define stickslip_friction_instability_h

namespace StickSlip
{
  /**
   * Parameters that tell whether a fault with rate and state friction, b > a,
   * can slip unstably, by estimates from the literature for elastic bodies
   * without viscosity.
   */
  struct WeakeningFriction
  {
    /** Direct effect a and evolution effect b, without unit. */
    double a, b;

    /** Normal stress, Pa, and characteristic slip, m. */
    double normal_stress, characteristic_slip;
  };

  /**
   * The stiffness, Pa/m, below which steady sliding of a fault as a whole is
   * unstable: (b - a) sigma / L. Ruina, A. (1983), Slip instability and state
   * variable friction laws, J. Geophys. Res. 88, 10359-10370.
   */
  double
  critical_stiffness(const WeakeningFriction &friction);

  /**
   * The length, m, of the part of a fault that slides faster and faster: twice
   * the half-length max(1.3774, 1 / (pi (1 - a/b)^2)) G* L / (b sigma) of
   * Rubin, A. M. and Ampuero, J.-P. (2005), Earthquake nucleation on (aging)
   * rate and state faults, J. Geophys. Res. 110, B11312, for the aging law in
   * two dimensions; in three its diameter, pi^2 / 4 times that (Chen, T. and
   * Lapusta, N. (2009), J. Geophys. Res. 114, B01311). @p shear_modulus: G*,
   * Pa, which is G / (1 - nu) for slip in the plane.
   */
  double
  nucleation_length(const WeakeningFriction &friction,
                    const double             shear_modulus,
                    const unsigned int       dim);

  /**
   * The length, m, behind the tip of a rupture over which friction weakens,
   * while the rupture is slow: 9 pi / 32 G* L / (b sigma). Day, S. M., Dalguer,
   * L. A., Lapusta, N. and Liu, Y. (2005), Comparison of finite difference and
   * boundary integral solutions to three-dimensional spontaneous rupture, J.
   * Geophys. Res. 110, B12307, who want three cells and more in it.
   */
  double
  process_zone(const WeakeningFriction &friction, const double shear_modulus);

  /** Cells of a fault in the process zone that resolve a rupture. */
  constexpr double least_cells_in_process_zone = 3.;
} // namespace StickSlip

#endif
