// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <stickslip/mesh/nodal_normals.h>
#include <stickslip/mortar/dual_basis.h>
#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/face_overlap.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <type_traits>

namespace StickSlip
{
  namespace
  {
    /**
     * Entries of N and S below this are rounding. Removing them matters:
     * matching meshes then couple a slave node to one master node only.
     */
    constexpr double entry_tolerance = 1e-14;



    /** Integrals over the covered part of one slave face. */
    template <int dim>
    struct FaceIntegrals
    {
      static constexpr unsigned int n = FaceShape<dim>::max_vertices;

      /** int phi_i phi_j of the slave's shape functions. */
      typename DualBasis<dim>::Matrix mass = {};

      /** int phi_i phi_q with the shape functions of master node q. */
      std::map<unsigned int, std::array<double, n>> mixed;

      /** int phi_i g grad phi_q with the gap g, along the axes of the plane of
       * the face; empty between plane sides. */
      std::map<unsigned int, std::array<Tensor<1, dim - 1>, n>> slopes;

      /** int phi_i g of smooth sides; zero if nobody asks for it. */
      std::array<double, n> gap = {};

      double area = 0.;
    };



    /** Unit vectors out of the bodies at the nodes of both sides. */
    template <int dim>
    struct SideNormals
    {
      std::vector<Tensor<1, dim>> slave, master;
    };



    /** By how much a smooth surface with these normals at the nodes is above
     * one of its faces, at the point x of a plane that the face is projected
     * onto, see side_gaps(). */
    template <int dim>
    double
    bulge(const FacePlane<dim>              &plane,
          const FaceShape<dim>              &shape,
          const FaultSurface<dim>           &surface,
          const unsigned int                 face,
          const std::vector<Tensor<1, dim>> &normals,
          const Point<dim - 1>              &x)
    {
      const auto phi    = shape.shape_values(x);
      double     result = 0.;
      for (unsigned int v = 0; v < shape.n_vertices(); ++v)
        {
          const Tensor<1, dim> &normal = normals[surface.faces[face][v]];
          // At the edge of a fold there is no slope.
          if (const double up = normal * plane.normal(); std::abs(up) > 0.5)
            result -= 0.5 / up * phi[v] *
                      (plane.components(normal) * (x - shape.vertices()[v]));
        }
      return result;
    }



    /** Elevations of the vertices of a face above the origin along a normal, m.
     */
    template <int dim>
    std::array<double, FaceShape<dim>::max_vertices>
    elevations(const Tensor<1, dim>          &normal,
               const FaultSurface<dim>       &surface,
               const std::vector<Point<dim>> &positions,
               const unsigned int             face)
    {
      std::array<double, FaceShape<dim>::max_vertices> result = {};
      const auto vertices = surface.face_vertices(positions, face);
      for (unsigned int v = 0; v < surface.n_vertices_of(face); ++v)
        result[v] = normal * vertices[v];
      return result;
    }



    template <typename Values>
    double
    product(const Values &a, const Values &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }



    Quadrature<1>
    cell_quadrature(const std::integral_constant<int, 2>)
    {
      return QGauss<1>(2);
    }



    // Products of two bilinear functions have degree four.
    Quadrature<2>
    cell_quadrature(const std::integral_constant<int, 3>)
    {
      return QGaussSimplex<2>(3);
    }



