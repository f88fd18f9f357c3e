// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_history.h>
#include <stickslip/output/hdf5_file.h>
#include <stickslip/parameters/input_error.h>
#include <stickslip/version.h>

#include <fstream>

namespace StickSlip
{
  namespace
  {
    void
    describe(const hid_t        data_set,
             const std::string &units,
             const std::string &description)
    {
      write_hdf5_attribute(data_set, "units", units);
      write_hdf5_attribute(data_set, "description", description);
    }



    template <int rank>
    std::vector<double>
    flatten(const std::vector<Tensor<1, rank>> &vectors)
    {
      std::vector<double> values;
      values.reserve(vectors.size() * rank);
      for (const Tensor<1, rank> &vector : vectors)
        for (unsigned int d = 0; d < rank; ++d)
          values.push_back(vector[d]);
      return values;
    }



    Hdf5Series
    described_series(const hid_t                 group,
                     const std::string          &name,
                     const std::vector<hsize_t> &record_shape,
                     const std::string          &units,
                     const std::string          &description)
    {
      Hdf5Series series(group, name, record_shape);
      describe(series.id(), units, description);
      return series;
    }



    template <int dim>
    std::vector<hsize_t>
    vector_shape(const hsize_t n_nodes)
    {
      return dim == 2 ? std::vector<hsize_t>{n_nodes} :
                        std::vector<hsize_t>{n_nodes, dim - 1};
    }



    // The data sets of one fault.
    template <int dim>
    class FaultGroup
    {
    public:
      FaultGroup(const hid_t file, const FaultSnapshot<dim> &fault);

      void
      append(const double time, const FaultSnapshot<dim> &fault);

    private:
      unsigned int n_nodes;
      Hdf5Handle   group;
      Hdf5Series   time, slip, slip_rate, shear_traction, normal_stress, state;
    };



    template <int dim>
    FaultGroup<dim>::FaultGroup(const hid_t               file,
                                const FaultSnapshot<dim> &fault)
      : n_nodes(fault.points.size())
      , group(create_hdf5_group(file, fault.name))
      , time(described_series(group, "time", {}, "s", "time of each record"))
      , slip(described_series(group,
                              "slip",
                              vector_shape<dim>(n_nodes),
                              "m",
                              "slip of the upper body relative to the lower "
                              "one, tangential components"))
      , slip_rate(described_series(group,
                                   "slip_rate",
                                   vector_shape<dim>(n_nodes),
                                   "m/s",
                                   "rate of the slip, tangential components"))
      , shear_traction(described_series(group,
                                        "shear_traction",
                                        vector_shape<dim>(n_nodes),
                                        "Pa",
                                        "traction that resists the slip, with "
                                        "the sign of the slip rate"))
      , normal_stress(described_series(group,
                                       "normal_stress",
                                       {n_nodes},
                                       "Pa",
                                       "normal stress, compression positive"))
      , state(described_series(group,
                               "state",
                               {n_nodes},
                               "s",
                               "state theta of the friction law"))
    {
      std::vector<double> coordinates;
      for (const Point<dim> &point : fault.points)
        for (unsigned int d = 0; d < dim; ++d)
          coordinates.push_back(point[d]);
      describe(
        write_hdf5_array(group, "coordinates", {n_nodes, dim}, coordinates),
        "m",
        "reference positions of the nodes");
      describe(write_hdf5_array(group, "weight", {n_nodes}, fault.weights),
               dim == 2 ? "m" : "m^2",
               "share of each node in the fault's area; 0: not in contact");
    }



    template <int dim>
    void
    FaultGroup<dim>::append(const double              new_time,
                            const FaultSnapshot<dim> &fault)
    {
      AssertDimension(fault.points.size(), n_nodes);
      slip.append(flatten(fault.slip));
      slip_rate.append(flatten(fault.slip_rate));
      shear_traction.append(flatten(fault.shear_traction));
      normal_stress.append(fault.normal_stress);
      state.append(fault.state);
      // Last, so that each time has its fields.
      time.append({new_time});
    }
  } // namespace



  template <int dim>
  class FaultHistory<dim>::File
  {
  public:
    File(const std::string                     &file_name,
         const std::vector<FaultSnapshot<dim>> &faults)
      : file(create_hdf5_file(file_name))
    {
      write_hdf5_attribute(file, "program", "stickslip");
      write_hdf5_attribute(file, "version", StickSlip::version);
      write_hdf5_attribute(file,
                           "layout",
                           "a group per fault; first extent of time-dependent "
                           "data sets: record, second: node");
      groups.reserve(faults.size());
      for (const FaultSnapshot<dim> &fault : faults)
        groups.emplace_back(file, fault);
      flush();
    }

    void
    flush()
    {
      AssertThrow(H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0,
                  ExcMessage("HDF5 failed to write the faults' records."));
    }

    // In this order, so that the file is closed last.
    Hdf5Handle                   file;
    std::vector<FaultGroup<dim>> groups;
    unsigned int                 n_records = 0;
  };



  template <int dim>
  FaultHistory<dim>::FaultHistory(const std::string &file_name,
                                  const std::vector<FaultSnapshot<dim>> &faults)
  {
    // HDF5 would print a stack of its own.
    if (!std::ofstream(file_name))
      throw InputError("The file '" + file_name + "' cannot be written.");
    file = std::make_unique<File>(file_name, faults);
  }



  template <int dim>
  FaultHistory<dim>::~FaultHistory() = default;



  template <int dim>
  void
  FaultHistory<dim>::add(const double                           time,
                         const std::vector<FaultSnapshot<dim>> &faults)
  {
    AssertDimension(faults.size(), file->groups.size());
    for (unsigned int i = 0; i < faults.size(); ++i)
      file->groups[i].append(time, faults[i]);
    file->flush();
    ++file->n_records;
  }



  template <int dim>
  unsigned int
  FaultHistory<dim>::n_records() const
  {
    return file->n_records;
  }



  template class FaultHistory<2>;
  template class FaultHistory<3>;
} // namespace StickSlip
