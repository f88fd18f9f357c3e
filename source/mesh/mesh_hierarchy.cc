// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/fe/fe.h>
#include <deal.II/lac/full_matrix.h>

#include <stickslip/mesh/mesh_hierarchy.h>

#include <algorithm>

namespace StickSlip
{
  namespace
  {
    /**
     * Walks the trees of a fine and a coarse mesh together. Below an active
     * coarse cell, @p values holds the coarse cell's basis functions at the
     * vertices of the current fine cell.
     */
    template <int dim>
    class TreeWalk
    {
    public:
      TreeWalk(const BodyMesh<dim> &coarse, const BodyMesh<dim> &fine)
        : coarse(coarse)
        , fine(fine)
        , rows(fine.dof_handler().n_dofs())
        , visited(rows.size(), false)
      {}

      void
      both(const typename DoFHandler<dim>::cell_iterator &fine_cell,
           const typename DoFHandler<dim>::cell_iterator &coarse_cell)
      {
        if (coarse_cell->is_active())
          {
            coarse_dofs.resize(coarse_cell->get_fe().n_dofs_per_cell());
            coarse_cell->get_dof_indices(coarse_dofs);
            below(fine_cell, IdentityMatrix(coarse_dofs.size()));
          }
        else
          for (unsigned int child = 0; child < fine_cell->n_children(); ++child)
            both(fine_cell->child(child), coarse_cell->child(child));
      }

      std::vector<TransferMatrix::Row>
      result()
      {
        return std::move(rows);
      }

    private:
      void
      below(const typename DoFHandler<dim>::cell_iterator &fine_cell,
            const FullMatrix<double>                      &values)
      {
        if (fine_cell->is_active())
          {
            std::vector<types::global_dof_index> fine_dofs(values.m());
            fine_cell->get_dof_indices(fine_dofs);
            for (unsigned int i = 0; i < fine_dofs.size(); ++i)
              set_row(fine_dofs[i], values, i);
            return;
          }
        for (unsigned int child = 0; child < fine_cell->n_children(); ++child)
          {
            FullMatrix<double> product(values.m(), values.n());
            fine.dof_handler()
              .get_fe()
              .get_prolongation_matrix(child, fine_cell->refinement_case())
              .mmult(product, values);
            below(fine_cell->child(child), product);
          }
      }

      void
      set_row(const types::global_dof_index fine_dof,
              const FullMatrix<double>     &values,
              const unsigned int            i)
      {
        if (visited[fine_dof] || fine.hanging_nodes().is_constrained(fine_dof))
          return;
        visited[fine_dof] = true;
        for (unsigned int j = 0; j < coarse_dofs.size(); ++j)
          if (const double value = values(i, j))
            {
              const auto *masters =
                coarse.hanging_nodes().get_constraint_entries(coarse_dofs[j]);
              if (masters == nullptr)
                rows[fine_dof].emplace_back(coarse_dofs[j], value);
              else
                for (const auto &master : *masters)
                  rows[fine_dof].emplace_back(master.first,
                                              value * master.second);
            }
      }

      const BodyMesh<dim>                 &coarse;
      const BodyMesh<dim>                 &fine;
      std::vector<types::global_dof_index> coarse_dofs;
      std::vector<TransferMatrix::Row>     rows;
      std::vector<bool>                    visited;
    };



    template <int dim>
    MeshLevel<dim>
    make_level(const std::vector<std::shared_ptr<const BodyMesh<dim>>> &bodies,
               const MPI_Comm &communicator)
    {
      MeshLevel<dim> level;
      level.bodies     = bodies;
      level.first_node = {0};
      for (const auto &body : bodies)
        level.first_node.push_back(level.first_node.back() +
                                   body->dof_handler().n_dofs());
      const types::global_dof_index n = level.first_node.back();
      level.nodes =
        NodePartition(complete_index_set(n), IndexSet(n), dim, communicator);
      return level;
    }
  } // namespace



  template <int dim>
  std::vector<TransferMatrix::Row>
  nodal_prolongation(const BodyMesh<dim> &coarse, const BodyMesh<dim> &fine)
  {
    TreeWalk<dim> walk(coarse, fine);
    auto          coarse_cell = coarse.dof_handler().begin(0);
    for (auto fine_cell = fine.dof_handler().begin(0);
         fine_cell != fine.dof_handler().end(0);
         ++fine_cell, ++coarse_cell)
      walk.both(fine_cell, coarse_cell);
    return walk.result();
  }



  template <int dim>
  unsigned int
  MeshLevel<dim>::node(const unsigned int            body,
                       const types::global_dof_index dof) const
  {
    return nodes.local_index(first_node[body] + dof);
  }



  template <int dim>
  MeshHierarchy<dim>::MeshHierarchy(
    const std::vector<BodyGeometry<dim>> &geometries,
    const MPI_Comm                       &communicator)
  {
    std::vector<std::shared_ptr<const BodyMesh<dim>>> bodies;
    for (unsigned int i = 0; i < geometries.size(); ++i)
      bodies.push_back(std::make_shared<BodyMesh<dim>>(geometries[i],
                                                       /*fault_below=*/i > 0,
                                                       /*fault_above=*/i + 1 <
                                                         geometries.size()));
    levels.push_back(make_level<dim>(bodies, communicator));

    while (std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
      return body->can_be_coarsened();
    }))
      {
        const MeshLevel<dim>            &fine = levels.back();
        std::vector<TransferMatrix::Row> rows(fine.first_node.back());
        types::global_dof_index          first_coarse = 0;
        for (unsigned int i = 0; i < bodies.size(); ++i)
          {
            if (bodies[i]->can_be_coarsened())
              bodies[i] = std::make_shared<BodyMesh<dim>>(*bodies[i]);
            auto body_rows =
              nodal_prolongation<dim>(*bodies[i], *fine.bodies[i]);
            for (unsigned int dof = 0; dof < body_rows.size(); ++dof)
              {
                for (auto &entry : body_rows[dof])
                  entry.first += first_coarse;
                rows[fine.first_node[i] + dof] = std::move(body_rows[dof]);
              }
            first_coarse += bodies[i]->dof_handler().n_dofs();
          }
        prolongations.emplace_back(rows, first_coarse);
        levels.push_back(make_level<dim>(bodies, communicator));
      }
    std::reverse(levels.begin(), levels.end());
    std::reverse(prolongations.begin(), prolongations.end());
  }



  template <int dim>
  unsigned int
  MeshHierarchy<dim>::n_levels() const
  {
    return levels.size();
  }



  template <int dim>
  unsigned int
  MeshHierarchy<dim>::n_bodies() const
  {
    return levels.back().bodies.size();
  }



  template <int dim>
  const MeshLevel<dim> &
  MeshHierarchy<dim>::level(const unsigned int l) const
  {
    return levels[l];
  }



  template <int dim>
  const MeshLevel<dim> &
  MeshHierarchy<dim>::finest() const
  {
    return levels.back();
  }



  template <int dim>
  const TransferMatrix &
  MeshHierarchy<dim>::prolongation(const unsigned int l) const
  {
    AssertIndexRange(l - 1, prolongations.size());
    return prolongations[l - 1];
  }



  template class MeshHierarchy<2>;
  template class MeshHierarchy<3>;
  template struct MeshLevel<2>;
  template struct MeshLevel<3>;
  template std::vector<TransferMatrix::Row>
  nodal_prolongation<2>(const BodyMesh<2> &, const BodyMesh<2> &);
  template std::vector<TransferMatrix::Row>
  nodal_prolongation<3>(const BodyMesh<3> &, const BodyMesh<3> &);
} // namespace StickSlip
