// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/checksum.h>

#include <array>

namespace StickSlip
{
  namespace
  {
    /** The generating polynomial, the lowest power in the highest bit. */
    constexpr std::uint32_t polynomial = 0xEDB88320;



    /** The remainder of each byte. */
    std::array<std::uint32_t, 256>
    make_remainders()
    {
      std::array<std::uint32_t, 256> remainders;
      for (std::uint32_t byte = 0; byte < 256; ++byte)
        {
          std::uint32_t rest = byte;
          for (unsigned int bit = 0; bit < 8; ++bit)
            rest = (rest >> 1) ^ ((rest & 1) != 0 ? polynomial : 0);
          remainders[byte] = rest;
        }
      return remainders;
    }
  } // namespace



  std::uint32_t
  crc32(const void *bytes, const std::size_t n, const std::uint32_t before)
  {
    static const std::array<std::uint32_t, 256> remainders = make_remainders();
    const auto   *byte = static_cast<const unsigned char *>(bytes);
    std::uint32_t rest = ~before;
    for (std::size_t i = 0; i < n; ++i)
      rest = (rest >> 8) ^ remainders[(rest ^ byte[i]) & 0xFF];
    return ~rest;
  }
} // namespace StickSlip
