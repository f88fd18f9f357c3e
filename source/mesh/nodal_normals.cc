// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <stickslip/mesh/face_plane.h>
#include <stickslip/mesh/nodal_normals.h>

#include <algorithm>
#include <map>
#include <set>

namespace StickSlip
{
  namespace
  {
    /** The faces around one node, and where their centres are from there, m. */
    template <int dim>
    using Patch = std::map<unsigned int, Tensor<1, dim>>;



    /** Faces around the nodes of a surface. */
    template <int dim>
    class Neighbourhood
    {
    public:
      explicit Neighbourhood(const FaultSurface<dim> &surface)
        : surface(surface)
        , faces_at(surface.nodes.size())
      {
        for (unsigned int f = 0; f < surface.faces.size(); ++f)
          for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
            faces_at[surface.faces[f][v]].push_back(f);
      }

      Patch<dim>
      faces_around(const unsigned int node) const
      {
        Patch<dim> patch;
        add_faces_at(node, {}, patch);
        return patch;
      }

      /** The faces around a node and those that share a node with them. */
      Patch<dim>
      wide_patch(const unsigned int node) const
      {
        Patch<dim> patch = faces_around(node);
        for (const unsigned int f : faces_at[node])
          {
            const auto vertices    = surface.face_vertices(surface.points, f);
            const unsigned int own = vertex_of(node, f);
            for (unsigned int v = 0; v < surface.n_vertices_of(f); ++v)
              add_faces_at(surface.faces[f][v],
                           vertices[v] - vertices[own],
                           patch);
          }
        return patch;
      }

      /** True if a node is joined to another one by the edge of a single face,
       * or, in two dimensions, is on a single face. */
      bool
      is_at_edge(const unsigned int node) const
      {
        if (dim == 2)
          return faces_at[node].size() < 2;
        std::multiset<unsigned int> joined;
        for (const unsigned int f : faces_at[node])
          {
            const unsigned int own         = vertex_of(node, f);
            const bool         is_triangle = surface.n_vertices_of(f) == 3;
            // In deal.II's order, vertices of a quadrilateral that an edge
            // joins differ in one bit.
            for (const unsigned int other : {1, 2})
              joined.insert(surface.faces[f][is_triangle ? (own + other) % 3 :
                                                           own ^ other]);
          }
        return std::any_of(joined.begin(),
                           joined.end(),
                           [&](const unsigned int other) {
                             return joined.count(other) < 2;
                           });
      }

    private:
      unsigned int
      vertex_of(const unsigned int node, const unsigned int face) const
      {
        const auto &vertices = surface.faces[face];
        return std::find(vertices.begin(), vertices.end(), node) -
               vertices.begin();
      }

      /** Add the faces at a node that is by @p offset away. */
      void
      add_faces_at(const unsigned int    node,
                   const Tensor<1, dim> &offset,
                   Patch<dim>           &patch) const
      {
        for (const unsigned int f : faces_at[node])
          {
            const auto vertices    = surface.face_vertices(surface.points, f);
            const unsigned int n   = surface.n_vertices_of(f);
            const unsigned int own = vertex_of(node, f);
            Tensor<1, dim>     centre;
            for (unsigned int v = 0; v < n; ++v)
              centre += (vertices[v] - vertices[own]) / n;
            patch.emplace(f, offset + centre);
          }
      }

      const FaultSurface<dim>               &surface;
      std::vector<std::vector<unsigned int>> faces_at;
    };



    /** The value at the node of the linear function fitted to the normals of a
     * patch. */
    template <int dim>
    Tensor<1, dim>
    fitted_normal(const FaultSurface<dim> &surface,
                  const Tensor<1, dim>    &mean_normal,
                  const Patch<dim>        &patch)
    {
      const FacePlane<dim> plane(mean_normal);
      const double         n_faces = patch.size();
      Tensor<1, dim>       mean;
      Tensor<1, dim - 1>   middle;
      for (const auto &[face, offset] : patch)
        {
          mean += surface.normal_of(face) / n_faces;
          middle += plane.components(offset) / n_faces;
        }
      Tensor<2, dim - 1>                  moments;
      std::array<Tensor<1, dim - 1>, dim> products;
      for (const auto &[face, offset] : patch)
        {
          const Tensor<1, dim - 1> x = plane.components(offset) - middle;
          const Tensor<1, dim>     n = surface.normal_of(face) - mean;
          moments += outer_product(x, x);
          for (unsigned int d = 0; d < dim; ++d)
            products[d] += n[d] * x;
        }
      const double sum = trace(moments);
      if (sum == 0.)
        return mean;
      // In a row of faces the centres differ along one direction only, and
      // there is no slope across it.
      const bool is_a_row = dim == 3 && determinant(moments) < 1e-8 * sum * sum;
      const Tensor<1, dim - 1> to_node =
        (is_a_row ? moments / (sum * sum) : invert(moments)) * middle;
      for (unsigned int d = 0; d < dim; ++d)
        mean[d] -= products[d] * to_node;
      return mean;
    }



