// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_mumps_factorisation_h
#define stickslip_algebra_mumps_factorisation_h

#include <stickslip/algebra/sparse_factorisation.h>

namespace StickSlip
{
  /**
   * Cholesky factorisation by MUMPS, called directly, since the interface of
   * Trilinos offers neither symmetric factors nor Schur complements.
   */
  template <int n_components>
  class MumpsFactorisation : public SparseFactorisation<n_components>
  {
  public:
    /**
     * The @p retained entries of vectors (n_components * node + component, in
     * ascending order, none of them ever masked) are not eliminated. With I the
     * others and F the retained ones, solve() gives x_I = A_II^-1 b_I and x_F =
     * 0, and schur_complement() what A becomes on F.
     */
    explicit MumpsFactorisation(const std::vector<unsigned int> &retained = {});

    /**
     * On all processes of @p nodes, each with its rows of the matrix. The @p
     * retained entries have global numbers (n_components * global node +
     * component), in any order, the same on all processes; the first process
     * gets the Schur complement, in that order. What is not const is
     * collective.
     */
    MumpsFactorisation(const NodePartition                        &nodes,
                       const std::vector<types::global_dof_index> &retained);

    ~MumpsFactorisation() override;

    void
    set_matrix(const BlockMatrix<n_components> &matrix,
               const NodeMask                  &mask) override;

    void
    solve(NodalVector &x, const NodalVector &b) override;

    /** A_FF - A_FI A_II^-1 A_IF of the last matrix, symmetric, all entries. */
    const std::vector<double> &
    schur_complement() const;

    /** Schur complement to keep; it is not here any more then. */
    std::vector<double>
    take_schur_complement();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace StickSlip

#endif
