// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

/*
 * kernel_speed [--triad]
 *
 * Measures the bandwidth of the memory by the triad of STREAM, and then (not
 * with --triad) the kernels of the block matrices and those of deal.II on the
 * same matrix: elasticity and mass on cells of one size, in two and three
 * dimensions. Prints a row for each: time for an unknown in ns, the bytes that
 * have to be moved for it, and the share of the bound that follows from both.
 *
 * With d components a node, e entries (blocks) in a row and numbers of s bytes,
 * a node of a product costs e (d^2 s + 4) + 4 bytes for the matrix, and 2 d s
 * for the vectors; one of Gauss-Seidel also d^2 s for the inverse of the
 * diagonal block and 2 d s for right hand side and the writing of the solution.
 * As for the triad, what a write reads first does not count. The smoother of
 * the V-cycle keeps the blocks off the diagonal apart from the inverses of
 * those on it: (e - 1) (d^2 s + 4) + d^2 s + 8 bytes, and 3 d s for a sweep, d
 * s for the residual after one from zero, with which it shares the matrix.
 */

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/sparse_matrix.h>

#include <stickslip/mechanics/elastic_assembly.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

#include <cmath>
#include <type_traits>

#include "measurement.h"
#include "memory_kernels.h"

namespace
{
  using namespace StickSlip;
  using namespace Measure;

  constexpr unsigned int repetitions = 10;

  struct Bandwidth
  {
    /** bytes/s */
    double triad = 0, read = 0;
  };



  Bandwidth
  measure_bandwidth(ResultTable &table)
  {
    // 400 MB each, far beyond any cache.
    constexpr std::size_t size = 50000000;
    AlignedVector<double> a(size, 0.), b(size, 1.), c(size, 2.);
    Bandwidth             bandwidth;
    bandwidth.triad = 3. * sizeof(double) * size / shortest(repetitions, [&]() {
                        triad(a.data(), b.data(), c.data(), 3., size);
                      });
    double sum      = 0;
    bandwidth.read  = 1. * sizeof(double) * size / shortest(repetitions, [&]() {
                       sum += Measure::read(a.data(), size);
                     });
    AssertThrow(std::abs(sum / (7. * size) - repetitions) < 1e-6,
                ExcInternalError());
    for (const auto &[name, value] : {std::make_pair("triad", bandwidth.triad),
                                      std::make_pair("read", bandwidth.read)})
      {
        table.add("kernel", name);
        table.add("dim", 0);
        table.add("unknowns", size);
        table.add("number", "double");
        table.add("GB_per_s", value * 1e-9);
        table.add("ns_per_unknown", 1e9 * sizeof(double) / value);
        table.add("bytes_per_unknown", 0);
        table.add("percent_of_bound", 100. * value / bandwidth.triad);
        table.end_row();
      }
    return bandwidth;
  }



