// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/symmetric_tensor.h>

#include <gtest/gtest.h>
#include <stickslip/mechanics/elastic_assembly.h>

#include "stacked_bodies.h"

using namespace StickSlip;

namespace
{
  template <int dim>
  struct Scene
  {
    std::vector<BodyGeometry<dim>> bodies;
    MeshHierarchy<dim>             meshes;
    std::vector<Material>          materials;
    ElasticMatrices<dim>           matrices;

    explicit Scene(const std::vector<BodyGeometry<dim>> &bodies,
                   const VolumetricStrain                volumetric_strain)
      : bodies(bodies)
      , meshes(bodies, MPI_COMM_WORLD)
      , materials(bodies.size())
    {
      for (unsigned int b = 0; b < bodies.size(); ++b)
        {
          materials[b].youngs_modulus    = (1. + b) * 4.12e7;
          materials[b].poissons_ratio    = 0.3 - 0.1 * b;
          materials[b].density           = 5e3 - 700. * b;
          materials[b].shear_viscosity   = 1e3 * (2. + b);
          materials[b].bulk_viscosity    = 1e3 * (5. - b);
          materials[b].volumetric_strain = volumetric_strain;
        }
      matrices =
        assemble_elastic_matrices(meshes.finest(),
                                  {materials.begin(), materials.end()});
    }

    double
    volume(const unsigned int b) const
    {
      double result = 1.;
      for (unsigned int c = 0; c < dim; ++c)
        result *= bodies[b].upper_corner()[c] - bodies[b].lower_corner()[c];
      return result;
    }

    /** A motion x -> shift + G x of one body, the others at rest. */
    NodalVector
    affine(const unsigned int    body,
           const Tensor<1, dim> &shift,
           const Tensor<2, dim> &G) const
    {
      return interpolate(meshes.finest(),
                         [&](const unsigned int b, const Point<dim> &x) {
                           return b == body ? shift + G * x : Tensor<1, dim>();
                         });
    }
  };



  constexpr VolumetricStrain both_strains[] = {VolumetricStrain::full,
                                               VolumetricStrain::patch_mean};

  template <int dim>
  Scene<dim>
  make_scene(const VolumetricStrain volumetric_strain = VolumetricStrain::full)
  {
    if constexpr (dim == 2)
      return Scene<2>(nonmatching_bodies(), volumetric_strain);
    else
      return Scene<3>(nonmatching_blocks(), volumetric_strain);
  }



  template <int dim>
  double
  product(const NodalVector &u, const TermMatrix<dim> &A, const NodalVector &v)
  {
    NodalVector Av = v;
    A.vmult(Av, v);
    return u * Av;
  }



  /** Calls action(row, column, block). */
  template <int dim, typename Action>
  void
  for_each_entry(const TermMatrix<dim> &A, const Action &action)
  {
    const BlockSparsity &sparsity = A.sparsity();
    for (unsigned int i = 0; i < A.n_rows(); ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        action(i, sparsity.column[k], A.entry(i, k));
  }



  template <int dim>
  double
  largest_entry(const TermMatrix<dim> &A)
  {
    double result = 0.;
    for_each_entry(A,
                   [&](const unsigned int,
                       const unsigned int,
                       const Tensor<2, dim> &block) {
                     for (unsigned int c = 0; c < dim; ++c)
                       for (unsigned int d = 0; d < dim; ++d)
                         result = std::max(result, std::abs(block[c][d]));
                   });
    return result;
  }



  template <int dim>
  void
  expect_symmetric(const TermMatrix<dim> &A)
  {
    double defect = 0.;
    for_each_entry(A,
                   [&](const unsigned int    i,
                       const unsigned int    j,
                       const Tensor<2, dim> &block) {
                     const Tensor<2, dim> other =
                       A.entry(j, A.sparsity().position(j, i));
                     for (unsigned int c = 0; c < dim; ++c)
                       for (unsigned int d = 0; d < dim; ++d)
                         defect = std::max(defect,
                                           std::abs(block[c][d] - other[d][c]));
                   });
    EXPECT_GT(largest_entry(A), 0.);
    EXPECT_LT(defect, 1e-14 * largest_entry(A));
  }



  template <int dim>
  void
  expect_right_mass()
  {
    const Scene<dim> scene = make_scene<dim>();
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const double mass = scene.materials[b].density * scene.volume(b);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            {
              Tensor<1, dim> ec, ed;
              ec[c]          = 1.;
              ed[d]          = 1.;
              const double m = product(scene.affine(b, ec, {}),
                                       scene.matrices.mass,
                                       scene.affine(b, ed, {}));
              EXPECT_NEAR(m, c == d ? mass : 0., 1e-12 * mass);
            }

        // The moment of inertia of a brick about each axis through the origin.
        for (const auto &motion : rigid_motions<dim>())
          {
            double inertia = motion.first.norm_square();
            for (unsigned int c = 0; c < dim; ++c)
              if (motion.second[c].norm() > 0.)
                {
                  const double p = scene.bodies[b].lower_corner()[c];
                  const double q = scene.bodies[b].upper_corner()[c];
                  inertia += (q * q + p * q + p * p) / 3.;
                }
            const NodalVector r = scene.affine(b, motion.first, motion.second);
            EXPECT_NEAR(product(r, scene.matrices.mass, r) / mass,
                        inertia,
                        1e-12 * inertia);
          }
      }
  }



