// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/problem/lumped_mass.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace StickSlip
{
  namespace
  {
    /** The axes of a node, as columns. */
    template <int n_components>
    Tensor<2, n_components>
    axes_of(const LocalFrames &frames, const unsigned int node)
    {
      Tensor<2, n_components> axes;
      const double *const     given = frames.find(node);
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          axes[c][d] = given ? given[c * n_components + d] : (c == d ? 1. : 0.);
      return axes;
    }
  } // namespace



  template <int dim, int n_components>
  LumpedMass<dim, n_components>::LumpedMass(
    const SpatialProblem<dim, n_components> &problem)
    : fixed(problem.operators().unknowns().fixed)
  {
    // Integrals of dual functions may leave weights that are rounding.
    constexpr double least_weight = 1e-12;

    const JumpBasis<dim>                 &basis  = problem.jump_basis();
    const LevelDescription<n_components> &finest = problem.hierarchy().finest();
    const NodePartition                  &nodes  = finest.nodes;

    // Masses of nodes, of slave nodes and what faces them also as ghosts.
    NodalVector nodal_mass = problem.make_vector(), faced_mass = nodal_mass;
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      nodal_mass.local_element(i * n_components) = problem.nodal_masses()[i];
    update_ghosts(nodal_mass);
    const auto mass_of = [&](const unsigned int node) {
      return nodal_mass.local_element(node * n_components);
    };

    /** A slave node with something that this process owns. */
    struct Slave
    {
      unsigned int                                 node;
      double                                       factor;
      std::vector<std::pair<unsigned int, double>> row;
    };
    std::vector<Slave> slaves;
    for (const types::global_dof_index p : basis.contact_nodes())
      {
        const GlobalRow row = basis.to_nodal(p);
        const bool      is_here =
          std::any_of(row.begin(), row.end(), [&](const auto &entry) {
            return nodes.owned().is_element(entry.first) &&
                   (entry.first == p || std::abs(entry.second) > least_weight);
          });
        if (!is_here)
          continue;
        Slave slave;
        slave.node = nodes.local_index(p);
        for (const auto &[q, weight] : row)
          if (q == p)
            slave.factor = 1. / weight;
          else if (std::abs(weight) > least_weight && nodes.is_local(q))
            slave.row.emplace_back(nodes.local_index(q), weight);
        slaves.push_back(std::move(slave));
      }

    // Masses that slave nodes add to the nodes that they face.
    for (const Slave &slave : slaves)
      for (const auto &[q, weight] : slave.row)
        if (q < nodes.n_owned())
          faced_mass.local_element(q * n_components) +=
            weight * mass_of(slave.node);
    update_ghosts(faced_mass);

    masses.resize(nodes.n_owned() * n_components);
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        masses[i * n_components + c] =
          mass_of(i) + faced_mass.local_element(i * n_components);
    for (const unsigned int p : basis.owned_contact_nodes(nodes))
      std::fill_n(masses.begin() + p * n_components, n_components, 0.);
    inverse_masses.resize(masses.size());
    for (unsigned int i = 0; i < nodes.n_owned(); ++i)
      for (unsigned int c = 0; c < n_components; ++c)
        if (const double mass = masses[i * n_components + c];
            mass != 0. && fixed.is_active(i, c))
          inverse_masses[i * n_components + c] = 1. / mass;

    std::map<unsigned int, std::vector<Partner>> slaves_of;
    for (const Slave &slave : slaves)
      {
        const unsigned int            p = slave.node;
        const double                  m = mass_of(p), f = slave.factor;
        const Tensor<2, n_components> axes =
          axes_of<n_components>(finest.frames, p);
        // The matrix that couples jumps: sum of the row, and its diagonal.
        Tensor<1, n_components> row_sum, diagonal;
        for (unsigned int c = 0; c < n_components; ++c)
          row_sum[c] = diagonal[c] = m / (f * f);
        const bool is_owned = p < nodes.n_owned();
        if (is_owned)
          {
            of_slaves.nodes.push_back(p);
            of_slaves.first.push_back(of_slaves.partners.size());
          }
        for (const auto &[q, weight] : slave.row)
          {
            const Tensor<2, n_components> between =
              transpose(axes) * axes_of<n_components>(finest.frames, q);
            const Tensor<2, n_components> coupling = m * weight / f * between;
            if (q < nodes.n_owned())
              slaves_of[q].push_back({p, coupling});
            if (!is_owned)
              continue;
            of_slaves.partners.push_back({q, coupling});
            const double faced = faced_mass.local_element(q * n_components),
                         all   = mass_of(q) + faced;
            if (all == 0.)
              continue;
            for (unsigned int c = 0; c < n_components; ++c)
              {
                double free = 0.;
                for (unsigned int d = 0; d < n_components; ++d)
                  if (fixed.is_active(q, d))
                    free += between[c][d] * between[c][d];
                row_sum[c] -= m / (f * f) * weight * faced / all * free;
                diagonal[c] -= std::pow(m * weight / f, 2) / all * free;
              }
          }
        if (!is_owned)
          continue;
        // Weights of nodes that face little may be negative, and so may the
        // sums; the diagonal is not.
        for (unsigned int c = 0; c < n_components; ++c)
          if (row_sum[c] < 0.1 * diagonal[c])
            row_sum[c] = diagonal[c];
        relative_masses.push_back(row_sum);
      }
    of_slaves.first.push_back(of_slaves.partners.size());
    for (const auto &[q, partners] : slaves_of)
      {
        of_faced.nodes.push_back(q);
        of_faced.first.push_back(of_faced.partners.size());
        of_faced.partners.insert(of_faced.partners.end(),
                                 partners.begin(),
                                 partners.end());
      }
    of_faced.first.push_back(of_faced.partners.size());
  }



  template <int dim, int n_components>
  Tensor<1, n_components>
  LumpedMass<dim, n_components>::values_at(const NodalVector &w,
                                           const unsigned int node)
  {
    Tensor<1, n_components> values;
    for (unsigned int c = 0; c < n_components; ++c)
      values[c] = w.local_element(node * n_components + c);
    return values;
  }



  template <int dim, int n_components>
  Tensor<1, n_components>
  LumpedMass<dim, n_components>::jump_momentum(const unsigned int k,
                                               const NodalVector &w) const
  {
    Tensor<1, n_components> sum;
    for (unsigned int i = of_faced.first[k]; i < of_faced.first[k + 1]; ++i)
      sum += transpose(of_faced.partners[i].coupling) *
             values_at(w, of_faced.partners[i].node);
    return sum;
  }



  template <int dim, int n_components>
  void
  LumpedMass<dim, n_components>::vmult(NodalVector       &p,
                                       const NodalVector &w) const
  {
    update_ghosts(w);
    for (unsigned int i = 0; i < masses.size(); ++i)
      p.local_element(i) = masses[i] * w.local_element(i);
    NodalVector mean = w;
    for (unsigned int k = 0; k < of_faced.nodes.size(); ++k)
      {
        const Tensor<1, n_components> of_jumps = jump_momentum(k, w);
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int i = of_faced.nodes[k] * n_components + c;
            p.local_element(i) += of_jumps[c];
            mean.local_element(i) += inverse_masses[i] * of_jumps[c];
          }
      }
    update_ghosts(mean);
    for (unsigned int k = 0; k < of_slaves.nodes.size(); ++k)
      {
        const unsigned int      node = of_slaves.nodes[k];
        Tensor<1, n_components> sum;
        for (unsigned int i = of_slaves.first[k]; i < of_slaves.first[k + 1];
             ++i)
          sum += of_slaves.partners[i].coupling *
                 values_at(mean, of_slaves.partners[i].node);
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int i = node * n_components + c;
            p.local_element(i) =
              sum[c] + relative_masses[k][c] * w.local_element(i);
          }
      }
  }



  template <int dim, int n_components>
  void
  LumpedMass<dim, n_components>::accelerate_bodies(
    NodalVector       &a,
    const NodalVector &force) const
  {
    double *const       acceleration = a.begin();
    const double *const f            = force.begin();
    for (unsigned int i = 0; i < masses.size(); ++i)
      if (inverse_masses[i] != 0.)
        acceleration[i] = inverse_masses[i] * f[i];
    update_ghosts(a);
  }



  template <int dim, int n_components>
  void
  LumpedMass<dim, n_components>::accelerate_jumps(NodalVector &a) const
  {
    update_ghosts(a);
    for (unsigned int k = 0; k < of_faced.nodes.size(); ++k)
      {
        const Tensor<1, n_components> of_jumps = jump_momentum(k, a);
        for (unsigned int c = 0; c < n_components; ++c)
          {
            const unsigned int i = of_faced.nodes[k] * n_components + c;
            a.local_element(i) -= inverse_masses[i] * of_jumps[c];
          }
      }
  }



  template <int dim, int n_components>
  void
  LumpedMass<dim, n_components>::solve(NodalVector       &a,
                                       const NodalVector &force) const
  {
    a = 0.;
    accelerate_bodies(a, force);
    for (unsigned int k = 0; k < of_slaves.nodes.size(); ++k)
      {
        const unsigned int            node = of_slaves.nodes[k];
        const Tensor<1, n_components> f    = relative_force(k, force, a);
        for (unsigned int c = 0; c < n_components; ++c)
          if (fixed.is_active(node, c))
            a.local_element(node * n_components + c) =
              f[c] / relative_masses[k][c];
      }
    accelerate_jumps(a);
  }



  template <int dim, int n_components>
  Tensor<1, n_components>
  LumpedMass<dim, n_components>::relative_force(const unsigned int i,
                                                const NodalVector &force,
                                                const NodalVector &a) const
  {
    Tensor<1, n_components> result = values_at(force, of_slaves.nodes[i]);
    for (unsigned int k = of_slaves.first[i]; k < of_slaves.first[i + 1]; ++k)
      result -= of_slaves.partners[k].coupling *
                values_at(a, of_slaves.partners[k].node);
    return result;
  }



  template class LumpedMass<2>;
  template class LumpedMass<3>;
  template class LumpedMass<2, 1>;
} // namespace StickSlip
