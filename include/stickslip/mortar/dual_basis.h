// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_dual_basis_h
#define stickslip_mortar_dual_basis_h

#include <deal.II/base/geometry_info.h>

#include <array>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The dual (biorthogonal) basis of one slave face,
   *
   *   psi_p = sum_q A_pq phi_q,   int psi_p phi_q = delta_pq int phi_p,
   *
   * where the integrals run over the covered part of the face, so that
   * A = D M^-1 with the mass matrix M of the covered part and D its row sums
   * (Wohlmuth 2000; partly covered faces: Cichosz and Bischoff 2011; Popp et
   * al. 2013). The functions sum to one on the covered part.
   */
  template <int dim>
  class DualBasis
  {
  public:
    /** The most vertices of a face. */
    static constexpr unsigned int n = GeometryInfo<dim>::vertices_per_face;

    using Vector = std::array<double, n>;
    using Matrix = std::array<Vector, n>;

    /**
     * Faces are too thinly covered for a dual basis if a pivot of the Cholesky
     * factorisation of the mass matrix, scaled to ones on the diagonal, is
     * below this: the shape functions are nearly linearly dependent there
     * and the dual functions would be huge. A strip along an edge or a corner
     * is not thin in this sense, however small it is.
     */
    static constexpr double pivot_tolerance = 1e-3;

    /**
     * The basis that belongs to the mass matrix of the covered part, m^(dim-1),
     * of the first @p n_vertices vertices; three for a triangle. Without one,
     * is_valid() is false.
     */
    explicit DualBasis(const Matrix &mass, const unsigned int n_vertices = n);

    bool
    is_valid() const
    {
      return valid;
    }

    /**
     * Give the functions of the vertices that are not @p active to those that
     * are. The remaining functions still sum to one and stay biorthogonal to
     * the shape functions of all active vertices; their integrals against those
     * of the inactive ones are not zero any more. The function of an
     * inactive vertex goes in equal parts to the active ones joined to it by an
     * edge, or else to all. At least one vertex must be active.
     */
    void
    restrict_to(const std::array<bool, n> &active);

    /** The matrix A; rows of inactive vertices, and of those that a triangle
     * does not have, are zero. */
    const Matrix &
    coefficients() const;

  private:
    Matrix       A;
    unsigned int n_vertices;
    bool         valid;
  };
} // namespace StickSlip

#endif
