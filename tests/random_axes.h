// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_random_axes_h
#define stickslip_tests_random_axes_h

#include <stickslip/algebra/node_frames.h>

#include <random>

namespace StickSlip::Tests
{
  /** Random orthonormal axes, right- or left-handed; a sign for n = 1. */
  template <int n>
  Tensor<2, n>
  random_axes(std::mt19937 &engine)
  {
    std::normal_distribution<double> normal;
    // Rows first, made orthogonal twice against rounding.
    Tensor<2, n> axes;
    for (unsigned int c = 0; c < n; ++c)
      {
        for (unsigned int d = 0; d < n; ++d)
          axes[c][d] = normal(engine);
        for (unsigned int pass = 0; pass < 2; ++pass)
          {
            for (unsigned int e = 0; e < c; ++e)
              axes[c] -= (axes[c] * axes[e]) * axes[e];
            axes[c] /= axes[c].norm();
          }
      }
    return axes;
  }



  /** Components along the axes of the nodes become those in space. */
  inline void
  to_space(NodalVector &vector, const LocalFrames &frames)
  {
    const unsigned int  n = frames.n_components();
    std::vector<double> w(n);
    for (const unsigned int i : frames.nodes())
      if ((i + 1) * n <= vector.locally_owned_size())
        {
          for (unsigned int c = 0; c < n; ++c)
            w[c] = vector.local_element(i * n + c);
          for (unsigned int c = 0; c < n; ++c)
            {
              double sum = 0;
              for (unsigned int d = 0; d < n; ++d)
                sum += frames.find(i)[c * n + d] * w[d];
              vector.local_element(i * n + c) = sum;
            }
        }
  }



  /** Components in space become those along the axes of the nodes. */
  inline void
  to_frames(NodalVector &vector, const LocalFrames &frames)
  {
    const unsigned int  n = frames.n_components();
    std::vector<double> u(n);
    for (const unsigned int i : frames.nodes())
      if ((i + 1) * n <= vector.locally_owned_size())
        {
          for (unsigned int c = 0; c < n; ++c)
            u[c] = vector.local_element(i * n + c);
          for (unsigned int c = 0; c < n; ++c)
            {
              double sum = 0;
              for (unsigned int d = 0; d < n; ++d)
                sum += frames.find(i)[d * n + c] * u[d];
              vector.local_element(i * n + c) = sum;
            }
        }
  }
} // namespace StickSlip::Tests

#endif
