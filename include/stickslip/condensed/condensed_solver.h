// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_condensed_condensed_solver_h
#define stickslip_condensed_condensed_solver_h

#include <stickslip/condensed/condensed_operator.h>
#include <stickslip/multigrid/level_hierarchy.h>
#include <stickslip/tnnmg/nonsmooth_solver.h>

#include <list>

namespace StickSlip
{
  /**
   * The minimisation of J condensed to the components F of the nonsmooth nodes:
   * with all others minimal at given z = w_F, what remains is
   *
   *   1/2 z . S z - g . z + phi(z)
   *
   * with the Schur complement S of A as a dense matrix. The iteration is that
   * of TNNMGSolver, with an exact correction: nonlinear Gauss-Seidel,
   * truncation, Newton's method, line search. The components outside F are
   * found by finish().
   *
   * S and the factors of the rest are made once for each operator, and kept
   * for those used last. Memory grows with the square, the time for an operator
   * with the cube of the number of entries of F. On one process.
   */
  template <int n_components>
  class CondensedSolver : public NonsmoothSolver<n_components>
  {
  public:
    /** The largest number of entries of F. */
    static constexpr unsigned int max_entries = 20000;

    /** The hierarchy holds A and the fixed components. Throws AgreedFailure if
     * there are more than max_entries entries. */
    CondensedSolver(const LevelHierarchy<n_components> &hierarchy,
                    const TNNMGParameters              &parameters);

    void
    start(const NodalVector &b, const NodalVector &w) override;

    /**
     * The norm of the iterate in the summary leaves out the product of z with
     * the prescribed components.
     */
    IterationSummary
    iterate(const NonsmoothFunctional<n_components> &functional,
            const NodalVector                       &b,
            NodalVector                             &w) override;

    void
    finish(const NodalVector &b, NodalVector &w) override;

    /** Number of operators condensed so far. */
    unsigned int
    n_condensed() const;

  private:
    struct Operator
    {
      unsigned long                   version = 0;
      CondensedOperator<n_components> condensed;

      explicit Operator(const CondensedEntries<n_components> &entries);
    };

    /** The present operator, as the first of the list. */
    void
    find_operator();

    /** Nonlinear Gauss-Seidel. */
    void
    smooth(const NonsmoothFunctional<n_components> &functional, NodalVector &w);

    /** The entries of F in a vector. */
    std::vector<double>
    values_of(const NodalVector &vector) const;

    /** Set the fixed components and those of F to zero. */
    void
    restrict_to_eliminated(NodalVector &vector) const;

    /** Block of S of the k-th node; that of the identity in fixed
     * components. */
    Tensor<2, n_components>
    diagonal_block(const unsigned int k) const;

    const LevelHierarchy<n_components> &hierarchy;
    CondensedEntries<n_components>      entries;
    /** Those used last come first. */
    std::list<Operator> operators;
    unsigned int        condensations = 0;

    /** The fixed components, what remains of b with them, and g. */
    NodalVector         prescribed, load;
    std::vector<double> condensed_load;
    /** g - S z. */
    std::vector<double> residual;
    /** w . A w for z = 0. */
    double square_at_zero = 0;

    NodeMask                             active;
    NodalVector                          previous, correction, scratch, bulk;
    std::vector<Tensor<2, n_components>> hessians, diagonal_blocks;
  };
} // namespace StickSlip

#endif
