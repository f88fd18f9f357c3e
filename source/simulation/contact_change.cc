// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/contact_change.h>

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace StickSlip
{
  namespace
  {
    /** Rates with a new contact mapping. Sides that touch keep their slip
     * rates, and the slave side moves accordingly; those that are apart keep
     * their velocities, so that nothing changes their energy. */
    template <int dim, int n_components>
    void
    change_rates(NodalVector                           &velocity,
                 std::vector<Tensor<1, dim - 1>>       &slip_rate,
                 std::vector<double>                   &opening_rate,
                 const std::vector<double>             &gap,
                 const ContactSpace<dim, n_components> &space,
                 const FaultNodes<dim>                 &before,
                 const FaultNodes<dim>                 &now)
    {
      NodalVector w = space.make_vector();
      space.to_jumps(w, velocity);
      for (const unsigned int k : now.owned_contact())
        {
          if (!gap.empty() && gap[k] > 0.)
            continue;
          for (unsigned int c = dim - 1; c < n_components; ++c)
            w.local_element(now.node(k) * n_components + c) = 0.;
          if (before.in_contact(k))
            for (unsigned int d = 0; d < dim - 1; ++d)
              w.local_element(now.node(k) * n_components + d) = slip_rate[k][d];
        }
      space.to_nodal(velocity, w);
      slip_rate = now.tangential_jumps(w);
      if (!gap.empty())
        opening_rate = now.opening_jumps(w);
    }



    /** The slave node in contact of the same fault that is nearest to the k-th
     * one, and k itself if there is none. */
    template <int dim>
    unsigned int
    nearest_node(const JumpBasis<dim>  &basis,
                 const FaultNodes<dim> &faults,
                 const unsigned int     k)
    {
      const unsigned int             f       = faults.fault(k);
      const unsigned int             first   = faults.first_of_fault()[f];
      const std::vector<Point<dim>> &points  = basis.faults()[f].slave.points;
      unsigned int                   nearest = k;
      double distance = std::numeric_limits<double>::max();
      for (unsigned int m = 0; m < points.size(); ++m)
        if (faults.in_contact(first + m) &&
            points[m].distance(points[k - first]) < distance)
          {
            nearest  = first + m;
            distance = points[m].distance(points[k - first]);
          }
      return nearest;
    }



    /** Gaps with a new contact mapping; @p distances_before, @p distances_now:
     * distances_of_gaps(). */
    template <int dim>
    void
    change_gaps(SystemState<dim>          &state,
                const JumpBasis<dim>      &basis,
                const FaultNodes<dim>     &before,
                const FaultNodes<dim>     &now,
                const std::vector<double> &distances_before,
                const std::vector<double> &distances_now)
    {
      const std::vector<double> gap = state.gap;
      for (unsigned int k = 0; k < gap.size(); ++k)
        if (now.in_contact(k) && !before.in_contact(k))
          state.gap[k] = gap[nearest_node(basis, before, k)];
        else if (gap[k] > 0. && now.in_contact(k) && !distances_now.empty())
          state.gap[k] =
            std::max(gap[k] + distances_now[k] - distances_before[k],
                     std::numeric_limits<double>::min());
    }



    template <int dim>
    bool
    is_any_bent(const JumpBasis<dim> &basis)
    {
      return std::any_of(basis.faults().begin(),
                         basis.faults().end(),
                         [](const auto &contact) { return contact.is_bent; });
    }
  } // namespace



  template <int dim>
  std::vector<double>
  sliding_distances(const JumpBasis<dim>    &basis,
                    const ContactParameters &parameters)
  {
    double smallest_face = std::numeric_limits<double>::max();
    for (const FaultContact<dim> &contact : basis.faults())
      smallest_face = std::min(smallest_face, contact.smallest_face);
    std::vector<double> distances;
    for (const FaultContact<dim> &contact : basis.faults())
      distances.push_back(parameters.fraction(contact.is_bent) * smallest_face);
    return distances;
  }



  template <int dim>
  bool
  has_slid(const FaultNodes<dim>                 &faults,
           const std::vector<Tensor<1, dim - 1>> &slip,
           const std::vector<Tensor<1, dim - 1>> &since,
           const std::vector<double>             &distances)
  {
    for (unsigned int k = 0; k < since.size(); ++k)
      if ((slip[k] - since[k]).norm() > distances[faults.fault(k)])
        return true;
    return false;
  }



  template <int dim>
  double
  n_intervals(const FaultNodes<dim>                 &faults,
              const std::vector<Tensor<1, dim - 1>> &slip,
              const std::vector<double>             &distances)
  {
    double result = 0;
    for (unsigned int k = 0; k < slip.size(); ++k)
      result = std::max(result, slip[k].norm() / distances[faults.fault(k)]);
    return result;
  }



  template <int dim>
  std::vector<Tensor<1, dim - 1>>
  expected_slip(const FaultNodes<dim>                 &faults,
                const std::vector<Tensor<1, dim - 1>> &slip,
                const std::vector<Tensor<1, dim - 1>> &since,
                const std::vector<double>             &distances)
  {
    std::vector<Tensor<1, dim - 1>> result = slip;
    for (unsigned int k = 0; k < result.size(); ++k)
      result[k] -= since[k];
    if (const double n = n_intervals(faults, result, distances); n > 0.)
      for (Tensor<1, dim - 1> &of_node : result)
        of_node /= n;
    return result;
  }



  template <int dim, int n_components>
  std::vector<Tensor<1, dim - 1>>
  slip_accelerations(const ContactSpace<dim, n_components> &space,
                     const FaultNodes<dim>                 &faults,
                     const SystemState<dim>                &state)
  {
    if (state.acceleration.size() == 0)
      return {};
    NodalVector w = space.make_vector();
    space.to_jumps(w, state.acceleration);
    return faults.tangential_jumps(w);
  }



  template <int dim>
  double
  way_to_end(const JumpBasis<dim>    &basis,
             const MappingPlace<dim> &before,
             const MappingPlace<dim> &now)
  {
    if (is_any_bent(basis))
      return 0.;
    double along = 0., squares = 0.;
    for (unsigned int k = 0; k < now.slip.size(); ++k)
      {
        const Tensor<1, dim - 1> half_way = 0.5 * now.expected_slip[k];
        Tensor<1, dim - 1>       way = now.slip[k] + half_way - before.slip[k];
        if (!before.expected_slip.empty())
          way -= 0.5 * before.expected_slip[k];
        along += half_way * way;
        squares += way * way;
      }
    return squares > 0. ? std::clamp(along / squares, -1., 1.) : 0.;
  }



  template <int dim>
  std::vector<double>
  background_normal_stress(const BackgroundStress<dim> &background,
                           const JumpBasis<dim>        &basis)
  {
    if (!background.is_needed() || !is_any_bent(basis))
      return {};
    std::vector<double> result;
    for (unsigned int f = 0; f < basis.faults().size(); ++f)
      {
        std::vector<double> of_fault = background.normal_stress(basis, f);
        of_fault.resize(basis.faults()[f].slave.nodes.size(), 0.);
        result.insert(result.end(), of_fault.begin(), of_fault.end());
      }
    return result;
  }



  template <int dim, int n_components>
  std::vector<double>
  side_distances(const ContactSpace<dim, n_components> &space,
                 const NodalVector                     &displacement)
  {
    const JumpBasis<dim> &basis = space.jump_basis();
    const MeshLevel<dim> &level = space.meshes().finest();
    std::vector<double>   distances;
    for (unsigned int f = 0; f < basis.faults().size(); ++f)
      {
        const FaultContact<dim> &contact = basis.faults()[f];
        std::unordered_map<types::global_dof_index, Point<dim>> positions;
        for (const unsigned int side : {0, 1})
          {
            const FaultSurface<dim> &surface = level.surface(f, side);
            const auto               u = gather_displacements<dim>(displacement,
                                                     level.nodes,
                                                     surface.nodes);
            for (unsigned int k = 0; k < u.size(); ++k)
              positions[surface.nodes[k]] = surface.points[k] + u[k];
          }
        for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
          {
            distances.push_back(0.);
            if (!contact.coupling.active[k])
              continue;
            // Entries of the row sum to zero.
            const types::global_dof_index node = contact.slave.nodes[k];
            Tensor<1, dim>                jump;
            for (const auto &[partner, factor] : basis.to_jumps(node))
              jump += factor * (positions.at(partner) - positions.at(node));
            distances.back() =
              contact.sides.sign() * (contact.axes.normal(k) * jump);
          }
      }
    return distances;
  }



  template <int dim, int n_components>
  std::vector<double>
  distances_of_gaps(const ContactSpace<dim, n_components> &space,
                    const SystemState<dim>                &state)
  {
    if (!is_any_open(state) || !is_any_bent(space.jump_basis()))
      return {};
    return side_distances(space, state.displacement);
  }



  template <int dim>
  bool
  is_any_open(const SystemState<dim> &state)
  {
    return std::any_of(state.gap.begin(),
                       state.gap.end(),
                       [](const double gap) { return gap > 0.; });
  }



  template <int dim, int n_components>
  void
  change_contact(SystemState<dim>                      &state,
                 const ContactSpace<dim, n_components> &space,
                 const FaultNodes<dim>                 &before,
                 const FaultNodes<dim>                 &now,
                 const std::vector<double>             &distances_before,
                 std::vector<Tensor<1, dim - 1>>        slip_acceleration)
  {
    change_gaps(state,
                space.jump_basis(),
                before,
                now,
                distances_before,
                distances_of_gaps(space, state));
    change_rates(state.velocity,
                 state.slip_rate,
                 state.opening_rate,
                 state.gap,
                 space,
                 before,
                 now);
    if (!slip_acceleration.empty())
      {
        std::vector<double> opening_acceleration;
        change_rates(state.acceleration,
                     slip_acceleration,
                     opening_acceleration,
                     state.gap,
                     space,
                     before,
                     now);
      }
    // Rates of gaps are means over the step where there is one of velocities.
    if (state.mean_velocity.size() > 0)
      change_rates(state.mean_velocity,
                   state.mean_slip_rate,
                   state.opening_rate,
                   state.gap,
                   space,
                   before,
                   now);
    // Forces are those of the state as it is now.
    state.force.reinit(0);
    // Tractions of nodes off contact mean nothing any more.
    for (auto *tractions : {&state.balancing_traction, &state.mean_traction})
      for (unsigned int k = 0; k < tractions->size(); ++k)
        if (!now.in_contact(k))
          (*tractions)[k] = Tensor<1, dim - 1>();
  }



  template decltype(sliding_distances<2>)        sliding_distances<2>;
  template decltype(sliding_distances<3>)        sliding_distances<3>;
  template decltype(has_slid<2>)                 has_slid<2>;
  template decltype(has_slid<3>)                 has_slid<3>;
  template decltype(n_intervals<2>)              n_intervals<2>;
  template decltype(n_intervals<3>)              n_intervals<3>;
  template decltype(expected_slip<2>)            expected_slip<2>;
  template decltype(expected_slip<3>)            expected_slip<3>;
  template decltype(slip_accelerations<2>)       slip_accelerations<2>;
  template decltype(slip_accelerations<3>)       slip_accelerations<3>;
  template decltype(slip_accelerations<2, 1>)    slip_accelerations<2, 1>;
  template decltype(way_to_end<2>)               way_to_end<2>;
  template decltype(way_to_end<3>)               way_to_end<3>;
  template decltype(background_normal_stress<2>) background_normal_stress<2>;
  template decltype(background_normal_stress<3>) background_normal_stress<3>;
  template decltype(side_distances<2>)           side_distances<2>;
  template decltype(side_distances<3>)           side_distances<3>;
  template decltype(side_distances<2, 1>)        side_distances<2, 1>;
  template decltype(distances_of_gaps<2>)        distances_of_gaps<2>;
  template decltype(distances_of_gaps<3>)        distances_of_gaps<3>;
  template decltype(distances_of_gaps<2, 1>)     distances_of_gaps<2, 1>;
  template decltype(is_any_open<2>)              is_any_open<2>;
  template decltype(is_any_open<3>)              is_any_open<3>;
  template decltype(change_contact<2>)           change_contact<2>;
  template decltype(change_contact<3>)           change_contact<3>;
  template decltype(change_contact<2, 1>)        change_contact<2, 1>;
} // namespace StickSlip
