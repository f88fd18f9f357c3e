// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/instability.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    const double pi = 3.14159265358979323846;
  }



  double
  critical_stiffness(const WeakeningFriction &friction)
  {
    return (friction.b - friction.a) * friction.normal_stress /
           friction.characteristic_slip;
  }



  double
  nucleation_length(const WeakeningFriction &friction,
                    const double             shear_modulus,
                    const unsigned int       dim)
  {
    const double scale = shear_modulus * friction.characteristic_slip /
                         (friction.b * friction.normal_stress),
                 weakening = 1. - friction.a / friction.b,
                 factor = std::max(1.3774, 1. / (pi * weakening * weakening));
    return 2. * factor * scale * (dim == 3 ? pi * pi / 4. : 1.);
  }



  double
  process_zone(const WeakeningFriction &friction, const double shear_modulus)
  {
    return 9. * pi / 32. * shear_modulus * friction.characteristic_slip /
           (friction.b * friction.normal_stress);
  }
} // namespace StickSlip
