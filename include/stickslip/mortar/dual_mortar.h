// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_mortar_dual_mortar_h
#define stickslip_mortar_dual_mortar_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <stickslip/algebra/packed_rows.h>
#include <stickslip/mesh/fault_surface.h>
#include <stickslip/mortar/slave_weights.h>

#include <utility>
#include <vector>

namespace StickSlip
{
  /** The entries of a row, columns ascending. */
  using SparseRow = PackedRows<unsigned int>::Row;

  /**
   * The coupling of the two sides of a fault by dual Lagrange multipliers on
   * the slave side. Tractions are sum_p lambda_p psi_p with the dual functions
   * of the active slave nodes p, which sum to one where the fault carries
   * contact. The mean of the jump of a field u over psi_p is
   *
   *   1/weight_p int psi_p (u_s - u_m)
   *     = averaging_factor_p (u_s,p - sum_q N_pq u_m,q - sum_k S_pk u_s,k)
   *
   * with master nodes q and inactive slave nodes k. Each row of (N, S) sums
   * to one. The traction's virtual power at p is weight_p lambda_p times that
   * mean, or weight_p averaging_factor_p lambda_p times the bracket.
   *
   * Away from inactive nodes S is empty, the averaging factor is one, and N
   * = D^-1 M, which maps linear functions on the master nodes to their values
   * at slave nodes.
   *
   * Where the fault is curved, the faces of the two sides are not at the same
   * places: with the gap g = n . (x_s - x_m) between points opposite to each
   * other along the normal n of a slave face, a rotation has a jump of the size
   * of g. Matrices C_pq take it away: they carry the master's displacement from
   * x_m to x_s as a rotation by the slope of its normal component would,
   *
   *   C_pq u_q = 1/(weight_p averaging_factor_p)
   *                int psi_p g grad (phi_q n . u_q),
   *
   * with the gradient along the slave face, and the bracket becomes
   *
   *   u_s,p - sum_q N_pq u_m,q - sum_k S_pk u_s,k + sum_q C_pq u_m,q ,
   *
   * which is zero for all rigid motions.
   *
   * All vectors have one entry per slave node, in the order of the surface.
   */
  template <int dim>
  struct MortarCoupling
  {
    /** True if the node carries contact. All else is zero or empty if not. */
    std::vector<bool> active;

    /** Integral of psi_p, m^(dim-1). The sum is covered_area. */
    std::vector<double> weight;

    /**
     * int psi_p phi_p / int psi_p: one, or less next to inactive nodes, whose
     * share of the weight the node has taken over.
     */
    std::vector<double> averaging_factor;

    /** N: columns are positions in the arrays of the master surface. */
    PackedRows<unsigned int> master_rows;

    /** S: columns are positions of inactive nodes on the slave surface. */
    PackedRows<unsigned int> inactive_slave_rows;

    /** C: columns are positions in the arrays of the master surface. Empty, not
     * even rows, where both sides are plane. */
    std::vector<std::vector<std::pair<unsigned int, Tensor<2, dim>>>>
      rotation_rows;

    /**
     * Area of the slave faces that lies opposite to master faces and carries
     * contact, m^(dim-1). Zero: the two sides do not touch.
     */
    double covered_area = 0.;

    /**
     * Area that lies opposite to master faces but carries nothing, m^(dim-1):
     * on slave faces without active nodes, and on those too thinly covered for
     * a dual basis (see DualBasis::pivot_tolerance).
     */
    double lost_area = 0.;

    /** Forget the rows, of which a jump basis has its own. */
    void
    forget_rows();
  };

  /**
   * Build the coupling for the current positions of the nodes, in m and in the
   * order of the nodes of the two surfaces, which may be numbered and oriented
   * in any way. The surfaces themselves must not have hanging nodes. Integrals
   * run over the slave faces, each projected onto its plane like the master
   * faces opposite to it (face_overlap.h).
   *
   * Inactive are the slave nodes that are barely covered, see
   * active_weight_fraction, and those that are @p excluded (because Dirichlet
   * conditions hold them, say, or other faults meet there; empty: none). On
   * faces that have both active and inactive nodes, the active ones take over
   * the dual functions of the others. A face without any active node carries
   * nothing; without excluded nodes the area lost that way is less than
   * active_weight_fraction times the integral of the inactive nodes' shape
   * functions, so less than that fraction of the area of the faces around them.
   *
   * All integrals of one face use the same quadrature points, exact for
   * products of two shape functions on parallelograms. On other
   * quadrilaterals the integrals are not exact, but biorthogonality,
   * sums of rows and the reproduction of linear functions are.
   *
   * Periodic surfaces must have the same period; they may have slid along each
   * other by any number of periods.
   *
   * The surfaces may be apart: then covered_area is zero. Throws ExcMessage
   * as compute_face_overlap() does.
   *
   * If a @p range of slave nodes is given, only their coupling is found, from
   * the faces around them and their neighbours. Of other nodes the result says
   * nothing, and areas are those of the faces whose first node is in the range.
   */
  template <int dim>
  MortarCoupling<dim>
  build_mortar_coupling(const FaultSurface<dim>       &slave,
                        const std::vector<Point<dim>> &slave_positions,
                        const FaultSurface<dim>       &master,
                        const std::vector<Point<dim>> &master_positions,
                        const std::vector<bool>       &excluded = {},
                        const SlaveRange              &range    = {});
} // namespace StickSlip

#endif
