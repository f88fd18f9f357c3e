// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <stickslip/base/input_error.h>
#include <stickslip/geometry/gmsh_file.h>
#include <stickslip/geometry/gmsh_sections.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>

namespace StickSlip
{
  namespace
  {
    /** Kinds of elements that can be used: dimension and order of nodes. */
    struct Shape
    {
      unsigned int                dim;
      unsigned int                n_nodes;
      std::array<unsigned int, 8> order;
    };

    const std::map<int, Shape> shapes = {{1, {1, 2, {{0, 1}}}},
                                         {2, {2, 3, {{0, 1, 2}}}},
                                         {3, {2, 4, {{0, 1, 3, 2}}}},
                                         {4, {3, 4, {{0, 1, 2, 3}}}},
                                         {5,
                                          {3, 8, {{0, 1, 3, 2, 4, 5, 7, 6}}}},
                                         {15, {0, 1, {{0}}}}};



    class GmshReader
    {
    public:
      GmshReader(const std::string &contents,
                 const std::string &name,
                 const double       length_unit)
        : input(contents, name)
        , length_unit(length_unit)
      {
        file.name = name;
      }

      GmshFile
      read()
      {
        if (input.next_section() != "MeshFormat")
          input.fail("is not one of Gmsh: it does not begin with a section "
                     "$MeshFormat");
        read_format();
        bool has_nodes = false, has_elements = false;
        for (std::string section = input.next_section(); !section.empty();
             section             = input.next_section())
          {
                        if (section == "PhysicalNames")
              read_names();
            else if (section == "Entities" && is_version_4)
              read_entities();
            else if (section == "Nodes")
              {
                            if (is_version_4)
                  read_nodes_4();
                else
                  read_nodes_2();
                has_nodes = true;
              }
            else if (section == "Elements")
              {
                            if (!has_nodes)
                  input.fail("has no section $Nodes before its elements");
                if (is_version_4)
                  read_elements_4();
                else
                  read_elements_2();
                has_elements = true;
              }
            else
              {
                            is_partitioned =
                              is_partitioned || section == "PartitionedEntities";
                            input.skip_section();
                            continue;
              }
            input.end_section();
          }
        if (!has_elements)
          input.fail("has no section $Elements");
        return std::move(file);
      }

    private:
      void
      read_format()
      {
        const std::string version = input.word();
        if (version != "2.2" && version != "4.1")
          input.fail("is of version " + version +
                     ", but only versions 2.2 and 4.1 can be read: write it "
                     "with gmsh -format msh41");
        is_version_4     = version == "4.1";
        const int binary = input.text<int>();
        const int size   = input.text<int>();
        if (binary == 1)
          {
            if (size != 8 && (!is_version_4 || size != 4))
              input.fail("has numbers of " + std::to_string(size) +
                         " bytes, which is not known");
            input.end_line();
            if (input.bytes<int>() != 1)
              input.fail("has its bytes in another order than this machine: "
                         "write it as text");
          }
        input.binary     = binary == 1;
        input.size_bytes = size;
        input.end_section();
      }

      void
      read_names()
      {
        const int n = input.text<int>();
        for (int i = 0; i < n; ++i)
          {
            const int         dim  = input.text<int>();
            const int         tag  = input.text<int>();
            const std::string name = input.quoted();
            if (dim < 0 || dim > 3)
              input.fail("has a group '" + name + "' of dimension " +
                         std::to_string(dim));
            for (const GmshFile::Group &group : file.groups)
              if (group.dim == static_cast<unsigned int>(dim) &&
                  group.name == name)
                input.fail("has two groups '" + name + "' of dimension " +
                           std::to_string(dim));
            file.groups[group_number(dim, tag)].name = name;
          }
      }

      /** The place of a group among all of them; a new one if it has none. */
      unsigned int
      group_number(const unsigned int dim, const int tag)
      {
        if (tag == 0)
          return GmshFile::no_group;
        // Gmsh turns elements of negative tags around.
        const auto [place, is_new] =
          group_of_tag.emplace(std::make_pair(dim, std::abs(tag)),
                               file.groups.size());
        if (is_new)
          file.groups.push_back({dim, std::abs(tag), ""});
        return place->second;
      }

