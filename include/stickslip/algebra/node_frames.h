// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_algebra_node_frames_h
#define stickslip_algebra_node_frames_h

#include <deal.II/base/tensor.h>

#include <stickslip/algebra/node_partition.h>

#include <map>
#include <memory>
#include <vector>

namespace StickSlip
{
  using namespace dealii;

  /**
   * The axes of the nodes that this process owns or reads, by local index; see
   * NodeFrames, which makes them. Copies share what they hold; where no node
   * has axes of its own there is nothing to hold.
   */
  class LocalFrames
  {
  public:
    LocalFrames() = default;

    /** Axes of some of @p n_nodes nodes: @p nodes in ascending order, and the
     * matrices of all of them, row by row, with @p components rows each. */
    LocalFrames(const unsigned int        n_nodes,
                const unsigned int        components,
                std::vector<unsigned int> nodes,
                std::vector<double>       matrices);

    /** Return whether all nodes have the axes of space. */
    bool
    empty() const
    {
      return frames == nullptr;
    }

    /** The matrix R of a node's axes, u = R w, row by row; null where the axes
     * are those of space. */
    const double *
    find(const unsigned int node) const
    {
      if (frames == nullptr || frames->position[node] < 0)
        return nullptr;
      return frames->matrices.data() + frames->position[node];
    }

    /** The nodes with axes of their own, ascending. */
    const std::vector<unsigned int> &
    nodes() const;

    /** Return whether the nodes and their axes are the same. */
    bool
    operator==(const LocalFrames &other) const;

    /** Number of components a node; 0 where empty. */
    unsigned int
    n_components() const;

    /** Bytes on this process, all copies taken together. */
    std::size_t
    memory_consumption() const;

  private:
    struct Frames
    {
      unsigned int              components;
      std::vector<unsigned int> nodes;
      std::vector<double>       matrices;
      /** For each local node the first entry of its matrix; -1 for none. */
      std::vector<int> position;
    };

    std::shared_ptr<const Frames> frames;
  };

  /**
   * Nodes whose components are not along the axes of space but along axes of
   * their own, as normal and tangential ones on a fault or a side that is not
   * level. The components w of a node p are related to the vector u in space
   * by
   *
   *   u = R_p w
   *
   * with an orthogonal matrix R_p, whose columns are the axes.
   *
   * Nodes are given by their global numbers. Every process is given the axes
   * of all nodes that it owns or reads; more do no harm.
   */
  template <int n_components>
  class NodeFrames
  {
  public:
    /** The axes of all nodes are those of space. */
    NodeFrames() = default;

    /**
     * Give a node these @p axes, the columns of the tensor, in the place of
     * those that it had. Where they are those of space to the last bit, nothing
     * is stored. Throws ExcMessage if they are not orthonormal to 1e-10.
     */
    void
    set(const types::global_dof_index  node,
        const Tensor<2, n_components> &axes);

    /** Return whether all nodes have the axes of space. */
    bool
    empty() const
    {
      return axes_of_nodes.empty();
    }

    /** Number of nodes with axes of their own. */
    unsigned int
    size() const
    {
      return axes_of_nodes.size();
    }

    /** The axes of a node; null where they are those of space. */
    const Tensor<2, n_components> *
    find(const types::global_dof_index node) const;

    /** The nodes with axes of their own in ascending order, as pairs of number
     * and axes. */
    auto
    begin() const
    {
      return axes_of_nodes.begin();
    }

    auto
    end() const
    {
      return axes_of_nodes.end();
    }

    /** The axes of the owned nodes and the ghosts of @p nodes. */
    LocalFrames
    local_part(const NodePartition &nodes) const;

  private:
    std::map<types::global_dof_index, Tensor<2, n_components>> axes_of_nodes;
  };
} // namespace StickSlip

#endif
