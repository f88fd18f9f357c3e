// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_field_values.h>

namespace StickSlip
{
  namespace
  {
    template <int n, typename Vector>
    FaultFieldValues
    of_vectors(const std::string         &units,
               const std::string         &description,
               const std::vector<Vector> &vectors)
    {
      FaultFieldValues result = {units, description, n, {}};
      result.values.reserve(vectors.size() * n);
      for (const Vector &vector : vectors)
        for (unsigned int d = 0; d < n; ++d)
          result.values.push_back(vector[d]);
      return result;
    }



    std::vector<double>
    numbers_of(const std::vector<ContactState> &states)
    {
      std::vector<double> result;
      result.reserve(states.size());
      for (const ContactState state : states)
        result.push_back(static_cast<char>(state));
      return result;
    }
  } // namespace



  template <int dim>
  bool
  has_values(const FaultSnapshot<dim> &fault, const FaultField field)
  {
    return fault.may_open() ||
           (field != FaultField::gap && field != FaultField::opening_rate &&
            field != FaultField::contact_state);
  }



  template <int dim>
  FaultFieldValues
  field_values(const FaultSnapshot<dim> &fault, const FaultField field)
  {
    switch (field)
      {
        case FaultField::slip:
          return of_vectors<dim - 1>(
            "m",
            "slip of the second side relative to the first one, in a stack of "
            "the upper body relative to the lower one, tangential components",
            fault.slip);
        case FaultField::slip_rate:
          return of_vectors<dim - 1>("m/s",
                                     "rate of the slip, tangential components",
                                     fault.slip_rate);
        case FaultField::shear_traction:
          return of_vectors<dim - 1>(
            "Pa",
            "traction that resists the slip, with the sign of the slip rate",
            fault.shear_traction);
        case FaultField::normal_stress:
          return {"Pa",
                  "normal stress that friction feels, compression positive",
                  1,
                  fault.normal_stress};
        case FaultField::state:
          return {"s", "state theta of the friction law", 1, fault.state};
        case FaultField::contact_pressure:
          return {"Pa",
                  "force that keeps the sides together over the area, "
                  "compression positive",
                  1,
                  fault.contact_pressure};
        case FaultField::contact_weight:
          return {dim == 2 ? "m" : "m^2",
                  "share of each node in the area of contact; 0: not in "
                  "contact",
                  1,
                  fault.weights};
        case FaultField::gap:
          return {"m",
                  "gap between the sides, exactly 0 where they touch",
                  1,
                  fault.gap};
        case FaultField::opening_rate:
          return {"m/s", "rate of the gap", 1, fault.opening_rate};
        case FaultField::contact_state:
          return {"1",
                  "3: bonded, 2: stuck, 1: slipping, 0: open or off contact",
                  1,
                  numbers_of(fault.contact_state)};
        case FaultField::position:
          return of_vectors<dim>("m",
                                 "positions of the nodes, which move with the "
                                 "bodies",
                                 fault.positions);
      }
    AssertThrow(false, ExcInternalError());
    return {};
  }



  template decltype(has_values<2>)   has_values<2>;
  template decltype(has_values<3>)   has_values<3>;
  template decltype(field_values<2>) field_values<2>;
  template decltype(field_values<3>) field_values<3>;
} // namespace StickSlip
