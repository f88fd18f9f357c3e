// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_automatic_number_h
#define stickslip_base_automatic_number_h

namespace StickSlip
{
  /**
   * A number that follows from others unless it is given: in parameter files
   * the word `auto`. It is used as a number is.
   */
  class AutomaticNumber
  {
  public:
    /** Follows from others; @p value holds until another one is given or
     * derived. */
    AutomaticNumber(const double value = 0.)
      : number(value)
    {}

    /** Give the number. */
    AutomaticNumber &
    operator=(const double value)
    {
      number       = value;
      is_automatic = false;
      return *this;
    }

    operator double() const
    {
      return number;
    }

    /** Let the number follow from others, which derive() says. */
    void
    make_automatic()
    {
      is_automatic = true;
    }

    /** Say what follows from others; it is used if the number is not given. */
    void
    derive(const double value)
    {
      if (is_automatic)
        number = value;
    }

    bool
    follows() const
    {
      return is_automatic;
    }

    /** Keep the number as if it was given. */
    void
    fix()
    {
      is_automatic = false;
    }

  private:
    double number;
    bool   is_automatic = true;
  };
} // namespace StickSlip

#endif
