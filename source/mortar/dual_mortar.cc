// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <stickslip/mortar/dual_basis.h>
#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/face_overlap.h>
#include <stickslip/mortar/face_shape.h>

#include <cmath>
#include <map>
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
      static constexpr unsigned int n = FaceShape<dim>::n_vertices;

      /** int phi_i phi_j of the slave's shape functions. */
      typename DualBasis<dim>::Matrix mass = {};

      /** int phi_i phi_q with the shape functions of master node q. */
      std::map<unsigned int, std::array<double, n>> mixed;

      double area = 0.;
    };



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
    integrate_faces(const FaultSurface<dim>           &slave,
                    const std::vector<Point<dim - 1>> &slave_positions,
                    const FaultSurface<dim>           &master,
                    const std::vector<Point<dim - 1>> &master_positions)
    {
      const Quadrature<dim - 1> quadrature =
        cell_quadrature(std::integral_constant<int, dim>());
      double reference_area = 0.;
      for (const double weight : quadrature.get_weights())
        reference_area += weight;

      std::vector<FaceIntegrals<dim>> integrals(slave.faces.size());
      for (const OverlapCell<dim> &cell : compute_face_overlap(
             slave, slave_positions, master, master_positions))
        {
          const auto          &master_face = master.faces[cell.master_face];
          const FaceShape<dim> slave_shape(
            slave.face_vertices(slave_positions, cell.slave_face));
          const FaceShape<dim> master_shape(
            master.face_vertices(master_positions, cell.master_face));
          // From the slave face to the master face, whose image it meets.
          Tensor<1, dim - 1> shift;
          for (unsigned int d = 0; d < dim - 1; ++d)
            shift[d] = -cell.master_wraps[d] * slave.period[d];
          FaceIntegrals<dim> &face = integrals[cell.slave_face];

          const double scale = cell.measure() / reference_area;
          face.area += cell.measure();
          for (unsigned int g = 0; g < quadrature.size(); ++g)
            {
              Point<dim - 1> x = cell.vertices[0];
              for (unsigned int d = 0; d < dim - 1; ++d)
                x += quadrature.point(g)[d] *
                     (cell.vertices[d + 1] - cell.vertices[0]);
              const double JxW         = quadrature.weight(g) * scale;
              const auto   slave_phi   = slave_shape.shape_values(x);
              const auto   master_phi  = master_shape.shape_values(x + shift);
              constexpr unsigned int n = FaceIntegrals<dim>::n;
              for (unsigned int i = 0; i < n; ++i)
                for (unsigned int j = 0; j < n; ++j)
                  face.mass[i][j] += slave_phi[i] * slave_phi[j] * JxW;
              for (unsigned int j = 0; j < n; ++j)
                {
                  auto &column =
                    face.mixed.try_emplace(master_face[j]).first->second;
                  for (unsigned int i = 0; i < n; ++i)
                    column[i] += slave_phi[i] * master_phi[j] * JxW;
                }
            }
        }
      return integrals;
    }



    MortarCoupling::SparseRow
    normalised_row(const std::map<unsigned int, double> &row,
                   const double                          diagonal)
    {
      MortarCoupling::SparseRow result;
      for (const auto &[column, value] : row)
        if (std::abs(value) > entry_tolerance * diagonal)
          result.emplace_back(column, value / diagonal);
      return result;
    }
  } // namespace



  template <int dim>
  MortarCoupling
  build_mortar_coupling(const FaultSurface<dim>           &slave,
                        const std::vector<Point<dim - 1>> &slave_positions,
                        const FaultSurface<dim>           &master,
                        const std::vector<Point<dim - 1>> &master_positions,
                        const std::vector<bool>           &excluded)
  {
    constexpr unsigned int n       = FaceShape<dim>::n_vertices;
    const unsigned int     n_nodes = slave_positions.size();
    const unsigned int     n_faces = slave.faces.size();
    Assert(excluded.empty() || excluded.size() == n_nodes,
           ExcDimensionMismatch(excluded.size(), n_nodes));

    const std::vector<FaceIntegrals<dim>> integrals =
      integrate_faces(slave, slave_positions, master, master_positions);

    std::vector<DualBasis<dim>> bases;
    std::vector<double>         diagonal(n_nodes), full_weight(n_nodes);
    for (unsigned int f = 0; f < n_faces; ++f)
      {
        bases.emplace_back(integrals[f].mass);
        const auto full =
          FaceShape<dim>(slave.face_vertices(slave_positions, f))
            .shape_integrals();
        for (unsigned int i = 0; i < n; ++i)
          {
            full_weight[slave.faces[f][i]] += full[i];
            if (bases[f].is_valid())
              for (unsigned int j = 0; j < n; ++j)
                diagonal[slave.faces[f][i]] += integrals[f].mass[i][j];
          }
      }

    MortarCoupling coupling;
    coupling.active.resize(n_nodes);
    coupling.weight.resize(n_nodes);
    coupling.averaging_factor.resize(n_nodes);
    coupling.master_rows.resize(n_nodes);
    coupling.inactive_slave_rows.resize(n_nodes);
    for (unsigned int p = 0; p < n_nodes; ++p)
      coupling.active[p] =
        diagonal[p] > 0. &&
        diagonal[p] >= active_weight_fraction * full_weight[p] &&
        !(excluded.size() > 0 && excluded[p]);

    std::vector<std::map<unsigned int, double>> M(n_nodes), E(n_nodes);
    for (unsigned int f = 0; f < n_faces; ++f)
      {
        const auto         &face     = slave.faces[f];
        unsigned int        n_active = 0;
        std::array<bool, n> active;
        for (unsigned int i = 0; i < n; ++i)
          {
            active[i] = coupling.active[face[i]];
            n_active += active[i];
          }
        if (n_active == 0 || !bases[f].is_valid())
          {
            coupling.lost_area += integrals[f].area;
            continue;
          }
        coupling.covered_area += integrals[f].area;

        bases[f].restrict_to(active);
        const auto &A = bases[f].coefficients();
        for (unsigned int i = 0; i < n; ++i)
          if (active[i])
            {
              for (const auto &[q, column] : integrals[f].mixed)
                {
                  double &entry = M[face[i]][q];
                  for (unsigned int j = 0; j < n; ++j)
                    entry += A[i][j] * column[j];
                }
              for (unsigned int k = 0; k < n; ++k)
                {
                  double product = 0.;
                  for (unsigned int j = 0; j < n; ++j)
                    product += A[i][j] * integrals[f].mass[j][k];
                  // The integral against the node's own shape function is
                  // in the diagonal, that against other active ones zero.
                  coupling.weight[face[i]] += product;
                  if (!active[k])
                    E[face[i]][face[k]] -= product;
                }
            }
      }

    for (unsigned int p = 0; p < n_nodes; ++p)
      if (coupling.active[p])
        {
          coupling.averaging_factor[p]    = diagonal[p] / coupling.weight[p];
          coupling.master_rows[p]         = normalised_row(M[p], diagonal[p]);
          coupling.inactive_slave_rows[p] = normalised_row(E[p], diagonal[p]);
        }
    return coupling;
  }



  template MortarCoupling
  build_mortar_coupling(const FaultSurface<2> &,
                        const std::vector<Point<1>> &,
                        const FaultSurface<2> &,
                        const std::vector<Point<1>> &,
                        const std::vector<bool> &);
  template MortarCoupling
  build_mortar_coupling(const FaultSurface<3> &,
                        const std::vector<Point<2>> &,
                        const FaultSurface<3> &,
                        const std::vector<Point<2>> &,
                        const std::vector<bool> &);
} // namespace StickSlip