    template <int dim>
    std::vector<FaceIntegrals<dim>>
    integrate_faces(const FaultSurface<dim>       &slave,
                    const std::vector<Point<dim>> &slave_positions,
                    const FaultSurface<dim>       &master,
                    const std::vector<Point<dim>> &master_positions,
                    const SideNormals<dim>        *normals = nullptr)
    {
      const Quadrature<dim - 1> quadrature =
        cell_quadrature(std::integral_constant<int, dim>());
      double reference_area = 0.;
      for (const double weight : quadrature.get_weights())
        reference_area += weight;
      const bool are_plane = slave.is_plane() && master.is_plane();

      std::vector<FaceIntegrals<dim>> integrals(slave.faces.size());
      // Cells of one pair of faces follow each other.
      const OverlapCell<dim>             *last = nullptr;
      std::optional<FacePlane<dim>>       plane;
      std::optional<FaceShape<dim>>       slave_shape, master_shape;
      const std::vector<OverlapCell<dim>> cells =
        compute_face_overlap(slave, slave_positions, master, master_positions);
      for (const OverlapCell<dim> &cell : cells)
        {
          const auto          &master_face = master.faces[cell.master_face];
          const Tensor<1, dim> normal      = slave.normal_of(cell.slave_face);
          const bool           is_new_slave =
            last == nullptr || last->slave_face != cell.slave_face;
          if (is_new_slave)
            {
              plane.emplace(normal);
              slave_shape.emplace(
                project_face(*plane, slave, slave_positions, cell.slave_face));
            }
          if (is_new_slave || last->master_face != cell.master_face)
            master_shape.emplace(
              project_face(*plane, master, master_positions, cell.master_face));
          last = &cell;
          // From the slave face to the master face, whose image it meets.
          Tensor<1, dim> shift;
          for (unsigned int d = 0; d < dim - 1; ++d)
            shift[d] = -cell.master_wraps[d] * slave.period[d];
          const Tensor<1, dim - 1> shift_in_plane = plane->components(shift);
          FaceIntegrals<dim>      &face           = integrals[cell.slave_face];

          std::array<double, FaceIntegrals<dim>::n> slave_heights  = {},
                                                    master_heights = {};
          if (!are_plane)
            {
              slave_heights =
                elevations(normal, slave, slave_positions, cell.slave_face);
              master_heights =
                elevations(normal, master, master_positions, cell.master_face);
            }

          const double scale = cell.measure() / reference_area;
          face.area += cell.measure();
          for (unsigned int g = 0; g < quadrature.size(); ++g)
            {
              Point<dim - 1> x = cell.vertices[0];
              for (unsigned int d = 0; d < dim - 1; ++d)
                x += quadrature.point(g)[d] *
                     (cell.vertices[d + 1] - cell.vertices[0]);
              const double         JxW       = quadrature.weight(g) * scale;
              const Point<dim - 1> on_master = x + shift_in_plane;
              const auto           slave_phi = slave_shape->shape_values(x);
              const auto master_phi = master_shape->shape_values(on_master);
              const unsigned int n_slave  = slave_shape->n_vertices();
              const unsigned int n_master = master_shape->n_vertices();
              for (unsigned int i = 0; i < n_slave; ++i)
                for (unsigned int j = 0; j < n_slave; ++j)
                  face.mass[i][j] += slave_phi[i] * slave_phi[j] * JxW;
              for (unsigned int j = 0; j < n_master; ++j)
                {
                  auto &column =
                    face.mixed.try_emplace(master_face[j]).first->second;
                  for (unsigned int i = 0; i < n_slave; ++i)
                    column[i] += slave_phi[i] * master_phi[j] * JxW;
                }
              if (are_plane)
                continue;
              const double gap = product(slave_phi, slave_heights) -
                                 product(master_phi, master_heights) +
                                 shift * normal;
              if (normals != nullptr)
                {
                  const double smooth_gap = gap +
                                            bulge(*plane,
                                                  *slave_shape,
                                                  slave,
                                                  cell.slave_face,
                                                  normals->slave,
                                                  x) -
                                            bulge(*plane,
                                                  *master_shape,
                                                  master,
                                                  cell.master_face,
                                                  normals->master,
                                                  on_master);
                  for (unsigned int i = 0; i < n_slave; ++i)
                    face.gap[i] += slave_phi[i] * smooth_gap * JxW;
                  continue;
                }
              const auto slopes = master_shape->shape_gradients(on_master);
              for (unsigned int j = 0; j < n_master; ++j)
                {
                  auto &column = face.slopes[master_face[j]];
                  for (unsigned int i = 0; i < n_slave; ++i)
                    column[i] += slave_phi[i] * gap * JxW * slopes[j];
                }
            }
        }
      return integrals;
    }



    /** The integrals of the shape functions of each slave node over all of its
     * faces and over what of them is covered and has a dual basis. */
    struct NodeWeights
    {
      std::vector<double> full, covered;

      bool
      is_active(const unsigned int p) const
      {
        return covered[p] > 0. &&
               covered[p] >= active_weight_fraction * full[p];
      }
    };



