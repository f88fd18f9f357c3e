// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_scene_members_of_h
#define stickslip_scene_members_of_h

#include <string>
#include <vector>

namespace StickSlip
{
  /** One member of all bodies, faults or the like, in their order. */
  template <typename Item, typename Member>
  std::vector<Member>
  members_of(const std::vector<Item> &items, Member Item::*const member)
  {
    std::vector<Member> result;
    for (const Item &item : items)
      result.push_back(item.*member);
    return result;
  }

  /** The names of bodies or faults, in their order. */
  template <typename Item>
  std::vector<std::string>
  names_of(const std::vector<Item> &items)
  {
    return members_of(items, &Item::name);
  }
} // namespace StickSlip

#endif
