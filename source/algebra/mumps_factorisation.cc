// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <dmumps_c.h>
#include <stickslip/algebra/masked_entries.h>
#include <stickslip/algebra/mumps_factorisation.h>

#include <algorithm>

namespace StickSlip
{
  template <int n_components>
  struct MumpsFactorisation<n_components>::Implementation
  {
    /** The jobs of MUMPS. */
    enum Job
    {
      initialise = -1,
      terminate  = -2,
      analyse    = 1,
      factorise  = 2,
      solve      = 3
    };

    DMUMPS_STRUC_C   mumps;
    std::vector<int> retained;
    /** Whose sparsity the arrays have; kept alive, so that its address stays
     * its own. */
    std::shared_ptr<const BlockSparsity> source;
    std::vector<int>                     row, column;
    std::vector<double>                  value, schur;

    explicit Implementation(const std::vector<unsigned int> &retained_entries)
    {
      for (const unsigned int entry : retained_entries)
        retained.push_back(entry + 1);
      schur.resize(retained.size() * retained.size());
      mumps.comm_fortran = MPI_Comm_c2f(MPI_COMM_SELF);
      mumps.par          = 1;
      // Positive definite.
      mumps.sym = 1;
      run(initialise);
      // No messages.
      for (const unsigned int k : {1, 2, 3, 4})
        control(k) = 0;
      if (!retained.empty())
        {
          // The Schur complement as one dense matrix.
          control(19)         = 1;
          mumps.size_schur    = retained.size();
          mumps.listvar_schur = retained.data();
          mumps.schur         = schur.data();
        }
    }

    ~Implementation()
    {
      run(terminate);
    }

    /** The control parameters as numbered in the manual of MUMPS. */
    MUMPS_INT &
    control(const unsigned int k)
    {
      return mumps.icntl[k - 1];
    }

    /** Returns 0 or the number of an error. */
    int
    run(const Job job)
    {
      mumps.job = job;
      dmumps_c(&mumps);
      return mumps.infog[0];
    }

    /** Positions of the lower triangle. */
    void
    set_sparsity(const std::shared_ptr<const BlockSparsity> &sparsity)
    {
      source = sparsity;
      row.clear();
      column.clear();
      for (unsigned int i = 0; i < source->n_rows(); ++i)
        for (unsigned int k = source->row_start[i];
             k < source->row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              {
                const unsigned int I = i * n_components + c,
                                   J = source->column[k] * n_components + d;
                if (J <= I)
                  {
                    row.push_back(I + 1);
                    column.push_back(J + 1);
                  }
              }
      value.resize(row.size());
      mumps.n   = source->n_rows() * n_components;
      mumps.nnz = value.size();
      mumps.irn = row.data();
      mumps.jcn = column.data();
      mumps.a   = value.data();
    }

    void
    set_values(const BlockMatrix<n_components> &matrix, const NodeMask &mask)
    {
      double *entry = value.data();
      for (unsigned int i = 0; i < source->n_rows(); ++i)
        for (unsigned int k = source->row_start[i];
             k < source->row_start[i + 1];
             ++k)
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              if (source->column[k] * n_components + d <= i * n_components + c)
                *entry++ = masked_entry(matrix, mask, i, k, c, d);
    }
  };



  template <int n_components>
  MumpsFactorisation<n_components>::MumpsFactorisation(
    const std::vector<unsigned int> &retained)
    : implementation(std::make_unique<Implementation>(retained))
  {}



  template <int n_components>
  MumpsFactorisation<n_components>::~MumpsFactorisation() = default;



  template <int n_components>
  void
  MumpsFactorisation<n_components>::set_matrix(
    const BlockMatrix<n_components> &matrix,
    const NodeMask                  &mask)
  {
    constexpr int too_little_space[] = {-8, -9};
    constexpr int out_of_memory      = -13;
    constexpr int singular           = -10;

    Implementation &data = *implementation;
    if (matrix.shared_sparsity() != data.source)
      {
        data.set_sparsity(matrix.shared_sparsity());
        data.set_values(matrix, mask);
        const int error = data.run(Implementation::analyse);
        if (error < 0)
          data.source = nullptr;
        AssertThrow(error >= 0,
                    ExcMessage("MUMPS cannot analyse a matrix: error " +
                               std::to_string(error) + "."));
      }
    else
      data.set_values(matrix, mask);

    int error = data.run(Implementation::factorise);
    // The estimate of the space is exceeded at times.
    for (unsigned int attempt = 0;
         attempt < 5 &&
         (error == too_little_space[0] || error == too_little_space[1]);
         ++attempt)
      {
        data.control(14) = 2 * data.control(14) + 20;
        error            = data.run(Implementation::factorise);
      }
    AssertThrow(error != out_of_memory,
                ExcMessage("MUMPS has not enough memory."));
    if (error == singular)
      throw SingularMatrix("the linearised matrix");
    AssertThrow(error >= 0,
                ExcMessage("MUMPS cannot factorise a matrix: error " +
                           std::to_string(error) + "."));

    // MUMPS gives one triangle, row by row.
    const unsigned int n = data.retained.size();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i + 1; j < n; ++j)
        data.schur[i * n + j] = data.schur[j * n + i];
  }



  template <int n_components>
  void
  MumpsFactorisation<n_components>::solve(NodalVector &x, const NodalVector &b)
  {
    Implementation &data = *implementation;
    std::copy_n(b.begin(), data.mumps.n, x.begin());
    data.mumps.nrhs = 1;
    data.mumps.lrhs = data.mumps.n;
    data.mumps.rhs  = x.begin();
    const int error = data.run(Implementation::solve);
    AssertThrow(error >= 0,
                ExcMessage("The factors of MUMPS are of no use: error " +
                           std::to_string(error) + "."));
    for (const int entry : data.retained)
      x.local_element(entry - 1) = 0.;
  }



  template <int n_components>
  const std::vector<double> &
  MumpsFactorisation<n_components>::schur_complement() const
  {
    return implementation->schur;
  }



  template class MumpsFactorisation<1>;
  template class MumpsFactorisation<2>;
  template class MumpsFactorisation<3>;
} // namespace StickSlip
