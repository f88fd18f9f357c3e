// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_checksum_h
#define stickslip_base_checksum_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace StickSlip
{
  /**
   * The cyclic redundancy check of IEEE 802.3, also of zlib and gzip: that of
   * some bytes behind others, whose checksum is @p before.
   */
  std::uint32_t
  crc32(const void *bytes, const std::size_t n, const std::uint32_t before = 0);

  inline std::uint32_t
  crc32(const std::string &bytes)
  {
    return crc32(bytes.data(), bytes.size());
  }
} // namespace StickSlip

#endif
