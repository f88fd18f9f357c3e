// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_trilinos_system_h
#define stickslip_algebra_trilinos_system_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>

#include <memory>

class Epetra_LinearProblem;
class Epetra_RowMatrix;

namespace StickSlip
{
  /**
   * A linear system of one process in the form of Trilinos: a block matrix,
   * with rows and columns of masked components replaced by those of the
   * identity, and two vectors.
   */
  template <int n_components>
  class TrilinosSystem
  {
  public:
    TrilinosSystem();

    ~TrilinosSystem();

    /** Take over the values of a matrix; returns whether its sparsity is
     * another one than before, so that all of the system has been made anew. */
    bool
    set_matrix(const BlockMatrix<n_components> &matrix, const NodeMask &mask);

    unsigned int
    size() const;

    Epetra_RowMatrix &
    matrix();

    /** Matrix, right hand side and solution. */
    Epetra_LinearProblem &
    problem();

    void
    set_rhs(const NodalVector &b);

    void
    get_solution(NodalVector &x) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /**
   * While an object of this class lives, nothing is written to std::cerr: for
   * libraries that comment on errors besides returning them.
   */
  class SilentErrors
  {
  public:
    SilentErrors();

    ~SilentErrors();

    SilentErrors(const SilentErrors &) = delete;
    SilentErrors &
    operator=(const SilentErrors &) = delete;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace StickSlip

#endif
