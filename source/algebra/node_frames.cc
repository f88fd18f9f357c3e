// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>
#include <deal.II/base/symmetric_tensor.h>

#include <stickslip/algebra/node_frames.h>

namespace StickSlip
{
  LocalFrames::LocalFrames(const unsigned int        n_nodes,
                           const unsigned int        components,
                           std::vector<unsigned int> nodes,
                           std::vector<double>       matrices)
  {
    const unsigned int size = components * components;
    AssertDimension(matrices.size(), nodes.size() * size);
    if (nodes.empty())
      return;
    std::vector<int> position(n_nodes, -1);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      position[nodes[k]] = k * size;
    frames = std::make_shared<const Frames>(Frames{
      components, std::move(nodes), std::move(matrices), std::move(position)});
  }



  const std::vector<unsigned int> &
  LocalFrames::nodes() const
  {
    static const std::vector<unsigned int> none;
    return empty() ? none : frames->nodes;
  }



  bool
  LocalFrames::operator==(const LocalFrames &other) const
  {
    if (frames == other.frames)
      return true;
    return frames != nullptr && other.frames != nullptr &&
           frames->nodes == other.frames->nodes &&
           frames->matrices == other.frames->matrices;
  }



  unsigned int
  LocalFrames::n_components() const
  {
    return empty() ? 0 : frames->components;
  }



  std::size_t
  LocalFrames::memory_consumption() const
  {
    if (empty())
      return 0;
    return sizeof(unsigned int) * frames->nodes.size() +
           sizeof(double) * frames->matrices.size() +
           sizeof(int) * frames->position.size();
  }



  template <int n_components>
  void
  NodeFrames<n_components>::set(const types::global_dof_index  node,
                                const Tensor<2, n_components> &axes)
  {
    constexpr double              tolerance = 1e-10;
    const Tensor<2, n_components> identity =
      unit_symmetric_tensor<n_components>();
    // A NaN is no axis.
    AssertThrow((transpose(axes) * axes - identity).norm() <= tolerance,
                ExcMessage("The axes of a node must be orthonormal."));
    if (axes == identity)
      axes_of_nodes.erase(node);
    else
      axes_of_nodes[node] = axes;
  }



  template <int n_components>
  const Tensor<2, n_components> *
  NodeFrames<n_components>::find(const types::global_dof_index node) const
  {
    const auto found = axes_of_nodes.find(node);
    return found == axes_of_nodes.end() ? nullptr : &found->second;
  }



  template <int n_components>
  LocalFrames
  NodeFrames<n_components>::local_part(const NodePartition &nodes) const
  {
    if (empty())
      return {};
    std::vector<unsigned int> local;
    std::vector<double>       matrices;
    for (unsigned int i = 0; i < nodes.n_local(); ++i)
      if (const Tensor<2, n_components> *axes = find(nodes.global_index(i)))
        {
          local.push_back(i);
          for (unsigned int c = 0; c < n_components; ++c)
            for (unsigned int d = 0; d < n_components; ++d)
              matrices.push_back((*axes)[c][d]);
        }
    return LocalFrames(nodes.n_local(),
                       n_components,
                       std::move(local),
                       std::move(matrices));
  }



  template class NodeFrames<1>;
  template class NodeFrames<2>;
  template class NodeFrames<3>;
} // namespace StickSlip
