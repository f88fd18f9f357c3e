// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_condensed_condensed_operator_h
#define stickslip_condensed_condensed_operator_h

#include <stickslip/algebra/mumps_factorisation.h>
#include <stickslip/algebra/operator_sum.h>
#include <stickslip/algebra/umfpack_factorisation.h>
#include <stickslip/multigrid/kept_linearisation.h>

namespace StickSlip
{
  /**
   * The entries of the unknowns that a condensed problem keeps, node after node
   * in ascending order.
   */
  template <int n_components>
  struct CondensedEntries
  {
    CondensedEntries() = default;

    /** The components of the nonsmooth nodes that are not fixed. */
    explicit CondensedEntries(const Unknowns &unknowns);

    /** Positions n_components * node + component in a vector of all unknowns,
     * and n_components * k + component in one of the nonsmooth nodes only. */
    std::vector<unsigned int> positions, positions_at_nodes;

    /** The number of the entry of component c of the k-th node, or
     * numbers::invalid_unsigned_int. */
    std::vector<std::array<unsigned int, n_components>> of_node;

    unsigned int
    size() const
    {
      return positions.size();
    }
  };

  /**
   * An operator A condensed to a set F of entries: the Schur complement
   *
   *   S = A_FF - A_FI A_II^-1 A_IF
   *
   * with the other entries I that are not fixed, as a dense matrix, together
   * with the factors of A_II. A may be a factor times a matrix: another factor
   * costs no more than the size of S. On one process.
   */
  template <int n_components>
  class CondensedOperator
  {
  public:
    /** @p entries must live longer than this object. */
    explicit CondensedOperator(const CondensedEntries<n_components> &entries);

    /** Let A be a matrix, with the factor 1. Throws SingularMatrix. */
    void
    set_matrix(const BlockMatrix<n_components> &A, const NodeMask &fixed);

    /** Let A be @p factor > 0 times the last matrix. */
    void
    set_factor(const double new_factor)
    {
      factor = new_factor;
    }

    /** The factor of A. */
    double
    present_factor() const
    {
      return factor;
    }

    /** Row @p i of S over that factor, and column, since S is symmetric. */
    const double *
    row(const unsigned int i) const;

    /** y = S x. */
    void
    vmult(std::vector<double> &y, const std::vector<double> &x) const;

    /** x_I = A_II^-1 b_I, where @p b is zero in the components that are fixed
     * or belong to F, and so is x. */
    void
    solve_eliminated(NodalVector &x, const NodalVector &b);

    /**
     * Solve (S + H) x = r on the entries with @p active true, to a residual of
     * 1e-4 in the energy norm at least; x is zero elsewhere, and r is not
     * read. H has a block for each node. A Cholesky factorisation of an earlier
     * matrix preconditions as long as a few steps of CG with it do, else it is
     * made anew. Throws SingularMatrix.
     */
    void
    solve_linearised(std::vector<double>                        &x,
                     const std::vector<double>                  &r,
                     const std::vector<Tensor<2, n_components>> &H,
                     const std::vector<bool>                    &active);

    /** The linearisation whose factors are there, with nonsmooth nodes as
     * numbers of nodes; without coefficients. */
    KeptLinearisation<n_components>
    factorised() const;

    /** The factor of A in that linearisation. */
    double
    factor_of_factorised() const
    {
      return factorised_factor;
    }

    /** Make the factors of a linearisation, if it is set. */
    void
    recall(const KeptLinearisation<n_components> &kept);

  private:
    /** At most max_steps(); returns whether they were enough. */
    bool
    solve_by_cg(std::vector<double>                        &x,
                const std::vector<double>                  &r,
                const std::vector<Tensor<2, n_components>> &H,
                const std::vector<bool>                    &active);

    void
    factorise(const std::vector<Tensor<2, n_components>> &H,
              const std::vector<bool>                    &active);

    /** x = the factors applied to b, on active entries. */
    void
    apply_factors(std::vector<double>       &x,
                  const std::vector<double> &b,
                  const std::vector<bool>   &active) const;

    const CondensedEntries<n_components> &entries;
    MumpsFactorisation<n_components>      bulk;
    double                                factor = 1.;
    /** Factors of A_II once more where it is small: UMFPACK solves faster
     * then. */
    std::unique_ptr<UmfpackFactorisation<n_components>> small_bulk;
    /** Empty if there are none. */
    std::vector<double> factors;
    /** Linearisation that they are the factors of. */
    std::vector<Tensor<2, n_components>> factorised_hessians;
    std::vector<bool>                    factorised_active;
    double                               factorised_factor = 1.;
  };
} // namespace StickSlip

#endif