      void
      read_entities()
      {
        std::array<std::uint64_t, 4> n;
        for (auto &number : n)
          number = input.size();
        for (unsigned int dim = 0; dim < 4; ++dim)
          for (std::uint64_t i = 0; i < n[dim]; ++i)
            {
              const int tag = input.integer();
              // A position, or corners of a box.
              for (unsigned int j = 0; j < (dim == 0 ? 3 : 6); ++j)
                input.real();
              std::vector<unsigned int> &groups = groups_of_entity[{dim, tag}];
              for (std::uint64_t n_groups = input.size(); n_groups > 0;
                   --n_groups)
                groups.push_back(group_number(dim, input.integer()));
              if (dim > 0)
                for (std::uint64_t n_bounding = input.size(); n_bounding > 0;
                     --n_bounding)
                  input.integer();
            }
      }

      void
      read_nodes_2()
      {
        const auto n = input.text<std::uint64_t>();
        reserve_nodes(n);
        if (input.binary)
          input.end_line();
        for (std::uint64_t i = 0; i < n; ++i)
          {
            add_node(input.tag());
            read_position(file.nodes.back());
          }
      }

      void
      read_nodes_4()
      {
        const std::uint64_t n_blocks = input.size();
        reserve_nodes(input.size());
        input.size();
        input.size();
        for (std::uint64_t block = 0; block < n_blocks; ++block)
          {
            const int dim = input.integer();
            input.integer();
            const bool          is_parametric = input.integer() != 0;
            const std::uint64_t n             = input.size();
            const std::size_t   first         = file.nodes.size();
            for (std::uint64_t i = 0; i < n; ++i)
              add_node(input.size());
            for (std::uint64_t i = 0; i < n; ++i)
              {
                read_position(file.nodes[first + i]);
                for (int j = 0; is_parametric && j < dim; ++j)
                  input.real();
              }
          }
      }

      void
      reserve_nodes(const std::uint64_t n)
      {
        file.nodes.reserve(input.plausible(n));
        node_of_tag.reserve(input.plausible(n));
      }

      void
      add_node(const std::uint64_t tag)
      {
        if (!node_of_tag.emplace(tag, file.nodes.size()).second)
          input.fail("has two nodes with number " + std::to_string(tag));
        file.nodes.emplace_back();
      }

      void
      read_position(Point<3> &position)
      {
        for (unsigned int d = 0; d < 3; ++d)
          {
            position[d] = input.real() * length_unit;
            if (!std::isfinite(position[d]))
              input.fail("has a node whose position is not finite");
          }
      }

      void
      read_elements_2()
      {
        const auto n = input.text<std::uint64_t>();
        if (input.binary)
          input.end_line();
        for (std::uint64_t i = 0; i < n;)
          {
            std::uint64_t tag  = 0;
            int           type = 0, n_elements = 1, n_tags = 0;
            if (!input.binary)
              tag = input.tag();
            type = input.integer();
            if (input.binary)
              n_elements = input.integer();
            n_tags = input.integer();
            if (n_elements < 1)
              input.fail("has an empty block of elements");
            for (int j = 0; j < n_elements; ++j, ++i)
              {
                if (input.binary)
                  tag = input.tag();
                int group_tag = 0;
                for (int t = 0; t < n_tags; ++t)
                  {
                    const int value = input.integer();
                    if (t == 0)
                      group_tag = value;
                  }
                const auto         known = shapes.find(type);
                const unsigned int group =
                  known == shapes.end() ?
                    GmshFile::no_group :
                    group_number(known->second.dim, group_tag);
                const Shape &shape = shape_of(type, {group}, group_tag);
                add_element(shape, tag, {group}, [this]() {
                  return input.tag();
                });
              }
          }
      }

