// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mortar/dual_basis.h>

#include <cmath>

namespace StickSlip
{
  template <int dim>
  DualBasis<dim>::DualBasis(const Matrix &mass, const unsigned int n_vertices)
    : A()
    , n_vertices(n_vertices)
    , valid(false)
  {
    // Scaled to a unit diagonal, the matrix of a sliver is as well-conditioned
    // as that of the whole face.
    Vector scale, row_sum;
    for (unsigned int i = 0; i < n_vertices; ++i)
      {
        if (!(mass[i][i] > 0.))
          return;
        scale[i]   = 1. / std::sqrt(mass[i][i]);
        row_sum[i] = 0.;
        for (unsigned int j = 0; j < n_vertices; ++j)
          row_sum[i] += mass[i][j];
      }

    Matrix L = {};
    for (unsigned int i = 0; i < n_vertices; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        {
          double value = mass[i][j] * scale[i] * scale[j];
          for (unsigned int k = 0; k < j; ++k)
            value -= L[i][k] * L[j][k];
          if (i != j)
            L[i][j] = value / L[j][j];
          else if (value > pivot_tolerance)
            L[i][i] = std::sqrt(value);
          else
            return;
        }

    const auto solve = [&](Vector x) {
      for (unsigned int i = 0; i < n_vertices; ++i)
        {
          x[i] *= scale[i];
          for (unsigned int k = 0; k < i; ++k)
            x[i] -= L[i][k] * x[k];
          x[i] /= L[i][i];
        }
      for (unsigned int i = n_vertices; i-- > 0;)
        {
          for (unsigned int k = i + 1; k < n_vertices; ++k)
            x[i] -= L[k][i] * x[k];
          x[i] /= L[i][i];
        }
      for (unsigned int i = 0; i < n_vertices; ++i)
        x[i] *= scale[i];
      return x;
    };

    // Row p of A = D M^-1 solves M x = D_pp e_p. One step of iterative
    // refinement makes up for the digits lost on thinly covered faces.
    for (unsigned int p = 0; p < n_vertices; ++p)
      {
        Vector right_hand_side = {};
        right_hand_side[p]     = row_sum[p];
        A[p]                   = solve(right_hand_side);

        Vector residual = right_hand_side;
        for (unsigned int i = 0; i < n_vertices; ++i)
          for (unsigned int j = 0; j < n_vertices; ++j)
            residual[i] -= mass[i][j] * A[p][j];
        const Vector correction = solve(residual);
        for (unsigned int i = 0; i < n_vertices; ++i)
          A[p][i] += correction[i];
      }
    valid = true;
  }



  template <int dim>
  void
  DualBasis<dim>::restrict_to(const std::array<bool, n> &active)
  {
    Assert(valid, ExcInternalError());
    for (unsigned int k = 0; k < n_vertices; ++k)
      if (!active[k])
        {
          // In deal.II's order, vertices of a quadrilateral that an edge joins
          // differ in one bit; those of a triangle are all joined.
          std::array<bool, n> heirs    = {};
          unsigned int        n_heirs  = 0;
          const auto          add_heir = [&](const unsigned int p) {
            if (active[p])
              {
                heirs[p] = true;
                ++n_heirs;
              }
          };
          if (n_vertices == n)
            for (unsigned int bit = 1; bit < n; bit *= 2)
              add_heir(k ^ bit);
          if (n_heirs == 0)
            for (unsigned int p = 0; p < n_vertices; ++p)
              add_heir(p);
          Assert(n_heirs > 0,
                 ExcMessage("At least one vertex must be active."));

          for (unsigned int p = 0; p < n_vertices; ++p)
            if (heirs[p])
              for (unsigned int j = 0; j < n_vertices; ++j)
                A[p][j] += A[k][j] / n_heirs;
          A[k] = {};
        }
  }



  template <int dim>
  const typename DualBasis<dim>::Matrix &
  DualBasis<dim>::coefficients() const
  {
    return A;
  }



  template class DualBasis<2>;
  template class DualBasis<3>;
} // namespace StickSlip
