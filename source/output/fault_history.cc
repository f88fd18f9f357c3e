// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/fault_field_values.h>
#include <stickslip/output/fault_history.h>
#include <stickslip/output/hdf5_file.h>
#include <stickslip/version.h>

#include <filesystem>
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



    /** Extents of a record. */
    template <int dim>
    std::vector<hsize_t>
    record_shape(const hsize_t n_nodes, const FaultFieldValues &values)
    {
      if (values.n_components > 1)
        return {n_nodes, values.n_components};
      return {n_nodes};
    }



    /** The vertices of each face, one after the other around it; -1 in the last
     * place of a triangle. */
    template <int dim>
    std::vector<int>
    corners(const FaultSurface<dim> &surface)
    {
      std::vector<int> result;
      for (unsigned int f = 0; f < surface.faces.size(); ++f)
        {
          for (const unsigned int v : vertices_around<dim>(surface, f))
            result.push_back(surface.faces[f][v]);
          if (surface.n_vertices_of(f) < FaultSurface<dim>::n_vertices)
            result.push_back(-1);
        }
      return result;
    }



    template <int dim>
    std::vector<double>
    flatten(const std::vector<Point<dim>> &points)
    {
      std::vector<double> values;
      for (const Point<dim> &point : points)
        for (unsigned int d = 0; d < dim; ++d)
          values.push_back(point[d]);
      return values;
    }



    /** Axis by axis, tangential ones first. */
    template <int dim>
    std::vector<double>
    flatten(const std::vector<Tensor<2, dim>> &axes)
    {
      std::vector<double> values;
      for (const Tensor<2, dim> &of_node : axes)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            values.push_back(of_node[d][i]);
      return values;
    }



    void
    write_arc_length(const hid_t group, const FaultLayout<2> &shape)
    {
      const std::vector<double> lengths = arc_lengths(shape);
      describe(write_hdf5_array(group, "arc_length", {lengths.size()}, lengths),
               "m",
               "way along the fault from its end at the back of the tangents");
    }



    /** Three dimensions: there is no such thing. */
    void
    write_arc_length(const hid_t, const FaultLayout<3> &)
    {}



    // The data sets of one fault.
    template <int dim>
    class FaultGroup
    {
    public:
      FaultGroup(const hid_t                    file,
                 const FaultSnapshot<dim>      &fault,
                 const FaultLayout<dim>        &shape,
                 const std::vector<FaultField> &wanted)
        : n_nodes(fault.points.size())
        , group(create_hdf5_group(file, fault.name))
        , time(group, "time", {})
      {
        describe(time.id(), "s", "time of each record");
        for (const auto &[field, name] : fault_field_names())
          if (has_field(wanted, field) && has_values(fault, field))
            {
              const FaultFieldValues values = field_values(fault, field);
              fields.push_back(
                {field,
                 Hdf5Series(group, name, record_shape<dim>(n_nodes, values))});
              describe(fields.back().series.id(),
                       values.units,
                       values.description);
            }

        describe(write_hdf5_array(
                   group, "coordinates", {n_nodes, dim}, flatten(fault.points)),
                 "m",
                 "reference positions of the nodes");
        describe(write_hdf5_array(group, "weight", {n_nodes}, fault.weights),
                 dim == 2 ? "m" : "m^2",
                 "share of each node in the fault's area; 0: not in contact");
        describe(write_hdf5_array(group,
                                  "faces",
                                  {shape.surface.faces.size(),
                                   FaultSurface<dim>::n_vertices},
                                  corners(shape.surface)),
                 "1",
                 "numbers of the nodes around each face, from 0; -1 behind "
                 "those of a triangle");
        describe(write_hdf5_array(
                   group, "axes", {n_nodes, dim, dim}, flatten(shape.axes)),
                 "1",
                 "unit vectors at each node at the start: those of the "
                 "tangential components, then the normal from the first to the "
                 "second side");
        write_arc_length(group, shape);
      }

      /** The group of an earlier run. */
      FaultGroup(const hid_t                    file,
                 const FaultSnapshot<dim>      &fault,
                 const std::vector<FaultField> &wanted)
        : n_nodes(fault.points.size())
        , group(open_hdf5_group(file, fault.name))
        , time(group, "time")
      {
        for (const auto &[field, name] : fault_field_names())
          if (has_field(wanted, field) && has_values(fault, field))
            fields.push_back({field, Hdf5Series(group, name)});
      }

      /** Bytes that the next record takes, at most. */
      std::uint64_t
      growth() const
      {
        std::uint64_t result = time.growth();
        for (const Field &field : fields)
          result += field.series.growth();
        return result;
      }

      /** Places in the file of records that are final. */
      void
      add_final_ranges(ByteRanges &ranges)
      {
        const auto add = [&](Hdf5Series &series) {
          const ByteRanges &chunks = series.full_chunks();
          ranges.insert(ranges.end(), chunks.begin(), chunks.end());
        };
        add(time);
        for (Field &field : fields)
          add(field.series);
      }

      void
      append(const double new_time, const FaultSnapshot<dim> &fault)
      {
        AssertDimension(fault.points.size(), n_nodes);
        for (Field &field : fields)
          field.series.append(field_values(fault, field.field).values);
        // Last, so that each time has its fields.
        time.append({new_time});
      }

    private:
      struct Field
      {
        FaultField field;
        Hdf5Series series;
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
         const std::vector<FaultLayout<dim>>   &shapes,
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
      for (unsigned int i = 0; i < faults.size(); ++i)
        groups.emplace_back(file, faults[i], shapes[i], fields);
      flush();
    }

    /** The file of an earlier run. */
    File(const std::string                     &file_name,
         const std::vector<FaultSnapshot<dim>> &faults,
         const std::vector<FaultField>         &fields)
      : file(open_hdf5_file(file_name))
    {
      groups.reserve(faults.size());
      for (const FaultSnapshot<dim> &fault : faults)
        groups.emplace_back(file, fault, fields);
    }

    void
    flush()
    {
      if (H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0)
        return;
      Hdf5Handle::note_failure();
      AssertThrow(false,
                  ExcMessage("HDF5 failed to write the faults' records."));
    }

    // In this order, so that the file is closed last.
    Hdf5Handle                   file;
    std::vector<FaultGroup<dim>> groups;
  };



  template <int dim>
  FaultHistory<dim>::FaultHistory(const std::string &file_name,
                                  const std::vector<FaultSnapshot<dim>> &faults,
                                  const std::vector<FaultLayout<dim>>   &shapes,
                                  const std::vector<FaultField>         &fields)
    : file_name(file_name)
  {
    AssertDimension(faults.size(), shapes.size());
    std::uint64_t size = 0;
    for (const FaultSnapshot<dim> &fault : faults)
      size += fault.points.size() * dim * 8 * sizeof(double);
    require_space(file_name, size);
    if (!std::ofstream(file_name))
      throw InputError("The file '" + file_name + "' cannot be written.");
    file = std::make_unique<File>(file_name, faults, shapes, fields);
  }



  template <int dim>
  FaultHistory<dim>::FaultHistory(const std::string &file_name,
                                  const std::vector<FaultSnapshot<dim>> &faults,
                                  const std::vector<FaultField>         &fields,
                                  const FileState &earlier)
    : file_name(file_name)
  {
    restore_file(file_name, earlier);
    file = std::make_unique<File>(file_name, faults, fields);
  }



  template <int dim>
  FaultHistory<dim>::~FaultHistory() = default;



  template <int dim>
  FileState
  FaultHistory<dim>::state() const
  {
    file->flush();
    ByteRanges final_ranges;
    for (FaultGroup<dim> &group : file->groups)
      group.add_final_ranges(final_ranges);
    return file_state(file_name, final_ranges);
  }



  template <int dim>
  void
  FaultHistory<dim>::add(const double                           time,
                         const std::vector<FaultSnapshot<dim>> &faults)
  {
    AssertDimension(faults.size(), file->groups.size());
    std::uint64_t growth = 0;
    for (const FaultGroup<dim> &group : file->groups)
      growth += group.growth();
    require_space(file_name, growth);
    // HDF5 would go on writing to a file that has been deleted.
    std::error_code error;
    if (!std::filesystem::exists(file_name, error))
      throw InputError("The file '" + file_name +
                       "' cannot be written (it is not there any more).");
    for (unsigned int i = 0; i < faults.size(); ++i)
      file->groups[i].append(time, faults[i]);
    file->flush();
  }



  template class FaultHistory<2>;
  template class FaultHistory<3>;
} // namespace StickSlip