      void
      read_elements_4()
      {
        const std::uint64_t n_blocks = input.size();
        for (unsigned int i = 0; i < 3; ++i)
          input.size();
        for (std::uint64_t block = 0; block < n_blocks; ++block)
          {
            const int           dim    = input.integer();
            const int           entity = input.integer();
            const int           type   = input.integer();
            const std::uint64_t n      = input.size();
            const auto          place =
              groups_of_entity.find({static_cast<unsigned int>(dim), entity});
            if (place == groups_of_entity.end())
              input.fail("has elements on an entity of dimension " +
                         std::to_string(dim) + " and number " +
                         std::to_string(entity) +
                         " that its section $Entities does not have" +
                         (is_partitioned ?
                            ": it is divided into partitions, and must be "
                            "written without" :
                            ""));
            std::vector<unsigned int> groups = place->second;
            const Shape              &shape  = shape_of(type, groups, 0);
            if (groups.empty())
              groups.push_back(GmshFile::no_group);
            for (std::uint64_t i = 0; i < n; ++i)
              {
                const std::uint64_t tag = input.size();
                add_element(shape, tag, groups, [this]() {
                  return input.size();
                });
              }
          }
      }

      const Shape &
      shape_of(const int                        type,
               const std::vector<unsigned int> &groups,
               const int                        group_tag) const
      {
        const auto place = shapes.find(type);
        if (place != shapes.end())
          return place->second;
        std::string where = "";
        if (!groups.empty() && groups[0] != GmshFile::no_group)
          where = " in " + file.describe(groups[0]);
        else
          for (const GmshFile::Group &group : file.groups)
            if (group.tag == std::abs(group_tag) && group.dim > 0 &&
                where.empty())
              where = " in the group '" + group.name + "'";
        if (type == 6 || type == 7)
          input.fail(std::string("has ") + (type == 6 ? "prisms" : "pyramids") +
                     where +
                     ", but only triangles, quadrilaterals, tetrahedra and "
                     "hexahedra can be used");
        if (type >= 8 && type <= 19)
          input.fail("has elements of second order" + where +
                     ": it must be written with gmsh -order 1");
        input.fail("has elements of Gmsh's type " + std::to_string(type) +
                   where + ", which cannot be used");
      }

      template <typename NextNode>
      void
      add_element(const Shape                     &shape,
                  const std::uint64_t              tag,
                  const std::vector<unsigned int> &groups,
                  const NextNode                  &next_node)
      {
        GmshFile::Element element = {};
        element.n_nodes           = shape.n_nodes;
        for (unsigned int i = 0; i < shape.n_nodes; ++i)
          {
            const std::uint64_t node  = next_node();
            const auto          place = node_of_tag.find(node);
            if (place == node_of_tag.end())
              input.fail("has an element, number " + std::to_string(tag) +
                         (groups[0] == GmshFile::no_group ?
                            "" :
                            " in " + file.describe(groups[0])) +
                         ", with the node " + std::to_string(node) +
                         ", which is not in its section $Nodes");
            element.nodes[shape.order[i]] = place->second;
          }
        for (const unsigned int group : groups)
          {
            element.group = group;
            file.elements[shape.dim].push_back(element);
          }
      }

      GmshSections input;
      double       length_unit;
      GmshFile     file;
      bool         is_version_4   = false;
      bool         is_partitioned = false;
      std::map<std::pair<unsigned int, int>, unsigned int> group_of_tag;
      std::map<std::pair<unsigned int, int>, std::vector<unsigned int>>
                                                      groups_of_entity;
      std::unordered_map<std::uint64_t, unsigned int> node_of_tag;
    };
  } // namespace



  GmshFile::GmshFile(const std::string &file_name, const double length_unit)
  {
    // Reading a folder throws what does not name it.
    if (std::filesystem::is_directory(file_name))
      throw InputError("The mesh file '" + file_name + "' is a folder.");
    std::ifstream stream(file_name, std::ios::binary);
    std::string   contents((std::istreambuf_iterator<char>(stream)),
                         std::istreambuf_iterator<char>());
    if (!stream)
      throw InputError("The mesh file '" + file_name + "' cannot be read.");
    *this = parse(contents, file_name, length_unit);
  }



  GmshFile
  GmshFile::parse(const std::string &contents,
                  const std::string &name,
                  const double       length_unit)
  {
    return GmshReader(contents, name, length_unit).read();
  }



  std::string
  GmshFile::describe(const unsigned int group) const
  {
    if (group == no_group)
      return "no group";
    const Group &described = groups[group];
    if (!described.name.empty())
      return "the group '" + described.name + "'";
    return "the group without a name, number " + std::to_string(described.tag) +
           " of dimension " + std::to_string(described.dim);
  }
} // namespace StickSlip
