// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/make_set.h>
#include <stickslip/multigrid/block_gauss_seidel.h>
#include <stickslip/multigrid/level_hierarchy.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /** Whether two second derivatives differ by no more than @p threshold times
     * the second one. However small they are beside the matrix: they count
     * where a whole fault slides and nothing else holds it. A NaN is not
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
    std::vector<LevelDescription<n_components>> descriptions)
    : levels(std::move(descriptions))
  {
    const NodePartition &coarsest = levels.front().nodes;
    AssertThrow(coarsest.n_owned() == 0 ||
                  coarsest.n_owned() == coarsest.n_global(),
                ExcMessage("The coarsest level must belong to one process."));
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::set_terms(
    std::vector<BlockMatrix<n_components>> new_terms)
  {
    Assert(!new_terms.empty(), ExcMessage("At least one term is needed."));
    terms = std::move(new_terms);
    A     = BlockMatrix<n_components>(terms.front().shared_sparsity());
    inverse_diagonals.resize(std::size_t(A.n_rows()) * n_components *
                             n_components);
    current_coefficients.clear();
    versions.clear();
    cycle.reset();
    is_linearised = false;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::update(
    std::vector<LevelDescription<n_components>> new_levels,
    std::vector<BlockMatrix<n_components>>      new_terms)
  {
    AssertDimension(new_levels.size(), levels.size());
    levels                                       = std::move(new_levels);
    std::unique_ptr<VCycle<n_components>> before = std::move(cycle);
    set_terms(std::move(new_terms));
    cycle = std::move(before);
    if (cycle)
      cycle->set_terms(terms);
  }



  template <int n_components>
  BlockMatrix<n_components>
  LevelHierarchy<n_components>::release_term(const unsigned int k)
  {
    return std::move(terms[k]);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::combine(const std::vector<double> &coefficients)
  {
    AssertThrow(coefficients.size() == terms.size(),
                ExcDimensionMismatch(coefficients.size(), terms.size()));
    if (coefficients == current_coefficients)
      return;
    current_coefficients = coefficients;
    forget_linearisation();
    if (versions.emplace(coefficients, last_version + 1).second)
      ++last_version;
    // So few rows at a time that the cycle copies them from the cache.
    constexpr unsigned int n_rows = 512;
    for (unsigned int begin = 0; begin < A.n_rows(); begin += n_rows)
      combine_rows(begin, std::min(begin + n_rows, A.n_rows()));
    if (cycle)
      cycle->combine_coarse_levels(coefficients);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::combine_rows(const unsigned int begin,
                                             const unsigned int end)
  {
    A.combine(current_coefficients, terms, begin, end);
    for (unsigned int i = begin; i < end; ++i)
      {
        const Tensor<2, n_components> inverse =
          invert_active(A.diagonal_block(i), finest().fixed, i);
        double *target =
          &inverse_diagonals[std::size_t(i) * n_components * n_components];
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            target[c * n_components + d] = inverse[c][d];
        if (cycle)
          cycle->set_finest_row(A, i, inverse);
      }
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::prepare_cycle()
  {
    cycle = make_v_cycle(precision, levels);
    cycle->set_smoothing_sweeps(sweeps);
    cycle->set_coarse_solver(coarse_solver);
    cycle->set_terms(terms);
    cycle->combine_coarse_levels(current_coefficients);
    forget_linearisation();
    for (unsigned int i = 0; i < A.n_rows(); ++i)
      cycle->set_finest_row(
        A, i, invert_active(A.diagonal_block(i), finest().fixed, i));
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::forget_linearisation()
  {
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
    const std::vector<unsigned int> &nodes = finest().nonsmooth_nodes;
    AssertDimension(hessians.size(), nodes.size());
    if (!cycle)
      prepare_cycle();
    const bool is_same = is_linearised && hessians == current_hessians &&
                         new_active.is_equal(active, finest().nodes.n_owned());
    if (on_all_processes(is_same))
      return;
    is_linearised    = false;
    current_hessians = hessians;
    active           = new_active;
    active.update_ghosts(finest().nodes);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      cycle->set_finest_diagonal(nodes[k],
                                 A.diagonal_block(nodes[k]) + hessians[k],
                                 active);
    // The coarsest level must be exact where it is the only one.
    const double threshold = levels.size() > 1 ? coarse_update_threshold : 0.;
    if (!on_all_processes(coarse_levels_set &&
                          outdated_on_coarse_levels(threshold).empty()))
      // Whatever differs by less than this is not worth the rows around it.
      linearise_coarse_levels(outdated_on_coarse_levels(0.02 * threshold));
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
  LevelHierarchy<n_components>::linearise_coarse_levels(
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
    for (const unsigned int i : A.sparsity().coupled_to(masked))
      changed.push_back(i);
    make_set(changed);
    coarse_active = active;

    // A itself stays as it is: H is added for the time of the products.
    std::vector<Tensor<2, n_components>> diagonal(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        diagonal[k] = A.diagonal_block(nodes[k]);
        A.set_diagonal_block(nodes[k], diagonal[k] + coarse_hessians[k]);
      }
    const auto remove_hessians = [&]() {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        A.set_diagonal_block(nodes[k], diagonal[k]);
    };
    try
      {
        coarse_levels_set = false;
        cycle->set_coarse_levels(A, active, changed);
        coarse_levels_set = true;
      }
    catch (const SingularCoarseMatrix &)
      {
        remove_hessians();
        throw;
      }
    remove_hessians();
  }



  template <int n_components>
  bool
  LevelHierarchy<n_components>::on_all_processes(const bool condition) const
  {
    return Utilities::MPI::min(static_cast<int>(condition),
                               finest().nodes.communicator()) != 0;
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::vmult_linearised(NodalVector       &y,
                                                 const NodalVector &x) const
  {
    A.vmult(y, x);
    add_hessians(y, 1., finest().nonsmooth_nodes, current_hessians, x);
    active.apply(y);
  }



  template <int n_components>
  void
  LevelHierarchy<n_components>::v_cycle(NodalVector &x, const NodalVector &b)
  {
    Assert(is_linearised, ExcMessage("linearise() comes first."));
    ++cycle_count;
    cycle->vmult(x, b, active);
  }



  template <int n_components>
  const BlockMatrix<n_components> &
  LevelHierarchy<n_components>::matrix() const
  {
    return A;
  }



  template <int n_components>
  unsigned long
  LevelHierarchy<n_components>::operator_version() const
  {
    const auto version = versions.find(current_coefficients);
    return version == versions.end() ? 0 : version->second;
  }



  template <int n_components>
  const BlockMatrix<n_components> &
  LevelHierarchy<n_components>::term(const unsigned int k) const
  {
    return terms[k];
  }



  template <int n_components>
  const AlignedVector<double> &
  LevelHierarchy<n_components>::inverse_diagonal() const
  {
    return inverse_diagonals;
  }



  template <int n_components>
  const LevelDescription<n_components> &
  LevelHierarchy<n_components>::finest() const
  {
    return levels.back();
  }



  template <int n_components>
  const LevelDescription<n_components> &
  LevelHierarchy<n_components>::description(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    return levels[l];
  }



  template <int n_components>
  BlockMatrix<n_components>
  LevelHierarchy<n_components>::level_matrix(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    if (l + 1 == levels.size())
      return A;
    Assert(cycle, ExcMessage("linearise() comes first."));
    return cycle->coarse_matrix(l);
  }



  template <int n_components>
  unsigned int
  LevelHierarchy<n_components>::n_levels() const
  {
    return levels.size();
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
  unsigned long
  LevelHierarchy<n_components>::n_cycles() const
  {
    return cycle_count;
  }



  template <int n_components>
  std::size_t
  LevelHierarchy<n_components>::memory_consumption() const
  {
    std::size_t bytes = A.memory_consumption() * (1 + terms.size()) +
                        A.sparsity().memory_consumption() +
                        sizeof(double) * inverse_diagonals.size();
    for (const LevelDescription<n_components> &level : levels)
      if (level.to_coarser)
        bytes += level.to_coarser->memory_consumption();
    if (cycle)
      bytes += cycle->memory_consumption();
    return bytes;
  }



  template <int n_components>
  void
  add_hessians(NodalVector                                &y,
               const double                                factor,
               const std::vector<unsigned int>            &nodes,
               const std::vector<Tensor<2, n_components>> &hessians,
               const NodalVector                          &x)
  {
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int d = 0; d < n_components; ++d)
          y.local_element(nodes[k] * n_components + c) +=
            factor * hessians[k][c][d] *
            x.local_element(nodes[k] * n_components + d);
  }



#define STICKSLIP_INSTANTIATE(n_components)       \
  template class LevelHierarchy<n_components>;    \
  template void add_hessians<n_components>(       \
    NodalVector &,                                \
    const double,                                 \
    const std::vector<unsigned int> &,            \
    const std::vector<Tensor<2, n_components>> &, \
    const NodalVector &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
