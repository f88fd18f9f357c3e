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
    constexpr double least_strength = 0.42;

    /** From here on two nodes are a line without others beside them. Only both
     * ends of a line of two get there, across a layer of cells that are four
     * times as wide as thick. */
    constexpr double strength_of_pairs = 0.7;

    /** The farthest nodes of a line that may couple; rows of the coarser side
     * of a fault do so over the dual functions of the finer one. */
    constexpr unsigned int widest_band = 3;

    constexpr unsigned int shortest_line = 3;

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

      unsigned int
      number() const
      {
        return (node[0] != numbers::invalid_unsigned_int) +
               (node[1] != numbers::invalid_unsigned_int);
      }

      void
      drop(const unsigned int k)
      {
        node[k] = numbers::invalid_unsigned_int;
      }
    };



    /** The strength of the coupling at @p position in row i. */
    template <typename Matrix>
    double
    coupling_strength(const Matrix      &matrix,
                      const NodeMask    &fixed,
                      const unsigned int i,
                      const unsigned int position)
    {
      const BlockSparsity &sparsity = matrix.sparsity();
      const unsigned int   j        = sparsity.column[position];
      const auto           A_ij     = matrix.entry(i, position);
      const auto           A_ii     = matrix.diagonal_block(i);
      const auto           A_jj     = matrix.diagonal_block(j);
      double               ij = 0., ii = 0., jj = 0.;
      for (unsigned int c = 0; c < fixed.n_components(); ++c)
        if (fixed.is_active(i, c) && fixed.is_active(j, c))
          {
            ij += A_ij[c][c];
            ii += A_ii[c][c];
            jj += A_jj[c][c];
          }
      return ij < 0. && ii > 0. && jj > 0. ? -ij / std::sqrt(ii * jj) : 0.;
    }



    /** The neighbours of all nodes, of which each has the other. @p strength
     * is that of a row and a position in it. */
    template <typename Strength>
    std::vector<Neighbours>
    find_neighbours(const BlockSparsity &sparsity, const Strength &strength)
    {
      const unsigned int      n = sparsity.n_rows();
      std::vector<Neighbours> neighbours(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = sparsity.row_start[i];
             k < sparsity.row_start[i + 1];
             ++k)
          if (sparsity.column[k] < n)
            {
              const double s = strength(i, k);
              if (s >= least_strength)
                neighbours[i].offer(sparsity.column[k], s);
            }
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = 0; k < 2; ++k)
          {
            const unsigned int j = neighbours[i].node[k];
            if (j != numbers::invalid_unsigned_int &&
                !neighbours[j].contains(i))
              neighbours[i].drop(k);
          }
      return neighbours;
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



    /** Return if a line is long or strong enough: others of two nodes are
     * found where graded meshes end, and are no trouble. */
    bool
    is_worth_it(const NodeLine &line, const std::vector<Neighbours> &neighbours)
    {
      if (line.size() != 2)
        return line.size() >= shortest_line;
      const Neighbours &first = neighbours[line[0]];
      return first.strength[first.node[0] == line[1] ? 0 : 1] >=
             strength_of_pairs;
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



  template <typename Matrix>
  std::vector<NodeLine>
  find_strong_lines(const BlockSparsity             &sparsity,
                    const std::vector<Matrix>       &matrices,
                    const NodeMask                  &fixed,
                    const std::vector<unsigned int> &nonsmooth_nodes)
  {
    const unsigned int n = sparsity.n_rows();
    std::vector<bool>  is_nonsmooth(n, false), is_free(n, true);
    for (const unsigned int i : nonsmooth_nodes)
      is_nonsmooth[i] = true;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < fixed.n_components(); ++c)
        if (is_nonsmooth[i] || !fixed.is_active(i, c))
          is_free[i] = false;

    // Nodes that have lost components couple strongly in the others on meshes
    // of square cells, too, so that they need free ones beside them.
    const auto strength = [&](const unsigned int i, const unsigned int k) {
      const unsigned int j = sparsity.column[k];
      double             s = 0.;
      if (i != j && is_nonsmooth[i] == is_nonsmooth[j])
        for (const Matrix &matrix : matrices)
          s = std::max(s, coupling_strength(matrix, fixed, i, k));
      return s;
    };
    const std::vector<Neighbours> among_free = find_neighbours(
      sparsity, [&](const unsigned int i, const unsigned int k) {
        return is_free[i] && is_free[sparsity.column[k]] ? strength(i, k) : 0.;
      });
    std::vector<bool> is_beside_line(n, false);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int k = sparsity.row_start[i];
           k < sparsity.row_start[i + 1];
           ++k)
        if (sparsity.column[k] < n &&
            among_free[sparsity.column[k]].number() > 0)
          is_beside_line[i] = true;
    const std::vector<Neighbours> neighbours =
      find_neighbours(sparsity,
                      [&](const unsigned int i, const unsigned int k) {
                        const unsigned int j = sparsity.column[k];
                        const double       s = strength(i, k);
                        return (is_free[i] && is_free[j]) ||
                                   (is_beside_line[i] && is_beside_line[j]) ||
                                   s >= strength_of_pairs ?
                                 s :
                                 0.;
                      });

    std::vector<NodeLine>     lines;
    std::vector<bool>         visited(n, false);
    std::vector<unsigned int> place(n, 0);
    // Open ends first: what is left are rings.
    for (const bool is_ring : {false, true})
      for (unsigned int i = 0; i < n; ++i)
        if (!visited[i] && neighbours[i].number() == (is_ring ? 2 : 1))
          append_parts(
            follow(neighbours, i, visited), sparsity, neighbours, place, lines);
    return lines;
  }



#define STICKSLIP_INSTANTIATE(...)                               \
  template std::vector<NodeLine> find_strong_lines<__VA_ARGS__>( \
    const BlockSparsity &,                                       \
    const std::vector<__VA_ARGS__> &,                            \
    const NodeMask &,                                            \
    const std::vector<unsigned int> &);

  STICKSLIP_INSTANTIATE(BlockMatrix<1, float>)
  STICKSLIP_INSTANTIATE(BlockMatrix<2, float>)
  STICKSLIP_INSTANTIATE(BlockMatrix<3, float>)
  STICKSLIP_INSTANTIATE(BlockMatrix<1>)
  STICKSLIP_INSTANTIATE(BlockMatrix<2>)
  STICKSLIP_INSTANTIATE(BlockMatrix<3>)
  STICKSLIP_INSTANTIATE(TermMatrix<1>)
  STICKSLIP_INSTANTIATE(TermMatrix<2>)
  STICKSLIP_INSTANTIATE(TermMatrix<3>)
#undef STICKSLIP_INSTANTIATE
} // namespace StickSlip
