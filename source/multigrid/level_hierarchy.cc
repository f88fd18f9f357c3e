// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/level_hierarchy.h>

namespace StickSlip
{
  namespace
  {
    /** Return whether two second derivatives differ by no more than @p
     * threshold times the second one, however small they are beside the matrix:
     * where nothing else holds the nonsmooth nodes, they count. A NaN is not
     * close. */
    template <int n_components>
    bool
    is_close(const Tensor<2, n_components> &a,
             const Tensor<2, n_components> &b,
             const double                   threshold)
    {
      return (a - b).norm() <= threshold * b.norm();
    }
  } // namespace



  template <int n_components>
  LevelHierarchy<n_components>::LevelHierarchy(
    OperatorSum<n_components>                  &operators,
    std::vector<LevelDescription<n_components>> descriptions)
    : A(operators)
    , levels(std::move(descriptions))
    , coarse_solver(CoarseSolverType::direct)
    , precision(CyclePrecision::single_precision)
  {
    const NodePartition &coarsest = levels.front().nodes;
    AssertThrow(coarsest.n_owned() == 0 ||
                  coarsest.n_owned() == coarsest.n_global(),
                ExcMessage("The coarsest level must belong to one process."));
    for (unsigned int l = 1; l < levels.size(); ++l)
      {
        const TransferMatrix &P = levels[l].to_coarser->prolongation();
        AssertThrow(P.row_frames() == levels[l].frames &&
                      P.column_frames() == levels[l - 1].frames,
                    ExcMessage("Transfers and levels must have the same axes "
                               "of nodes."));
      }
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::take_over_operator()
  {
    if (!cycle)
      {
        cycle = make_v_cycle(precision, levels, A.terms());
        cycle->set_smoothing_sweeps(sweeps);
        cycle->set_coarse_solver(coarse_solver);
      }
    else if (version == A.version())
      return;
    version      = A.version();
    coefficients = A.coefficients();
    cycle->set_operator(A);
    is_linearised     = false;
    coarse_levels_set = false;
    coarse_active     = finest().fixed;
    coarse_hessians.assign(finest().nonsmooth_nodes.size(),
                           Tensor<2, n_components>());
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::linearise(
    const std::vector<Tensor<2, n_components>> &hessians,
    const NodeMask                             &new_active)
  {
    const bool is_outdated = linearise_finest_level(hessians, new_active);
    linearise_coarse_levels(Utilities::MPI::max(static_cast<int>(is_outdated),
                                                finest().nodes.communicator()) >
                            0);
  }



  template <int n_components>
  bool
  LevelHierarchy<n_components>::linearise_finest_level(
    const std::vector<Tensor<2, n_components>> &hessians,
    const NodeMask                             &new_active)
  {
    const std::vector<unsigned int> &nodes = finest().nonsmooth_nodes;
    AssertDimension(hessians.size(), nodes.size());
    take_over_operator();
    const bool is_same = is_linearised && hessians == current_hessians &&
                         new_active.is_equal(active, finest().nodes.n_owned());
    is_linearised = false;
    active        = new_active;
    active.update_ghosts(finest().nodes);
    if (!is_same)
      {
        current_hessians = hessians;
        for (unsigned int k = 0; k < nodes.size(); ++k)
          cycle->set_finest_diagonal(nodes[k],
                                     A.matrix().diagonal_block(nodes[k]) +
                                       hessians[k],
                                     active);
      }
    return !coarse_levels_set ||
           !outdated_on_coarse_levels(update_threshold()).empty();
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::linearise_coarse_levels(const bool are_outdated)
  {
    if (are_outdated)
      // Smaller differences are not worth the rows around them.
      form_coarse_levels(outdated_on_coarse_levels(0.02 * update_threshold()));
    is_linearised = true;
  }



  template <int n_components>
  std::vector<unsigned int>
  LevelHierarchy<n_components>::outdated_on_coarse_levels(
    const double threshold) const
  {
    const std::vector<unsigned int> &nodes = finest().nonsmooth_nodes;
    std::vector<unsigned int>        outdated;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      if (!active.is_equal_at(coarse_active, nodes[k]) ||
          !is_close(current_hessians[k], coarse_hessians[k], threshold))
        outdated.push_back(k);
    return outdated;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::form_coarse_levels(
    const std::vector<unsigned int> &outdated)
  {
    const std::vector<unsigned int> &nodes = finest().nonsmooth_nodes;
    // The rows of S (A + H) S that change. A mask also counts in those that
    // are coupled to the node.
    std::vector<unsigned int> changed, masked;
    for (const unsigned int k : outdated)
      {
        coarse_hessians[k] = current_hessians[k];
        changed.push_back(nodes[k]);
        if (!active.is_equal_at(coarse_active, nodes[k]))
          masked.push_back(nodes[k]);
      }
    for (const unsigned int i : A.matrix().sparsity().coupled_to(masked))
      changed.push_back(i);
    make_set(changed);
    coarse_active = active;

    coarse_levels_set = false;
    A.with_hessians(coarse_hessians,
                    [&](const BlockMatrix<n_components> &linearised) {
                      cycle->set_coarse_levels(linearised, active, changed);
                    });
    coarse_levels_set = true;
  }



  template <int n_components>
  KeptLinearisation<n_components>
  LevelHierarchy<n_components>::kept_linearisation() const
  {
    KeptLinearisation<n_components> kept;
    if (!cycle)
      return kept;
    kept.coefficients = coefficients;
    kept.is_set       = coarse_levels_set;
    if (kept.is_set)
      {
        kept.hessians    = coarse_hessians;
        kept.active      = coarse_active;
        kept.formed_rows = cycle->formed_rows();
      }
    return kept;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::recall(
    const KeptLinearisation<n_components> &kept)
  {
    take_over_operator();
    // Another solver's says nothing here.
    if (!kept.is_set || kept.active.n_nodes() != finest().nodes.n_local())
      return;
    coarse_hessians = kept.hessians;
    coarse_active   = kept.active;
    A.with_hessians(coarse_hessians,
                    [&](const BlockMatrix<n_components> &linearised) {
                      cycle->recall_coarse_levels(linearised,
                                                  coarse_active,
                                                  kept.formed_rows);
                    });
    coarse_levels_set = true;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::vmult_linearised(NodalVector       &y,
                                                 const NodalVector &x) const
  {
    A.matrix().vmult(y, x);
    A.add_hessians(y, 1., current_hessians, x);
    active.apply(y);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::v_cycle(NodalVector &x, const NodalVector &b)
  {
    v_cycle(x, b, b.linfty_norm());
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::v_cycle(NodalVector       &x,
                                        const NodalVector &b,
                                        const double       size)
  {
    Assert(is_linearised && version == A.version(),
           ExcMessage("linearise() comes first."));
    cycle->vmult(x, b, size, active);
  }



  template <int n_components>
  BlockMatrix<n_components>
  LevelHierarchy<n_components>::level_matrix(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    if (l + 1 == levels.size())
      return A.matrix();
    Assert(cycle, ExcMessage("linearise() comes first."));
    return cycle->coarse_matrix(l);
  }



  template <int n_components>
  BlockMatrix<n_components>
  LevelHierarchy<n_components>::operator_on_level(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    if (l + 1 == levels.size())
      return A.matrix();
    Assert(cycle && version == A.version(),
           ExcMessage("take_over_operator() comes first."));
    return cycle->combine_coarse(l, coefficients);
  }



  template <int n_components>
  Tensor<2, n_components>
  LevelHierarchy<n_components>::diagonal_on_level(const unsigned int l,
                                                  const unsigned int row) const
  {
    AssertIndexRange(l, levels.size());
    if (l + 1 == levels.size())
      return A.matrix().diagonal_block(row);
    Assert(cycle && version == A.version(),
           ExcMessage("take_over_operator() comes first."));
    return cycle->combine_coarse_diagonal(l, coefficients, row);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::set_coarse_update_threshold(
    const double threshold)
  {
    coarse_update_threshold = threshold;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::set_coarse_solver(const CoarseSolverType type)
  {
    if (type == coarse_solver)
      return;
    coarse_solver     = type;
    is_linearised     = false;
    coarse_levels_set = false;
    if (cycle)
      cycle->set_coarse_solver(type);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::set_cycle_precision(
    const CyclePrecision new_precision)
  {
    if (new_precision == precision)
      return;
    precision     = new_precision;
    is_linearised = false;
    cycle.reset();
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::set_smoothing_sweeps(const unsigned int n)
  {
    sweeps = n;
    if (cycle)
      cycle->set_smoothing_sweeps(n);
  }



  template <int n_components>
  std::size_t
  LevelHierarchy<n_components>::memory_consumption() const
  {
    std::size_t bytes = A.memory_consumption();
    for (const LevelDescription<n_components> &level : levels)
      {
        bytes += level.frames.memory_consumption();
        if (level.to_coarser)
          bytes += level.to_coarser->memory_consumption();
      }
    if (cycle)
      bytes += cycle->memory_consumption();
    return bytes;
  }



  template class LevelHierarchy<1>;
  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
} // namespace StickSlip
