// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/algebra/flush_to_zero.h>
#include <stickslip/algebra/make_set.h>
#include <stickslip/tnnmg/block_gauss_seidel.h>
#include <stickslip/tnnmg/v_cycle.h>

#include <limits>
#include <type_traits>

namespace StickSlip
{
  namespace
  {
    template <int dim, typename Number>
    class VCycleIn : public VCycle<dim>
    {
    public:
      explicit VCycleIn(const std::vector<LevelDescription<dim>> &descriptions);

      void
      set_terms(const std::vector<BlockMatrix<dim>> &finest) override;

      void
      combine_coarse_levels(const std::vector<double> &coefficients) override;

      void
      set_finest_row(const BlockMatrix<dim> &A,
                     const unsigned int      i,
                     const Tensor<2, dim>   &inverse_diagonal) override;

      void
      set_finest_diagonal(const unsigned int    i,
                          const Tensor<2, dim> &block,
                          const NodeMask       &active) override;

      void
      set_coarse_levels(const BlockMatrix<dim>          &A,
                        const NodeMask                  &active,
                        const std::vector<unsigned int> &changed) override;

      void
      vmult(NodalVector       &x,
            const NodalVector &b,
            const NodeMask    &active) override;

      BlockMatrix<dim>
      coarse_matrix(const unsigned int l) const override;

      void
      set_smoothing_sweeps(const unsigned int sweeps) override;

      void
      set_coarse_solver(const CoarseSolverType type) override;

      std::size_t
      memory_consumption() const override;

    private:
      struct Level
      {
        BlockGaussSeidel<dim, Number> smoother;
        NodeValues<Number>            solution, rhs, residual, change;

        /** The rest is of coarse levels only. */
        std::vector<BlockMatrix<dim, Number>> terms;
        BlockMatrix<dim, Number>              matrix;
        /** On several processes: the owned rows that a change of the
         * nonsmooth term or of the truncation can touch. */
        std::vector<unsigned int> strip;
        NodeMask                  active;
      };

      template <typename FineNumber>
      void
      compute_coarser_terms(
        const unsigned int                               l,
        const std::vector<BlockMatrix<dim, FineNumber>> &fine_terms);

      /** @p sparsity is that of the finest level. */
      void
      find_strips(const BlockSparsity &sparsity);

      /** The operator on the level below @p l from that on it, where that has
       * changed; replaces the @p changed rows by those of the coarser
       * level. */
      template <typename FineNumber>
      void
      set_coarser_level(const unsigned int                  l,
                        const BlockMatrix<dim, FineNumber> &matrix,
                        const NodeMask                     &active,
                        std::vector<unsigned int>          &changed);

      /** Form rows of the operator on the level below @p l, at least those
       * that depend on the @p changed ones; returns which. */
      template <typename FineNumber>
      std::vector<unsigned int>
      form_coarse_rows(const unsigned int                  l,
                       const BlockMatrix<dim, FineNumber> &matrix,
                       const NodeMask                     &active,
                       const std::vector<unsigned int>    &changed);

      void
      factorise_coarsest_level();

      void
      cycle(const unsigned int l, const NodeMask &active);

      void
      solve_coarsest_level();

      const std::vector<LevelDescription<dim>> &descriptions;
      /** Whether there are several processes. */
      const bool         is_shared;
      std::vector<Level> levels;
      /** Only where the coarsest level is. */
      std::unique_ptr<CoarseSolver<dim>> coarse_solver;
      NodalVector                        coarsest_solution, coarsest_rhs;
      unsigned int                       sweeps = 1;
    };



