// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <dmumps_c.h>
#include <stickslip/algebra/masked_entries.h>
#include <stickslip/algebra/mumps_factorisation.h>

#include <algorithm>
#include <numeric>

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

    DMUMPS_STRUC_C mumps;
    /** Numbers from one on, and their positions on this process. */
    std::vector<int>          retained;
    std::vector<unsigned int> retained_here;
    /** Of all processes; null if one has all. */
    std::unique_ptr<const NodePartition> nodes;
    /** Numbers of entries of each process, and of those before. */
    std::vector<int> n_entries, first_entry;
    /** Whose sparsity the arrays have; kept alive, so that its address stays
     * its own. */
    std::shared_ptr<const BlockSparsity> source;
    std::vector<int>                     row, column;
    std::vector<double>                  value, schur;
    /** Space for small factors. For its own MUMPS would ask for new pages with
     * each factorisation, which can take longer than that. */
    std::vector<double> workspace;

    Implementation(const std::vector<types::global_dof_index> &retained_entries,
                   const NodePartition                        *all_nodes)
    {
      if (all_nodes != nullptr &&
          Utilities::MPI::n_mpi_processes(all_nodes->communicator()) > 1)
        {
          nodes = std::make_unique<NodePartition>(*all_nodes);
          n_entries =
            Utilities::MPI::all_gather(nodes->communicator(),
                                       int(nodes->n_owned() * n_components));
          first_entry.assign(n_entries.size(), 0);
          std::partial_sum(n_entries.begin(),
                           n_entries.end() - 1,
                           first_entry.begin() + 1);
        }
      for (const types::global_dof_index entry : retained_entries)
        {
          retained.push_back(entry + 1);
          if (!nodes)
            retained_here.push_back(entry);
          else if (nodes->owned().is_element(entry / n_components))
            retained_here.push_back(nodes->local_index(entry / n_components) *
                                      n_components +
                                    entry % n_components);
        }
      if (is_first())
        schur.resize(retained.size() * retained.size());
      mumps.comm_fortran =
        MPI_Comm_c2f(nodes ? nodes->communicator() : MPI_COMM_SELF);
      mumps.par = 1;
      // Positive definite.
      mumps.sym = 1;
      run(initialise);
      // No messages.
      for (const unsigned int k : {1, 2, 3, 4})
        control(k) = 0;
      if (nodes)
        // Each process has a part of the matrix.
        control(18) = 3;
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

    /** True on the process that has right hand sides and the Schur complement.
     */
    bool
    is_first() const
    {
      return !nodes ||
             Utilities::MPI::this_mpi_process(nodes->communicator()) == 0;
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
                const types::global_dof_index I =
                                                global_node(i) * n_components +
                                                c,
                                              J =
                                                global_node(source->column[k]) *
                                                  n_components +
                                                d;
                if (J <= I)
                  {
                    row.push_back(I + 1);
                    column.push_back(J + 1);
                  }
              }
      value.resize(row.size());
      mumps.n   = (nodes ? nodes->n_global() : source->n_rows()) * n_components;
      mumps.nnz = mumps.nnz_loc = value.size();
      mumps.irn = mumps.irn_loc = row.data();
      mumps.jcn = mumps.jcn_loc = column.data();
      mumps.a = mumps.a_loc = value.data();
    }

    /** Factorise, in the workspace if the factors are small; returns 0 or the
     * number of an error. */
    int
    factorise_in_workspace()
    {
      // Negative for what does not fit an int.
      const MUMPS_INT estimate = mumps.info[7], most = 1 << 24;
      if (estimate > 0 && estimate <= most)
        {
          const std::size_t size =
            estimate + std::size_t(estimate) * control(14) / 100 + 1000;
          if (workspace.size() < size)
            workspace = std::vector<double>(size);
          mumps.wk_user = workspace.data();
        }
      else
        workspace.clear();
      mumps.lwk_user = workspace.size();
      return run(factorise);
    }

    types::global_dof_index
    global_node(const unsigned int node) const
    {
      return nodes ? nodes->global_index(node) : node;
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
              if (global_node(source->column[k]) * n_components + d <=
                  global_node(i) * n_components + c)
                *entry++ = masked_entry(matrix, mask, i, k, c, d);
    }
  };



  template <int n_components>
  MumpsFactorisation<n_components>::MumpsFactorisation(
    const std::vector<unsigned int> &retained)
    : implementation(std::make_unique<Implementation>(
        std::vector<types::global_dof_index>(retained.begin(), retained.end()),
        nullptr))
  {}



  template <int n_components>
  MumpsFactorisation<n_components>::MumpsFactorisation(
    const NodePartition                        &nodes,
    const std::vector<types::global_dof_index> &retained)
    : implementation(std::make_unique<Implementation>(retained, &nodes))
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

    int error = data.factorise_in_workspace();
    // The estimate of the space is exceeded at times.
    for (unsigned int attempt = 0;
         attempt < 5 &&
         (error == too_little_space[0] || error == too_little_space[1]);
         ++attempt)
      {
        data.control(14) = 2 * data.control(14) + 20;
        error            = data.factorise_in_workspace();
      }
    AssertThrow(error != out_of_memory,
                ExcMessage("MUMPS has not enough memory."));
    if (error == singular)
      throw SingularMatrix("the linearised matrix");
    AssertThrow(error >= 0,
                ExcMessage("MUMPS cannot factorise a matrix: error " +
                           std::to_string(error) + "."));

    // MUMPS gives one triangle, row by row.
    if (!data.is_first())
      return;
    const std::size_t n = data.retained.size();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = i + 1; j < n; ++j)
        data.schur[i * n + j] = data.schur[j * n + i];
  }



  template <int n_components>
  void
  MumpsFactorisation<n_components>::solve(NodalVector &x, const NodalVector &b)
  {
    Implementation     &data = *implementation;
    std::vector<double> all;
    if (data.nodes)
      all = gather_on_first(b);
    else
      std::copy_n(b.begin(), data.mumps.n, x.begin());
    data.mumps.nrhs = 1;
    data.mumps.lrhs = data.mumps.n;
    data.mumps.rhs  = data.nodes ? all.data() : x.begin();
    const int error = data.run(Implementation::solve);
    if (data.nodes)
      MPI_Scatterv(all.data(),
                   data.n_entries.data(),
                   data.first_entry.data(),
                   MPI_DOUBLE,
                   x.begin(),
                   x.locally_owned_size(),
                   MPI_DOUBLE,
                   0,
                   data.nodes->communicator());
    AssertThrow(error >= 0,
                ExcMessage("The factors of MUMPS are of no use: error " +
                           std::to_string(error) + "."));
    for (const unsigned int entry : data.retained_here)
      x.local_element(entry) = 0.;
  }



  template <int n_components>
  const std::vector<double> &
  MumpsFactorisation<n_components>::schur_complement() const
  {
    return implementation->schur;
  }



  template <int n_components>
  std::vector<double>
  MumpsFactorisation<n_components>::take_schur_complement()
  {
    return std::move(implementation->schur);
  }



  template class MumpsFactorisation<1>;
  template class MumpsFactorisation<2>;
  template class MumpsFactorisation<3>;
} // namespace StickSlip
