// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_slave_weights_h
#define stickslip_mortar_slave_weights_h

#include <deal.II/base/point.h>

#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mortar/dual_basis.h>

#include <vector>

namespace StickSlip
{
  /** Slave nodes of a surface, by their places. */
  struct SlaveRange
  {
    unsigned int begin = 0, end = numbers::invalid_unsigned_int;

    bool
    contains(const unsigned int node) const
    {
      return node >= begin && node < end;
    }
  };

  /**
   * A slave node is active if the integral of its shape function over the
   * covered part of the slave surface is at least this fraction of that over
   * all of it. At the end of a fault in two dimensions this means that half of
   * the last face is covered. The value at a node is an extrapolation from the
   * covered part, and the sum of |N_pq| grows with the distance: it is up to
   * 5/3 inside and up to 4.6 at the ends of a fault in two dimensions, where a
   * fraction of 0.05 would allow 12.
   */
  constexpr double active_weight_fraction = 0.25;

  /** The mass matrix of the covered part of each slave face, m^(dim-1). */
  template <int dim>
  using FaceMasses = std::vector<typename DualBasis<dim>::Matrix>;

  /** The dual basis of each face. */
  template <int dim>
  std::vector<DualBasis<dim>>
  dual_bases(const FaultSurface<dim> &slave, const FaceMasses<dim> &masses);

  /** The integrals of the shape functions of each slave node over all of its
   * faces and over what of them is covered and has a dual basis, m^(dim-1). */
  struct SlaveWeights
  {
    std::vector<double> full, covered;

    bool
    is_active(const unsigned int p) const
    {
      return covered[p] > 0. && covered[p] >= active_weight_fraction * full[p];
    }
  };

  template <int dim>
  SlaveWeights
  slave_weights(const FaultSurface<dim>           &slave,
                const std::vector<Point<dim>>     &positions,
                const FaceMasses<dim>             &masses,
                const std::vector<DualBasis<dim>> &bases);

  /** A surface of all nodes with the faces of those in a range and of those
   * that share a face with them: what the weights of all of these follow
   * from. */
  template <int dim>
  FaultSurface<dim>
  faces_around(const FaultSurface<dim> &surface, const SlaveRange &range);
} // namespace StickSlip

#endif
