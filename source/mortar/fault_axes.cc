// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/mesh/nodal_normals.h>
#include <stickslip/mortar/fault_axes.h>
#include <stickslip/mortar/fault_displacement.h>

#include <algorithm>
#include <cmath>

namespace StickSlip
{
  namespace
  {
    Tensor<2, 2>
    axes_at(const Tensor<1, 2> &n, const Tensor<1, 2> &)
    {
      return Tensor<2, 2>({{n[1], n[0]}, {-n[0], n[1]}});
    }



    /** True if a reference axis is too near to a normal. */
    bool
    is_normal_to_fault(const Tensor<1, 3> &reference, const Tensor<1, 3> &n)
    {
      return std::abs(reference * n) >
             reference.norm() *
               std::cos(FaultAxes<3>::least_angle * numbers::PI / 180.);
    }



    Tensor<2, 3>
    axes_at(const Tensor<1, 3> &n, const Tensor<1, 3> &reference)
    {
      if (is_normal_to_fault(reference, n))
        throw InputError("the direction of the first component of slip is "
                         "somewhere within 15 degrees of its normal; choose "
                         "another one as 'Strike'.");
      Tensor<1, 3> first = reference - (reference * n) * n;
      first /= first.norm();
      const Tensor<1, 3> second = cross_product_3d(n, first);
      Tensor<2, 3>       axes;
      for (unsigned int d = 0; d < 3; ++d)
        {
          axes[d][0] = first[d];
          axes[d][1] = second[d];
          axes[d][2] = n[d];
        }
      return axes;
    }



    Tensor<1, 2>
    reference_axis(const Fault &, const std::vector<Tensor<1, 2>> &)
    {
      return FaultAxes<2>::first_axis();
    }



    Tensor<1, 3>
    reference_axis(const Fault &fault, const std::vector<Tensor<1, 3>> &normals)
    {
      const Tensor<1, 3> strike(
        {fault.strike[0], fault.strike[1], fault.strike[2]});
      if (strike.norm() > 0.)
        return strike / strike.norm();
      const Tensor<1, 3> x = FaultAxes<3>::first_axis();
      if (std::none_of(normals.begin(),
                       normals.end(),
                       [&x](const Tensor<1, 3> &n) {
                         return is_normal_to_fault(x, n);
                       }))
        return x;
      Tensor<1, 3> mean;
      for (const Tensor<1, 3> &n : normals)
        mean += n;
      const Tensor<1, 3> horizontal({-mean[1], mean[0], 0.});
      const double       length = horizontal.norm();
      // Nothing is mean on a closed surface.
      return length < 1e-3 * normals.size() ? x :
             mean[0] < 0.                   ? -horizontal / length :
                                              horizontal / length;
    }
  } // namespace



  template <int dim>
  Tensor<1, dim>
  FaultAxes<dim>::first_axis()
  {
    Tensor<1, dim> axis;
    axis[0] = 1.;
    return axis;
  }



  template <int dim>
  FaultAxes<dim>::FaultAxes(const std::vector<Tensor<1, dim>> &normals,
                            const Tensor<1, dim>              &reference)
    : reference(reference)
    , normals(normals)
  {
    // Surfaces that are level have normals that are so to the last bit.
    if (normals.size() == 1 && std::abs(normals[0][dim - 1]) == 1. &&
        reference == first_axis())
      return;
    for (const Tensor<1, dim> &n : normals)
      axes.push_back(axes_at(n, reference));
  }



  template <int dim>
  Tensor<2, dim>
  FaultAxes<dim>::at(const unsigned int k) const
  {
    return are_those_of_space() ? Tensor<2, dim>(unit_symmetric_tensor<dim>()) :
           axes.size() == 1     ? axes[0] :
                                  axes[k];
  }



  template <int dim>
  FaultAxes<dim>
  FaultAxes<dim>::at_places(const std::vector<unsigned int> &places) const
  {
    if (normals.size() == 1)
      return *this;
    FaultAxes result;
    result.reference = reference;
    for (const unsigned int k : places)
      {
        result.normals.push_back(normals[k]);
        result.axes.push_back(axes[k]);
      }
    return result;
  }



  template <int dim>
  std::vector<FaultAxes<dim>>
  make_fault_axes(const MeshLevel<dim>          &level,
                  const FaultTopology           &topology,
                  const std::vector<FaultSides> &sides)
  {
    std::vector<FaultAxes<dim>> result;
    for (unsigned int f = 0; f < sides.size(); ++f)
      {
        std::vector<Tensor<1, dim>> normals =
          nodal_normals(level.surface(f, sides[f].slave));
        // Out of the first side, into the second one.
        if (sides[f].slave_is_second())
          for (Tensor<1, dim> &normal : normals)
            normal *= -1.;
        try
          {
            result.emplace_back(normals,
                                reference_axis(topology.faults()[f], normals));
          }
        catch (const InputError &error)
          {
            throw InputError("The fault '" + topology.faults()[f].name +
                             "': " + error.what());
          }
      }
    return result;
  }



  template <int dim>
  std::vector<FaultAxes<dim>>
  inject(const MeshHierarchy<dim>          &meshes,
         const unsigned int                 level,
         const std::vector<FaultSides>     &sides,
         const std::vector<FaultAxes<dim>> &axes)
  {
    std::vector<FaultAxes<dim>> result;
    for (unsigned int f = 0; f < sides.size(); ++f)
      result.push_back(
        axes[f].at_places(meshes.places_on_finer(level, f, sides[f].slave)));
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                           \
  template class FaultAxes<dim>;                             \
  template std::vector<FaultAxes<dim>> make_fault_axes<dim>( \
    const MeshLevel<dim> &,                                  \
    const FaultTopology &,                                   \
    const std::vector<FaultSides> &);                        \
  template std::vector<FaultAxes<dim>> inject<dim>(          \
    const MeshHierarchy<dim> &,                              \
    const unsigned int,                                      \
    const std::vector<FaultSides> &,                         \
    const std::vector<FaultAxes<dim>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
