// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_condensed_schur_complement_h
#define stickslip_condensed_schur_complement_h

#include <stickslip/algebra/mumps_factorisation.h>

namespace StickSlip
{
  /**
   * The Schur complement of a matrix K on the entries F, and its rows for
   * entries P whose values are known,
   *
   *   S_FF = K_FF - K_FI K_II^-1 K_IF,   S_PF = K_PF - K_PI K_II^-1 K_IF,
   *
   * where I are the others that are not fixed, together with factors of K_II.
   * Each process has the entries of its nodes, and their rows as dense
   * matrices. All but n_entries() is collective.
   */
  template <int n_components>
  class SchurComplement
  {
  public:
    /** @p free and @p known: F and P, entries n_components * node + component
     * of nodes that this process owns, in ascending order; P may be fixed.
     * Throws SingularMatrix. */
    SchurComplement(const BlockMatrix<n_components> &K,
                    const NodePartition             &nodes,
                    const NodeMask                  &fixed,
                    const std::vector<unsigned int> &free,
                    const std::vector<unsigned int> &known);

    /** Number of entries F of all processes. */
    unsigned int
    n_entries() const
    {
      return n_all;
    }

    /** Values on F of all processes, one process after the other, from those of
     * this one. */
    std::vector<double>
    on_all(const std::vector<double> &here) const;

    /** y = S_FF x; @p x of all processes, @p y of this one. */
    void
    multiply(std::vector<double> &y, const std::vector<double> &x) const;

    /** The row of S_PF of the k-th of P of this process, n_entries() numbers.
     */
    const double *
    row_of_known(const unsigned int k) const
    {
      return rows.data() + (n_free + k) * stride;
    }

    /** x_I = K_II^-1 b_I, where @p b is zero in all other components, and so is
     * x. */
    void
    solve_eliminated(NodalVector &x, const NodalVector &b);

  private:
    MPI_Comm                         communicator;
    MumpsFactorisation<n_components> factors;
    /** Numbers of entries F of each process, and of those before. */
    std::vector<int> n_of_process, first_of_process;
    unsigned int     n_all = 0, n_free = 0;
    /** Rows of F, then of P, of which the first n_all numbers are read. */
    std::vector<double> rows;
    std::size_t         stride = 0;
  };
} // namespace StickSlip

#endif
