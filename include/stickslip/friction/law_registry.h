// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_friction_law_registry_h
#define stickslip_friction_law_registry_h

#include <stickslip/friction/friction_law.h>
#include <stickslip/friction/law_parameter.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * A kind of friction, as the entry 'Friction' of a parameter file names it.
   */
  struct LawKind
  {
    /** The word of the entry. */
    std::string name;

    /** Formula of what resists the slip, for the documentation of the entry. */
    std::string formula;

    /** All parameters that the law reads. */
    std::vector<LawParameter> parameters;

    /** True if the law depends on a state, which then has a law of its own. */
    bool has_state = false;

    /** True if the traction grows with the normal stress; false without
     * friction. */
    bool needs_normal_stress = true;

    /** The law of a node; empty where the slip rate is known, so that no
     * friction acts. */
    std::function<std::shared_ptr<const FrictionLaw>(const LawValues &)>
      make_law = {};
  };



  /**
   * All kinds of friction that a scene may name, in the order in which they are
   * documented.
   */
  class LawRegistry
  {
  public:
    /**
     * Throws std::logic_error saying what is wrong where
     *
     * - two kinds have one name, or one has no name or formula;
     * - a parameter has no name, documentation or unit, or a default value that
     *   is not allowed; or two with the same entry differ;
     * - a law reads a parameter that its kind does not list, or does not read
     *   one that it lists;
     * - a law depends on the state and its kind says that it does not, or the
     *   other way round.
     */
    explicit LawRegistry(const std::vector<LawKind> &kinds);

    /** The kinds, each with all parameters that tell nodes apart: those that it
     * lists, the characteristic slip if it has friction, and the state law if
     * it has a state. */
    const std::vector<LawKind> &
    kinds() const
    {
      return known_kinds;
    }

    /** The kind of a name that is there. */
    const LawKind &
    kind(const std::string &name) const;

    /** The parameters of all kinds, each of them once. */
    const std::vector<LawParameter> &
    parameters() const
    {
      return known_parameters;
    }

  private:
    void
    add(const LawParameter &parameter, const std::string &kind);

    std::vector<LawKind>      known_kinds;
    std::vector<LawParameter> known_parameters;
  };



  /**
   * A law as a kind of friction. The class of the law says its LawKind, but for
   * make_law, in a static function kind(), and is made from LawValues.
   */
  template <typename Law>
  LawKind
  kind_of_law()
  {
    LawKind kind  = Law::kind();
    kind.make_law = [](const LawValues &values) {
      return std::make_shared<const Law>(values);
    };
    return kind;
  }



  /**
   * The kinds of friction of this program: the list of them is in
   * law_registry.cc. They are checked at the first call.
   */
  const LawRegistry &
  law_registry();
} // namespace StickSlip

#endif
