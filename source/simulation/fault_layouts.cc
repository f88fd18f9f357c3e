// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/simulation/fault_layouts.h>

namespace StickSlip
{
  template <int dim>
  std::vector<FaultLayout<dim>>
  make_fault_layouts(const JumpBasis<dim> &basis)
  {
    std::vector<FaultLayout<dim>> shapes;
    for (const FaultContact<dim> &fault : basis.faults())
      {
        FaultLayout<dim> shape;
        shape.surface = fault.slave;
        for (unsigned int k = 0; k < fault.slave.nodes.size(); ++k)
          {
            Tensor<2, dim>       axes   = fault.axes.at(k);
            const Tensor<1, dim> normal = fault.axes.normal(k);
            for (unsigned int d = 0; d < dim; ++d)
              axes[d][dim - 1] = normal[d];
            shape.axes.push_back(axes);
          }
        shapes.push_back(shape);
      }
    return shapes;
  }



  template <int dim>
  std::vector<std::vector<Point<dim>>>
  fault_positions(const JumpBasis<dim> &basis,
                  const NodePartition  &nodes,
                  const NodalVector    &displacement)
  {
    std::vector<std::vector<Point<dim>>> result;
    for (const FaultContact<dim> &fault : basis.faults())
      {
        result.push_back(fault.slave.points);
        const auto moved =
          gather_displacements<dim>(displacement, nodes, fault.slave.nodes);
        for (unsigned int k = 0; k < moved.size(); ++k)
          result.back()[k] += moved[k];
      }
    return result;
  }



  template decltype(make_fault_layouts<2>) make_fault_layouts<2>;
  template decltype(make_fault_layouts<3>) make_fault_layouts<3>;
  template decltype(fault_positions<2>)    fault_positions<2>;
  template decltype(fault_positions<3>)    fault_positions<3>;
} // namespace StickSlip
