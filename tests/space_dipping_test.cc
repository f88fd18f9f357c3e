// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/faults/contact_pressure.h>
#include <stickslip/faults/fault_nodes.h>

#include <map>

#include "stuck_faults.h"
#include "without_friction.h"

using namespace StickSlip;

namespace
{
  /** The axis of space that the last one is turned to when a stack is laid on
   * its side; the last one itself is turned against that axis. */
  template <int dim>
  constexpr unsigned int across = dim - 2;



  template <int dim>
  Tensor<1, dim>
  laid_down(const Tensor<1, dim> &vector)
  {
    Tensor<1, dim> result = vector;
    result[across<dim>]   = vector[dim - 1];
    result[dim - 1]       = -vector[across<dim>];
    return result;
  }



  /** A body of a stack laid on its side, all bodies of which extend from -2.5 m
   * to 2.5 m. */
  template <int dim>
  BodyGeometry<dim>
  laid_down(const BodyGeometry<dim> &body)
  {
    BodyGeometry<dim> result          = body;
    result.lateral_lower[across<dim>] = body.base;
    result.lateral_upper[across<dim>] = body.base + body.thickness;
    result.base                       = -2.5;
    result.thickness                  = 5.;
    std::swap(result.coarse_cells[across<dim>], result.coarse_cells[dim - 1]);
    return result;
  }



  /** A stack held at its lowest and highest side, loaded by gravity, and the
   * static solution with faults that slide without friction. */
  template <int dim>
  struct Solution
  {
    MeshHierarchy<dim>  meshes;
    BoundaryValues<dim> boundary;
    SpatialProblem<dim> problem;
    unsigned int        iterations = 0;
    NodalVector         u;

    /** By the positions of the slave nodes, in the axes of the stack. */
    std::map<std::vector<long>, Tensor<1, dim - 1>> slip;
    std::map<std::vector<long>, double>             pressure;
    std::map<std::vector<long>, Tensor<1, dim>>     displacement;

    Solution(const std::vector<BodyGeometry<dim>> &bodies,
             const bool                            is_laid_down,
             const std::vector<Material>          &materials)
      : meshes(all(bodies, is_laid_down),
               topology(bodies.size(), is_laid_down),
               MPI_COMM_WORLD)
      , boundary(meshes, held(bodies.size(), is_laid_down), {"0", "1", "2"})
      , problem(meshes,
                {materials.begin(), materials.end()},
                boundary,
                gravity(is_laid_down))
    {
      LevelHierarchy<dim> &hierarchy = problem.hierarchy();
      problem.combine({0., 0., 1.});
      Tests::linearise_without_friction(hierarchy, hierarchy.finest().fixed);
      const NodalVector load = problem.load(0.);
      NodalVector       rhs = load, w = problem.make_vector();
      hierarchy.finest().fixed.apply(rhs);
      SolverControl control(200, 1e-13 * rhs.l2_norm());
      SolverCG<NodalVector>(control).solve(LinearisedOperator<dim>{hierarchy},
                                           w,
                                           rhs,
                                           CyclePreconditioner<dim>{hierarchy});
      iterations = control.last_step();
      u          = problem.make_nodal_vector();
      problem.to_nodal(u, w);

      NodalVector reaction = problem.make_vector();
      problem.operators().matrix().residual(reaction, load, w);
      reaction *= -1.;
      const JumpBasis<dim> &basis = problem.jump_basis();
      const FaultNodes<dim> nodes(basis, hierarchy.finest().nodes);
      const auto            jumps = nodes.tangential_jumps(w);
      const auto            pressures =
        contact_pressures(basis, hierarchy.finest().nodes, reaction);
      unsigned int k = 0;
      for (const FaultContact<dim> &contact : basis.faults())
        for (const Point<dim> &point : contact.slave.points)
          {
            slip[place(point, is_laid_down)] = contact.sides.sign() * jumps[k];
            pressure[place(point, is_laid_down)] = pressures[k++];
          }
      for_each_node(meshes.finest(),
                    [&](const unsigned int body,
                        const unsigned int,
                        const unsigned int node,
                        const Point<dim>  &x,
                        const bool) {
                      Tensor<1, dim> value;
                      for (unsigned int d = 0; d < dim; ++d)
                        value[d] = u.local_element(node * dim + d);
                      auto key = place(x, is_laid_down);
                      key.push_back(body);
                      displacement[key] =
                        is_laid_down ? stood_up(value) : value;
                    });
    }

    static Tensor<1, dim>
    stood_up(const Tensor<1, dim> &vector)
    {
      // Three more quarter turns.
      return laid_down(laid_down(laid_down(vector)));
    }

