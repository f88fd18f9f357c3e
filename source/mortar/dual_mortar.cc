// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/mortar/dual_mortar.h>
#include <stickslip/mortar/overlap_points.h>

#include <algorithm>
#include <cmath>
#include <map>

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

      /** int phi_i phi_q with the shape functions of master node q. */
      std::map<unsigned int, std::array<double, n>> mixed;

      /** int phi_i g grad phi_q with the gap g, along the axes of the plane of
       * the face; empty between plane sides. */
      std::map<unsigned int, std::array<Tensor<1, dim - 1>, n>> slopes;

      double area = 0.;
    };



    /** @p masses: int phi_i phi_j of the slave's shape functions. */
    template <int dim>
    std::vector<FaceIntegrals<dim>>
    integrate_faces(const FaultSurface<dim>       &slave,
                    const std::vector<Point<dim>> &slave_positions,
                    const FaultSurface<dim>       &master,
                    const std::vector<Point<dim>> &master_positions,
                    FaceMasses<dim>               &masses)
    {
      const bool are_plane = slave.is_plane() && master.is_plane();
      masses.resize(slave.faces.size());
      std::vector<FaceIntegrals<dim>> integrals(slave.faces.size());
      for_each_overlap_point<dim>(
        slave,
        slave_positions,
        master,
        master_positions,
        [&](const OverlapPoint<dim> &point) {
          FaceIntegrals<dim> &face        = integrals[point.slave_face];
          auto               &mass        = masses[point.slave_face];
          const auto         &master_face = master.faces[point.master_face];
          const auto         &slave_phi   = point.slave_phi;
          const unsigned int  n_slave     = point.slave_shape.n_vertices();
          const unsigned int  n_master    = point.master_shape.n_vertices();
          face.area += point.JxW;
          for (unsigned int i = 0; i < n_slave; ++i)
            for (unsigned int j = 0; j < n_slave; ++j)
              mass[i][j] += slave_phi[i] * slave_phi[j] * point.JxW;
          for (unsigned int j = 0; j < n_master; ++j)
            {
              auto &column =
                face.mixed.try_emplace(master_face[j]).first->second;
              for (unsigned int i = 0; i < n_slave; ++i)
                column[i] += slave_phi[i] * point.master_phi[j] * point.JxW;
            }
          if (are_plane)
            return;
          const auto slopes =
            point.master_shape.shape_gradients(point.on_master);
          for (unsigned int j = 0; j < n_master; ++j)
            {
              auto &column = face.slopes[master_face[j]];
              for (unsigned int i = 0; i < n_slave; ++i)
                column[i] += slave_phi[i] * point.gap * point.JxW * slopes[j];
            }
        });
      return integrals;
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
    FaceMasses<dim>         masses;
    const std::vector<FaceIntegrals<dim>> integrals =
      integrate_faces(slave, slave_positions, master, master_positions, masses);

    std::vector<DualBasis<dim>> bases = dual_bases(slave, masses);
    const SlaveWeights          weights =
      slave_weights(slave, slave_positions, masses, bases);
    const std::vector<double> &diagonal = weights.covered;

    MortarCoupling<dim> coupling;
    coupling.active.resize(n_nodes);
    coupling.weight.resize(n_nodes);
    coupling.averaging_factor.resize(n_nodes);
    for (unsigned int p = 0; p < n_nodes; ++p)
      coupling.active[p] =
        weights.is_active(p) && !(excluded.size() > 0 && excluded[p]);

    // Rows of the range.
    const unsigned int n_rows    = std::min(range.end, n_nodes) - range.begin;
    const bool         are_plane = slave.is_plane() && master.is_plane();
    std::vector<std::map<unsigned int, double>>         M(n_rows), E(n_rows);
    std::vector<std::map<unsigned int, Tensor<2, dim>>> C(are_plane ? 0 :
                                                                      n_rows);
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
              const unsigned int row = face[i] - range.begin;
              for (const auto &[q, column] : integrals[f].mixed)
                {
                  double &entry = M[row][q];
                  for (unsigned int j = 0; j < n; ++j)
                    entry += A[i][j] * column[j];
                }
              for (const auto &[q, column] : integrals[f].slopes)
                {
                  Tensor<1, dim - 1> slope;
                  for (unsigned int j = 0; j < n; ++j)
                    slope += A[i][j] * column[j];
                  C[row][q] += outer_product(
                    FacePlane<dim>(slave.normal_of(f)).in_space(slope),
                    slave.normal_of(f));
                }
              for (unsigned int k = 0; k < n; ++k)
                {
                  double integral = 0.;
                  for (unsigned int j = 0; j < n; ++j)
                    integral += A[i][j] * masses[f][j][k];
                  // The integral against the node's own shape function is
                  // in the diagonal, that against other active ones zero.
                  coupling.weight[face[i]] += integral;
                  if (!active[k])
                    E[row][face[k]] -= integral;
                }
            }
      }

    if (!are_plane)
      coupling.rotation_rows.resize(n_nodes);
    for (unsigned int p = 0; p < n_nodes; ++p)
      {
        if (coupling.active[p] && range.contains(p))
          {
            const unsigned int row = p - range.begin;
            if (!are_plane)
              for (const auto &[q, value] : C[row])
                if (value.norm() > entry_tolerance * diagonal[p])
                  coupling.rotation_rows[p].emplace_back(q,
                                                         value / diagonal[p]);
            coupling.averaging_factor[p] = diagonal[p] / coupling.weight[p];
            add_normalised(M[row], diagonal[p], coupling.master_rows);
            add_normalised(E[row], diagonal[p], coupling.inactive_slave_rows);
          }
        coupling.master_rows.end_row();
        coupling.inactive_slave_rows.end_row();
      }
    coupling.master_rows.close();
    coupling.inactive_slave_rows.close();
    return coupling;
  }



  template struct MortarCoupling<2>;
  template struct MortarCoupling<3>;

  template decltype(build_mortar_coupling<2>) build_mortar_coupling<2>;
  template decltype(build_mortar_coupling<3>) build_mortar_coupling<3>;
} // namespace StickSlip
