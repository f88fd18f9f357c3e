// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/fault_history.h>
#include <stickslip/output/hdf5_file.h>
#include <stickslip/version.h>

#include <fstream>
#include <map>

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



    /** Form in which a field is written: tangential vectors or numbers of all
     * nodes, the other one null. */
    template <int dim>
    struct FieldDescription
    {
      std::string                     units, description;
      std::vector<Tensor<1, dim - 1>> FaultSnapshot<dim>::*vectors;
      std::vector<double> FaultSnapshot<dim>::*numbers;

      /** Extents of a record. */
      std::vector<hsize_t>
      shape(const hsize_t n_nodes) const
      {
        if (vectors && dim == 3)
          return {n_nodes, dim - 1};
        return {n_nodes};
      }

      /** All values of a record, node by node. */
      std::vector<double>
      values(const FaultSnapshot<dim> &fault) const
      {
        return vectors ? flatten(fault.*vectors) : fault.*numbers;
      }
    };



    template <int dim>
    FieldDescription<dim>
    describe(const FaultField field)
    {
      using Fault = FaultSnapshot<dim>;
      static const std::map<FaultField, FieldDescription<dim>> fields = {
        {FaultField::slip,
         {"m",
          "slip of the upper body relative to the lower one, tangential "
          "components",
          &Fault::slip,
          nullptr}},
        {FaultField::slip_rate,
         {"m/s",
          "rate of the slip, tangential components",
          &Fault::slip_rate,
          nullptr}},
        {FaultField::shear_traction,
         {"Pa",
          "traction that resists the slip, with the sign of the slip rate",
          &Fault::shear_traction,
          nullptr}},
        {FaultField::normal_stress,
         {"Pa",
          "normal stress that friction feels, compression positive",
          nullptr,
          &Fault::normal_stress}},
        {FaultField::state,
         {"s", "state theta of the friction law", nullptr, &Fault::state}},
        {FaultField::contact_pressure,
         {"Pa",
          "force that keeps the sides together over the area, compression "
          "positive",
          nullptr,
          &Fault::contact_pressure}},
        {FaultField::contact_weight,
         {dim == 2 ? "m" : "m^2",
          "share of each node in the area of contact; 0: not in contact",
          nullptr,
          &Fault::weights}}};
      return fields.at(field);
    }



    // The data sets of one fault.
    template <int dim>
    class FaultGroup
    {
    public:
      FaultGroup(const hid_t                    file,
                 const FaultSnapshot<dim>      &fault,
                 const std::vector<FaultField> &wanted)
        : n_nodes(fault.points.size())
        , group(create_hdf5_group(file, fault.name))
        , time(group, "time", {})
      {
        describe(time.id(), "s", "time of each record");
        for (const auto &[field, name] : fault_field_names())
          if (has_field(wanted, field))
            {
              const FieldDescription<dim> description = describe<dim>(field);
              fields.push_back(
                {description,
                 Hdf5Series(group, name, description.shape(n_nodes))});
              describe(fields.back().series.id(),
                       description.units,
                       description.description);
            }

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

      void
      append(const double new_time, const FaultSnapshot<dim> &fault)
      {
        AssertDimension(fault.points.size(), n_nodes);
        for (Field &field : fields)
          field.series.append(field.description.values(fault));
        // Last, so that each time has its fields.
        time.append({new_time});
      }

    private:
      struct Field
      {
        FieldDescription<dim> description;
        Hdf5Series            series;
      };

      unsigned int       n_nodes;
      Hdf5Handle         group;
      Hdf5Series         time;
      std::vector<Field> fields;
    };
  } // namespace



  template <int dim>
  class FaultHistory<dim>::File
  {
  public:
    File(const std::string                     &file_name,
         const std::vector<FaultSnapshot<dim>> &faults,
         const std::vector<FaultField>         &fields)
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
        groups.emplace_back(file, fault, fields);
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
  };



  template <int dim>
  FaultHistory<dim>::FaultHistory(const std::string &file_name,
                                  const std::vector<FaultSnapshot<dim>> &faults,
                                  const std::vector<FaultField>         &fields)
  {
    // HDF5 would print a stack of its own.
    if (!std::ofstream(file_name))
      throw InputError("The file '" + file_name + "' cannot be written.");
    file = std::make_unique<File>(file_name, faults, fields);
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
  }



  template class FaultHistory<2>;
  template class FaultHistory<3>;
} // namespace StickSlip
