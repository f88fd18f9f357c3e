// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/numbers.h>

#include <stickslip/multigrid/strong_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace StickSlip
{
  namespace
  {
    constexpr double least_strength = 0.4;

    /** The farthest nodes of a line that may couple; rows of the coarser side
     * of a fault do so over the dual functions of the finer one. */
    constexpr unsigned int widest_band = 3;

    /** Shorter lines with less strength than this are found where graded meshes
     * end, and are no trouble. Across thin layers they are much stronger. */
    constexpr unsigned int shortest_line       = 3;
    constexpr double       strength_of_shorter = 0.5;

    /** The neighbours of a node in its line, the stronger one first. */
    struct Neighbours
    {
      std::array<unsigned int, 2> node = {
        {numbers::invalid_unsigned_int, numbers::invalid_unsigned_int}};
      std::array<double, 2> strength = {{0., 0.}};

      void
      offer(const unsigned int other, const double other_strength)
      {
        if (other_strength > strength[0])
          {
            node     = {{other, node[0]}};
            strength = {{other_strength, strength[0]}};
          }
        else if (other_strength > strength[1])
          {
            node[1]     = other;
            strength[1] = other_strength;
          }
      }

      bool
      contains(const unsigned int other) const
      {
        return node[0] == other || node[1] == other;
      }

      void
      drop(const unsigned int k)
      {
        node[k] = numbers::invalid_unsigned_int;
      }
    };



    /** The strength of the coupling at @p position in row i. */
    template <int n_components, typename Number>
    double
    coupling_strength(const BlockMatrix<n_components, Number> &matrix,
                      const NodeMask                          &fixed,
                      const unsigned int                       i,
                      const unsigned int                       position)
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      const unsigned int   j        = sparsity.column[position];
      const Number        *A_ij     = matrix.block(position);
      const Number        *A_ii     = matrix.block(sparsity.diagonal[i]);
      const Number        *A_jj     = matrix.block(sparsity.diagonal[j]);
      double               least    = std::numeric_limits<double>::max();
      bool                 couples  = false;
      for (unsigned int c = 0; c < n_components; ++c)
        if (fixed.is_active(i, c) && fixed.is_active(j, c))
          {
            const unsigned int cc = c * (n_components + 1);
            if (!(A_ij[cc] < 0. && A_ii[cc] > 0. && A_jj[cc] > 0.))
              return 0.;
            couples = true;
            least   = std::min(least,
                             -double(A_ij[cc]) /
                               std::sqrt(double(A_ii[cc]) * double(A_jj[cc])));
          }
      return couples ? least : 0.;
    }



    /** The chain of neighbours that have not been visited, from a node on. */
    NodeLine
    follow(const std::vector<Neighbours> &neighbours,
           const unsigned int             start,
           std::vector<bool>             &visited)
    {
      NodeLine line;
      for (unsigned int i = start; i != numbers::invalid_unsigned_int;)
        {
          line.push_back(i);
          visited[i]        = true;
          unsigned int next = numbers::invalid_unsigned_int;
          for (const unsigned int j : neighbours[i].node)
            if (j != numbers::invalid_unsigned_int && !visited[j])
              next = j;
          i = next;
        }
      return line;
    }



    /** Return if a line is long or strong enough. */
    bool
    is_worth_it(const NodeLine &line, const std::vector<Neighbours> &neighbours)
    {
      for (unsigned int i = 0;
           i + 1 < line.size() && line.size() < shortest_line;
           ++i)
        for (const unsigned int k : {0, 1})
          if (neighbours[line[i]].node[k] == line[i + 1] &&
              neighbours[line[i]].strength[k] < strength_of_shorter)
            return false;
      return line.size() > 1;
    }



    /** Append the parts of a chain in which no nodes couple that are farther
     * apart in it than the widest band: rings are opened, for one. @p place is
     * for the place of each node in its line. */
    void
    append_parts(const NodeLine                &chain,
                 const BlockSparsity           &sparsity,
                 const std::vector<Neighbours> &neighbours,
                 std::vector<unsigned int>     &place,
                 std::vector<NodeLine>         &lines)
    {
      NodeLine   line;
      const auto couples_too_far = [&](const unsigned int i) {
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          {
            const unsigned int j = sparsity.column[k];
            if (j < place.size() && place[j] < line.size() &&
                line[place[j]] == j && place[j] + widest_band < line.size())
              return true;
          }
        return false;
      };
      const auto finish = [&]() {
        if (is_worth_it(line, neighbours))
          lines.push_back(line);
        line.clear();
      };
      for (const unsigned int i : chain)
        {
          if (couples_too_far(i))
            finish();
          place[i] = line.size();
          line.push_back(i);
        }
      finish();
    }
  } // namespace



  template <int n_components, typename Number>
  std::vector<NodeLine>
  find_strong_lines(
    const BlockSparsity                                  &sparsity,
    const std::vector<BlockMatrix<n_components, Number>> &matrices,
    const NodeMask                                       &fixed,
    const std::vector<unsigned int>                      &nonsmooth_nodes)
  {
    const unsigned int n = sparsity.n_rows();
    std::vector<bool>  is_nonsmooth(n, false);
    for (const unsigned int i : nonsmooth_nodes)
      is_nonsmooth[i] = true;

    std::vector<Neighbours> neighbours(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        {
          const unsigned int j = sparsity.column[k];
          if (j == i || j >= n || is_nonsmooth[i] != is_nonsmooth[j])
            continue;
          double strength = 0.;
          for (const BlockMatrix<n_components, Number> &matrix : matrices)
            strength =
              std::max(strength, coupling_strength(matrix, fixed, i, k));
          if (strength >= least_strength)
            neighbours[i].offer(j, strength);
        }
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = 0; k < 2; ++k)
        {
          const unsigned int j = neighbours[i].node[k];
          if (j != numbers::invalid_unsigned_int && !neighbours[j].contains(i))
            neighbours[i].drop(k);
        }

    std::vector<NodeLine>     lines;
    std::vector<bool>         visited(n, false);
    std::vector<unsigned int> place(n, 0);
    // Open ends first: what is left are rings.
    for (const bool is_ring : {false, true})
      for (unsigned int i = 0; i < n; ++i)
        {
          const auto        &nodes = neighbours[i].node;
          const unsigned int n_neighbours =
            (nodes[0] != numbers::invalid_unsigned_int) +
            (nodes[1] != numbers::invalid_unsigned_int);
          if (!visited[i] && n_neighbours == (is_ring ? 2 : 1))
            append_parts(follow(neighbours, i, visited),
                         sparsity,
                         neighbours,
                         place,
                         lines);
        }
    return lines;
  }



#define STICKSLIP_INSTANTIATE(n_components, Number)                       \
  template std::vector<NodeLine> find_strong_lines<n_components, Number>( \
    const BlockSparsity &,                                                \
    const std::vector<BlockMatrix<n_components, Number>> &,               \
    const NodeMask &,                                                     \
    const std::vector<unsigned int> &);

  STICKSLIP_INSTANTIATE(1, float)
  STICKSLIP_INSTANTIATE(2, float)
  STICKSLIP_INSTANTIATE(3, float)
  STICKSLIP_INSTANTIATE(1, double)
  STICKSLIP_INSTANTIATE(2, double)
  STICKSLIP_INSTANTIATE(3, double)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
