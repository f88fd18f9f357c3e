// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <metis.h>
#include <stickslip/mesh/cell_graph.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace StickSlip
{
  using namespace dealii;

  namespace
  {
    std::vector<idx_t>
    parts_by_metis(
      const std::vector<unsigned int> &n_cells,
      const std::vector<std::vector<std::pair<unsigned int, unsigned int>>>
                        &neighbours,
      const unsigned int n_parts)
    {
      std::vector<idx_t>       row_start = {0}, columns, weights;
      std::vector<std::size_t> place(n_cells.size(), 0);
      for (const auto &row : neighbours)
        {
          // Edges between the same nodes are one.
          const std::size_t begin = columns.size();
          for (const auto &[neighbour, weight] : row)
            if (std::size_t &k = place[neighbour];
                k >= begin && k < columns.size() &&
                columns[k] == idx_t(neighbour))
              weights[k] += weight;
            else
              {
                k = columns.size();
                columns.push_back(neighbour);
                weights.push_back(weight);
              }
          AssertThrow(columns.size() <= static_cast<std::size_t>(
                                          std::numeric_limits<idx_t>::max()),
                      ExcMessage("The meshes have more cells than this "
                                 "machine's METIS can count."));
          row_start.push_back(columns.size());
        }

      idx_t options[METIS_NOPTIONS];
      METIS_SetDefaultOptions(options);
      options[METIS_OPTION_NUMBERING] = 0;
      // A fixed seed gives equal results on all processes.
      options[METIS_OPTION_SEED] = 1;

      // By bisection, for the order of the parts in space.
      idx_t              n_nodes   = n_cells.size();
      idx_t              n_weights = 1;
      idx_t              n         = n_parts;
      idx_t              cut       = 0;
      std::vector<idx_t> sizes(n_cells.begin(), n_cells.end());
      std::vector<idx_t> result(n_nodes);
      const int          status = METIS_PartGraphRecursive(&n_nodes,
                                                  &n_weights,
                                                  row_start.data(),
                                                  columns.data(),
                                                  sizes.data(),
                                                  /*vsize=*/nullptr,
                                                  weights.data(),
                                                  &n,
                                                  /*tpwgts=*/nullptr,
                                                  /*ubvec=*/nullptr,
                                                  options,
                                                  &cut,
                                                  result.data());
      AssertThrow(status == METIS_OK,
                  ExcMessage(
                    "METIS could not distribute " + std::to_string(n_nodes) +
                    " cells onto " + std::to_string(n_parts) +
                    " processes and returned " + std::to_string(status) + "."));
      return result;
    }
  } // namespace



  CellGraph::CellGraph(const std::vector<unsigned int> &n_cells)
    : n_cells(n_cells)
    , neighbours(n_cells.size())
  {}



  void
  CellGraph::add_edge(const unsigned int a,
                      const unsigned int b,
                      const unsigned int weight)
  {
    neighbours[a].emplace_back(b, weight);
    neighbours[b].emplace_back(a, weight);
  }



  std::vector<unsigned int>
  CellGraph::parts(const unsigned int n_parts) const
  {
    std::vector<unsigned int> result(n_cells.size(), 0);
    if (n_parts >= result.size())
      // METIS would complain on the screen and waste parts.
      std::iota(result.begin(), result.end(), 0);
    else if (n_parts > 1)
      {
        const std::vector<idx_t> found =
          parts_by_metis(n_cells, neighbours, n_parts);
        std::copy(found.begin(), found.end(), result.begin());
      }
    return result;
  }
} // namespace StickSlip
