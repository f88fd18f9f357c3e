// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_mortar_surfaces_h
#define stickslip_tests_mortar_surfaces_h

#include <gtest/gtest.h>
#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mortar/dual_mortar.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace StickSlip
{
  /** One side of a fault and the positions of its nodes. */
  template <int dim>
  struct Side
  {
    FaultSurface<dim>       surface;
    std::vector<Point<dim>> positions;
  };



  /** The surface with its normals reversed: a side that faces that one. */
  template <int dim>
  FaultSurface<dim>
  reversed(FaultSurface<dim> surface)
  {
    surface.normal *= -1.;
    for (Tensor<1, dim> &normal : surface.face_normals)
      normal *= -1.;
    return surface;
  }



  /** n + 1 increasing numbers from lower to upper, irregularly spaced. */
  inline std::vector<double>
  random_breakpoints(const unsigned int n,
                     const double       lower,
                     const double       upper,
                     std::mt19937      &random)
  {
    std::uniform_real_distribution<double> spacing(0.3, 1.);
    std::vector<double>                    points(n + 1, 0.);
    for (unsigned int i = 0; i < n; ++i)
      points[i + 1] = points[i] + spacing(random);
    const double length = points.back();
    for (double &x : points)
      x = lower + (upper - lower) * (x / length);
    points.back() = upper;
    return points;
  }



  inline std::vector<double>
  uniform_breakpoints(const unsigned int n,
                      const double       lower,
                      const double       upper)
  {
    std::vector<double> points(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      points[i] = lower + (upper - lower) * i / n;
    return points;
  }



  inline Side<2>
  line(const std::vector<double> &breakpoints)
  {
    Side<2> side;
    for (const double x : breakpoints)
      {
        side.positions.push_back(Point<2>(x, 0.));
        side.surface.points.push_back(Point<2>(x, 0.));
        side.surface.nodes.push_back(side.surface.nodes.size());
      }
    for (unsigned int i = 0; i + 1 < breakpoints.size(); ++i)
      side.surface.faces.push_back({{i, i + 1}});
    side.surface.normal[1] = 1.;
    return side;
  }



  /** A grid of rectangles, rotated about the origin. */
  inline Side<3>
  grid(const std::vector<double> &x,
       const std::vector<double> &y,
       const double               angle = 0.)
  {
    Side<3> side;
    for (const double b : y)
      for (const double a : x)
        {
          side.positions.push_back(
            Point<3>(std::cos(angle) * a - std::sin(angle) * b,
                     std::sin(angle) * a + std::cos(angle) * b,
                     0.));
          side.surface.points.push_back(side.positions.back());
          side.surface.nodes.push_back(side.surface.nodes.size());
        }
    const unsigned int n = x.size();
    for (unsigned int j = 0; j + 1 < y.size(); ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
        side.surface.faces.push_back(
          {{j * n + i, j * n + i + 1, (j + 1) * n + i, (j + 1) * n + i + 1}});
    side.surface.normal[2] = 1.;
    return side;
  }



  /** A copy of a side with nodes and faces renumbered and half of the faces
   * reversed.
   */
  template <int dim>
  Side<dim>
  shuffle(const Side<dim> &side, std::mt19937 &random)
  {
    std::vector<unsigned int> new_number(side.positions.size());
    std::iota(new_number.begin(), new_number.end(), 0);
    std::shuffle(new_number.begin(), new_number.end(), random);

    Side<dim> result = side;
    for (unsigned int i = 0; i < new_number.size(); ++i)
      {
        result.positions[new_number[i]]      = side.positions[i];
        result.surface.points[new_number[i]] = side.surface.points[i];
      }
    for (auto &face : result.surface.faces)
      {
        for (auto &vertex : face)
          vertex = new_number[vertex];
        // In deal.II's order of vertices this mirrors the face in x.
        if (random() % 2 == 0)
          for (unsigned int i = 0; i < face.size(); i += 2)
            std::swap(face[i], face[i + 1]);
      }
    std::shuffle(result.surface.faces.begin(),
                 result.surface.faces.end(),
                 random);
    return result;
  }



  /** The coupling of two sides whose normals are on the same side. */
  template <int dim>
  MortarCoupling<dim>
  couple(const Side<dim>         &slave,
         const Side<dim>         &master,
         const std::vector<bool> &excluded = {})
  {
    return build_mortar_coupling<dim>(slave.surface,
                                      slave.positions,
                                      reversed(master.surface),
                                      master.positions,
                                      excluded);
  }



  inline double
  row_sum(const SparseRow &row)
  {
    double sum = 0.;
    for (const auto &entry : row)
      sum += entry.second;
    return sum;
  }



  inline double
  entry(const SparseRow &row, const unsigned int column)
  {
    for (const auto &entry : row)
      if (entry.first == column)
        return entry.second;
    return 0.;
  }



  /**
   * Properties of any pair of surfaces: rigid motion and linear functions have
   * no jump, the weights add up to the area that carries contact, and with the
   * lost area to the whole overlap.
   */
  template <int dim>
  void
  expect_consistent(const MortarCoupling<dim> &coupling,
                    const Side<dim>           &slave,
                    const Side<dim>           &master,
                    const double               overlap_area,
                    const double               tolerance = 1e-13)
  {
    double total = 0.;
    for (unsigned int p = 0; p < slave.positions.size(); ++p)
      {
        total += coupling.weight[p];
        if (!coupling.active[p])
          {
            EXPECT_EQ(coupling.weight[p], 0.);
            EXPECT_TRUE(coupling.master_rows[p].empty());
            EXPECT_TRUE(coupling.inactive_slave_rows[p].empty());
            continue;
          }
        EXPECT_GT(coupling.weight[p], 0.);
        EXPECT_GT(coupling.averaging_factor[p], 0.);
        EXPECT_LE(coupling.averaging_factor[p], 1. + 1e-14);
        EXPECT_NEAR(row_sum(coupling.master_rows[p]) +
                      row_sum(coupling.inactive_slave_rows[p]),
                    1.,
                    tolerance);

        Tensor<1, dim> jump = slave.positions[p];
        for (const auto &[q, value] : coupling.master_rows[p])
          jump -= value * master.positions[q];
        for (const auto &[k, value] : coupling.inactive_slave_rows[p])
          {
            EXPECT_FALSE(coupling.active[k]);
            jump -= value * slave.positions[k];
          }
        EXPECT_LT(jump.norm(), tolerance) << "at node " << p;
      }
    EXPECT_NEAR(total, coupling.covered_area, tolerance);
    EXPECT_NEAR(total + coupling.lost_area, overlap_area, tolerance);
    EXPECT_GE(coupling.lost_area, 0.);
  }



  /**
   * A traction of one must give each master node q the integral of its shape
   * function, and each slave node likewise: the patch test, seen from the
   * fault.
   */
  template <int dim>
  void
  expect_constant_traction(const MortarCoupling<dim> &coupling,
                           const std::vector<double> &slave_integrals,
                           const std::vector<double> &master_integrals,
                           const double               tolerance = 1e-13)
  {
    std::vector<double> on_slave(slave_integrals.size(), 0.);
    std::vector<double> on_master(master_integrals.size(), 0.);
    for (unsigned int p = 0; p < on_slave.size(); ++p)
      {
        const double force = coupling.weight[p] * coupling.averaging_factor[p];
        on_slave[p] += force;
        for (const auto &[q, value] : coupling.master_rows[p])
          on_master[q] += force * value;
        for (const auto &[k, value] : coupling.inactive_slave_rows[p])
          on_slave[k] -= force * value;
      }
    for (unsigned int p = 0; p < on_slave.size(); ++p)
      EXPECT_NEAR(on_slave[p], slave_integrals[p], tolerance)
        << "at slave node " << p;
    for (unsigned int q = 0; q < on_master.size(); ++q)
      EXPECT_NEAR(on_master[q], master_integrals[q], tolerance)
        << "at master node " << q;
  }



  /**
   * Integrals of the piecewise linear nodal functions of increasing breakpoints
   * over the part between two bounds.
   */
  inline std::vector<double>
  hat_integrals(const std::vector<double> &x,
                const double               lower,
                const double               upper)
  {
    std::vector<double> result(x.size(), 0.);
    for (unsigned int i = 0; i + 1 < x.size(); ++i)
      {
        const double a = std::max(x[i], lower), b = std::min(x[i + 1], upper);
        if (a >= b)
          continue;
        const double middle = (a + b) / 2., h = x[i + 1] - x[i];
        result[i] += (b - a) * (x[i + 1] - middle) / h;
        result[i + 1] += (b - a) * (middle - x[i]) / h;
      }
    return result;
  }
} // namespace StickSlip

#endif
