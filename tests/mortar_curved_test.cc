// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/mortar/face_overlap.h>

#include "mortar_curves.h"

using namespace StickSlip;

namespace
{
  /** All that a coupling says but where things are. */
  template <int dim>
  void
  expect_same(const MortarCoupling<dim> &a,
              const MortarCoupling<dim> &b,
              const double               tolerance)
  {
    const auto expect_rows = [&](const SparseRow &x, const SparseRow &y) {
      for (const auto &[column, value] : x)
        EXPECT_NEAR(entry(y, column), value, tolerance);
      for (const auto &[column, value] : y)
        EXPECT_NEAR(entry(x, column), value, tolerance);
    };
    EXPECT_EQ(a.active, b.active);
    EXPECT_NEAR(a.covered_area, b.covered_area, tolerance);
    EXPECT_NEAR(a.lost_area, b.lost_area, tolerance);
    for (unsigned int p = 0; p < a.active.size(); ++p)
      {
        EXPECT_NEAR(a.weight[p], b.weight[p], tolerance);
        EXPECT_NEAR(a.averaging_factor[p], b.averaging_factor[p], tolerance);
        expect_rows(a.master_rows[p], b.master_rows[p]);
        expect_rows(a.inactive_slave_rows[p], b.inactive_slave_rows[p]);
      }
  }



  Tensor<1, 2>
  turned(const Point<2> &x)
  {
    return Tensor<1, 2>({-x[1], x[0]});
  }



  /** The elevation A sin(2 pi x), of a wave of length one. */
  std::function<Point<2>(const double)>
  sine(const double amplitude)
  {
    return [amplitude](const double x) {
      return Point<2>(x, amplitude * std::sin(2. * numbers::PI * x));
    };
  }



  double
  order(const std::vector<double> &errors)
  {
    return std::log2(errors[errors.size() - 2] / errors.back());
  }
} // namespace



TEST(DippingFault, IsTheRotatedLevelOne)
{
  std::mt19937 random(1);
  for (const double degrees : {30., 60., 90., 135., 240.})
    for (const double slid : {0., 0.2, -0.7})
      {
        auto y = random_breakpoints(11, -2., 2., random);
        for (double &x : y)
          x += slid;
        const Side<2> slave  = line(random_breakpoints(16, -2., 2., random)),
                      master = line(y);
        const Tensor<2, 2> R = rotation_by(degrees * numbers::PI / 180.);
        const Tensor<1, 2> a({0.3, -0.8});
        const auto         dipping_slave = moved(slave, R, a),
                   dipping_master        = moved(master, R, a);
        const auto dipping = couple(dipping_slave, dipping_master);
        expect_same(couple(slave, master), dipping, 1e-12);
        EXPECT_TRUE(dipping.rotation_rows.empty());
        EXPECT_LT(largest(jumps<2>(dipping,
                                   dipping_slave,
                                   dipping_master,
                                   [](const Point<2> &x) { return x; })),
                  1e-13);
      }
}



TEST(DippingFault, IsTheRotatedLevelOneInThreeDimensions)
{
  std::mt19937       random(2);
  const Tensor<2, 3> R(
    {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.}, {0.48, 0.64, 0.6}});
  const Tensor<1, 3> a({0.3, -0.8, 2.});
  for (const double angle : {0., 0.4})
    {
      const Side<3> slave       = grid(random_breakpoints(9, -2., 2., random),
                                 random_breakpoints(6, -1., 1., random)),
                    master      = grid(random_breakpoints(7, -2., 1.8, random),
                                  random_breakpoints(8, -1., 1., random),
                                  angle);
      const auto dipping_slave  = moved(slave, R, a),
                 dipping_master = moved(master, R, a);
      const auto dipping        = couple(dipping_slave, dipping_master);
      expect_same(couple(slave, master), dipping, 1e-12);
      EXPECT_LT(largest(jumps<3>(dipping,
                                 dipping_slave,
                                 dipping_master,
                                 [](const Point<3> &x) { return x; })),
                1e-13);
    }
}