    template <int dim, typename Number>
    VCycleIn<dim, Number>::VCycleIn(
      const std::vector<LevelDescription<dim>> &descriptions)
      : descriptions(descriptions)
      , is_shared(Utilities::MPI::n_mpi_processes(
                    descriptions.back().nodes.communicator()) > 1)
      , levels(descriptions.size())
      , coarse_solver(make_coarse_solver<dim>(CoarseSolverType::direct))
      , coarsest_solution(
          descriptions.front().nodes.template make_vector<double>())
      , coarsest_rhs(coarsest_solution)
    {
      for (unsigned int l = 0; l < levels.size(); ++l)
        {
          Level &level   = levels[l];
          level.solution = descriptions[l].nodes.template make_vector<Number>();
          level.rhs      = level.solution;
          level.residual = level.solution;
        }
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_terms(
      const std::vector<BlockMatrix<dim>> &finest)
    {
      for (unsigned int l = 0; l < levels.size(); ++l)
        levels[l].active = descriptions[l].fixed;
      levels.back().smoother =
        BlockGaussSeidel<dim, Number>(finest.front().sparsity());
      for (unsigned int l = levels.size() - 1; l > 0; --l)
        {
          if (l + 1 == levels.size())
            compute_coarser_terms(l, finest);
          else
            compute_coarser_terms(l, levels[l].terms);
          Level &coarse = levels[l - 1];
          coarse.matrix = BlockMatrix<dim, Number>(
            descriptions[l].to_coarser->coarse_sparsity());
          if (l > 1)
            coarse.smoother =
              BlockGaussSeidel<dim, Number>(coarse.matrix.sparsity());
        }
      if (levels.size() == 1)
        levels.front().matrix =
          BlockMatrix<dim, Number>(finest.front().shared_sparsity());
      if (is_shared)
        find_strips(finest.front().sparsity());
    }



    template <int dim, typename Number>
    template <typename FineNumber>
    void
    VCycleIn<dim, Number>::compute_coarser_terms(
      const unsigned int                               l,
      const std::vector<BlockMatrix<dim, FineNumber>> &fine_terms)
    {
      GalerkinProduct<dim> &product = *descriptions[l].to_coarser;
      Level                &coarse  = levels[l - 1];
      const std::vector<BlockMatrix<dim, Number>> before =
        std::move(coarse.terms);
      coarse.terms.clear();
      for (unsigned int k = 0; k < fine_terms.size(); ++k)
        {
          const BlockMatrix<dim, FineNumber> &term = fine_terms[k];
          coarse.terms.emplace_back(product.coarse_sparsity());
          if (product.is_update() && !before.empty())
            product.update(term,
                           descriptions[l].fixed,
                           before[k],
                           coarse.terms.back());
          else
            product.compute(term, descriptions[l].fixed, coarse.terms.back());
        }
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::find_strips(const BlockSparsity &sparsity)
    {
      std::vector<bool> strip = find_strip(descriptions.back(), sparsity);
      for (unsigned int l = levels.size() - 1; l-- > 0;)
        {
          const LevelDescription<dim> &finer = descriptions[l + 1];
          strip                              = find_strip(descriptions[l],
                             levels[l].matrix.sparsity(),
                             finer,
                             strip);
          finer.to_coarser->select_rows(strip);
          levels[l].strip.clear();
          for (unsigned int i = 0; i < levels[l].matrix.n_rows(); ++i)
            if (strip[i])
              levels[l].strip.push_back(i);
        }
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::combine_coarse_levels(
      const std::vector<double> &coefficients)
    {
      for (unsigned int l = 0; l + 1 < levels.size(); ++l)
        {
          Level             &level = levels[l];
          const unsigned int n     = level.matrix.n_rows();
          level.matrix.combine(coefficients, level.terms, 0, n);
          level.active = descriptions[l].fixed;
          if (l > 0)
            for (unsigned int i = 0; i < n; ++i)
              {
                level.smoother.set_row(i, level.matrix);
                level.smoother.set_diagonal(i,
                                            level.matrix.diagonal_block(i),
                                            descriptions[l].fixed);
              }
        }
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_finest_row(
      const BlockMatrix<dim> &A,
      const unsigned int      i,
      const Tensor<2, dim>   &inverse_diagonal)
    {
      levels.back().smoother.set_row(i, A);
      levels.back().smoother.set_inverse_diagonal(i, inverse_diagonal);
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_finest_diagonal(const unsigned int    i,
                                               const Tensor<2, dim> &block,
                                               const NodeMask       &active)
    {
      levels.back().smoother.set_diagonal(i, block, active);
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_coarse_levels(
      const BlockMatrix<dim>          &A,
      const NodeMask                  &active,
      const std::vector<unsigned int> &changed)
    {
      if (levels.size() == 1)
        {
          // The coarsest level is the finest one.
          std::copy(A.values().begin(),
                    A.values().end(),
                    levels.front().matrix.values().begin());
          levels.front().active = active;
        }
      std::vector<unsigned int> changed_on_level = changed;
      for (unsigned int l = levels.size() - 1; l > 0; --l)
        if (l + 1 == levels.size())
          set_coarser_level(l, A, active, changed_on_level);
        else
          set_coarser_level(l,
                            levels[l].matrix,
                            levels[l].active,
                            changed_on_level);
      factorise_coarsest_level();
    }



    template <int dim, typename Number>
    template <typename FineNumber>
    void
    VCycleIn<dim, Number>::set_coarser_level(
      const unsigned int                  l,
      const BlockMatrix<dim, FineNumber> &matrix,
      const NodeMask                     &active,
      std::vector<unsigned int>          &changed)
    {
      Level                    &coarse = levels[l - 1];
      std::vector<unsigned int> rows =
        form_coarse_rows(l, matrix, active, changed);

      const NodeMask before = std::move(coarse.active);
      coarse.active =
        coarsen_mask(descriptions[l - 1], descriptions[l], active);
      if (!is_shared)
        {
          // A mask also counts in the rows that are coupled to its node.
          std::vector<unsigned int> masked;
          for (const unsigned int i : descriptions[l - 1].nonsmooth_nodes)
            if (!coarse.active.is_equal_at(before, i))
              masked.push_back(i);
          if (!masked.empty())
            {
              masked = coarse.matrix.sparsity().coupled_to(masked);
              rows.insert(rows.end(), masked.begin(), masked.end());
              make_set(rows);
            }
        }
      changed = std::move(rows);

      if (l > 1)
        for (const unsigned int i : changed)
          {
            coarse.smoother.set_row(i, coarse.matrix);
            coarse.smoother.set_diagonal(i,
                                         coarse.matrix.diagonal_block(i),
                                         coarse.active);
          }
    }



    template <int dim, typename Number>
    template <typename FineNumber>
    std::vector<unsigned int>
    VCycleIn<dim, Number>::form_coarse_rows(
      const unsigned int                  l,
      const BlockMatrix<dim, FineNumber> &matrix,
      const NodeMask                     &active,
      const std::vector<unsigned int>    &changed)
    {
      GalerkinProduct<dim> &product = *descriptions[l].to_coarser;
      Level                &coarse  = levels[l - 1];
      if (is_shared)
        {
          // To agree on rows takes longer than to form them.
          product.compute_selected_rows(matrix, active, coarse.matrix);
          return coarse.strip;
        }
      std::vector<unsigned int> rows = product.rows_from(changed);
      product.compute_rows(matrix, active, rows, coarse.matrix);
      return rows;
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::factorise_coarsest_level()
    {
      // One process does this, and all must know how it ended.
      const Level &coarsest    = levels.front();
      int          is_singular = 0;
      try
        {
          if (coarsest.matrix.n_rows() > 0)
            coarse_solver->set_matrix(coarse_matrix(0), coarsest.active);
        }
      catch (const SingularCoarseMatrix &)
        {
          is_singular = 1;
        }
      if (Utilities::MPI::max(is_singular,
                              descriptions.front().nodes.communicator()) > 0)
        throw SingularCoarseMatrix();
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::vmult(NodalVector       &x,
                                 const NodalVector &b,
                                 const NodeMask    &active)
    {
      // Single precision has no room for numbers like those of a fault at
      // rest, 1e-40, so the right hand side is scaled.
      double scale = 1.;
      if (std::is_same<Number, float>::value)
        {
          scale = b.linfty_norm();
          if (scale < std::numeric_limits<double>::min())
            {
              x = 0.;
              return;
            }
        }
      const FlushToZero  flush;
      Level             &finest  = levels.back();
      const unsigned int n       = b.locally_owned_size();
      const double       inverse = 1. / scale;
      for (unsigned int i = 0; i < n; ++i)
        finest.rhs.local_element(i) = Number(b.local_element(i) * inverse);
      cycle(levels.size() - 1, active);
      for (unsigned int i = 0; i < n; ++i)
        x.local_element(i) = finest.solution.local_element(i) * scale;
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::cycle(const unsigned int l, const NodeMask &active)
    {
      if (l == 0)
        {
          solve_coarsest_level();
          return;
        }
      Level                               &level    = levels[l];
      Level                               &coarse   = levels[l - 1];
      const BlockGaussSeidel<dim, Number> &smoother = level.smoother;
      const TransferMatrix &P = descriptions[l].to_coarser->prolongation();

      smoother.sweep_from_zero(level.solution, level.rhs);
      if (sweeps == 1)
        smoother.residual_after_first_sweep(level.residual, level.solution);
      else
        {
          if (level.change.size() == 0)
            level.change = level.solution;
          for (unsigned int sweep = 1; sweep < sweeps; ++sweep)
            smoother.sweep_forward(level.solution, level.change, level.rhs);
          smoother.residual_after_sweep(level.residual, level.change);
        }
      active.apply(level.residual);

      P.restrict_to(coarse.rhs, level.residual, dim);
      coarse.active.apply(coarse.rhs);
      cycle(l - 1, coarse.active);
      P.prolongate_add(level.solution, coarse.solution, dim);
      active.apply(level.solution);

      for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
        smoother.sweep_backward(level.solution, level.rhs);
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::solve_coarsest_level()
    {
      Level &level = levels.front();
      if (level.matrix.n_rows() > 0)
        {
          coarsest_rhs.copy_locally_owned_data_from(level.rhs);
          coarse_solver->solve(coarsest_solution, coarsest_rhs);
          level.solution.copy_locally_owned_data_from(coarsest_solution);
        }
      level.active.apply(level.solution);
    }



    template <int dim, typename Number>
    BlockMatrix<dim>
    VCycleIn<dim, Number>::coarse_matrix(const unsigned int l) const
    {
      BlockMatrix<dim> result(levels[l].matrix.shared_sparsity());
      std::copy(levels[l].matrix.values().begin(),
                levels[l].matrix.values().end(),
                result.values().begin());
      return result;
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_smoothing_sweeps(const unsigned int n)
    {
      sweeps = n;
    }



    template <int dim, typename Number>
    void
    VCycleIn<dim, Number>::set_coarse_solver(const CoarseSolverType type)
    {
      coarse_solver = make_coarse_solver<dim>(type);
    }



    template <int dim, typename Number>
    std::size_t
    VCycleIn<dim, Number>::memory_consumption() const
    {
      std::size_t bytes = 0;
      for (const Level &level : levels)
        {
          bytes += level.smoother.memory_consumption() +
                   sizeof(Number) * 3 * level.rhs.locally_owned_size() +
                   level.matrix.memory_consumption();
          if (!level.terms.empty())
            bytes +=
              level.terms.size() * level.terms.front().memory_consumption() +
              level.matrix.sparsity().memory_consumption();
        }
      return bytes;
    }
  } // namespace



  template <int dim>
  std::unique_ptr<VCycle<dim>>
  make_v_cycle(const CyclePrecision                      precision,
               const std::vector<LevelDescription<dim>> &levels)
  {
    if (precision == CyclePrecision::single_precision)
      return std::make_unique<VCycleIn<dim, float>>(levels);
    return std::make_unique<VCycleIn<dim, double>>(levels);
  }



#define STICKSLIP_INSTANTIATE(dim)                         \
  template class VCycle<dim>;                              \
  template std::unique_ptr<VCycle<dim>> make_v_cycle<dim>( \
    const CyclePrecision, const std::vector<LevelDescription<dim>> &);

  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
