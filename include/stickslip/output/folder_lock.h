// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_folder_lock_h
#define stickslip_output_folder_lock_h

#include <string>

namespace StickSlip
{
  /**
   * The right to write to a folder, which one program has at a time. It ends
   * with the object or the program, however that ends, and leaves no file.
   * File systems that know no locks give it to everybody.
   */
  class FolderLock
  {
  public:
    /** Throws InputError if another program has it. */
    explicit FolderLock(const std::string &path);

    ~FolderLock();

    FolderLock(const FolderLock &) = delete;

    FolderLock &
    operator=(const FolderLock &) = delete;

  private:
    int folder;
  };
} // namespace StickSlip

#endif