    /** Position of a point in the stack, in whole micrometres. */
    static std::vector<long>
    place(const Point<dim> &point, const bool is_laid_down)
    {
      const Tensor<1, dim> x =
        is_laid_down ? stood_up(point) : Tensor<1, dim>(point);
      std::vector<long> result;
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(std::lround(1e6 * x[d]));
      return result;
    }

    static Tensor<1, dim>
    gravity(const bool is_laid_down)
    {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = 3. + 2. * d;
      return is_laid_down ? laid_down(result) : result;
    }

    static std::vector<BodyGeometry<dim>>
    all(std::vector<BodyGeometry<dim>> bodies, const bool is_laid_down)
    {
      if (is_laid_down)
        for (BodyGeometry<dim> &body : bodies)
          body = laid_down(body);
      return bodies;
    }

    /** Boundary indicators of the sides of a body that were below and above. */
    static std::pair<unsigned int, unsigned int>
    lower_and_upper(const bool is_laid_down)
    {
      const unsigned int axis = is_laid_down ? across<dim> : dim - 1;
      return {2 * axis, 2 * axis + 1};
    }

    static FaultTopology
    topology(const unsigned int n_bodies, const bool is_laid_down)
    {
      const auto [lower, upper] = lower_and_upper(is_laid_down);
      std::vector<std::string> names;
      std::vector<Fault>       faults;
      for (unsigned int b = 0; b < n_bodies; ++b)
        names.push_back(std::to_string(b));
      for (unsigned int f = 0; f + 1 < n_bodies; ++f)
        faults.push_back(
          {std::to_string(f), {{{{f, upper}}, {{f + 1, lower}}}}});
      return FaultTopology(names, faults);
    }

    static std::vector<BoundaryCondition<dim>>
    held(const unsigned int n_bodies, const bool is_laid_down)
    {
      const auto [lower, upper] = lower_and_upper(is_laid_down);
      std::array<BoundaryType, dim> type;
      type.fill(BoundaryType::velocity);
      return {make_side<dim>("0", lower, type),
              make_side<dim>(std::to_string(n_bodies - 1), upper, type)};
    }
  };



  /** The largest difference of the values of two maps with the same keys, over
   * the largest value. */
  template <typename Map, typename Size>
  double
  difference(const Map &a, const Map &b, const Size &size)
  {
    EXPECT_EQ(a.size(), b.size());
    double result = 0., scale = 0.;
    for (const auto &[key, value] : a)
      {
        const auto other = b.find(key);
        if (other == b.end())
          {
            ADD_FAILURE() << "Nodes are not at the same places.";
            return 1.;
          }
        result = std::max(result, size(value - other->second));
        scale  = std::max(scale, size(value));
      }
    return result / scale;
  }



  /** A stack and the same laid on its side do the same, in as many steps. */
  template <int dim>
  void
  expect_same_laid_down(const std::vector<BodyGeometry<dim>> &bodies)
  {
    std::vector<Material> materials(bodies.size());
    materials.back().youngs_modulus *= 3.;
    const Solution<dim> stack(bodies, false, materials),
      laid(bodies, true, materials);
    const auto norm = [](const auto &value) { return value.norm(); };
    EXPECT_LT(difference(stack.displacement, laid.displacement, norm), 1e-10);
    EXPECT_LT(difference(stack.slip, laid.slip, norm), 1e-10);
    EXPECT_LT(difference(stack.pressure,
                         laid.pressure,
                         [](const double value) { return std::abs(value); }),
              1e-9);
    EXPECT_EQ(stack.problem.hierarchy().finest().frames.empty(), true);
    EXPECT_EQ(laid.problem.hierarchy().finest().frames.empty(), false);
    EXPECT_LE(std::abs(int(laid.iterations) - int(stack.iterations)), 1)
      << stack.iterations << ' ' << laid.iterations;
    EXPECT_LT(stack.iterations, 40u);
  }
} // namespace



TEST(VerticalFault, IsALevelOneLaidOnItsSide)
{
  expect_same_laid_down<2>(
    stack<2>({make_body<2>(1., {{10, 2}}, 2), make_body<2>(1., {{9, 2}}, 3)}));
  // The finer mesh on the other side: the first one is the slave.
  expect_same_laid_down<2>(
    stack<2>({make_body<2>(1., {{9, 2}}, 3), make_body<2>(1., {{10, 2}}, 2)}));
}



TEST(VerticalFault, IsALevelOneLaidOnItsSideInThreeDimensions)
{
  expect_same_laid_down<3>(stack<3>(
    {make_body<3>(2., {{2, 3, 1}}, 1), make_body<3>(2., {{3, 2, 1}}, 1)}));
}
