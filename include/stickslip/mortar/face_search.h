// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_face_search_h
#define stickslip_mortar_face_search_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <boost/container/small_vector.hpp>

#include <stickslip/mesh/face_plane.h>
#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mortar/face_shape.h>

#include <array>
#include <utility>
#include <vector>

namespace StickSlip
{
  /**
   * Faces of two sides couple if the angle between the normal of one and the
   * opposite of the other one's is less than 60 degrees: this is the cosine.
   */
  constexpr double facing_cosine = 0.5;

  /**
   * A master face, moved by whole periods.
   */
  template <int dim>
  struct MasterImage
  {
    /** Position in the master surface's array of faces. */
    unsigned int face;

    /** By how many periods it is moved. */
    std::array<int, dim - 1> wraps;

    /** By how much that is, m. */
    Tensor<1, dim> shift;
  };

  /**
   * Finds the master faces that may overlap a slave face, by a tree of their
   * bounding boxes. The arguments must outlive this object.
   */
  template <int dim>
  class FaceSearch
  {
  public:
    FaceSearch(const FaultSurface<dim>       &slave,
               const std::vector<Point<dim>> &slave_positions,
               const FaultSurface<dim>       &master,
               const std::vector<Point<dim>> &master_positions);

    FaceSearch(const FaceSearch &) = delete;

    FaceSearch &
    operator=(const FaceSearch &) = delete;

    /**
     * The images whose boxes meet that of the slave face and that face it
     * (facing_cosine). Unless both sides are plane, their centres are at most
     * the sum of both diameters away along the normal. In a fixed order.
     */
    boost::container::small_vector<MasterImage<dim>, 8>
    opposite_to(const unsigned int slave_face) const;

  private:
    /** All images, moved by multiples of the period, that reach into the extent
     * of the slave side. */
    std::vector<MasterImage<dim>>
    find_images() const;

    std::vector<BoundingBox<dim>>
    find_boxes() const;

    /** The box of a face in which overlaps are looked for: in coordinates of
     * the plane in which all faces are, or else in space, a diameter larger on
     * all sides. */
    BoundingBox<dim>
    box(const FaultSurface<dim>       &surface,
        const std::vector<Point<dim>> &positions,
        const unsigned int             face,
        const Tensor<1, dim>          &shift) const;

    bool
    is_opposite(const unsigned int      slave_face,
                const MasterImage<dim> &image) const;

    const FaultSurface<dim>       &slave;
    const std::vector<Point<dim>> &slave_positions;
    const FaultSurface<dim>       &master;
    const std::vector<Point<dim>> &master_positions;
    const bool                     are_plane;
    /** The plane of all faces, if they are in one. */
    const FacePlane<dim>                common_plane;
    const std::vector<MasterImage<dim>> images;
    const std::vector<BoundingBox<dim>> boxes;
    /** The positions of the boxes, which it refers to. */
    const decltype(pack_rtree_of_indices(
      std::declval<const std::vector<BoundingBox<dim>> &>())) tree;
  };
} // namespace StickSlip

#endif