    /** The normal at the node, the origin, of the paraboloid through it that
     * fits the vertices of a patch, as a function over the plane of the mean
     * normal. */
    Tensor<1, 3>
    fitted_normal_of_vertices(const FaultSurface<3> &surface,
                              const Tensor<1, 3>    &mean_normal,
                              const Patch<3>        &patch)
    {
      std::map<unsigned int, Tensor<1, 3>> offsets;
      double                               size = 0.;
      for (const auto &[face, to_centre] : patch)
        {
          const auto vertices  = surface.face_vertices(surface.points, face);
          const unsigned int n = surface.n_vertices_of(face);
          Tensor<1, 3>       centre;
          for (unsigned int v = 0; v < n; ++v)
            centre += vertices[v] / n;
          for (unsigned int v = 0; v < n; ++v)
            {
              const Tensor<1, 3> offset = to_centre + (vertices[v] - centre);
              offsets.emplace(surface.faces[face][v], offset);
              size = std::max(size, offset.norm());
            }
        }

      const FacePlane<3>       plane(mean_normal);
      LAPACKFullMatrix<double> A(5);
      Vector<double>           b(5), x(5);
      for (const auto &[vertex, offset] : offsets)
        {
          const Tensor<1, 2>          y      = plane.components(offset) / size;
          const double                height = mean_normal * offset / size;
          const std::array<double, 5> terms  = {
             {y[0], y[1], y[0] * y[0], y[0] * y[1], y[1] * y[1]}};
          for (unsigned int i = 0; i < 5; ++i)
            {
              b(i) += terms[i] * height;
              for (unsigned int j = 0; j < 5; ++j)
                A(i, j) += terms[i] * terms[j];
            }
        }
      // Terms that the vertices do not tell are zero.
      A.compute_inverse_svd(1e-8);
      A.vmult(x, b);
      return mean_normal - plane.in_space(Tensor<1, 2>({x(0), x(1)}));
    }



    /** A fit to the normals of faces where these are known best: at the centres
     * of segments and quadrilaterals. The normal of a triangle is that of the
     * surface at no place of its own. */
    Tensor<1, 2>
    fit(const FaultSurface<2> &surface,
        const Tensor<1, 2>    &mean_normal,
        const Patch<2>        &patch)
    {
      return fitted_normal(surface, mean_normal, patch);
    }



    Tensor<1, 3>
    fit(const FaultSurface<3> &surface,
        const Tensor<1, 3>    &mean_normal,
        const Patch<3>        &patch)
    {
      if (std::any_of(patch.begin(), patch.end(), [&](const auto &face) {
            return surface.n_vertices_of(face.first) == 3;
          }))
        return fitted_normal_of_vertices(surface, mean_normal, patch);
      return fitted_normal(surface, mean_normal, patch);
    }
  } // namespace



  template <int dim>
  std::vector<Tensor<1, dim>>
  nodal_normals(const FaultSurface<dim> &surface)
  {
    if (surface.is_plane())
      return {surface.normal};
    const Neighbourhood<dim>    neighbourhood(surface);
    std::vector<Tensor<1, dim>> normals;
    for (unsigned int p = 0; p < surface.nodes.size(); ++p)
      {
        const Patch<dim> around = neighbourhood.faces_around(p);
        Tensor<1, dim>   mean;
        for (const auto &face : around)
          mean += surface.normal_of(face.first);
        mean /= mean.norm();

        Tensor<1, dim> normal = mean;
        if (!neighbourhood.is_at_edge(p))
          normal = fit(surface, mean, around);
        else
          {
            // Across a corner there is nothing to be extrapolated.
            const Patch<dim> wide = neighbourhood.wide_patch(p);
            if (std::all_of(wide.begin(), wide.end(), [&](const auto &face) {
                  return surface.normal_of(face.first) * mean > 0.8;
                }))
              normal = fit(surface, mean, wide);
          }
        normals.push_back(normal / normal.norm());
      }
    return normals;
  }



  template std::vector<Tensor<1, 2>>
  nodal_normals(const FaultSurface<2> &);
  template std::vector<Tensor<1, 3>>
  nodal_normals(const FaultSurface<3> &);
} // namespace StickSlip
