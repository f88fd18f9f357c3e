// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_operator_sum_h
#define stickslip_algebra_operator_sum_h

#include <stickslip/algebra/block_matrix.h>
#include <stickslip/algebra/node_mask.h>
#include <stickslip/algebra/term_matrix.h>

#include <functional>
#include <map>
#include <vector>

namespace StickSlip
{
  /**
   * The nodes that carry the unknowns of a problem, or of one of its levels.
   */
  struct Unknowns
  {
    NodePartition nodes;

    /** The components that never take part, of owned nodes and ghosts. */
    NodeMask fixed;

    /**
     * The owned nodes with a nonsmooth term, in ascending order; on the coarser
     * levels the nodes that stand for such nodes.
     */
    std::vector<unsigned int> nonsmooth_nodes;
  };

  /**
   * The operator
   *
   *   A = sum_k coefficients[k] * terms[k]
   *
   * of a minimisation problem, where the terms stay and the coefficients
   * change, as with the step size of a time scheme, together with the unknowns
   * that it acts on.
   */
  template <int n_components>
  class OperatorSum
  {
  public:
    /** At least one term; all share one sparsity. */
    OperatorSum(const Unknowns                       &unknowns,
                std::vector<TermMatrix<n_components>> terms);

    OperatorSum(const OperatorSum &) = delete;

    OperatorSum &
    operator=(const OperatorSum &) = delete;

    /** Set A. */
    void
    combine(const std::vector<double> &coefficients);

    const Unknowns &
    unknowns() const
    {
      return unknowns_of_problem;
    }

    /** The operator A. */
    const BlockMatrix<n_components> &
    matrix() const
    {
      return A;
    }

    const std::vector<TermMatrix<n_components>> &
    terms() const
    {
      return summands;
    }

    const std::vector<double> &
    coefficients() const
    {
      return current_coefficients;
    }

    /** A number for the operator A: another one for other coefficients, the
     * same again where these return, and 0 before the first combine(). */
    unsigned long
    version() const;

    /** Carry out @p action on A + H, where H has a block for each nonsmooth
     * node. A is as before afterwards, whether or not @p action throws. */
    void
    with_hessians(
      const std::vector<Tensor<2, n_components>>                   &hessians,
      const std::function<void(const BlockMatrix<n_components> &)> &action);

    /** y += factor H x. */
    void
    add_hessians(NodalVector                                &y,
                 const double                                factor,
                 const std::vector<Tensor<2, n_components>> &hessians,
                 const NodalVector                          &x) const;

    /** Bytes on this process. */
    std::size_t
    memory_consumption() const;

  private:
    const Unknowns                              unknowns_of_problem;
    const std::vector<TermMatrix<n_components>> summands;
    BlockMatrix<n_components>                   A;
    std::vector<double>                         current_coefficients;
    /** Numbers of the operators so far, by their coefficients. */
    std::map<std::vector<double>, unsigned long> versions;
  };
} // namespace StickSlip

#endif
