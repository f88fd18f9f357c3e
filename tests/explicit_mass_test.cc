// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>
#include <stickslip/problem/lumped_mass.h>
#include <stickslip/time/central_differences.h>

#include <random>

#include "antiplane_scenes.h"
#include "creeping_of_any_dimension.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  /** Bodies whose nodes face each other, and bodies whose nodes do not. */
  const Settings facing     = {"Bodies/upper/Coarse cells=4, 1"},
                 not_facing = {"Bodies/upper/Coarse cells=3, 1"};



  SceneParameters<2>
  bodies_in_the_plane(const Settings &more)
  {
    return creeping_bodies_with<2>({in_the_plane,
                                    {"Bodies/lower/Coarse cells=4, 1",
                                     "Bodies/lower/Refinement passes=1",
                                     "Bodies/upper/Refinement passes=1",
                                     "Bodies/upper/Material/Density=2e3",
                                     "Output/Event start slip rate=1"},
                                    more});
  }



  SceneParameters<3>
  bodies_in_space(const Settings &more)
  {
    return creeping_bodies_with<3>({in_space,
                                    {"Bodies/lower/Coarse cells=2, 1, 1",
                                     "Bodies/upper/Coarse cells=3, 2, 1",
                                     "Bodies/lower/Refinement passes=0",
                                     "Bodies/upper/Refinement passes=0",
                                     "Output/Event start slip rate=1"},
                                    more});
  }



  template <int dim, int n_components = dim>
  struct Bodies
  {
    explicit Bodies(const SceneParameters<dim> &scene)
      : simulation(scene, MPI_COMM_WORLD)
    {}

    SpatialProblem<dim, n_components> &
    problem()
    {
      return simulation.spatial_problem();
    }

    /** Random numbers where nothing is fixed. */
    NodalVector
    random_vector()
    {
      NodalVector w = problem().make_vector();
      for (double &value : w)
        value = number(generator);
      problem().operators().unknowns().fixed.apply(w);
      return w;
    }

    Simulation<dim, n_components>          simulation;
    std::mt19937                           generator{5};
    std::uniform_real_distribution<double> number{-1., 1.};
  };



  template <int dim, int n_components>
  void
  expect_inverse(const SceneParameters<dim> &scene)
  {
    Bodies<dim, n_components>           bodies(scene);
    const LumpedMass<dim, n_components> mass(bodies.problem());
    const NodalVector                   x = bodies.random_vector();
    NodalVector p = x, back = x, y = bodies.random_vector(), q = x;
    mass.vmult(p, x);
    mass.vmult(q, y);
    EXPECT_NEAR(x * q, y * p, 1e-12 * p.l2_norm() * y.l2_norm());
    EXPECT_GT(x * p, 0.);
    mass.solve(back, p);
    back -= x;
    EXPECT_LT(back.linfty_norm(), 1e-12);
  }



  /** The kinetic energy of nodes that move with random velocities, without
   * coupling between them, over that of the mass in the jump basis. */
  double
  energy_of_nodes_over_ours(const SceneParameters<2> &scene)
  {
    Bodies<2>           bodies(scene);
    const LumpedMass<2> mass(bodies.problem());
    const NodalVector   w = bodies.random_vector();
    NodalVector         p = w, nodal = bodies.problem().make_nodal_vector();
    mass.vmult(p, w);
    bodies.problem().to_nodal(nodal, w);
    double sum = 0.;
    for (unsigned int i = 0; i < nodal.locally_owned_size(); ++i)
      sum += bodies.problem().nodal_masses()[i / 2] *
             std::pow(nodal.local_element(i), 2);
    return sum / (w * p);
  }



  /** Twice the kinetic energy where each body moves as a whole, by the
   * velocities of @p u of its number. */
  template <int dim>
  double
  of_rigid_motions(Bodies<dim> &bodies, const std::vector<Tensor<1, dim>> &u)
  {
    const LumpedMass<dim> mass(bodies.problem());
    const MeshLevel<dim> &level = bodies.simulation.meshes().finest();
    NodalVector           nodal = bodies.problem().make_nodal_vector();
    for (unsigned int i = 0; i < nodal.locally_owned_size(); ++i)
      nodal.local_element(i) = u[i / dim < level.node(1, 0) ? 0 : 1][i % dim];
    NodalVector w = bodies.problem().make_vector(), p = w;
    bodies.problem().to_jumps(w, nodal);
    mass.vmult(p, w);
    return w * p;
  }



  /** Return whether M - tau/2 C - tau^2/4 K is positive definite where nothing
   * is fixed. */
  template <int dim, int n_components>
  bool
  is_stable(Bodies<dim, n_components> &bodies, const double tau)
  {
    using Problem = SpatialProblem<dim, n_components>;
    Problem                            &problem = bodies.problem();
    const LumpedMass<dim, n_components> mass(problem);
    const NodeMask           &fixed = problem.operators().unknowns().fixed;
    NodalVector               x = problem.make_vector(), p = x, product = x;
    std::vector<unsigned int> entries;
    for (unsigned int i = 0; i < x.locally_owned_size(); ++i)
      if (fixed.is_active(i / n_components, i % n_components))
        entries.push_back(i);
    LAPACKFullMatrix<double> matrix(entries.size());
    for (unsigned int j = 0; j < entries.size(); ++j)
      {
        x                           = 0.;
        x.local_element(entries[j]) = 1.;
        mass.vmult(p, x);
        problem.term(Problem::stiffness).vmult(product, x);
        p.add(-tau * tau / 4., product);
        if (problem.has(Problem::damping))
          {
            problem.term(Problem::damping).vmult(product, x);
            p.add(-tau / 2., product);
          }
        for (unsigned int i = 0; i < entries.size(); ++i)
          matrix(i, j) = p.local_element(entries[i]);
      }
    matrix.compute_eigenvalues();
    for (unsigned int i = 0; i < entries.size(); ++i)
      if (matrix.eigenvalue(i).real() <= 0.)
        return false;
    return true;
  }



  template <int dim, int n_components>
  void
  expect_limit(const SceneParameters<dim> &scene)
  {
    Bodies<dim, n_components> bodies(scene);
    bodies.simulation.set_up();
    const double limit =
      CentralDifferences<dim, n_components>(bodies.problem(),
                                            bodies.simulation.fault_nodes(),
                                            bodies.simulation.node_laws())
        .stability_limit();
    EXPECT_TRUE((is_stable<dim, n_components>(bodies, 0.99 * limit)));
    EXPECT_FALSE((is_stable<dim, n_components>(bodies, 1.01 * limit)));
  }



  const Settings with_inertia = {"Time/Inertia=dynamic"};
} // namespace



