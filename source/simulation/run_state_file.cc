// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <stickslip/algebra/serial_order.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/checksum.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/atomic_file.h>
#include <stickslip/simulation/run_state_file.h>

#include <fstream>
#include <sstream>

namespace StickSlip
{
  namespace
  {
    /** First word of each file; version of the format, to be changed with
     * anything that is written, size and checksum of all that follows the line
     * come next. */
    const std::string  first_word     = "stickslip-run-state";
    constexpr unsigned format_version = 15;



    /** Properties of a file that must agree with the meshes. */
    struct Header
    {
      unsigned int       n_components = 0;
      unsigned long long n_nodes      = 0;
      /** Of the positions of all vertices. */
      std::uint32_t checksum = 0;

      bool
      operator==(const Header &other) const
      {
        return n_components == other.n_components && n_nodes == other.n_nodes &&
               checksum == other.checksum;
      }

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &n_components &n_nodes &checksum;
      }
    };



    /** Collective. */
    template <int dim>
    Header
    header(const MeshLevel<dim> &level)
    {
      Header result;
      result.n_components = level.nodes.n_components();
      result.n_nodes      = level.n_nodes();
      result.checksum     = level.checksum();
      return result;
    }



    /** All that follows the first line of a file, if it is whole. */
    std::string
    content_of(const std::string &file_name)
    {
      std::ifstream file(file_name, std::ios::binary);
      std::string   line, word;
      std::getline(file, line);
      std::istringstream words(line);
      unsigned int       version  = 0;
      std::size_t        size     = 0;
      std::uint32_t      checksum = 0;
      if (!(words >> word >> version >> size >> checksum) || word != first_word)
        throw InputError("The file '" + file_name +
                         "' is not the state of a run.");
      if (version != format_version)
        throw InputError("The file '" + file_name +
                         "' is the state of a run by another version of the "
                         "program.");
      std::ostringstream content;
      content << file.rdbuf();
      if (content.str().size() != size || crc32(content.str()) != checksum)
        throw InputError("The file '" + file_name +
                         "' with the state of a run is damaged.");
      return content.str();
    }



    /** The values of all nodes on the first process; none of an empty vector.
     */
    std::vector<double>
    gather(const NodalVector &vector,
           const SerialOrder &order,
           const unsigned int n_components)
    {
      if (vector.size() == 0)
        return {};
      return order.gather(std::vector<double>(vector.begin(),
                                              vector.begin() +
                                                vector.locally_owned_size()),
                          n_components);
    }



    template <int dim>
    NodalVector
    nodal_vector(const std::vector<double> &values, const MeshLevel<dim> &level)
    {
      const unsigned int n_components = level.nodes.n_components();
      AssertThrow(values.size() == level.n_nodes() * n_components,
                  ExcDimensionMismatch(values.size(),
                                       level.n_nodes() * n_components));
      NodalVector result = level.nodes.make_vector();
      auto        here   = result.begin();
      for (const types::global_dof_index node : level.owned_serial_nodes())
        here =
          std::copy_n(values.begin() + node * n_components, n_components, here);
      return result;
    }
  } // namespace



  template <int dim, int n_components>
  void
  write_run_state(const std::string                 &file_name,
                  const RunState<dim, n_components> &state,
                  const MeshLevel<dim>              &level,
                  const SceneEntries                &entries)
  {
    const MPI_Comm                   communicator = level.nodes.communicator();
    const SerialOrder                order(level.owned_serial_nodes(),
                            level.n_nodes(),
                            communicator);
    std::vector<std::vector<double>> vectors;
    RunState<dim, n_components>::for_each_vector(
      state, [&](const NodalVector &vector) {
        vectors.push_back(gather(vector, order, n_components));
      });
    const std::vector<std::vector<KeptLinearisation<n_components>>>
      linearisations =
        Utilities::MPI::gather(communicator, state.linearisations);
    const Header start = header(level);
    carry_out_agreed(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) != 0)
        return;
      std::ostringstream content;
      {
        boost::archive::binary_oarchive archive(content);
        archive << entries << start << state << vectors << linearisations;
      }
      std::ostringstream line;
      line << first_word << ' ' << format_version << ' ' << content.str().size()
           << ' ' << crc32(content.str()) << '\n';
      write_file_atomically(file_name, line.str() + content.str());
    });
  }



  SceneEntries
  run_state_entries(const std::string &file_name)
  {
    std::istringstream              content(content_of(file_name));
    boost::archive::binary_iarchive archive(content);
    SceneEntries                    entries;
    archive >> entries;
    return entries;
  }



  template <int dim, int n_components>
  RunState<dim, n_components>
  read_run_state(const std::string &file_name, const MeshLevel<dim> &level)
  {
    RunState<dim, n_components>                               state;
    std::vector<std::vector<double>>                          vectors;
    std::vector<std::vector<KeptLinearisation<n_components>>> linearisations;
    const Header here = header(level);
    carry_out_agreed(level.nodes.communicator(), [&]() {
      std::istringstream content(content_of(file_name));
      try
        {
          boost::archive::binary_iarchive archive(content);
          SceneEntries                    entries;
          Header                          start;
          archive >> entries >> start;
          if (!(start == here))
            throw InputError("The file '" + file_name +
                             "' is not the state of a run with these meshes.");
          archive >> state >> vectors >> linearisations;
        }
      catch (const InputError &)
        {
          throw;
        }
      catch (const std::exception &)
        {
          throw InputError("The file '" + file_name +
                           "' with the state of a run is damaged.");
        }
    });
    auto values = vectors.begin();
    RunState<dim, n_components>::for_each_vector(
      state, [&](NodalVector &vector) {
        if (!values->empty())
          vector = nodal_vector(*values, level);
        ++values;
      });
    const MPI_Comm communicator = level.nodes.communicator();
    if (linearisations.size() == Utilities::MPI::n_mpi_processes(communicator))
      state.linearisations = std::move(
        linearisations[Utilities::MPI::this_mpi_process(communicator)]);
    return state;
  }



  template decltype(write_run_state<2>)    write_run_state<2>;
  template decltype(write_run_state<3>)    write_run_state<3>;
  template decltype(write_run_state<2, 1>) write_run_state<2, 1>;
  template decltype(read_run_state<2>)     read_run_state<2>;
  template decltype(read_run_state<3>)     read_run_state<3>;
  template decltype(read_run_state<2, 1>)  read_run_state<2, 1>;
} // namespace StickSlip
