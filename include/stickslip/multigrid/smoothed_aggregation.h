// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_smoothed_aggregation_h
#define stickslip_multigrid_smoothed_aggregation_h

#include <stickslip/algebra/trilinos_system.h>

#include <memory>
#include <vector>

namespace ML_Epetra
{
  class MultiLevelPreconditioner;
}

namespace StickSlip
{
  /**
   * Cycles of smoothed aggregation with ML of Trilinos for a block matrix of
   * one process, with rows and columns of masked components replaced by those
   * of the identity: a symmetric linear map of the right hand side.
   */
  template <int n_components>
  class SmoothedAggregation
  {
  public:
    /** @p n_cycles in each application. Without a @p near_null_space it
     * consists of the translations. */
    explicit SmoothedAggregation(
      const unsigned int              n_cycles,
      const std::vector<NodalVector> &near_null_space = {});

    ~SmoothedAggregation();

    /** Return whether there are cycles. */
    bool
    is_set() const
    {
      return cycles != nullptr;
    }

    /** Make the cycles for a matrix; returns whether they could be made. */
    bool
    set_matrix(const BlockMatrix<n_components> &matrix, const NodeMask &mask);

    /** x = an approximation of A^-1 b. */
    void
    vmult(NodalVector &x, const NodalVector &b);

  private:
    const unsigned int n_cycles;
    /** Mode after mode, as ML wants them. */
    std::vector<double>                                  null_space;
    const unsigned int                                   n_modes;
    TrilinosSystem<n_components>                         system;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> cycles;
  };
} // namespace StickSlip

#endif
