// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_simulation_stations_h
#define stickslip_simulation_stations_h

#include <stickslip/mesh/mesh_level.h>
#include <stickslip/mortar/jump_basis.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/station_files.h>
#include <stickslip/problem/nodal_functional.h>
#include <stickslip/scene/scene_parameters.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * The stations of a scene in its meshes: fields of faults and bodies are
   * interpolated there with the basis functions of the face or cell.
   */
  template <int dim>
  class Stations
  {
  public:
    /** None. */
    Stations() = default;

    /** Throws InputError if a station is outside of its fault or body. */
    Stations(const SceneParameters<dim> &scene,
             const MeshLevel<dim>       &level,
             const JumpBasis<dim>       &basis);

    /** The headers of their files. */
    const std::vector<StationTable> &
    tables() const
    {
      return headers;
    }

    /** Functionals of displacements and velocities that are their values at
     * the stations in bodies, component by component, one station after the
     * other. */
    const std::vector<NodalFunctional> &
    functionals() const
    {
      return of_bodies;
    }

    /**
     * The values of each station: of a fault slip, m, log10
     * of the slip rate over 1 m/s, shear stress, MPa, normal stress, MPa, where
     * it follows the contact pressure, and log10 of the state over 1 s; of a
     * body displacement, m, and velocity, m/s, which are @p in_bodies the
     * values of functionals().
     */
    std::vector<std::vector<double>>
    values(const std::vector<FaultSnapshot<dim>> &faults,
           const FunctionalValues                &in_bodies) const;

  private:
    /** Of a station on a fault. */
    struct Place
    {
      /** The number of the fault. */
      unsigned int number;

      /** Nodes, as places among those of the fault, and values of their basis
       * functions. */
      std::vector<std::pair<unsigned int, double>> nodes;

      /** True on a fault whose normal stress follows the contact pressure. */
      bool with_normal_stress = false;
    };

    void
    add_on_fault(const Station        &station,
                 const unsigned int    fault,
                 const bool            with_normal_stress,
                 const JumpBasis<dim> &basis);

    void
    add_in_body(const Station        &station,
                const unsigned int    body,
                const MeshLevel<dim> &level);

    std::vector<double>
    fault_values(const Place &place, const FaultSnapshot<dim> &fault) const;

    unsigned int              n_components = dim;
    std::vector<StationTable> headers;
    /** Of the stations on faults, in their order. */
    std::vector<Place>           places;
    std::vector<NodalFunctional> of_bodies;
  };
} // namespace StickSlip

#endif
