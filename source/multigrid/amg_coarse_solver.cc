// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/amg_coarse_solver.h>

namespace StickSlip
{
  namespace
  {
    /** The translations along the axes of space, in components along those of
     * the nodes. None where these are the same, which is what is assumed
     * without modes. */
    template <int n_components>
    std::vector<NodalVector>
    translations(const NodePartition &nodes, const LocalFrames &frames)
    {
      std::vector<NodalVector> modes;
      if (frames.empty())
        return modes;
      for (unsigned int d = 0; d < n_components; ++d)
        {
          modes.push_back(nodes.make_vector());
          for (unsigned int i = 0; i < nodes.n_owned(); ++i)
            {
              const double *R = frames.find(i);
              for (unsigned int c = 0; c < n_components; ++c)
                modes.back().local_element(i * n_components + c) =
                  (R != nullptr ? R[d * n_components + c] : double(c == d));
            }
        }
      return modes;
    }
  } // namespace



  template <int n_components>
  AMGCoarseSolver<n_components>::AMGCoarseSolver(const NodePartition &nodes,
                                                 const LocalFrames   &frames)
    : cycles(/*n_cycles=*/2, translations<n_components>(nodes, frames))
  {}



  template <int n_components>
  void
  AMGCoarseSolver<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    if (!cycles.set_matrix(matrix, mask))
      throw SingularCoarseMatrix();
  }



  template <int n_components>
  void
  AMGCoarseSolver<n_components>::solve(NodalVector &x, const NodalVector &b)
  {
    cycles.vmult(x, b);
  }



  template class AMGCoarseSolver<1>;
  template class AMGCoarseSolver<2>;
  template class AMGCoarseSolver<3>;
} // namespace StickSlip
