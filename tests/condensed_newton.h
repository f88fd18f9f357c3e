// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_condensed_newton_h
#define stickslip_tests_condensed_newton_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/mortar/jump_basis.h>

#include <cmath>

namespace StickSlip::Reference
{
  /**
   * Rate-and-state friction at one node of the fault, as a curve in a
   * parameter s that grows with the slip rate: j(s), and the force over load
   * a. Both forms are odd in s, and s is about ln(V/Vmin).
   */
  struct FrictionCurve
  {
    bool   is_truncated;
    double load_times_a;
    double log_min;

    double
    jump(const double s) const
    {
      if (!is_truncated)
        return 2. * std::exp(log_min) * std::sinh(s);
      const double size = (std::abs(s) <= 1.) ?
                            std::exp(log_min) * std::abs(s) :
                            std::exp(log_min + std::abs(s) - 1.);
      return std::copysign(size, s);
    }

    double
    jump_derivative(const double s) const
    {
      if (!is_truncated)
        return 2. * std::exp(log_min) * std::cosh(s);
      return std::exp(log_min + std::max(0., std::abs(s) - 1.));
    }

    double
    force(const double s) const
    {
      if (!is_truncated)
        return load_times_a * s;
      return load_times_a * std::copysign(std::max(0., std::abs(s) - 1.), s);
    }

    double
    force_derivative(const double s) const
    {
      return (is_truncated && std::abs(s) <= 1.) ? 0. : load_times_a;
    }

    double
    parameter_at(const double jump) const
    {
      const double y = std::log(std::abs(jump)) - log_min;
      if (jump == 0.)
        return 0.;
      // asinh(e^y / 2) is y where e^y overflows.
      const double s = is_truncated ?
                         (y > 0. ? 1. + y : std::exp(y)) :
                         (y > 40. ? y : std::asinh(std::exp(y) / 2.));
      return std::copysign(s, jump);
    }
  };



  /**
   * The rate problem of one time step, condensed to the tangential jumps on
   * the fault. The bodies are coupled by multipliers instead of a basis of
   * jumps: in
   *
   *   A u + G_n^T lambda_n + G_t^T lambda_t = f,   G_n u = 0,
   *
   * with nodal matrices and G the jumps by the mortar condition, all but
   * lambda_t is eliminated by a sparse factorisation. What remains,
   *
   *   G_t u = jump(0) - F lambda_t,    lambda_t = friction(G_t u),
   *
   * is solved by Newton's method in the parameters of the friction curves.
   */
  class CondensedNewton
  {
  public:
    /** Two bodies with one fault; @p given has the prescribed velocities. */
    CondensedNewton(const MeshLevel<2>   &level,
                    const JumpBasis<2>   &basis,
                    const BlockMatrix<2> &A,
                    const NodalVector    &f,
                    const NodeMask       &dirichlet,
                    const NodalVector    &given)
      : n_entries(f.size())
    {
      NodeMask active = dirichlet;
      for (unsigned int b = 0; b < level.bodies.size(); ++b)
        for (const auto &line : level.bodies[b]->bound_nodes().get_lines())
          active.mask_node(level.node(b, line.index));

      // The rows of G: one for the jump of each active slave node.
      const FaultContact<2> &contact = basis.faults().front();
      for (unsigned int k = 0; k < contact.slave.nodes.size(); ++k)
        if (contact.coupling.active[k])
          {
            const GlobalRow row = basis.to_jumps(contact.slave.nodes[k]);
            jump_rows.emplace_back(row.begin(), row.end());
            slave_nodes.push_back(contact.slave.nodes[k]);
          }
      factorise(A, active);

      Vector<double> rhs(n_entries + jump_rows.size());
      for (unsigned int i = 0; i < n_entries; ++i)
        rhs(i) = active.is_active(i / 2, i % 2) ? f.local_element(i) :
                                                  given.local_element(i);
      without_friction     = solve(rhs);
      const unsigned int n = jump_rows.size();
      flexibility.reinit(n, n);
      for (unsigned int k = 0; k < n; ++k)
        {
          Vector<double> unit(n_entries + n);
          for (const auto &entry : jump_rows[k])
            unit(2 * entry.first) = entry.second;
          responses.push_back(solve(unit));
          for (unsigned int m = 0; m < n; ++m)
            flexibility(m, k) = jump(responses.back(), m);
        }
      stiffness = flexibility;
      stiffness.gauss_jordan();
    }

    /** The slave nodes with a jump, in the order of the curves. */
    std::vector<unsigned int> slave_nodes;

    struct Solution
    {
      bool                converged  = false;
      unsigned int        iterations = 0;
      std::vector<double> parameters, jumps, forces;
      /** Nodal velocities. */
      Vector<double> velocity;
    };

