// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/algebra/masked_entries.h>
#include <stickslip/multigrid/block_gauss_seidel.h>

namespace StickSlip
{
  template <int n_components, typename Number>
  BlockGaussSeidel<n_components, Number>::BlockGaussSeidel(
    const BlockSparsity &sparsity)
    : n_rows(sparsity.n_rows())
  {
    lower.row_start.reserve(n_rows + 1);
    upper.row_start.reserve(n_rows + 1);
    for (unsigned int i = 0; i < n_rows; ++i)
      {
        const auto columns = sparsity.column.begin();
        // Ghosts lie behind all owned nodes, so they belong to the upper part.
        lower.column.insert(lower.column.end(),
                            columns + sparsity.row_start[i],
                            columns + sparsity.diagonal[i]);
        upper.column.insert(upper.column.end(),
                            columns + sparsity.diagonal[i] + 1,
                            columns + sparsity.row_start[i + 1]);
        lower.row_start.push_back(lower.column.size());
        upper.row_start.push_back(upper.column.size());
      }
    for (Part *part : {&lower, &upper})
      part->values.resize(std::size_t(part->column.size()) * n_components *
                            n_components +
                          Kernels::sweep_padding);
    inverse_diagonal.resize(std::size_t(n_rows) * n_components * n_components +
                            Kernels::sweep_padding);
  }



  template <int n_components, typename Number>
  Kernels::Triangle<Number>
  BlockGaussSeidel<n_components, Number>::Part::rows() const
  {
    return {row_start.data(), column.data(), values.data()};
  }



  template <int n_components, typename Number>
  template <typename OtherNumber>
  void
  BlockGaussSeidel<n_components, Number>::set_row(
    const unsigned int                            i,
    const BlockMatrix<n_components, OtherNumber> &matrix)
  {
    const BlockSparsity &sparsity = matrix.sparsity();
    const auto           copy     = [&](Part &part, const unsigned int begin) {
      Number *target = part.values.data() + std::size_t(part.row_start[i]) *
                                              n_components * n_components;
      const unsigned int n = part.row_start[i + 1] - part.row_start[i];
      for (unsigned int k = 0; k < n;
           ++k, target += n_components * n_components)
        for (unsigned int c = 0; c < n_components; ++c)
          for (unsigned int d = 0; d < n_components; ++d)
            target[Kernels::sweep_position<n_components>(c, d)] =
              matrix.block(begin + k)[c * n_components + d];
    };
    copy(lower, sparsity.row_start[i]);
    copy(upper, sparsity.diagonal[i] + 1);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::set_diagonal(
    const unsigned int             i,
    const Tensor<2, n_components> &block,
    const NodeMask                &active)
  {
    set_inverse_diagonal(i, invert_active(block, active, i));
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::set_inverse_diagonal(
    const unsigned int             i,
    const Tensor<2, n_components> &inverse)
  {
    Number *target =
      inverse_diagonal.data() + std::size_t(i) * n_components * n_components;
    for (unsigned int c = 0; c < n_components; ++c)
      for (unsigned int d = 0; d < n_components; ++d)
        target[Kernels::sweep_position<n_components>(c, d)] = inverse[c][d];
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_from_zero(
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    Kernels::sweep_from_zero<n_components>(
      lower.rows(), inverse_diagonal.data(), n_rows, b.begin(), x.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_after_first_sweep(
    NodeValues<Number>       &r,
    const NodeValues<Number> &x) const
  {
    update_ghosts(x);
    Kernels::residual_after_sweep<n_components>(upper.rows(),
                                                n_rows,
                                                x.begin(),
                                                r.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_forward(
    NodeValues<Number>       &x,
    NodeValues<Number>       &change,
    const NodeValues<Number> &b) const
  {
    update_ghosts(x);
    change = x;
    Kernels::sweep_forward<n_components>(lower.rows(),
                                         upper.rows(),
                                         inverse_diagonal.data(),
                                         n_rows,
                                         b.begin(),
                                         x.begin());
    change.sadd(Number(-1.), Number(1.), x);
    update_ghosts(change);
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::residual_after_sweep(
    NodeValues<Number>       &r,
    const NodeValues<Number> &change) const
  {
    Kernels::residual_after_sweep<n_components>(upper.rows(),
                                                n_rows,
                                                change.begin(),
                                                r.begin());
  }



  template <int n_components, typename Number>
  void
  BlockGaussSeidel<n_components, Number>::sweep_backward(
    NodeValues<Number>       &x,
    const NodeValues<Number> &b) const
  {
    update_ghosts(x);
    Kernels::sweep_backward<n_components>(lower.rows(),
                                          upper.rows(),
                                          inverse_diagonal.data(),
                                          n_rows,
                                          b.begin(),
                                          x.begin());
  }



  template <int n_components, typename Number>
  std::size_t
  BlockGaussSeidel<n_components, Number>::Part::memory_consumption() const
  {
    return sizeof(unsigned int) * (row_start.capacity() + column.capacity()) +
           sizeof(Number) * values.capacity();
  }



  template <int n_components, typename Number>
  std::size_t
  BlockGaussSeidel<n_components, Number>::memory_consumption() const
  {
    return lower.memory_consumption() + upper.memory_consumption() +
           sizeof(Number) * inverse_diagonal.capacity();
  }



#define STICKSLIP_INSTANTIATE(n_components, Number)                      \
  template class BlockGaussSeidel<n_components, Number>;                 \
  template void BlockGaussSeidel<n_components, Number>::set_row<double>( \
    const unsigned int, const BlockMatrix<n_components, double> &);

  STICKSLIP_INSTANTIATE(1, float)
  STICKSLIP_INSTANTIATE(2, float)
  STICKSLIP_INSTANTIATE(1, double)
  STICKSLIP_INSTANTIATE(2, double)
  STICKSLIP_INSTANTIATE(3, float)
  STICKSLIP_INSTANTIATE(3, double)
#undef STICKSLIP_INSTANTIATE

  template void
  BlockGaussSeidel<1, float>::set_row(const unsigned int,
                                      const BlockMatrix<1, float> &);
  template void
  BlockGaussSeidel<2, float>::set_row(const unsigned int,
                                      const BlockMatrix<2, float> &);
  template void
  BlockGaussSeidel<3, float>::set_row(const unsigned int,
                                      const BlockMatrix<3, float> &);
} // namespace StickSlip
