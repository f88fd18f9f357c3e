// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_friction_newton_h
#define stickslip_tests_friction_newton_h

#include <deal.II/base/tensor.h>

#include <array>
#include <utility>

#include "friction_reference.h"

namespace Reference
{
  template <int dim>
  using Vector = std::array<Real, dim>;

  /**
   * Newton's method in fifty digits for the minimiser of
   *
   *   1/2 v . A v - r . v + load a Phi(|v_t|) / a
   *
   * over the active components, where v_t are the first @p n_tangential ones
   * and r holds what the inactive ones contribute through A. The functional is
   * strictly convex, so that a vanishing gradient proves the result, however
   * it was found. @p v is the start; the norm of the gradient relative to
   * that of r is returned.
   */
  template <int dim>
  double
  polish(const StickSlip::Regularisation regularisation,
         const dealii::Tensor<2, dim>   &A,
         const dealii::Tensor<1, dim>   &r,
         const Real                     &load_times_a,
         const double                    log_vmin,
         const unsigned int              n_tangential,
         const std::array<bool, dim>    &active,
         Vector<dim>                    &v)
  {
    Real relative_gradient = 1;
    for (unsigned int iteration = 0; iteration < 40; ++iteration)
      {
        Real V = 0;
        for (unsigned int i = 0; i < n_tangential; ++i)
          V += v[i] * v[i];
        V = sqrt(V);
        const Real force =
          load_times_a * scaled_coefficient(regularisation, V, log_vmin);
        const Real slope =
          load_times_a * scaled_derivative(regularisation, V, log_vmin);

        // The linear system, with the identity where v is inactive.
        std::array<std::array<Real, dim + 1>, dim> system;
        Real                                       norm = 0, norm_r = 0;
        for (unsigned int i = 0; i < dim; ++i)
          {
            for (unsigned int j = 0; j < dim; ++j)
              {
                const bool tangential = i < n_tangential && j < n_tangential;
                const Real tt =
                  (tangential && V > 0) ? Real(v[i] * v[j] / (V * V)) : Real(0);
                system[i][j] = Real(i == j ? 1 : 0);
                if (!active[i] || !active[j])
                  continue;
                system[i][j] = A[i][j];
                if (tangential && V > 0)
                  system[i][j] +=
                    slope * tt + force / V * (Real(i == j ? 1 : 0) - tt);
              }
            system[i][dim] = 0;
            if (!active[i])
              continue;
            system[i][dim] = r[i];
            for (unsigned int j = 0; j < dim; ++j)
              if (active[j])
                system[i][dim] -= A[i][j] * v[j];
            if (i < n_tangential && V > 0)
              system[i][dim] -= force * v[i] / V;
            norm += system[i][dim] * system[i][dim];
            norm_r += Real(r[i]) * r[i];
          }
        relative_gradient = sqrt(norm / norm_r);
        if (relative_gradient < 1e-40)
          break;

        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int k = i + 1; k < dim; ++k)
            {
              const Real factor = system[k][i] / system[i][i];
              for (unsigned int j = i; j <= dim; ++j)
                system[k][j] -= factor * system[i][j];
            }
        for (unsigned int i = dim; i-- > 0;)
          {
            for (unsigned int j = i + 1; j < dim; ++j)
              system[i][dim] -= system[i][j] * system[j][dim];
            system[i][dim] /= system[i][i];
            v[i] += system[i][dim];
          }
      }
    return static_cast<double>(relative_gradient);
  }
} // namespace Reference

#endif
