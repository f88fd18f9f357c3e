// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/mortar/face_overlap.h>
#include <stickslip/mortar/slave_weights.h>

namespace StickSlip
{
  template <int dim>
  std::vector<DualBasis<dim>>
  dual_bases(const FaultSurface<dim> &slave, const FaceMasses<dim> &masses)
  {
    std::vector<DualBasis<dim>> bases;
    bases.reserve(masses.size());
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      bases.emplace_back(masses[f], slave.n_vertices_of(f));
    return bases;
  }



  template <int dim>
  SlaveWeights
  slave_weights(const FaultSurface<dim>           &slave,
                const std::vector<Point<dim>>     &positions,
                const FaceMasses<dim>             &masses,
                const std::vector<DualBasis<dim>> &bases)
  {
    SlaveWeights weights;
    weights.full.resize(positions.size());
    weights.covered.resize(positions.size());
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      {
        const auto full =
          project_face(FacePlane<dim>(slave.normal_of(f)), slave, positions, f)
            .shape_integrals();
        const unsigned int n = slave.n_vertices_of(f);
        for (unsigned int i = 0; i < n; ++i)
          {
            weights.full[slave.faces[f][i]] += full[i];
            if (bases[f].is_valid())
              for (unsigned int j = 0; j < n; ++j)
                weights.covered[slave.faces[f][i]] += masses[f][i][j];
          }
      }
    return weights;
  }



  template <int dim>
  FaultSurface<dim>
  faces_around(const FaultSurface<dim> &surface, const SlaveRange &range)
  {
    std::vector<bool> is_near;
    for (unsigned int p = 0; p < surface.points.size(); ++p)
      is_near.push_back(range.contains(p));
    const auto touches = [&](const unsigned int       face,
                             const std::vector<bool> &nodes) {
      for (unsigned int v = 0; v < surface.n_vertices_of(face); ++v)
        if (nodes[surface.faces[face][v]])
          return true;
      return false;
    };
    const std::vector<bool> is_own = is_near;
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      if (touches(f, is_own))
        for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
          is_near[surface.faces[f][v]] = true;

    FaultSurface<dim> result = surface;
    result.faces.clear();
    result.face_normals.clear();
    result.wraps.clear();
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      if (touches(f, is_near))
        {
          result.faces.push_back(surface.faces[f]);
          if (!surface.is_plane())
            result.face_normals.push_back(surface.face_normals[f]);
          if (!surface.wraps.empty())
            result.wraps.push_back(surface.wraps[f]);
        }
    return result;
  }



#define STICKSLIP_INSTANTIATE(dim)                          \
  template decltype(dual_bases<dim>)    dual_bases<dim>;    \
  template decltype(slave_weights<dim>) slave_weights<dim>; \
  template decltype(faces_around<dim>)  faces_around<dim>;

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
