// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_multigrid_kept_linearisation_h
#define stickslip_multigrid_kept_linearisation_h

#include <deal.II/base/tensor.h>

#include <stickslip/algebra/node_mask.h>

#include <vector>

namespace StickSlip
{
  /**
   * A linearisation that a solver has made in one problem and goes on to use
   * in later ones, as a preconditioner. With it another solver for the same
   * operators goes on with the same bits, on the same number of processes.
   * Numbers of nodes and rows are local.
   */
  template <int n_components>
  struct KeptLinearisation
  {
    /** The coefficients of the operator. */
    std::vector<double> coefficients;

    /** False where only the operator is kept. */
    bool is_set = false;

    /** Second derivatives at the nonsmooth nodes. */
    std::vector<Tensor<2, n_components>> hessians;

    /** The components that take part. */
    NodeMask active;

    /** Rows of each coarse level, the coarsest first, that have been formed
     * since the operator was set; where that is not all that can be. */
    std::vector<std::vector<unsigned int>> formed_rows;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &coefficients &is_set &hessians &active &formed_rows;
    }
  };
} // namespace StickSlip

#endif
