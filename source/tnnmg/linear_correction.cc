// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/tnnmg/linear_correction.h>
#include <stickslip/tnnmg/multigrid_correction.h>

namespace StickSlip
{
  template <int dim>
  std::unique_ptr<LinearCorrection<dim>>
  make_linear_correction(LevelHierarchy<dim>   &hierarchy,
                         const TNNMGParameters &parameters)
  {
    return std::make_unique<MultigridCorrection<dim>>(hierarchy, parameters);
  }



  template class LinearCorrection<2>;
  template class LinearCorrection<3>;
  template std::unique_ptr<LinearCorrection<2>>
  make_linear_correction<2>(LevelHierarchy<2> &, const TNNMGParameters &);
  template std::unique_ptr<LinearCorrection<3>>
  make_linear_correction<3>(LevelHierarchy<3> &, const TNNMGParameters &);
} // namespace StickSlip
