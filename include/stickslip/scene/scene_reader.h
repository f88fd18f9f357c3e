// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_reader_h
#define stickslip_scene_scene_reader_h

#include <stickslip/parameters/parameter_file.h>
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

    /** The files read: parameter files, and those that are named in them as far
     * as they are there. */
    std::vector<std::string>
    input_files() const;

    /** Sentences on bodies, faults, regions and sides that are listed, but have
     * no subsection, so that all of theirs is as by default. */
    std::vector<std::string>
    warnings() const;

    /** The message of an error that begins with the path of an entry in quotes,
     * with what the scene says there, and file and line. Other messages, and
     * those that have them, are returned as they are. */
    std::string
    with_origin(const std::string &message) const;

  private:
    /** The last assignment to an entry; nullptr if there is none. */
    const Assignment *
    find(const std::string &path) const;

    /** As with_origin(), where the entry at the beginning is not set: the first
     * other one of its section that is named with its value. */
    std::string
    with_origin_of_other(const std::string &message,
                         const std::string &path) const;

    /** The last assignment to an entry, or to that of the fault which an entry
     * of a region takes its value from; nullptr if there is none. */
    const Assignment *
    find_or_inherited(const std::string &path) const;

    std::vector<std::string>
    names(const std::string &path, const unsigned int words_per_name) const;

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

    /** The names of mesh files in an entry with absolute paths: files are next
     * to the parameter file, wherever the program runs. Empty if it is not
     * set. */
    std::string
    with_paths(const std::string &path) const;

    /** The value of an entry that is read before all are declared; empty if
     * it is not set. */
    std::string
    value_of(const std::string &path) const;

    template <int dim>
    BoundaryCondition<dim>
    named_side(const std::string          &name,
               const SceneParameters<dim> &scene) const;

    std::string                  file_name;
    std::vector<Assignment>      assignments;
    std::vector<EmptySubsection> empty_subsections;
  };
} // namespace StickSlip

#endif
