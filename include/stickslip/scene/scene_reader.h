// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_reader_h
#define stickslip_scene_scene_reader_h

#include <stickslip/scene/scene_assignments.h>
#include <stickslip/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Reads a scene from a parameter file and overrides of the form
   * `Section/Subsection/Entry=value`, which act after the file.
   *
   * The names of bodies, faults and sides are read first, since they decide
   * which entries there are; everything is then declared and set. All
   * functions throw InputError with one sentence on the first mistake, and
   * nothing is written anywhere.
   */
  class SceneReader
  {
  public:
    SceneReader(const std::string              &file_name,
                const std::vector<std::string> &overrides = {});

    /**
     * Dimension of the scene, 2 or 3.
     */
    unsigned int
    dimension() const;

    /**
     * The checked scene. @p dim must equal dimension(). An empty output
     * directory has become one below output with the name of the parameter
     * file.
     */
    template <int dim>
    SceneParameters<dim>
    read() const;

    /** Sentences on bodies, faults, regions and sides that are listed, but have
     * no subsection, so that all of theirs is as by default. */
    std::vector<std::string>
    warnings() const;

    /** All that the scene says, as text. */
    const SceneAssignments &
    assignments() const
    {
      return given;
    }

  private:
    template <int dim>
    SceneParameters<dim>
    named_scene() const;

    /** The scene, with errors that may not name file and line. */
    template <int dim>
    SceneParameters<dim>
    checked_scene() const;

    /** The sides in the entry 'Between' of a fault. */
    std::array<std::vector<MeshFault::Side>, 2>
    parsed_between(const FaultParameters &fault) const;

    bool
    has_gap_from_mesh(const FaultParameters &fault) const;

    /** Read the mesh files of a scene whose bodies and faults are named. */
    template <int dim>
    void
    read_mesh(SceneParameters<dim> &scene) const;

    /** Read the cells that are refined, if there is a file of them. */
    void
    read_refinement(MeshAccuracy &accuracy) const;

    /** Make the blocks of a scene whose bodies and faults are named. */
    template <int dim>
    void
    read_blocks(SceneParameters<dim> &scene) const;

    template <int dim>
    BoundaryCondition<dim>
    named_side(const std::string          &name,
               const SceneParameters<dim> &scene) const;

    SceneAssignments given;
  };
} // namespace StickSlip

#endif