  /** One body with cells of one size. */
  template <int dim>
  BlockMatrix<dim>
  make_matrix()
  {
    BodyGeometry<dim> geometry;
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        geometry.lateral_lower[d] = 0.;
        geometry.lateral_upper[d] = 1.;
      }
    geometry.thickness = 1.;
    geometry.coarse_cells.fill(dim == 2 ? 11 : 3);
    geometry.uniform_refinements = dim == 2 ? 6 : 4;
    geometry.refinement_passes   = 0;
    const MeshHierarchy<dim>          meshes({geometry}, MPI_COMM_WORLD);
    const std::vector<MaterialFields> materials(1);
    const ElasticMatrices<dim>        terms =
      assemble_elastic_matrices(meshes.finest(), materials);
    BlockMatrix<dim> matrix(terms.mass.shared_sparsity());
    constexpr double tau = 1e-3;
    TermMatrix<dim>::combine({2. / tau, 1., tau / 2.},
                             {terms.mass, terms.damping, terms.stiffness},
                             0,
                             matrix.n_rows(),
                             matrix);
    return matrix;
  }



  /** Bytes of a row of @p table. */
  struct Cost
  {
    unsigned int dim;
    double       entries;
    double       number_bytes;

    double
    product() const
    {
      return (entries * (dim * dim * number_bytes + 4) + 4) / dim +
             2 * number_bytes;
    }

    /** Off the diagonal with indices, the inverse of the diagonal block
     * without. */
    double
    sweep() const
    {
      return ((entries - 1.) * (dim * dim * number_bytes + 4) +
              dim * dim * number_bytes + 8) /
               dim +
             3 * number_bytes;
    }

    /** The matrix with scalar entries. */
    double
    scalar_product() const
    {
      return entries * dim * (number_bytes + 4) + 8 + 2 * number_bytes;
    }
  };



  template <int dim>
  class KernelTimes
  {
  public:
    KernelTimes(ResultTable &table, const Bandwidth &bandwidth)
      : table(table)
      , bandwidth(bandwidth)
      , matrix(make_matrix<dim>())
      , n(matrix.n_rows())
      , entries(double(matrix.sparsity().n_entries()) / n)
    {}

    void
    run()
    {
      run_product();
      run_smoother<double>();
      run_smoother<float>();
      run_library();
    }

  private:
    void
    row(const std::string &name,
        const double       time,
        const double       bytes,
        const std::string &number = "double")
    {
      const double unknowns = double(n) * dim;
      table.add("kernel", name);
      table.add("dim", dim);
      table.add("unknowns", n * dim);
      table.add("number", number);
      table.add("GB_per_s", bytes * unknowns / time * 1e-9);
      table.add("ns_per_unknown", time / unknowns * 1e9);
      table.add("bytes_per_unknown", bytes);
      table.add("percent_of_bound",
                100. * bytes * unknowns / bandwidth.triad / time);
      table.end_row();
    }

    /** The product of conjugate gradients. */
    void
    run_product()
    {
      AlignedVector<double> x(n * dim, 0.), b(n * dim, 1.);
      const auto            A    = matrix.rows();
      const Cost            cost = {dim, entries, sizeof(double)};
      row("product",
          shortest(repetitions,
                   [&]() { Kernels::vmult<dim>(A, 0, n, b.data(), x.data()); }),
          cost.product());
    }



    /** The smoother of the V-cycle. */
    template <typename Number>
    void
    run_smoother()
    {
      BlockGaussSeidel<dim, Number> smoother(matrix.shared_sparsity());
      const NodeMask                all(n, dim);
      for (unsigned int i = 0; i < n; ++i)
        {
          smoother.set_row(i, matrix);
          smoother.set_diagonal(i, matrix.diagonal_block(i), all);
        }
      const IndexSet     nodes = complete_index_set(n);
      NodeValues<Number> x     = NodePartition(nodes, nodes, dim, MPI_COMM_SELF)
                               .template make_vector<Number>(),
                         b = x, r = x;
      b                      = Number(1.);
      const Cost        cost = {dim, entries, sizeof(Number)};
      const std::string number =
        std::is_same<Number, float>::value ? "float" : "double";
      row("sweep from zero and residual",
          shortest(repetitions,
                   [&]() {
                     smoother.sweep_from_zero(x, b);
                     smoother.residual_after_first_sweep(r, x, b);
                   }),
          cost.sweep() + 3 * cost.number_bytes,
          number);
      row("sweep backward",
          shortest(repetitions, [&]() { smoother.sweep_backward(x, b); }),
          cost.sweep(),
          number);
    }



    void
    run_library()
    {
      const BlockSparsity   &blocks = matrix.sparsity();
      DynamicSparsityPattern dynamic(n * dim);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int k = blocks.row_start[i];
               k < blocks.row_start[i + 1];
               ++k)
            for (unsigned int d = 0; d < dim; ++d)
              dynamic.add(i * dim + c, blocks.column[k] * dim + d);
      SparsityPattern sparsity;
      sparsity.copy_from(dynamic);
      dynamic.reinit(0, 0);
      SparseMatrix<double> A(sparsity);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = blocks.row_start[i]; k < blocks.row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              A.set(i * dim + c,
                    blocks.column[k] * dim + d,
                    matrix.block(k)[c * dim + d]);
      Vector<double> x(n * dim), b(n * dim);
      b               = 1.;
      const Cost cost = {dim, entries, sizeof(double)};
      row("SparseMatrix::vmult",
          shortest(repetitions, [&]() { A.vmult(x, b); }),
          cost.scalar_product());
      PreconditionSOR<SparseMatrix<double>> sor;
      sor.initialize(A);
      row("PreconditionSOR::step",
          shortest(repetitions, [&]() { sor.step(x, b); }),
          cost.scalar_product() + 2 * sizeof(double));
      row("PreconditionSOR::Tstep",
          shortest(repetitions, [&]() { sor.Tstep(x, b); }),
          cost.scalar_product() + 2 * sizeof(double));
    }

    ResultTable       &table;
    const Bandwidth    bandwidth;
    BlockMatrix<dim>   matrix;
    const unsigned int n;
    const double       entries;
  };
} // namespace



int
main(int argc, char *argv[])
{
  const StickSlip::Libraries libraries;
  Options                    options(argc, argv);
  ResultTable                table;
  const Bandwidth            bandwidth = measure_bandwidth(table);
  if (!options.take("--triad"))
    {
      KernelTimes<2>(table, bandwidth).run();
      KernelTimes<3>(table, bandwidth).run();
    }
  table.print();
}
