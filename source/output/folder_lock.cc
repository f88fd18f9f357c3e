// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <fcntl.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/folder_lock.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace StickSlip
{
  FolderLock::FolderLock(const std::string &path)
    : folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
  {
    if (folder < 0 || flock(folder, LOCK_EX | LOCK_NB) == 0 ||
        errno != EWOULDBLOCK)
      return;
    close(folder);
    throw InputError("'Output/Output directory' = '" + path +
                     "': another run is writing there.");
  }



  FolderLock::~FolderLock()
  {
    if (folder >= 0)
      close(folder);
  }
} // namespace StickSlip
