// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_fault_axes_h
#define stickslip_mortar_fault_axes_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <stickslip/mesh/mesh_hierarchy.h>
#include <stickslip/mortar/fault_sides.h>

#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The axes at the slave nodes of a fault: the normal from its first side to
   * the second one, and the tangential axes along which slip and tangential
   * tractions have their components. Vectors of the jump basis have the
   * tangential components of a slave node first and the normal one last.
   *
   * In two dimensions the tangent is t = (n_y, -n_x), which is right of the
   * normal. In three dimensions a reference axis of the fault, projected onto
   * the plane normal to n, is the first, and n x t_1 the second tangent.
   *
   * A level fault whose reference is the x axis keeps the axes of space,
   * whichever side is above: its normal may point against the last one. One set
   * of axes is stored for a fault that is plane, none for one that is level.
   */
  template <int dim>
  class FaultAxes
  {
  public:
    /** Normal component of a slave node in vectors of the jump basis. */
    static constexpr unsigned int normal_component = dim - 1;

    /** The reference axis must be at least so far from the normal, degrees. */
    static constexpr double least_angle = 15.;

    FaultAxes() = default;

    /** The axes for unit @p normals at all slave nodes, or a single one for
     * all. Throws InputError if the @p reference axis is nearer to a normal
     * than least_angle. */
    explicit FaultAxes(const std::vector<Tensor<1, dim>> &normals,
                       const Tensor<1, dim> &reference = first_axis());

    /** True if components are along the axes of space. */
    bool
    are_those_of_space() const
    {
      return axes.empty();
    }

    /** The unit normal at the k-th slave node. */
    const Tensor<1, dim> &
    normal(const unsigned int k) const
    {
      return normals.size() == 1 ? normals[0] : normals[k];
    }

    /** The axes at the k-th slave node as columns: the tangential ones, then
     * the normal one, but for level faults the axes of space. */
    Tensor<2, dim>
    at(const unsigned int k) const;

    /** The normal component, along normal(), of a vector whose components are
     * along the axes of the k-th slave node. */
    double
    normal_part(const unsigned int k, const Tensor<1, dim> &components) const
    {
      return are_those_of_space() ? normal(k) * components :
                                    components[normal_component];
    }

    /** The axis that is projected onto the fault for the first tangent. */
    const Tensor<1, dim> &
    reference_axis() const
    {
      return reference;
    }

    /** The axes at nodes that are at the @p places of some of these. */
    FaultAxes
    at_places(const std::vector<unsigned int> &places) const;

    /** The x axis. */
    static Tensor<1, dim>
    first_axis();

  private:
    Tensor<1, dim> reference = first_axis();

    /** One entry for all nodes where these agree. */
    std::vector<Tensor<1, dim>> normals;
    std::vector<Tensor<2, dim>> axes;
  };

  /**
   * The axes of all faults of the finest level, from the reference positions of
   * the nodes; @p sides: one entry a fault. In three dimensions the reference
   * axis is Fault::strike, or else the x axis, or, if that is nearer to any
   * normal than FaultAxes::least_angle, the horizontal direction in the mean
   * plane of the fault towards positive y. Throws InputError with the name of
   * the fault.
   */
  template <int dim>
  std::vector<FaultAxes<dim>>
  make_fault_axes(const MeshLevel<dim>          &level,
                  const FaultTopology           &topology,
                  const std::vector<FaultSides> &sides);

  /** The axes of all faults on a level from those on the next finer one: those
   * of the nodes at the same places. */
  template <int dim>
  std::vector<FaultAxes<dim>>
  inject(const MeshHierarchy<dim>          &meshes,
         const unsigned int                 level,
         const std::vector<FaultSides>     &sides,
         const std::vector<FaultAxes<dim>> &axes);
} // namespace StickSlip

#endif
