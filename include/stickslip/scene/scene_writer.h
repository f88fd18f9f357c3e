// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_scene_writer_h
#define stickslip_scene_scene_writer_h

#include <stickslip/parameters/declared_entries.h>
#include <stickslip/scene/scene_parameters.h>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Write a parameter file with every entry of a scene and its documentation.
   * Reading it gives the same scene again. Throws InputError if the file cannot
   * be written.
   */
  template <int dim>
  void
  write_parameters(const SceneParameters<dim> &scene,
                   const std::string          &file_name);

  /** Write the parameter file to a stream. */
  template <int dim>
  void
  write_parameters(const SceneParameters<dim> &scene, std::ostream &out);

  /** Values of entries, as written, by their paths. */
  using SceneEntries = std::map<std::string, std::string>;

  /** All entries of a scene. */
  template <int dim>
  SceneEntries
  entries_of(const SceneParameters<dim> &scene);

  /** All entries that a scene of three dimensions may have, of a body, a fault,
   * a region and sides with placeholders as names. */
  std::vector<DeclaredEntry>
  entries_of_any_scene();

  /**
   * The reference of all entries in Markdown, made from their declarations: a
   * section for each subsection of the parameter file, a row for each entry.
   */
  void
  print_parameter_reference(std::ostream &out);
} // namespace StickSlip

#endif