  template <int dim>
  void
  expect_no_energy_of_rigid_motion(const VolumetricStrain strain)
  {
    const Scene<dim> scene = make_scene<dim>(strain);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      for (const auto &motion : rigid_motions<dim>())
        for (const TermMatrix<dim> *A :
             {&scene.matrices.stiffness, &scene.matrices.damping})
          {
            const NodalVector r = scene.affine(b, motion.first, motion.second);
            NodalVector       force = r;
            A->vmult(force, r);
            const double scale = largest_entry(*A) * r.linfty_norm();
            EXPECT_LT(force.linfty_norm(), 1e-13 * scale);
            EXPECT_LT(std::abs(r * force), 1e-12 * scale);
          }
  }



  /** The stress of the material law as it stands in the textbooks, from the
   * strain in three dimensions. */
  template <int dim>
  std::pair<double, double>
  energy_densities(const Material &material, const Tensor<2, dim> &G)
  {
    SymmetricTensor<2, 3> eps;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d <= c; ++d)
        eps[c][d] = 0.5 * (G[c][d] + G[d][c]);
    const double E = material.youngs_modulus, nu = material.poissons_ratio;
    const auto   I = unit_symmetric_tensor<3>();
    const SymmetricTensor<2, 3> elastic =
      E / (1. + nu) * (eps + nu / (1. - 2. * nu) * trace(eps) * I);
    const SymmetricTensor<2, 3> viscous =
      2. * material.shear_viscosity * deviator(eps) +
      material.bulk_viscosity * trace(eps) * I;
    return {elastic * eps, viscous * eps};
  }



  template <int dim>
  void
  expect_energy_of_constant_strain(const VolumetricStrain strain)
  {
    const Scene<dim>                       scene = make_scene<dim>(strain);
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> number(-1., 1.);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      for (unsigned int repetition = 0; repetition < 5; ++repetition)
        {
          Tensor<2, dim> G;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              G[c][d] = number(random);
          const NodalVector u       = scene.affine(b, {}, G);
          const auto        density = energy_densities(scene.materials[b], G);
          const double elastic = 0.5 * product(u, scene.matrices.stiffness, u);
          const double viscous = product(u, scene.matrices.damping, u);
          EXPECT_NEAR(elastic / (0.5 * density.first * scene.volume(b)),
                      1.,
                      1e-12);
          EXPECT_NEAR(viscous / (density.second * scene.volume(b)), 1., 1e-12);
        }
  }



  template <int dim>
  void
  expect_right_weight()
  {
    const Scene<dim>  scene = make_scene<dim>();
    const double      g     = 9.81;
    const NodalVector load =
      assemble_gravity<dim>(scene.meshes.finest(),
                            {scene.materials.begin(), scene.materials.end()},
                            -g * Point<dim>::unit_vector(dim - 1));
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const double weight = scene.materials[b].density * g * scene.volume(b);
        const Point<dim> lower = scene.bodies[b].lower_corner();
        const Point<dim> upper = scene.bodies[b].upper_corner();
        for (unsigned int c = 0; c < dim; ++c)
          {
            Tensor<1, dim> e;
            e[c] = 1.;
            EXPECT_NEAR(load * scene.affine(b, e, {}),
                        c == dim - 1 ? -weight : 0.,
                        1e-12 * weight);
            // The first moments of the vertical load are those of the
            // centroid.
            Tensor<2, dim> G;
            G[dim - 1][c] = 1.;
            EXPECT_NEAR(load * scene.affine(b, {}, G),
                        -weight * 0.5 * (lower[c] + upper[c]),
                        1e-12 * weight);
          }
      }
    NodalVector at_hanging = load;
    for_each_node(scene.meshes.finest(),
                  [&](const unsigned int,
                      const unsigned int,
                      const unsigned int node,
                      const Point<dim> &,
                      const bool hanging) {
                    if (!hanging)
                      for (unsigned int c = 0; c < dim; ++c)
                        at_hanging.local_element(node * dim + c) = 0.;
                  });
    EXPECT_EQ(at_hanging.linfty_norm(), 0.);
  }
} // namespace



