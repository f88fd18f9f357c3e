// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_condensed_condensed_solver_h
#define stickslip_condensed_condensed_solver_h

#include <stickslip/condensed/condensed_operator.h>
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
   * with the Schur complement S of A as a dense matrix. The steps of
   * NonsmoothSolver are carried out on z, with an exact correction. The
   * components outside F are found by finish().
   *
   * S and the factors of the rest are made once for each operator, and kept
   * for those used last; an operator that is one term times a coefficient is
   * condensed once for all coefficients. Memory grows with the square, the time
   * for an operator with the cube of the number of entries of F. On one
   * process.
   */
  template <int n_components>
  class CondensedSolver : public NonsmoothSolver<n_components>
  {
  public:
    /** The largest number of entries of F. */
    static constexpr unsigned int max_entries = 20000;

    /** @p operators must live longer than this object. Throws AgreedFailure if
     * there are more than max_entries entries. */
    CondensedSolver(const OperatorSum<n_components> &operators,
                    const TNNMGParameters           &parameters);

    void
    start(const NodalVector &b, const NodalVector &w) override;

    /**
     * The square of the norm of the iterate in the summary is z . S z and that
     * of all values at the start.
     */
    IterationSummary
    iterate(const NonsmoothFunctional<n_components> &functional,
            const NodalVector                       &b,
            NodalVector                             &w) override;

    void
    finish(const NodalVector &b, NodalVector &w) override;

    /** The operators condensed, the one used last behind the others. */
    std::vector<KeptLinearisation<n_components>>
    kept_linearisations() const override;

    void
    recall(const KeptLinearisation<n_components> &kept) override;

    /** Number of operators condensed so far. */
    unsigned int
    n_condensed() const
    {
      return condensations;
    }

  private:
    struct Operator
    {
      unsigned long                   version = 0;
      std::vector<double>             coefficients;
      CondensedOperator<n_components> condensed;

      explicit Operator(const CondensedEntries<n_components> &entries);
    };

    /** The present operator, as the first of the list. */
    void
    find_operator();

    void
    sweep(const NonsmoothFunctional<n_components> &functional,
          const bool                               is_everywhere,
          NodalVector                             &z,
          NodalVector                             &r) override;

    /** y = S x. */
    void
    vmult(NodalVector &y, const NodalVector &x) const override;

    /** The block of S, or of the identity in fixed components. */
    Tensor<2, n_components>
    diagonal_block(const unsigned int k) const override;

    unsigned int
    correct(NodalVector &x,
            NodalVector &A_x,
            NodalVector &r,
            const double norm,
            const bool   is_outdated) override;

    /** The entries of F in a vector of the nonsmooth nodes. */
    std::vector<double>
    entries_of(const NodalVector &z) const;

    /** Set the entries of F there. */
    void
    set_entries(NodalVector &z, const std::vector<double> &values) const;

    /** Let z be the part of w at the nonsmooth nodes. */
    void
    gather(const NodalVector &w, NodalVector &z) const;

    /** Set the fixed components and those of F to zero. */
    void
    restrict_to_eliminated(NodalVector &vector) const;

    const OperatorSum<n_components> &operators;
    CondensedEntries<n_components>   entries;
    /** Operators used last come first. */
    std::list<Operator> condensed_operators;
    unsigned int        condensations = 0;

    /** The values at the start with all outside F minimal for those on F, the
     * residual of them, and work space. */
    NodalVector base, load, scratch, bulk;
    /** Vectors of the nonsmooth nodes. */
    NodalVector g, z, z_of_base;
  };
} // namespace StickSlip

#endif
