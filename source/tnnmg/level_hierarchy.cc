// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/tnnmg/level_hierarchy.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /**
     * The inverse of the block of active components, zero elsewhere.
     */
    template <int dim>
    void
    invert_diagonal_block(const BlockMatrix<dim> &matrix,
                          const unsigned int      row,
                          const NodeMask         &active,
                          double                 *inverse)
    {
      Tensor<2, dim> block = matrix.diagonal_block(row);
      const bool     full  = active.is_fully_active(row);
      if (!full)
        for (unsigned int c = 0; c < dim; ++c)
          if (!active.is_active(row, c))
            {
              for (unsigned int d = 0; d < dim; ++d)
                block[c][d] = block[d][c] = 0.;
              block[c][c] = 1.;
            }
      block = invert(block);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          inverse[c * dim + d] =
            full || (active.is_active(row, c) && active.is_active(row, d)) ?
              block[c][d] :
              0.;
    }
  } // namespace



  template <int dim>
  LevelHierarchy<dim>::LevelHierarchy(
    std::vector<LevelDescription<dim>> descriptions)
    : coarse_solver_type(CoarseSolverType::direct)
    , coarse_solver(make_coarse_solver<dim>(coarse_solver_type))
  {
    levels.resize(descriptions.size());
    for (unsigned int l = 0; l < levels.size(); ++l)
      {
        Level &level      = levels[l];
        level.description = std::move(descriptions[l]);
        level.active      = level.description.fixed;
        level.solution    = level.description.nodes.make_vector();
        level.rhs         = level.solution;
        level.residual    = level.solution;
      }
    const NodePartition &coarsest = levels.front().description.nodes;
    AssertThrow(coarsest.n_owned() == 0 ||
                  coarsest.n_owned() == coarsest.n_global(),
                ExcMessage("The coarsest level must belong to one process."));
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_terms(std::vector<BlockMatrix<dim>> terms)
  {
    Assert(!terms.empty(), ExcMessage("At least one term is needed."));
    levels.back().terms = std::move(terms);
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        Level                &fine    = levels[l];
        Level                &coarse  = levels[l - 1];
        GalerkinProduct<dim> &product = *fine.description.to_coarser;
        coarse.terms.clear();
        for (const BlockMatrix<dim> &term : fine.terms)
          {
            coarse.terms.emplace_back(product.coarse_sparsity());
            product.compute(term, fine.description.fixed, coarse.terms.back());
          }
      }
    for (Level &level : levels)
      {
        level.matrix = BlockMatrix<dim>(level.terms.front().shared_sparsity());
        level.inverse_diagonal.resize(level.matrix.n_rows() * dim * dim);
      }
    current_coefficients.clear();
    versions.clear();
    find_strips();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::find_strips()
  {
    std::vector<bool> strip;
    for (unsigned int l = levels.size(); l-- > 0;)
      {
        Level               &level    = levels[l];
        const BlockSparsity &sparsity = level.matrix.sparsity();
        if (l + 1 == levels.size())
          strip = find_strip(level.description, sparsity);
        else
          {
            const LevelDescription<dim> &finer = levels[l + 1].description;
            strip = find_strip(level.description, sparsity, finer, strip);
            finer.to_coarser->select_rows(strip);
          }
        level.strip.clear();
        for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
          if (strip[i])
            level.strip.push_back(i);
      }
  }



  template <int dim>
  void
  LevelHierarchy<dim>::combine(const std::vector<double> &coefficients)
  {
    if (coefficients == current_coefficients)
      return;
    current_coefficients = coefficients;
    if (versions.emplace(coefficients, last_version + 1).second)
      ++last_version;
    for (Level &level : levels)
      {
        std::vector<const BlockMatrix<dim> *> terms;
        for (const BlockMatrix<dim> &term : level.terms)
          terms.push_back(&term);
        level.matrix.combine(coefficients, terms);
        for (unsigned int i = 0; i < level.matrix.n_rows(); ++i)
          invert_diagonal_block(level.matrix,
                                i,
                                level.description.fixed,
                                &level.inverse_diagonal[i * dim * dim]);
      }
    is_linearised = false;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::linearise(const std::vector<Tensor<2, dim>> &hessians,
                                 const NodeMask                    &active)
  {
    Level &finest = levels.back();
    AssertDimension(hessians.size(), finest.description.nonsmooth_nodes.size());
    const Change change = required_change(hessians, active);
    if (change == Change::nothing)
      return;
    current_hessians = hessians;
    is_linearised    = false;
    finest.active    = active;
    finest.active.update_ghosts(finest.description.nodes);

    // The finest matrix keeps the operator A itself: H is added for the time
    // of the product and stays in the inverse of the diagonal only.
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    std::vector<Tensor<2, dim>>      diagonal(nodes.size());
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        diagonal[k] = finest.matrix.diagonal_block(nodes[k]);
        finest.matrix.set_diagonal_block(nodes[k], diagonal[k] + hessians[k]);
        invert_diagonal_block(finest.matrix,
                              nodes[k],
                              active,
                              &finest.inverse_diagonal[nodes[k] * dim * dim]);
      }
    const auto remove_hessians = [&]() {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        finest.matrix.set_diagonal_block(nodes[k], diagonal[k]);
    };
    if (change == Change::everything)
      try
        {
          linearise_coarse_levels();
          coarse_hessians = hessians;
        }
      catch (const SingularCoarseMatrix &)
        {
          remove_hessians();
          throw;
        }
    remove_hessians();
    is_linearised = true;
  }



  template <int dim>
  typename LevelHierarchy<dim>::Change
  LevelHierarchy<dim>::required_change(
    const std::vector<Tensor<2, dim>> &hessians,
    const NodeMask                    &active) const
  {
    const Level &finest = levels.back();
    Change       change = Change::everything;
    if (is_linearised &&
        active.is_equal(finest.active, finest.description.nodes.n_owned()))
      {
        if (hessians == current_hessians)
          change = Change::nothing;
        else if (levels.size() > 1 && are_close(hessians, coarse_hessians))
          change = Change::finest_level;
      }
    return Change(Utilities::MPI::min(static_cast<int>(change),
                                      finest.description.nodes.communicator()));
  }



  template <int dim>
  bool
  LevelHierarchy<dim>::are_close(const std::vector<Tensor<2, dim>> &a,
                                 const std::vector<Tensor<2, dim>> &b) const
  {
    // A change far below the diagonal of the matrix is none, whatever it is
    // compared with.
    constexpr double                 negligible = 1e-2;
    const Level                     &finest     = levels.back();
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double size =
          b[k].norm() +
          negligible * finest.matrix.diagonal_block(nodes[k]).norm();
        // Written so that a NaN is not close.
        if (!((a[k] - b[k]).norm() <= coarse_update_threshold * size))
          return false;
      }
    return true;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::linearise_coarse_levels()
  {
    for (unsigned int l = levels.size() - 1; l > 0; --l)
      {
        Level &coarse = levels[l - 1];
        coarse.active = coarsen_mask(coarse.description,
                                     levels[l].description,
                                     levels[l].active,
                                     coarse.rhs);
        levels[l].description.to_coarser->compute_selected_rows(
          levels[l].matrix, levels[l].active, coarse.matrix);
        for (const unsigned int i : coarse.strip)
          invert_diagonal_block(coarse.matrix,
                                i,
                                coarse.active,
                                &coarse.inverse_diagonal[i * dim * dim]);
      }
    // One process does this, and all must know how it ended.
    const Level &coarsest    = levels.front();
    int          is_singular = 0;
    try
      {
        if (coarsest.matrix.n_rows() > 0)
          coarse_solver->set_matrix(coarsest.matrix, coarsest.active);
      }
    catch (const SingularCoarseMatrix &)
      {
        is_singular = 1;
      }
    if (Utilities::MPI::max(is_singular,
                            coarsest.description.nodes.communicator()) > 0)
      throw SingularCoarseMatrix();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::vmult_linearised(NodalVector       &y,
                                        const NodalVector &x) const
  {
    const Level &finest = levels.back();
    finest.matrix.vmult(y, x);
    const std::vector<unsigned int> &nodes = finest.description.nonsmooth_nodes;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          y.local_element(nodes[k] * dim + c) +=
            current_hessians[k][c][d] * x.local_element(nodes[k] * dim + d);
    finest.active.apply(y);
  }



  template <int dim>
  void
  LevelHierarchy<dim>::v_cycle(NodalVector &x, const NodalVector &b)
  {
    Assert(is_linearised, ExcMessage("linearise() comes first."));
    ++cycle_count;
    cycle(levels.size() - 1, x, b);
  }



  template <int dim>
  void
  LevelHierarchy<dim>::cycle(const unsigned int l,
                             NodalVector       &x,
                             const NodalVector &b)
  {
    Level &level = levels[l];
    if (l == 0)
      {
        if (level.matrix.n_rows() > 0)
          coarse_solver->solve(x, b);
        level.active.apply(x);
        return;
      }

    // On the finest level the diagonal of the matrix lacks H, see linearise().
    // Gauss-Seidel in the form x_i += D_i (b - A x)_i needs the whole
    // diagonal, so H is put there for the time of the cycle.
    const bool                       finest = (l + 1 == levels.size());
    const std::vector<unsigned int> &nodes  = level.description.nonsmooth_nodes;
    std::vector<Tensor<2, dim>>      diagonal;
    if (finest)
      {
        diagonal.resize(nodes.size());
        for (unsigned int k = 0; k < nodes.size(); ++k)
          {
            diagonal[k] = level.matrix.diagonal_block(nodes[k]);
            level.matrix.set_diagonal_block(nodes[k],
                                            diagonal[k] + current_hessians[k]);
          }
      }

    const Kernels::BlockRows A = level.matrix.rows();
    const unsigned int       n = level.matrix.n_rows();
    x                          = 0.;
    for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
      {
        // Zero is known.
        if (sweep > 0)
          update_ghosts(x);
        Kernels::gauss_seidel_forward<dim>(
          A, level.inverse_diagonal.data(), 0, n, b.begin(), x.begin());
      }

    level.matrix.residual(level.residual, b, x);
    level.active.apply(level.residual);
    Level                &coarse = levels[l - 1];
    const TransferMatrix &P      = level.description.to_coarser->prolongation();
    P.restrict_to(coarse.rhs, level.residual, dim);
    coarse.active.apply(coarse.rhs);
    cycle(l - 1, coarse.solution, coarse.rhs);
    P.prolongate_add(x, coarse.solution, dim);
    level.active.apply(x);

    for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
      {
        update_ghosts(x);
        Kernels::gauss_seidel_backward<dim>(
          A, level.inverse_diagonal.data(), 0, n, b.begin(), x.begin());
      }

    if (finest)
      for (unsigned int k = 0; k < nodes.size(); ++k)
        level.matrix.set_diagonal_block(nodes[k], diagonal[k]);
  }



  template <int dim>
  const BlockMatrix<dim> &
  LevelHierarchy<dim>::matrix() const
  {
    return levels.back().matrix;
  }



  template <int dim>
  unsigned long
  LevelHierarchy<dim>::operator_version() const
  {
    const auto version = versions.find(current_coefficients);
    return version == versions.end() ? 0 : version->second;
  }



  template <int dim>
  const BlockMatrix<dim> &
  LevelHierarchy<dim>::term(const unsigned int k) const
  {
    return levels.back().terms[k];
  }



  template <int dim>
  const AlignedVector<double> &
  LevelHierarchy<dim>::inverse_diagonal() const
  {
    return levels.back().inverse_diagonal;
  }



  template <int dim>
  const LevelDescription<dim> &
  LevelHierarchy<dim>::finest() const
  {
    return levels.back().description;
  }



  template <int dim>
  const LevelDescription<dim> &
  LevelHierarchy<dim>::description(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    return levels[l].description;
  }



  template <int dim>
  const BlockMatrix<dim> &
  LevelHierarchy<dim>::level_matrix(const unsigned int l) const
  {
    AssertIndexRange(l, levels.size());
    return levels[l].matrix;
  }



  template <int dim>
  unsigned int
  LevelHierarchy<dim>::n_levels() const
  {
    return levels.size();
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_coarse_update_threshold(const double threshold)
  {
    coarse_update_threshold = threshold;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_coarse_solver(const CoarseSolverType type)
  {
    if (type == coarse_solver_type)
      return;
    coarse_solver_type = type;
    coarse_solver      = make_coarse_solver<dim>(type);
    is_linearised      = false;
  }



  template <int dim>
  void
  LevelHierarchy<dim>::set_smoothing_sweeps(const unsigned int n)
  {
    sweeps = n;
  }



  template <int dim>
  unsigned long
  LevelHierarchy<dim>::n_cycles() const
  {
    return cycle_count;
  }



  template <int dim>
  std::size_t
  LevelHierarchy<dim>::memory_consumption() const
  {
    std::size_t bytes = 0;
    for (const Level &level : levels)
      {
        bytes += level.matrix.memory_consumption() +
                 level.matrix.sparsity().memory_consumption() +
                 (level.description.to_coarser ?
                    level.description.to_coarser->memory_consumption() :
                    0) +
                 sizeof(double) * (level.inverse_diagonal.size() +
                                   3 * level.rhs.locally_owned_size());
        for (const BlockMatrix<dim> &term : level.terms)
          bytes += term.memory_consumption();
      }
    return bytes;
  }



  template class LevelHierarchy<2>;
  template class LevelHierarchy<3>;
} // namespace StickSlip