    template <int dim>
    NodeWeights
    node_weights(const FaultSurface<dim>               &slave,
                 const std::vector<Point<dim>>         &slave_positions,
                 const std::vector<FaceIntegrals<dim>> &integrals,
                 const std::vector<DualBasis<dim>>     &bases)
    {
      NodeWeights weights;
      weights.full.resize(slave_positions.size());
      weights.covered.resize(slave_positions.size());
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        {
          const auto full = project_face(FacePlane<dim>(slave.normal_of(f)),
                                         slave,
                                         slave_positions,
                                         f)
                              .shape_integrals();
          const unsigned int n = slave.n_vertices_of(f);
          for (unsigned int i = 0; i < n; ++i)
            {
              weights.full[slave.faces[f][i]] += full[i];
              if (bases[f].is_valid())
                for (unsigned int j = 0; j < n; ++j)
                  weights.covered[slave.faces[f][i]] += integrals[f].mass[i][j];
            }
        }
      return weights;
    }



    /** The faces of the nodes of a range and of those that share a face with
     * them: what the weights of all of these follow from. */
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



    template <int dim>
    std::vector<DualBasis<dim>>
    dual_bases(const FaultSurface<dim>               &slave,
               const std::vector<FaceIntegrals<dim>> &integrals)
    {
      std::vector<DualBasis<dim>> bases;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        bases.emplace_back(integrals[f].mass, slave.n_vertices_of(f));
      return bases;
    }



    /** Append a row divided by its diagonal. */
    void
    add_normalised(const std::map<unsigned int, double> &row,
                   const double                          diagonal,
                   PackedRows<unsigned int>             &rows)
    {
      for (const auto &[column, value] : row)
        if (std::abs(value) > entry_tolerance * diagonal)
          rows.add_entry(column, value / diagonal);
    }
  } // namespace



  template <int dim>
  void
  MortarCoupling<dim>::forget_rows()
  {
    master_rows         = {};
    inactive_slave_rows = {};
    rotation_rows       = {};
  }