TEST(CurvedFault, RowsOnASine)
{
  // The position along the fault is reproduced to third order and better,
  // whatever the ratio of the sizes of faces; that across it is off by the gap
  // between the two sides.
  for (const auto &ratio : {std::array<unsigned int, 2>{{4, 3}},
                            std::array<unsigned int, 2>{{2, 1}}})
    {
      std::vector<double> along, across;
      for (const unsigned int n : {16, 32, 64, 128})
        {
          const unsigned int n_master = n / ratio[0] * ratio[1];
          const Side<2>      slave =
                          curve(uniform_breakpoints(n, 0., 1.), sine(.05)),
                        master = curve(uniform_breakpoints(n_master, 0., 1.),
                                       sine(.05));
          const auto coupling  = couple(slave, master);
          EXPECT_EQ(coupling.lost_area, 0.);
          const auto normals = nodal_normals(slave.surface);
          along.push_back(0.);
          across.push_back(0.);
          for (unsigned int p = 0; p <= n; ++p)
            {
              ASSERT_TRUE(coupling.active[p]);
              EXPECT_NEAR(row_sum(coupling.master_rows[p]), 1., 1e-13);
              Tensor<1, 2> x = slave.positions[p];
              for (const auto &[q, value] : coupling.master_rows[p])
                x -= value * master.positions[q];
              across.back() = std::max(across.back(), std::abs(x * normals[p]));
              along.back() =
                std::max(along.back(),
                         std::abs(normals[p][1] * x[0] - normals[p][0] * x[1]));
            }
        }
      EXPECT_GT(order(along), 2.9);
      EXPECT_LT(along[1], 1e-5);
      EXPECT_GT(order(across), 1.9);
      EXPECT_LT(across[1], 1e-3);
    }
}



TEST(CurvedFault, RotationOfADiscInARingHasNoJump)
{
  // The disc is slave or master; the faces of both sides are chords.
  for (const auto &n : {std::array<unsigned int, 2>{{80, 60}},
                        std::array<unsigned int, 2>{{80, 40}},
                        std::array<unsigned int, 2>{{60, 80}}})
    {
      const Side<2> slave   = circle(n[0], 2., 0.1),
                    master  = circle(n[1], 2., 0.);
      const auto   coupling = couple(slave, master);
      const double length   = n[0] * 4. * std::sin(numbers::PI / n[0]);
      EXPECT_NEAR(coupling.covered_area, length, 1e-12);
      EXPECT_LT(largest(jumps<2>(coupling, slave, master, turned)), 2e-14);
      EXPECT_LT(largest(jumps<2>(coupling,
                                 slave,
                                 master,
                                 [](const Point<2> &) {
                                   return Tensor<1, 2>({1., 2.});
                                 })),
                1e-13);
      // The sagitta of a chord is what is left without the term.
      EXPECT_GT(largest(jumps<2>(coupling, slave, master, turned, false)),
                4e-4);
    }
}



TEST(CurvedFault, MatchingMeshesNeedNoRotationTerm)
{
  const Side<2> side     = circle(40, 2., 0.1);
  const auto    coupling = couple(side, side);
  for (unsigned int p = 0; p < 40; ++p)
    {
      ASSERT_EQ(coupling.master_rows[p].size(), 1u);
      EXPECT_NEAR(entry(coupling.master_rows[p], p), 1., 1e-14);
      EXPECT_TRUE(coupling.rotation_rows[p].empty());
    }
}



TEST(CurvedFault, FarPassesOfASpiralDoNotCouple)
{
  const auto spiral = [](const double s) {
    return Point<2>((1. + 0.1 * s) * std::cos(s), (1. + 0.1 * s) * std::sin(s));
  };
  const double  end    = 6. * numbers::PI;
  const Side<2> slave  = curve(uniform_breakpoints(400, 0., end), spiral),
                master = curve(uniform_breakpoints(300, 0., end), spiral);
  const auto coupling  = couple(slave, master);
  double     length    = 0.;
  for (unsigned int f = 0; f < slave.surface.faces.size(); ++f)
    length += slave.surface.face_size(f);
  // The ends of both curves meet, but not those of their projections.
  EXPECT_NEAR(coupling.covered_area, length, 1e-3 * length);
  EXPECT_LT(largest(jumps<2>(coupling, slave, master, turned)), 1e-13);
  EXPECT_LT(largest(jumps<2>(
              coupling, slave, master, [](const Point<2> &x) { return x; })),
            0.02);
}



TEST(Crosspoint, SidesThatEndAtAJunctionTransmitConstantTractions)
{
  // Two bodies side by side on a third one, which is master; each has a node of
  // its own at the junction.
  std::mt19937              random(4);
  const std::vector<double> x = random_breakpoints(9, 0., 1., random),
                            y = random_breakpoints(7, 1., 3., random),
                            z = random_breakpoints(13, 0., 3., random);
  Side<2>            slave    = line(x);
  const Side<2>      right = line(y), master = line(z);
  const unsigned int n_left = x.size();
  for (const Point<2> &point : right.positions)
    {
      slave.positions.push_back(point);
      slave.surface.points.push_back(point);
      slave.surface.nodes.push_back(slave.surface.nodes.size());
    }
  for (auto face : right.surface.faces)
    slave.surface.faces.push_back({{face[0] + n_left, face[1] + n_left}});
  std::vector<bool> excluded(slave.positions.size(), false);
  excluded[n_left - 1] = excluded[n_left] = true;

  const Tensor<2, 2> R             = rotation_by(1.);
  const auto         dipping_slave = moved(slave, R, Tensor<1, 2>()),
             dipping_master        = moved(master, R, Tensor<1, 2>());
  const auto coupling = couple(dipping_slave, dipping_master, excluded);
  EXPECT_EQ(coupling.lost_area, 0.);
  expect_consistent(coupling, dipping_slave, dipping_master, 3.);
  std::vector<double> slave_integrals = hat_integrals(x, 0., 1.);
  for (const double value : hat_integrals(y, 1., 3.))
    slave_integrals.push_back(value);
  expect_constant_traction(coupling, slave_integrals, hat_integrals(z, 0., 3.));
}



