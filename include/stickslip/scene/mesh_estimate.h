// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_mesh_estimate_h
#define stickslip_scene_mesh_estimate_h

#include <stickslip/scene/scene_parameters.h>

#include <vector>

namespace StickSlip
{
  /**
   * Sizes of the meshes of a scene, counted without making them. They
   * are exact for bodies that are refined everywhere, and right to some ten per
   * cent for others.
   *
   * A pass takes the cells at a fault, T of them at F faces, and leaves 2^d of
   * each, of which 2^(d-1) are at the fault again, which adds (2^d - 1) T
   * cells. It adds 4 nodes a quadrilateral and 10 a hexahedron, hanging ones
   * included.
   */
  struct MeshEstimate
  {
    /** Of all bodies that deform, on the finest level. */
    double cells = 0., nodes = 0.;

    /** Nodes of the meshes that each of several processes makes as a whole,
     * see BodyMesh::can_have_units(): the finest, or those that are divided. */
    double whole_nodes = 0.;

    /** Without those on which only some bodies are coarsened. */
    unsigned int levels = 1;

    /** Greatest length of a cell over its second one, and the body of it;
     * nothing is said of triangles and tetrahedra. */
    double       aspect_ratio   = 1.;
    unsigned int stretched_body = 0;

    struct OfFault
    {
      /** Length, m, or area, m^2, of the side with the smaller faces. */
      double size = 0.;

      /** Number of the faces of that side, and the length of the largest edge
       * and that of the smallest, m, among those that most passes refine. */
      double faces = 0., largest_edge = 0., smallest_edge = 0.;

      /** True if passes refine a part of it only. */
      bool is_refined_in_part = false;
    };

    std::vector<OfFault> faults;

    /** Number of all displacements of so many components. */
    double
    unknowns(const unsigned int n_components) const
    {
      return nodes * n_components;
    }

    /**
     * Memory of all @p n_processes processes on one machine, bytes: what was
     * measured in doc/performance.md and doc/parallel.md, 175 MiB for the
     * program, and for each node 0.7 kB of meshes in two dimensions and 1.1 kB
     * in three, on each of several processes for whole_nodes, and 2.8 kB or 9
     * kB of matrices and vectors.
     */
    double
    memory(const unsigned int dim, const unsigned int n_processes) const;
  };

  /**
   * Count the cells of a scene. Bricks are not made for that, unless there are
   * fewer than a million.
   */
  template <int dim>
  MeshEstimate
  estimate_meshes(const SceneParameters<dim> &scene);

  /**
   * Throw InputError if the meshes need more than the memory of this machine,
   * bytes.
   */
  template <int dim>
  void
  refuse_too_large_meshes(const SceneParameters<dim> &scene,
                          const unsigned int          n_processes,
                          const double                available_memory);

  /** Throw InputError if meshes as these do. */
  void
  refuse_too_large(const MeshEstimate &estimate,
                   const unsigned int  dim,
                   const unsigned int  n_processes,
                   const double        available_memory);

  /** A number of things in three digits: "1,230,000", "1.2e12". */
  std::string
  rounded_count(const double n);
} // namespace StickSlip

#endif
