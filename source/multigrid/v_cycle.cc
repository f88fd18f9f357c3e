// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <stickslip/base/flush_to_zero.h>
#include <stickslip/multigrid/cycle_operators.h>
#include <stickslip/multigrid/v_cycle.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace StickSlip
{
  namespace
  {
    template <int n_components, typename Number>
    class VCycleIn : public VCycle<n_components>
    {
    public:
      VCycleIn(const std::vector<LevelDescription<n_components>> &descriptions,
               const std::vector<TermMatrix<n_components>>       &terms);

      void
      set_operator(const OperatorSum<n_components> &A) override;

      void
      set_finest_diagonal(const unsigned int             i,
                          const Tensor<2, n_components> &block,
                          const NodeMask                &active) override;

      void
      set_coarse_levels(const BlockMatrix<n_components> &A,
                        const NodeMask                  &active,
                        const std::vector<unsigned int> &changed) override;

      std::vector<std::vector<unsigned int>>
      formed_rows() const override;

      void
      recall_coarse_levels(
        const BlockMatrix<n_components>              &A,
        const NodeMask                               &active,
        const std::vector<std::vector<unsigned int>> &formed) override;

      void
      vmult(NodalVector       &x,
            const NodalVector &b,
            const double       size,
            const NodeMask    &active) override;

      BlockMatrix<n_components>
      coarse_matrix(const unsigned int l) const override;

      BlockMatrix<n_components>
      combine_coarse(const unsigned int         l,
                     const std::vector<double> &coefficients) const override;

      Tensor<2, n_components>
      combine_coarse_diagonal(const unsigned int         l,
                              const std::vector<double> &coefficients,
                              const unsigned int         row) const override;

      void
      set_smoothing_sweeps(const unsigned int sweeps) override;

      void
      set_coarse_solver(const CoarseSolverType type) override;

      std::size_t
      memory_consumption() const override;

    private:
      struct Level
      {
        NodeValues<Number> solution, rhs, residual, change;
      };

      void
      factorise_coarsest_level();

      void
      cycle(const unsigned int l, const NodeMask &active);

      /** The sweeps before the coarser level, and the residual. */
      void
      smooth_from_zero(const unsigned int l);

      void
      smooth_backward(const unsigned int l);

      void
      solve_coarsest_level();

      const std::vector<LevelDescription<n_components>> &descriptions;
      CycleOperators<n_components, Number>               operators;
      std::vector<Level>                                 levels;
      /** Only where the coarsest level is. */
      std::unique_ptr<CoarseSolver<n_components>> coarse_solver;
      NodalVector  coarsest_solution, coarsest_rhs;
      unsigned int sweeps = 1;
    };



    template <int n_components, typename Number>
    BlockMatrix<n_components>
    in_double_precision(const BlockMatrix<n_components, Number> &matrix)
    {
      BlockMatrix<n_components> result(matrix.shared_sparsity());
      std::copy(matrix.values().begin(),
                matrix.values().end(),
                result.values().begin());
      return result;
    }



    template <int n_components, typename Number>
    VCycleIn<n_components, Number>::VCycleIn(
      const std::vector<LevelDescription<n_components>> &descriptions,
      const std::vector<TermMatrix<n_components>>       &terms)
      : descriptions(descriptions)
      , operators(descriptions, terms)
      , levels(descriptions.size())
      , coarse_solver(
          make_coarse_solver<n_components>(CoarseSolverType::direct,
                                           descriptions.front().nodes,
                                           descriptions.front().frames))
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



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::set_operator(
      const OperatorSum<n_components> &A)
    {
      operators.set_operator(A);
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::set_finest_diagonal(
      const unsigned int             i,
      const Tensor<2, n_components> &block,
      const NodeMask                &active)
    {
      operators.set_finest_diagonal(i, block, active);
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::set_coarse_levels(
      const BlockMatrix<n_components> &A,
      const NodeMask                  &active,
      const std::vector<unsigned int> &changed)
    {
      operators.set_coarse_levels(A, active, changed);
      factorise_coarsest_level();
    }



    template <int n_components, typename Number>
    std::vector<std::vector<unsigned int>>
    VCycleIn<n_components, Number>::formed_rows() const
    {
      return operators.formed_rows();
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::recall_coarse_levels(
      const BlockMatrix<n_components>              &A,
      const NodeMask                               &active,
      const std::vector<std::vector<unsigned int>> &formed)
    {
      operators.recall_coarse_levels(A, active, formed);
      factorise_coarsest_level();
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::factorise_coarsest_level()
    {
      // One process does this, and all must know how it ended.
      int is_singular = 0;
      try
        {
          if (operators.coarse_matrix(0).n_rows() > 0)
            coarse_solver->set_matrix(coarse_matrix(0), operators.active(0));
        }
      catch (const SingularCoarseMatrix &)
        {
          is_singular = 1;
        }
      if (Utilities::MPI::max(is_singular,
                              descriptions.front().nodes.communicator()) > 0)
        throw SingularCoarseMatrix();
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::vmult(NodalVector       &x,
                                          const NodalVector &b,
                                          const double       size,
                                          const NodeMask    &active)
    {
      // Single precision has no room for numbers as small as 1e-40, which
      // nothing forbids, so the right hand side is scaled: by a power of two,
      // which changes no digit.
      double scale = 1.;
      if (std::is_same<Number, float>::value)
        {
          if (size < std::numeric_limits<double>::min())
            {
              x = 0.;
              return;
            }
          scale = std::isfinite(size) ? std::exp2(std::ilogb(size)) : size;
        }
      const FlushToZero  flush;
      Level             &finest  = levels.back();
      const unsigned int n       = b.locally_owned_size();
      const double       inverse = 1. / scale;
      for (unsigned int i = 0; i < n; ++i)
        finest.rhs.local_element(i) = Number(b.local_element(i) * inverse);
      operators.factorise_smoothers();
      cycle(levels.size() - 1, active);
      for (unsigned int i = 0; i < n; ++i)
        x.local_element(i) = finest.solution.local_element(i) * scale;
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::smooth_from_zero(const unsigned int l)
    {
      Level                                        &level = levels[l];
      const BlockGaussSeidel<n_components, Number> &smoother =
        operators.smoother(l);
      const CutPatches<n_components, Number> &cuts = operators.cut_patches(l);
      if (sweeps == 1 && cuts.are_empty())
        {
          smoother.sweep_from_zero(level.solution, level.rhs);
          smoother.residual_after_first_sweep(level.residual,
                                              level.solution,
                                              level.rhs);
          return;
        }
      if (level.change.size() == 0)
        level.change = level.solution;
      for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
        {
          if (sweep == 0 && cuts.are_empty())
            {
              smoother.sweep_from_zero(level.solution, level.rhs);
              continue;
            }
          if (sweep == 0)
            cuts.relax_from_zero(level.solution,
                                 level.residual,
                                 level.rhs,
                                 smoother);
          else
            cuts.relax(/*is_forward=*/true,
                       level.solution,
                       level.residual,
                       level.rhs,
                       smoother);
          smoother.sweep_forward(level.solution, level.change, level.rhs);
        }
      smoother.residual_after_sweep(level.residual,
                                    level.solution,
                                    level.change,
                                    level.rhs);
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::smooth_backward(const unsigned int l)
    {
      Level                                        &level = levels[l];
      const BlockGaussSeidel<n_components, Number> &smoother =
        operators.smoother(l);
      for (unsigned int sweep = 0; sweep < sweeps; ++sweep)
        {
          smoother.sweep_backward(level.solution, level.rhs);
          operators.cut_patches(l).relax(/*is_forward=*/false,
                                         level.solution,
                                         level.residual,
                                         level.rhs,
                                         smoother);
        }
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::cycle(const unsigned int l,
                                          const NodeMask    &active)
    {
      if (l == 0)
        {
          solve_coarsest_level();
          return;
        }
      Level                &level        = levels[l];
      Level                &coarse       = levels[l - 1];
      const NodeMask       &active_below = operators.active(l - 1);
      const TransferMatrix &P = descriptions[l].to_coarser->prolongation();

      smooth_from_zero(l);
      active.apply(level.residual);

      const MiddleNodes<n_components> &middles = operators.middle_nodes(l);
      P.restrict_to(coarse.rhs, level.residual, n_components);
      middles.restrict_add(coarse.rhs, level.residual);
      active_below.apply(coarse.rhs);
      cycle(l - 1, active_below);
      P.prolongate_add(level.solution, coarse.solution, n_components);
      middles.prolongate_add(level.solution, coarse.solution);
      active.apply(level.solution);

      smooth_backward(l);
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::solve_coarsest_level()
    {
      Level &level = levels.front();
      if (operators.coarse_matrix(0).n_rows() > 0)
        {
          coarsest_rhs.copy_locally_owned_data_from(level.rhs);
          coarse_solver->solve(coarsest_solution, coarsest_rhs);
          level.solution.copy_locally_owned_data_from(coarsest_solution);
        }
      operators.active(0).apply(level.solution);
    }



    template <int n_components, typename Number>
    BlockMatrix<n_components>
    VCycleIn<n_components, Number>::coarse_matrix(const unsigned int l) const
    {
      return in_double_precision(operators.coarse_matrix(l));
    }



    template <int n_components, typename Number>
    BlockMatrix<n_components>
    VCycleIn<n_components, Number>::combine_coarse(
      const unsigned int         l,
      const std::vector<double> &coefficients) const
    {
      BlockMatrix<n_components, Number> sum(
        operators.coarse_matrix(l).shared_sparsity());
      operators.combine_coarse(l, coefficients, sum);
      return in_double_precision(sum);
    }



    template <int n_components, typename Number>
    Tensor<2, n_components>
    VCycleIn<n_components, Number>::combine_coarse_diagonal(
      const unsigned int         l,
      const std::vector<double> &coefficients,
      const unsigned int         row) const
    {
      return operators.combine_coarse_diagonal(l, coefficients, row);
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::set_smoothing_sweeps(const unsigned int n)
    {
      sweeps = n;
    }



    template <int n_components, typename Number>
    void
    VCycleIn<n_components, Number>::set_coarse_solver(
      const CoarseSolverType type)
    {
      coarse_solver =
        make_coarse_solver<n_components>(type,
                                         descriptions.front().nodes,
                                         descriptions.front().frames);
    }



    template <int n_components, typename Number>
    std::size_t
    VCycleIn<n_components, Number>::memory_consumption() const
    {
      std::size_t bytes = operators.memory_consumption();
      for (const Level &level : levels)
        bytes += sizeof(Number) * 3 * level.rhs.locally_owned_size();
      return bytes;
    }
  } // namespace



  template <int n_components>
  std::unique_ptr<VCycle<n_components>>
  make_v_cycle(const CyclePrecision                               precision,
               const std::vector<LevelDescription<n_components>> &levels,
               const std::vector<TermMatrix<n_components>>       &terms)
  {
    if (precision == CyclePrecision::single_precision)
      return std::make_unique<VCycleIn<n_components, float>>(levels, terms);
    return std::make_unique<VCycleIn<n_components, double>>(levels, terms);
  }



#define STICKSLIP_INSTANTIATE(n_components)                                  \
  template class VCycle<n_components>;                                       \
  template std::unique_ptr<VCycle<n_components>> make_v_cycle<n_components>( \
    const CyclePrecision,                                                    \
    const std::vector<LevelDescription<n_components>> &,                     \
    const std::vector<TermMatrix<n_components>> &);

  STICKSLIP_INSTANTIATE(1)
  STICKSLIP_INSTANTIATE(2)
  STICKSLIP_INSTANTIATE(3)
} // namespace StickSlip
