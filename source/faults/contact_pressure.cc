// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/faults/contact_pressure.h>

#include <limits>

namespace StickSlip
{
  namespace
  {
    /** The slave node in contact that is nearest to the k-th one. */
    template <int dim>
    unsigned int
    nearest_in_contact(const FaultContact<dim> &contact, const unsigned int k)
    {
      const std::vector<Point<dim>> &points  = contact.slave.points;
      unsigned int                   nearest = k;
      double distance = std::numeric_limits<double>::max();
      for (unsigned int m = 0; m < points.size(); ++m)
        if (contact.coupling.active[m] &&
            points[k].distance(points[m]) < distance)
          {
            nearest  = m;
            distance = points[k].distance(points[m]);
          }
      return nearest;
    }
  } // namespace



  template <int dim>
  std::vector<double>
  contact_pressures(const JumpBasis<dim> &basis,
                    const NodePartition  &nodes,
                    const NodalVector    &reaction)
  {
    std::vector<double> pressures;
    for (const FaultContact<dim> &contact : basis.faults())
      {
        const std::vector<Tensor<1, dim>> forces =
          gather_nodes<dim>(reaction, nodes, contact.slave.nodes);
        // The reaction pushes the slave side along the normal if that is the
        // second one.
        const double sign = contact.sides.sign();
        for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
          {
            const unsigned int m =
              contact.coupling.active[k] ? k : nearest_in_contact(contact, k);
            // The unknown is averaging_factor times the jump of the node, and
            // so is the force on it times the weight.
            pressures.push_back(nodes.n_components() < dim ?
                                  0. :
                                  sign *
                                    contact.axes.normal_part(m, forces[m]) /
                                    contact.coupling.weight[m]);
          }
      }
    return pressures;
  }



#define STICKSLIP_INSTANTIATE(dim)                                            \
  template std::vector<double> contact_pressures<dim>(const JumpBasis<dim> &, \
                                                      const NodePartition &,  \
                                                      const NodalVector &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