TEST(Crosspoint, TipsOfASlitHaveNoJump)
{
  // Both sides have their ends in common, which hand their dual functions on.
  std::mt19937              random(7);
  const std::vector<double> x    = random_breakpoints(9, -1., 1., random);
  const Tensor<2, 2>        R    = rotation_by(0.7);
  const Side<2>             side = moved(line(x), R, Tensor<1, 2>({0.1, 0.2}));
  std::vector<bool>         is_tip(10, false);
  is_tip[0] = is_tip[9] = true;
  const auto coupling   = couple(side, side, is_tip);
  EXPECT_EQ(coupling.lost_area, 0.);
  EXPECT_NEAR(coupling.covered_area, 2., 1e-14);
  for (unsigned int p = 1; p < 9; ++p)
    {
      EXPECT_NEAR(entry(coupling.master_rows[p], p), 1., 1e-13);
      for (const unsigned int tip : {0, 9})
        {
          // The displacement of a tip is that of both sides.
          const double on_slave = entry(coupling.inactive_slave_rows[p], tip);
          EXPECT_NEAR(entry(coupling.master_rows[p], tip), -on_slave, 1e-13);
          EXPECT_EQ(on_slave != 0., p == (tip == 0 ? 1u : 8u));
        }
    }
  expect_consistent(coupling, side, side, 2.);
}



TEST(CurvedFault, CylinderOfQuadrilateralsAndOfTriangles)
{
  const auto cylinder = [](const double angle, const double z) {
    return Point<3>(std::cos(angle), std::sin(angle), z);
  };
  std::mt19937 random(5);
  for (const bool slave_of_triangles : {false, true})
    for (const bool master_of_triangles : {false, true})
      {
        const Side<3> slave =
                        curved_grid(random_breakpoints(12, 0., 2., random),
                                    random_breakpoints(7, 0., 1., random),
                                    cylinder,
                                    slave_of_triangles),
                      master =
                        curved_grid(random_breakpoints(9, -0.1, 2.1, random),
                                    random_breakpoints(5, -.1, 1.1, random),
                                    cylinder,
                                    master_of_triangles);
        const auto coupling = couple(slave, master);
        EXPECT_EQ(coupling.lost_area, 0.);
        double area = 0.;
        for (unsigned int p = 0; p < slave.positions.size(); ++p)
          {
            ASSERT_TRUE(coupling.active[p]);
            EXPECT_NEAR(row_sum(coupling.master_rows[p]), 1., 1e-13);
            area += coupling.weight[p];
          }
        EXPECT_NEAR(area, coupling.covered_area, 1e-13);
        EXPECT_NEAR(area, 2., 0.02);
        const auto rotate = [](const Point<3> &x) {
          return cross_product_3d(Tensor<1, 3>({0.3, -0.5, 0.8}), x);
        };
        EXPECT_LT(largest(jumps<3>(coupling, slave, master, rotate)), 1e-13);
        EXPECT_GT(largest(jumps<3>(coupling, slave, master, rotate, false)),
                  1e-3);
      }
}



TEST(DualMortar3D, PlanesOfTriangles)
{
  // Triangles on both sides, or quadrilaterals on one, reproduce linear
  // functions and transmit constant tractions.
  std::mt19937 random(6);
  const auto   level = [](const double x, const double y) {
    return Point<3>(x, y, 0.);
  };
  for (const bool master_of_triangles : {false, true})
    {
      const Side<3> slave  = curved_grid(random_breakpoints(7, 0., 2., random),
                                        random_breakpoints(5, 0., 1., random),
                                        level,
                                        true),
                    master = curved_grid(random_breakpoints(4, 0., 2., random),
                                         random_breakpoints(6, 0., 1., random),
                                         level,
                                         master_of_triangles);
      const auto coupling  = couple(slave, master);
      expect_consistent(coupling, slave, master, 2.);
      const auto integrals = [](const Side<3> &side) {
        std::vector<double> result(side.positions.size(), 0.);
        for (unsigned int f = 0; f < side.surface.faces.size(); ++f)
          {
            const auto shape =
              project_face(FacePlane<3>(side.surface.normal_of(f)),
                           side.surface,
                           side.positions,
                           f);
            for (unsigned int v = 0; v < shape.n_vertices(); ++v)
              result[side.surface.faces[f][v]] += shape.shape_integrals()[v];
          }
        return result;
      };
      expect_constant_traction(coupling, integrals(slave), integrals(master));
    }
}
