// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>

#include "stuck_faults.h"

using namespace StickSlip;

namespace
{
  /** The first of two faults opens where x > 0, its slip rate is known where
   * x > 1. */
  template <int dim>
  struct Scene
  {
    MeshHierarchy<dim>  meshes;
    BoundaryValues<dim> boundary;
    SpatialProblem<dim> problem;

    Scene(const std::vector<BodyGeometry<dim>> &bodies)
      : meshes(stack<dim>(bodies), MPI_COMM_WORLD)
      , boundary(meshes, {}, SpatialScene<dim>::names(bodies.size()))
      , problem(meshes,
                std::vector<MaterialFields>(bodies.size(), Material()),
                boundary,
                Tensor<1, dim>(),
                /*with_inertia=*/true,
                {slips(), SlipRates<dim>()},
                {},
                {opens(), OpeningParts<dim>()})
    {}

    static SlipRates<dim>
    slips()
    {
      return [](const std::vector<Point<dim>> &points) {
        std::vector<std::optional<SlipRate<dim>>> rates(points.size());
        for (unsigned int k = 0; k < points.size(); ++k)
          if (points[k][0] > 1.)
            rates[k] = SlipRate<dim>();
        return rates;
      };
    }

    static OpeningParts<dim>
    opens()
    {
      return [](const std::vector<Point<dim>> &points) {
        std::vector<bool> result;
        for (const Point<dim> &x : points)
          result.push_back(x[0] > 0.);
        return result;
      };
    }
  };



  template <int dim>
  void
  expect_free_normals(const std::vector<BodyGeometry<dim>> &bodies)
  {
    Scene<dim>                   scene(bodies);
    const LevelDescription<dim> &finest = scene.problem.hierarchy().finest();
    NodalVector                  w      = scene.problem.make_vector();
    for (unsigned int i = 0; i < w.locally_owned_size(); ++i)
      w.local_element(i) = 5.;
    scene.problem.set_known_jumps(10., w);

    unsigned int n_open = 0, n_checked = 0;
    for (unsigned int f = 0; f < 2; ++f)
      {
        const FaultContact<dim> &fault = scene.problem.jump_basis().faults()[f];
        for (unsigned int k = 0; k < fault.slave.nodes.size(); ++k)
          {
            const auto         number = fault.slave.nodes[k];
            const unsigned int node   = finest.nodes.local_index(number);
            if (!std::binary_search(finest.nonsmooth_nodes.begin(),
                                    finest.nonsmooth_nodes.end(),
                                    node))
              continue;
            const double x             = fault.slave.points[k][0];
            const bool   opens         = f == 0 && x > 0. && x <= 1.;
            const bool   slip_is_known = f == 0 && x > 1.;
            EXPECT_EQ(scene.problem.may_open(number), opens);
            EXPECT_EQ(finest.fixed.is_active(node, dim - 1), opens);
            EXPECT_EQ(w.local_element(node * dim + dim - 1), opens ? 5. : 0.);
            EXPECT_EQ(finest.fixed.is_active(node, 0), !slip_is_known);
            EXPECT_EQ(w.local_element(node * dim), slip_is_known ? 0. : 5.);
            n_open += opens;
            ++n_checked;
          }
      }
    EXPECT_GT(n_open, 3u);
    EXPECT_LT(n_open, n_checked / 4);
  }
} // namespace



TEST(SpaceOpening, FreesTheNormalsOfItsPartOfAFault)
{
  expect_free_normals<2>({make_body<2>(1., {{10, 2}}, 2),
                          make_body<2>(1., {{14, 2}}, 1),
                          make_body<2>(1., {{9, 2}}, 2)});
  expect_free_normals<3>({make_body<3>(1., {{4, 4, 1}}, 1),
                          make_body<3>(1., {{5, 5, 1}}, 1),
                          make_body<3>(1., {{4, 4, 1}}, 1)});
}