TEST(ElasticMatrices, MassAndMomentsOfInertia)
{
  expect_right_mass<2>();
  expect_right_mass<3>();
}



TEST(ElasticMatrices, RigidMotionCostsNoEnergy)
{
  for (const VolumetricStrain strain : both_strains)
    {
      expect_no_energy_of_rigid_motion<2>(strain);
      expect_no_energy_of_rigid_motion<3>(strain);
    }
}



TEST(ElasticMatrices, EnergyOfConstantStrain)
{
  for (const VolumetricStrain strain : both_strains)
    {
      expect_energy_of_constant_strain<2>(strain);
      expect_energy_of_constant_strain<3>(strain);
    }
}



TEST(ElasticMatrices, AreSymmetric)
{
  for (const VolumetricStrain strain : both_strains)
    {
      const Scene<2> scene_2d = make_scene<2>(strain);
      expect_symmetric(scene_2d.matrices.mass);
      expect_symmetric(scene_2d.matrices.damping);
      expect_symmetric(scene_2d.matrices.stiffness);
      const Scene<3> scene_3d = make_scene<3>(strain);
      expect_symmetric(scene_3d.matrices.mass);
      expect_symmetric(scene_3d.matrices.damping);
      expect_symmetric(scene_3d.matrices.stiffness);
    }
}



TEST(ElasticMatrices, OnlyTheMeanChangeOfVolumeIsResistedIfAskedFor)
{
  // The divergence of x (y - 1/2) e_x is y - 1/2, and only its mean over each
  // row of cells is resisted. With the shear modulus nearly
  // zero beside the bulk modulus, the energy is 1/2 kappa times the integral
  // of the squared means.
  BodyGeometry<2> body = make_body<2>(1., {{10, 2}}, 0);
  Material        material;
  material.poissons_ratio = 0.499999;
  const MeshHierarchy<2> meshes({body}, MPI_COMM_WORLD);
  const NodalVector      u =
    interpolate(meshes.finest(), [](const unsigned int, const Point<2> &x) {
      return Tensor<1, 2>({x[0] * (x[1] - 0.5), 0.});
    });
  double energy[2];
  for (const VolumetricStrain strain : both_strains)
    {
      material.volumetric_strain = strain;
      const auto matrices =
        assemble_elastic_matrices(meshes.finest(), {material});
      energy[strain == VolumetricStrain::patch_mean] =
        0.5 * product(u, matrices.stiffness, u);
    }
  // Rows of cells of 0.5 m around y = 0.25 and 0.75: means -0.25 and 0.25,
  // mean squares 1/12 of all.
  const double kappa = material.bulk_modulus();
  EXPECT_NEAR(energy[0], 0.5 * kappa * 5. / 12., 1e-3 * energy[0]);
  EXPECT_NEAR(energy[1], 0.5 * kappa * 5. / 16., 1e-3 * energy[1]);
}



TEST(ElasticMatrices, GravityIsTheWeight)
{
  expect_right_weight<2>();
  expect_right_weight<3>();
}
