// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_entry_assignment_h
#define stickslip_scene_entry_assignment_h

#include <deal.II/base/parameter_handler.h>

#include <stickslip/parameters/declared_entries.h>
#include <stickslip/parameters/parameter_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /** An assignment in words, for messages: entry, value and origin. */
  std::string
  naming(const Assignment &assignment);

  /** An entry and a value of it, for messages. */
  std::string
  naming(const std::string &path, const std::string &value);
  std::string
  naming(const std::string &path, const double value);

  /** The path of the entry that makes bodies periodic along an axis. */
  std::string
  periodic_entry(const unsigned int axis);

  /** The entry to which a value is assigned; the end if there is none. */
  std::vector<DeclaredEntry>::const_iterator
  find_declared(const std::vector<DeclaredEntry> &entries,
                const Assignment                 &assignment);

  /**
   * Throw InputError that says that an entry, or a subsection that it is in, is
   * not among the @p entries, and what there is in its place.
   */
  [[noreturn]] void
  refuse_entry(const Assignment                 &assignment,
               const std::vector<DeclaredEntry> &entries);

  /**
   * Set one of the declared @p entries of @p prm. Throws InputError if there
   * is no such entry, with those that are there, or if it cannot have this
   * value, with what it must be.
   */
  void
  apply(ParameterHandler                 &prm,
        const std::vector<DeclaredEntry> &entries,
        const Assignment                 &assignment);
} // namespace StickSlip

#endif
