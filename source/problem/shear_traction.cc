// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/magnitude.h>
#include <stickslip/problem/shear_traction.h>

namespace StickSlip
{
  namespace
  {
    /** True if the forces on a node with this slip rate tell its shear
     * traction, and the law does not. */
    template <int dim>
    bool
    is_balancing(const FaultNodes<dim>    &faults,
                 const NodeLaws           &laws,
                 const SystemState<dim>   &state,
                 const Tensor<1, dim - 1> &slip_rate,
                 const unsigned int        k)
    {
      const bool is_held = state.normal_stress[k] > 0. ||
                           (!state.is_bonded.empty() && state.is_bonded[k]);
      return faults.in_contact(k) &&
             (laws[k].is_prescribed ||
              (is_held && magnitude(slip_rate) < least_slip_rate));
    }



    /** The friction coefficient of the law, times the direction of slip. */
    template <int dim>
    Tensor<1, dim - 1>
    directed_friction_of_law(const NodeLaws           &laws,
                             const SystemState<dim>   &state,
                             const Tensor<1, dim - 1> &slip_rate,
                             const unsigned int        k)
    {
      const double V = magnitude(slip_rate);
      if (V == 0.)
        return Tensor<1, dim - 1>();
      const FrictionLaw &law = *laws[k].friction;
      return law.coefficient(V, law.node_data(state.alpha[k])) / V * slip_rate;
    }



    /** shear_traction() at a slip rate. */
    template <int dim>
    Tensor<1, dim - 1>
    traction_at(const FaultNodes<dim>    &faults,
                const NodeLaws           &laws,
                const SystemState<dim>   &state,
                const Tensor<1, dim - 1> &slip_rate,
                const unsigned int        k)
    {
      if (!faults.in_contact(k))
        return Tensor<1, dim - 1>();
      if (is_balancing(faults, laws, state, slip_rate, k))
        return state.balancing_traction.empty() ? Tensor<1, dim - 1>() :
                                                  state.balancing_traction[k];
      return state.normal_stress[k] *
             directed_friction_of_law(laws, state, slip_rate, k);
    }
  } // namespace



  template <int dim>
  Tensor<1, dim - 1>
  directed_friction(const FaultNodes<dim>  &faults,
                    const NodeLaws         &laws,
                    const SystemState<dim> &state,
                    const unsigned int      k)
  {
    const Tensor<1, dim - 1> &slip_rate = state.slip_rate[k];
    if (is_balancing(faults, laws, state, slip_rate, k))
      return state.balancing_traction.empty() || state.normal_stress[k] == 0. ?
               Tensor<1, dim - 1>() :
               state.balancing_traction[k] / state.normal_stress[k];
    return directed_friction_of_law(laws, state, slip_rate, k);
  }



  template <int dim>
  Tensor<1, dim - 1>
  shear_traction(const FaultNodes<dim>  &faults,
                 const NodeLaws         &laws,
                 const SystemState<dim> &state,
                 const unsigned int      k)
  {
    return traction_at(faults, laws, state, state.slip_rate[k], k);
  }



  template <int dim>
  Tensor<1, dim - 1>
  written_traction(const FaultNodes<dim>  &faults,
                   const NodeLaws         &laws,
                   const SystemState<dim> &state,
                   const unsigned int      k)
  {
    return state.mean_traction.empty() ?
             shear_traction(faults, laws, state, k) :
             state.mean_traction[k];
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  shear_tractions(const FaultNodes<dim>                 &faults,
                  const NodeLaws                        &laws,
                  const SystemState<dim>                &state,
                  const std::vector<Tensor<1, dim - 1>> &slip_rate)
  {
    std::vector<Tensor<1, dim - 1>> result(faults.size());
    for (unsigned int k = 0; k < faults.size(); ++k)
      result[k] = traction_at(faults, laws, state, slip_rate[k], k);
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  shear_tractions(const FaultNodes<dim>  &faults,
                  const NodeLaws         &laws,
                  const SystemState<dim> &state)
  {
    return shear_tractions(faults, laws, state, state.slip_rate);
  }



  namespace
  {
    /** Answers are the same on all processes, which have all nodes. */
    template <int dim>
    bool
    is_any_balancing(const FaultNodes<dim>  &faults,
                     const NodeLaws         &laws,
                     const SystemState<dim> &state)
    {
      for (unsigned int k = 0; k < faults.size(); ++k)
        if (is_balancing(faults, laws, state, state.slip_rate[k], k))
          return true;
      return false;
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  balancing_tractions(const FaultNodes<dim>                 &faults,
                      const NodeLaws                        &laws,
                      const SystemState<dim>                &state,
                      const std::vector<Tensor<1, dim - 1>> &forces)
  {
    if (!is_any_balancing(faults, laws, state))
      return {};
    std::vector<Tensor<1, dim - 1>> result = forces;
    for (unsigned int k = 0; k < faults.size(); ++k)
      result[k] = is_balancing(faults, laws, state, state.slip_rate[k], k) ?
                    result[k] / faults.weights()[k] :
                    Tensor<1, dim - 1>();
    return result;
  }



  template <int dim, int n_components>
  std::vector<Tensor<1, dim - 1>>
  balancing_tractions(const FaultNodes<dim>           &faults,
                      const NodeLaws                  &laws,
                      const SystemState<dim>          &state,
                      const BlockMatrix<n_components> &A,
                      const NodalVector               &b,
                      const NodalVector               &w)
  {
    if (!is_any_balancing(faults, laws, state))
      return {};
    NodalVector forces = b;
    A.residual(forces, b, w);
    return balancing_tractions(faults,
                               laws,
                               state,
                               faults.tangential_jumps(forces));
  }



  template decltype(directed_friction<2>) directed_friction<2>;
  template decltype(directed_friction<3>) directed_friction<3>;
  template decltype(shear_traction<2>)    shear_traction<2>;
  template decltype(shear_traction<3>)    shear_traction<3>;
  template decltype(written_traction<2>)  written_traction<2>;
  template decltype(written_traction<3>)  written_traction<3>;

#define STICKSLIP_INSTANTIATE(dim)                                        \
  template std::vector<Tensor<1, dim - 1>> shear_tractions(               \
    const FaultNodes<dim> &, const NodeLaws &, const SystemState<dim> &); \
  template std::vector<Tensor<1, dim - 1>> shear_tractions(               \
    const FaultNodes<dim> &,                                              \
    const NodeLaws &,                                                     \
    const SystemState<dim> &,                                             \
    const std::vector<Tensor<1, dim - 1>> &);                             \
  template std::vector<Tensor<1, dim - 1>> balancing_tractions(           \
    const FaultNodes<dim> &,                                              \
    const NodeLaws &,                                                     \
    const SystemState<dim> &,                                             \
    const std::vector<Tensor<1, dim - 1>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
#undef STICKSLIP_INSTANTIATE

#define STICKSLIP_INSTANTIATE(dim, n_components)                \
  template std::vector<Tensor<1, dim - 1>> balancing_tractions( \
    const FaultNodes<dim> &,                                    \
    const NodeLaws &,                                           \
    const SystemState<dim> &,                                   \
    const BlockMatrix<n_components> &,                          \
    const NodalVector &,                                        \
    const NodalVector &);

  STICKSLIP_INSTANTIATE(2, 2)
  STICKSLIP_INSTANTIATE(3, 3)
  STICKSLIP_INSTANTIATE(2, 1)
} // namespace StickSlip
