// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/friction/common_parameters.h>
#include <stickslip/friction/instability.h>
#include <stickslip/problem/fault_stiffness.h>
#include <stickslip/simulation/fault_rigidity.h>
#include <stickslip/simulation/weakening.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** G* of a fault at some points, Pa: that of both bodies is their harmonic
     * mean; a rigid one does not count. */
    template <int dim>
    std::vector<double>
    shear_moduli(const SceneParameters<dim>    &scene,
                 const unsigned int             fault,
                 const std::vector<Point<dim>> &points)
    {
      const bool in_plane =
        scene.deformation == Deformation::plane_strain && dim == 2;
      std::vector<double> moduli =
        sum_over_sides(scene, fault, points, [](const Material &) {
          return 1.;
        });
      const std::vector<double> compliance =
        sum_over_sides(scene, fault, points, [&](const Material &material) {
          return (in_plane ? 1. - material.poissons_ratio : 1.) /
                 material.shear_modulus();
        });
      for (unsigned int k = 0; k < points.size(); ++k)
        moduli[k] /= compliance[k];
      return moduli;
    }
  } // namespace



  template <int dim, int n_components>
  Weakening
  find_weakening(const SceneParameters<dim>    &scene,
                 Simulation<dim, n_components> &simulation,
                 const unsigned int             f)
  {
    const FaultNodes<dim>         &faults = simulation.fault_nodes();
    const unsigned int             first  = faults.first_of_fault()[f];
    const std::vector<Point<dim>> &points =
      simulation.spatial_problem().jump_basis().faults()[f].slave.points;
    const std::vector<double> moduli = shear_moduli(scene, f, points);
    const std::string         a      = CommonParameters::direct_effect().entry,
                      L = CommonParameters::characteristic_slip().entry,
                      b = "b";
    Weakening weakening;
    weakening.nodes.resize(faults.size(), false);
    double area = 0.;
    for (const FaultPart &part : scene.faults[f].parts(points))
      {
        const auto &parameters = part.friction->kind().parameters;
        if (!part.friction->has_state() ||
            std::none_of(parameters.begin(),
                         parameters.end(),
                         [&b](const LawParameter &parameter) {
                           return parameter.entry == b;
                         }))
          continue;
        const std::vector<Point<dim>> of_part = part.select(points);
        const auto                    values  = [&](const std::string &entry) {
          return (*part.friction)[entry].values(of_part, part.section);
        };
        const std::vector<double> all_a = values(a), all_b = values(b),
                                  all_L = values(L);
        for (unsigned int i = 0; i < of_part.size(); ++i)
          {
            const unsigned int      k = first + part.positions[i];
            const WeakeningFriction friction{
              all_a[i],
              all_b[i],
              simulation.state().normal_stress[k],
              all_L[i]};
            if (!(friction.b > friction.a) || !faults.in_contact(k) ||
                friction.normal_stress == 0.)
              continue;
            weakening.nodes[k]   = true;
            const double weight  = faults.weights()[k],
                         modulus = moduli[part.positions[i]];
            area += weight;
            weakening.critical_stiffness +=
              weight * critical_stiffness(friction);
            weakening.nucleation_length =
              std::min(weakening.nucleation_length,
                       nucleation_length(friction, modulus, dim));
            weakening.process_zone =
              std::min(weakening.process_zone, process_zone(friction, modulus));
          }
      }
    if (weakening.is_there())
      {
        weakening.critical_stiffness /= area;
        weakening.stiffness =
          slip_stiffness(simulation.spatial_problem(), faults, weakening.nodes);
      }
    return weakening;
  }



#define STICKSLIP_INSTANTIATE(dim, n_components)        \
  template Weakening find_weakening<dim, n_components>( \
    const SceneParameters<dim> &,                       \
    Simulation<dim, n_components> &,                    \
    const unsigned int);

  STICKSLIP_INSTANTIATE(2, 1)
  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
} // namespace StickSlip