    /** Newton's method from the given jumps. No parameter moves by more than
     * three in a step, that is, no slip rate by more than e^3. */
    Solution
    minimise(const std::vector<FrictionCurve> &curves,
             const std::vector<double>        &start) const
    {
      const unsigned int n = curves.size();
      Vector<double>     load(n), free_jump(n), s(n), residual(n), trial(n);
      for (unsigned int k = 0; k < n; ++k)
        {
          free_jump(k) = jump(without_friction, k);
          s(k)         = curves[k].parameter_at(start[k]);
        }
      stiffness.vmult(load, free_jump);
      const auto evaluate = [&](const Vector<double> &s, Vector<double> &r) {
        Vector<double> j(n);
        for (unsigned int k = 0; k < n; ++k)
          j(k) = curves[k].jump(s(k));
        stiffness.vmult(r, j);
        for (unsigned int k = 0; k < n; ++k)
          r(k) += curves[k].force(s(k)) - load(k);
        return r.l2_norm();
      };

      Solution solution;
      double   norm = evaluate(s, residual);
      while (!solution.converged && solution.iterations < 500)
        {
          ++solution.iterations;
          FullMatrix<double> jacobian = stiffness;
          for (unsigned int m = 0; m < n; ++m)
            {
              const double slope = curves[m].jump_derivative(s(m));
              for (unsigned int k = 0; k < n; ++k)
                jacobian(k, m) *= slope;
              jacobian(m, m) += curves[m].force_derivative(s(m));
            }
          jacobian.gauss_jordan();
          Vector<double> step(n);
          jacobian.vmult(step, residual);
          double t = std::min(1., 3. / step.linfty_norm());
          if (step.linfty_norm() < 1e-11 * s.linfty_norm())
            solution.converged = true;
          for (unsigned int halvings = 0; halvings < 40; ++halvings, t /= 2.)
            {
              trial = s;
              trial.add(-t, step);
              Vector<double> r(n);
              const double   trial_norm = evaluate(trial, r);
              if (solution.converged || trial_norm < norm)
                {
                  s        = trial;
                  residual = r;
                  norm     = trial_norm;
                  break;
                }
            }
        }

      solution.velocity = without_friction;
      for (unsigned int k = 0; k < n; ++k)
        {
          solution.parameters.push_back(s(k));
          solution.jumps.push_back(curves[k].jump(s(k)));
          solution.forces.push_back(curves[k].force(s(k)));
          solution.velocity.add(-solution.forces.back(), responses[k]);
        }
      return solution;
    }

  private:
    double
    jump(const Vector<double> &u, const unsigned int k) const
    {
      double sum = 0;
      for (const auto &entry : jump_rows[k])
        sum += entry.second * u(2 * entry.first);
      return sum;
    }

    Vector<double>
    solve(Vector<double> x) const
    {
      lu.solve(x);
      return x;
    }

    /** The rows of inactive components become those of the identity. */
    void
    factorise(const BlockMatrix<2> &A, const NodeMask &active)
    {
      const BlockSparsity   &sparsity = A.sparsity();
      const unsigned int     n        = n_entries + jump_rows.size();
      DynamicSparsityPattern dsp(n, n);
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < 2; ++c)
            for (unsigned int d = 0; d < 2; ++d)
              dsp.add(2 * i + c, 2 * sparsity.column[k] + d);
      for (unsigned int k = 0; k < jump_rows.size(); ++k)
        for (const auto &entry : jump_rows[k])
          {
            dsp.add(2 * entry.first + 1, n_entries + k);
            dsp.add(n_entries + k, 2 * entry.first + 1);
          }
      pattern.copy_from(dsp);
      matrix.reinit(pattern);
      for (unsigned int i = 0; i < sparsity.n_rows(); ++i)
        for (unsigned int c = 0; c < 2; ++c)
          if (active.is_active(i, c))
            for (unsigned int k = sparsity.row_start[i];
                 k < sparsity.row_start[i + 1];
                 ++k)
              for (unsigned int d = 0; d < 2; ++d)
                matrix.set(2 * i + c,
                           2 * sparsity.column[k] + d,
                           A.block(k)[2 * c + d]);
          else
            matrix.set(2 * i + c, 2 * i + c, 1.);
      for (unsigned int k = 0; k < jump_rows.size(); ++k)
        for (const auto &entry : jump_rows[k])
          {
            if (active.is_active(entry.first, 1))
              matrix.set(2 * entry.first + 1, n_entries + k, entry.second);
            matrix.set(n_entries + k, 2 * entry.first + 1, entry.second);
          }
      lu.factorize(matrix);
    }

    const unsigned int                                        n_entries;
    std::vector<std::vector<std::pair<unsigned int, double>>> jump_rows;
    SparsityPattern                                           pattern;
    SparseMatrix<double>                                      matrix;
    SparseDirectUMFPACK                                       lu;
    Vector<double>                                            without_friction;
    std::vector<Vector<double>>                               responses;
    FullMatrix<double> flexibility, stiffness;
  };
} // namespace StickSlip::Reference

#endif