  template <int dim>
  MortarCoupling<dim>
  build_mortar_coupling(const FaultSurface<dim>       &whole_slave,
                        const std::vector<Point<dim>> &slave_positions,
                        const FaultSurface<dim>       &master,
                        const std::vector<Point<dim>> &master_positions,
                        const std::vector<bool>       &excluded,
                        const SlaveRange              &range)
  {
    const unsigned int n_nodes = slave_positions.size();
    Assert(excluded.empty() || excluded.size() == n_nodes,
           ExcDimensionMismatch(excluded.size(), n_nodes));

    const FaultSurface<dim> slave   = faces_around(whole_slave, range);
    const unsigned int      n_faces = slave.faces.size();
    const std::vector<FaceIntegrals<dim>> integrals =
      integrate_faces(slave, slave_positions, master, master_positions);

    std::vector<DualBasis<dim>> bases = dual_bases(slave, integrals);
    const NodeWeights           weights =
      node_weights(slave, slave_positions, integrals, bases);
    const std::vector<double> &diagonal = weights.covered;

    MortarCoupling<dim> coupling;
    coupling.active.resize(n_nodes);
    coupling.weight.resize(n_nodes);
    coupling.averaging_factor.resize(n_nodes);
    for (unsigned int p = 0; p < n_nodes; ++p)
      coupling.active[p] =
        weights.is_active(p) && !(excluded.size() > 0 && excluded[p]);

    std::vector<std::map<unsigned int, double>>         M(n_nodes), E(n_nodes);
    std::vector<std::map<unsigned int, Tensor<2, dim>>> C;
    if (!slave.is_plane() || !master.is_plane())
      C.resize(n_nodes);
    for (unsigned int f = 0; f < n_faces; ++f)
      {
        const auto        &face     = slave.faces[f];
        const unsigned int n        = slave.n_vertices_of(f);
        unsigned int       n_active = 0;
        std::array<bool, FaceShape<dim>::max_vertices> active = {};
        for (unsigned int i = 0; i < n; ++i)
          {
            active[i] = coupling.active[face[i]];
            n_active += active[i];
          }
        const bool is_lost = (n_active == 0 || !bases[f].is_valid());
        if (range.contains(face[0]))
          (is_lost ? coupling.lost_area : coupling.covered_area) +=
            integrals[f].area;
        if (is_lost)
          continue;

        bases[f].restrict_to(active);
        const auto &A = bases[f].coefficients();
        for (unsigned int i = 0; i < n; ++i)
          if (active[i] && range.contains(face[i]))
            {
              for (const auto &[q, column] : integrals[f].mixed)
                {
                  double &entry = M[face[i]][q];
                  for (unsigned int j = 0; j < n; ++j)
                    entry += A[i][j] * column[j];
                }
              for (const auto &[q, column] : integrals[f].slopes)
                {
                  Tensor<1, dim - 1> slope;
                  for (unsigned int j = 0; j < n; ++j)
                    slope += A[i][j] * column[j];
                  C[face[i]][q] += outer_product(
                    FacePlane<dim>(slave.normal_of(f)).in_space(slope),
                    slave.normal_of(f));
                }
              for (unsigned int k = 0; k < n; ++k)
                {
                  double integral = 0.;
                  for (unsigned int j = 0; j < n; ++j)
                    integral += A[i][j] * integrals[f].mass[j][k];
                  // The integral against the node's own shape function is
                  // in the diagonal, that against other active ones zero.
                  coupling.weight[face[i]] += integral;
                  if (!active[k])
                    E[face[i]][face[k]] -= integral;
                }
            }
      }

    if (!C.empty())
      coupling.rotation_rows.resize(n_nodes);
    for (unsigned int p = 0; p < n_nodes; ++p)
      {
        if (coupling.active[p] && range.contains(p))
          {
            if (!C.empty())
              for (const auto &[q, value] : C[p])
                if (value.norm() > entry_tolerance * diagonal[p])
                  coupling.rotation_rows[p].emplace_back(q,
                                                         value / diagonal[p]);
            coupling.averaging_factor[p] = diagonal[p] / coupling.weight[p];
            add_normalised(M[p], diagonal[p], coupling.master_rows);
            add_normalised(E[p], diagonal[p], coupling.inactive_slave_rows);
          }
        coupling.master_rows.end_row();
        coupling.inactive_slave_rows.end_row();
      }
    coupling.master_rows.close();
    coupling.inactive_slave_rows.close();
    return coupling;
  }



  template <int dim>
  std::vector<double>
  side_gaps(const FaultSurface<dim>       &slave,
            const std::vector<Point<dim>> &slave_positions,
            const FaultSurface<dim>       &master,
            const std::vector<Point<dim>> &master_positions)
  {
    const SideNormals<dim> normals{nodal_normals(slave), nodal_normals(master)};
    const std::vector<FaceIntegrals<dim>> integrals = integrate_faces(
      slave, slave_positions, master, master_positions, &normals);
    const std::vector<DualBasis<dim>> bases = dual_bases(slave, integrals);
    const NodeWeights                 weights =
      node_weights(slave, slave_positions, integrals, bases);

    std::vector<double> gaps(slave_positions.size());
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      for (unsigned int i = 0;
           bases[f].is_valid() && i < slave.n_vertices_of(f);
           ++i)
        gaps[slave.faces[f][i]] +=
          product(bases[f].coefficients()[i], integrals[f].gap);
    for (unsigned int p = 0; p < gaps.size(); ++p)
      gaps[p] = weights.is_active(p) ? gaps[p] / weights.covered[p] :
                                       std::numeric_limits<double>::quiet_NaN();
    return gaps;
  }



  template struct MortarCoupling<2>;
  template struct MortarCoupling<3>;

  template decltype(build_mortar_coupling<2>) build_mortar_coupling<2>;
  template decltype(build_mortar_coupling<3>) build_mortar_coupling<3>;
  template std::vector<double>
  side_gaps(const FaultSurface<2> &,
            const std::vector<Point<2>> &,
            const FaultSurface<2> &,
            const std::vector<Point<2>> &);
  template std::vector<double>
  side_gaps(const FaultSurface<3> &,
            const std::vector<Point<3>> &,
            const FaultSurface<3> &,
            const std::vector<Point<3>> &);
} // namespace StickSlip
