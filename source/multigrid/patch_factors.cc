// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/multigrid/patch_factors.h>

#include <algorithm>
#include <limits>

namespace StickSlip
{
  namespace
  {
    /**
     * Replace a symmetric positive definite matrix of n rows by its inverse.
     * Components whose pivot is no more than @p precision times the diagonal
     * are left out, as are those with a zero on it.
     */
    void
    invert_in_place(std::vector<double> &A,
                    const unsigned int   n,
                    const double         precision)
    {
      std::vector<double> diagonal(n);
      for (unsigned int i = 0; i < n; ++i)
        diagonal[i] = A[i * n + i];
      for (unsigned int k = 0; k < n; ++k)
        {
          double *row_k = A.data() + std::size_t(k) * n;
          if (!(row_k[k] > precision * diagonal[k]))
            {
              for (unsigned int i = 0; i < n; ++i)
                A[i * n + k] = row_k[i] = 0.;
              continue;
            }
          const double inverse = 1. / row_k[k];
          row_k[k]             = 1.;
          for (unsigned int j = 0; j < n; ++j)
            row_k[j] *= inverse;
          for (unsigned int i = 0; i < n; ++i)
            if (i != k)
              {
                double      *row_i  = A.data() + std::size_t(i) * n;
                const double factor = row_i[k];
                row_i[k]            = 0.;
                for (unsigned int j = 0; j < n; ++j)
                  row_i[j] -= factor * row_k[j];
              }
        }
    }
  } // namespace



  template <int n_components, typename Number>
  PatchFactors<n_components, Number>::PatchFactors(
    const unsigned int            n_nodes,
    const std::vector<NodePatch> &patches)
    : first_patch(n_nodes + 1, 0)
    , is_current(patches.size(), true)
    , diagonal(std::size_t(n_nodes) * block_size)
    , components(n_nodes, 0)
  {
    std::size_t n_entries = 0;
    for (const NodePatch &nodes : patches)
      {
        for (const unsigned int i : nodes)
          {
            node.push_back(i);
            ++first_patch[i + 1];
          }
        first_node.push_back(node.size());
        first_entry.push_back(n_entries);
        const std::size_t n = nodes.size() * n_components;
        n_entries += n * n;
      }
    for (unsigned int i = 0; i < n_nodes; ++i)
      first_patch[i + 1] += first_patch[i];
    patch.resize(node.size());
    std::vector<unsigned int> next(first_patch.begin(), first_patch.end() - 1);
    for (unsigned int p = 0; p < patches.size(); ++p)
      for (const unsigned int i : patches[p])
        patch[next[i]++] = p;
    inverse.resize(n_entries);
  }



  template <int n_components, typename Number>
  unsigned int
  PatchFactors<n_components, Number>::largest() const
  {
    unsigned int result = 0;
    for (unsigned int p = 0; p < n_patches(); ++p)
      result = std::max(result, n_nodes(p));
    return result;
  }



  template <int n_components, typename Number>
  void
  PatchFactors<n_components, Number>::touch(const unsigned int i)
  {
    for (unsigned int k = first_patch[i]; k < first_patch[i + 1]; ++k)
      is_current[patch[k]] = false;
  }



  template <int n_components, typename Number>
  void
  PatchFactors<n_components, Number>::set_diagonal(
    const unsigned int             i,
    const Tensor<2, n_components> &block,
    const NodeMask                &active)
  {
    components[i] = active.active_components(i);
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        diagonal[std::size_t(i) * block_size +
                 Kernels::sweep_position<n_components>(c, d)] = block[c][d];
    touch(i);
  }



  template <int n_components, typename Number>
  void
  PatchFactors<n_components, Number>::copy_patch(
    const unsigned int                          p,
    const SweepTriangles<n_components, Number> &matrix,
    std::vector<double>                        &entries) const
  {
    const unsigned int  n   = n_nodes(p) * n_components;
    const unsigned int *its = nodes(p);
    entries.resize(std::size_t(n) * n);
    for (unsigned int a = 0; a < n_nodes(p); ++a)
      for (unsigned int b = 0; b <= a; ++b)
        {
          // Nodes are in ascending order, and all of them couple.
          const unsigned int i = its[a], j = its[b];
          const Number      *block =
            a == b ? diagonal.data() + std::size_t(i) * block_size :
                          matrix.block_below(i, j);
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              {
                const unsigned int k = a * n_components + c,
                                   m = b * n_components + d;
                const double value =
                  ((components[i] >> c) & (components[j] >> d) & 1u) ?
                    block[Kernels::sweep_position<n_components>(c, d)] :
                    0.;
                entries[k * n + m] = entries[m * n + k] = value;
              }
        }
  }



  template <int n_components, typename Number>
  void
  PatchFactors<n_components, Number>::factorise(
    const SweepTriangles<n_components, Number> &matrix)
  {
    std::vector<double> entries;
    for (unsigned int p = 0; p < n_patches(); ++p)
      if (!is_current[p])
        {
          copy_patch(p, matrix, entries);
          invert_in_place(entries,
                          n_nodes(p) * n_components,
                          std::numeric_limits<Number>::epsilon());
          std::copy(entries.begin(),
                    entries.end(),
                    inverse.begin() + first_entry[p]);
          is_current[p] = true;
        }
  }



  template <int n_components, typename Number>
  void
  PatchFactors<n_components, Number>::add_solution(const unsigned int p,
                                                   const Number      *rhs,
                                                   Number            *x) const
  {
    const unsigned int  n     = n_nodes(p) * n_components;
    const unsigned int *its   = nodes(p);
    const Number       *entry = inverse.data() + first_entry[p];
    for (unsigned int a = 0; a < n_nodes(p); ++a)
      for (unsigned int c = 0; c < n_components; ++c, entry += n)
        {
          Number sum = 0;
          for (unsigned int b = 0; b < n; ++b)
            sum += entry[b] * rhs[b];
          x[std::size_t(its[a]) * n_components + c] += sum;
        }
  }



  template <int n_components, typename Number>
  std::size_t
  PatchFactors<n_components, Number>::memory_consumption() const
  {
    return sizeof(unsigned int) * (first_node.capacity() + node.capacity() +
                                   first_patch.capacity() + patch.capacity()) +
           sizeof(std::size_t) * first_entry.capacity() +
           sizeof(Number) * (inverse.capacity() + diagonal.capacity()) +
           is_current.capacity() / 8 + components.capacity();
  }



  template class PatchFactors<1, float>;
  template class PatchFactors<2, float>;
  template class PatchFactors<3, float>;
  template class PatchFactors<1, double>;
  template class PatchFactors<2, double>;
  template class PatchFactors<3, double>;
} // namespace StickSlip