TEST(LumpedMass, HasASymmetricInverse)
{
  expect_inverse<2, 2>(bodies_in_the_plane(facing));
  expect_inverse<2, 2>(bodies_in_the_plane(not_facing));
  expect_inverse<3, 3>(bodies_in_space({}));
  expect_inverse<2, 1>(
    read_scene(antiplane_bodies,
               with_inertia + Settings{"Bodies/upper/Coarse cells=5, 2"}));
}



TEST(LumpedMass, IsThatOfTheNodesWhereTheseFaceEachOther)
{
  EXPECT_NEAR(energy_of_nodes_over_ours(bodies_in_the_plane(facing)),
              1.,
              1e-12);
  // Masters have the sum of a row in place of couplings.
  EXPECT_GT(std::abs(
              energy_of_nodes_over_ours(bodies_in_the_plane(not_facing)) - 1.),
            1e-3);
}



TEST(LumpedMass, IsThatOfBodiesThatMoveAsAWhole)
{
  // Of 2 m x 0.5 m; what is held counts as well.
  Bodies<2> plane(bodies_in_the_plane(
    not_facing +
    Settings{"Boundary conditions/upper top/x condition=traction"}));
  EXPECT_NEAR(of_rigid_motions<2>(
                plane, {Tensor<1, 2>({2., 0.}), Tensor<1, 2>({-3., 0.})}),
              5e3 * 4. + 2e3 * 9.,
              1e-7);
  // On one side: what faces a node is the same all along it.
  EXPECT_NEAR(of_rigid_motions<2>(
                plane, {Tensor<1, 2>({2., 1.}), Tensor<1, 2>({2., 1.})}),
              7e3 * 5.,
              1e-7);
  Bodies<3> space(bodies_in_space({

    "Boundary conditions/upper top/x condition=traction"}));
  EXPECT_NEAR(of_rigid_motions<3>(space,
                                  {Tensor<1, 3>({2., 1., 0.}),
                                   Tensor<1, 3>({-3., 2., 0.})}),
              5e3 * (5. + 13.),
              1e-7);
}



TEST(CentralDifferences, StabilityLimitIsThatOfTheMatrices)
{
  for (const std::string viscosity : {"0", "2e5", "2e6"})
    {
      const Settings viscous = {
        "Bodies/lower/Material/Shear viscosity=" + viscosity,
        "Bodies/lower/Material/Bulk viscosity=" + viscosity,
        "Bodies/upper/Material/Shear viscosity=0.3*" + viscosity,
        "Bodies/upper/Material/Bulk viscosity=" + viscosity};
      expect_limit<2, 2>(bodies_in_the_plane(not_facing + viscous));
    }
  expect_limit<3, 3>(bodies_in_space({}));
  expect_limit<2, 1>(read_scene(antiplane_bodies, with_inertia));
}
