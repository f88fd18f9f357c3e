// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/fault_history.h>
#include <stickslip/output/hdf5_file.h>
#include <stickslip/version.h>
#include <sys/wait.h>
#include <unistd.h>

#include <numeric>

#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

namespace
{
  // Values that tell record, node and component.
  template <int dim>
  FaultSnapshot<dim>
  numbered_fault(const std::string &name,
                 const unsigned int n_nodes,
                 const double       record)
  {
    FaultSnapshot<dim> fault;
    fault.name = name;
    for (unsigned int p = 0; p < n_nodes; ++p)
      {
        Point<dim>         point;
        Tensor<1, dim - 1> vector;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = p + 0.1 * d;
        for (unsigned int d = 0; d < dim - 1; ++d)
          vector[d] = 100 * record + p + 0.1 * d;
        fault.points.push_back(point);
        fault.weights.push_back(0.5 + p);
        fault.slip.push_back(vector);
        fault.slip_rate.push_back(2 * vector);
        fault.shear_traction.push_back(3 * vector);
        fault.normal_stress.push_back(1e4 + vector[0]);
        fault.state.push_back(vector[0] + 0.5);
        fault.contact_pressure.push_back(2e4 + vector[0]);
        fault.gap.push_back(4e4 + vector[0]);
        fault.opening_rate.push_back(5e4 + vector[0]);
        fault.contact_state.push_back(ContactState(p % 4));
        fault.positions.push_back((1. + record) * point);
      }
    return fault;
  }



  // A row of faces between the nodes, and axes that tell node and entry.
  template <int dim>
  FaultLayout<dim>
  numbered_shape(const unsigned int n_nodes)
  {
    FaultLayout<dim> shape;
    shape.surface.points     = numbered_fault<dim>("", n_nodes, 0).points;
    constexpr unsigned int n = FaultSurface<dim>::n_vertices;
    for (unsigned int p = 0; p + n <= n_nodes; ++p)
      {
        std::array<unsigned int, n> face;
        std::iota(face.begin(), face.end(), p);
        shape.surface.faces.push_back(face);
      }
    for (unsigned int p = 0; p < n_nodes; ++p)
      {
        Tensor<2, dim> axes;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int i = 0; i < dim; ++i)
            axes[d][i] = 100 * p + 10 * i + d;
        shape.axes.push_back(axes);
      }
    return shape;
  }



  std::vector<FaultField>
  all_fields()
  {
    std::vector<FaultField> fields;
    for (const auto &field : fault_field_names())
      fields.push_back(field.first);
    return fields;
  }



  struct Array
  {
    std::vector<hsize_t> shape;
    std::vector<double>  values;
  };



  Array
  read_array(const hid_t file, const std::string &path)
  {
    const Hdf5Handle data_set(H5Dopen2(file, path.c_str(), H5P_DEFAULT),
                              H5Dclose,
                              "open " + path);
    const Hdf5Handle space(H5Dget_space(data_set), H5Sclose, "space");
    Array            array;
    array.shape.resize(H5Sget_simple_extent_ndims(space));
    H5Sget_simple_extent_dims(space, array.shape.data(), nullptr);
    array.values.resize(H5Sget_simple_extent_npoints(space));
    if (H5Dread(data_set,
                H5T_NATIVE_DOUBLE,
                H5S_ALL,
                H5S_ALL,
                H5P_DEFAULT,
                array.values.data()) < 0)
      throw std::runtime_error("cannot read " + path);
    return array;
  }



  std::string
  read_attribute(const hid_t        file,
                 const std::string &path,
                 const std::string &name)
  {
    const Hdf5Handle attribute(H5Aopen_by_name(file,
                                               path.c_str(),
                                               name.c_str(),
                                               H5P_DEFAULT,
                                               H5P_DEFAULT),
                               H5Aclose,
                               "open " + name);
    const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, "type");
    std::string      text(H5Tget_size(type), '\0');
    if (H5Aread(attribute, type, text.data()) < 0)
      throw std::runtime_error("cannot read " + name);
    return text.c_str();
  }



  Hdf5Handle
  open_file(const std::string &name)
  {
    return Hdf5Handle(H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT),
                      H5Fclose,
                      "open " + name);
  }
} // namespace



TEST(FaultHistory, GivesBackWhatWasWritten)
{
  const TemporaryFolder folder;
  const unsigned int    n_records = 300;
  {
    FaultHistory<2> history(folder.file("faults.h5"),
                            {numbered_fault<2>("lower", 4, 0),
                             numbered_fault<2>("upper", 161, 0)},
                            {numbered_shape<2>(4), numbered_shape<2>(161)},
                            all_fields());
    for (unsigned int i = 0; i < n_records; ++i)
      history.add(0.1 * i,
                  {numbered_fault<2>("lower", 4, i),
                   numbered_fault<2>("upper", 161, i)});
  }

  const Hdf5Handle file = open_file(folder.file("faults.h5"));
  EXPECT_EQ(read_attribute(file, "/", "program"), "stickslip");
  EXPECT_EQ(read_attribute(file, "/", "version"), version);

  const Array coordinates = read_array(file, "upper/coordinates");
  EXPECT_EQ(coordinates.shape, (std::vector<hsize_t>{161, 2}));
  EXPECT_EQ(coordinates.values[2 * 160 + 1], 160 + 0.1);
  EXPECT_EQ(read_array(file, "lower/weight").values[3], 3.5);
  EXPECT_EQ(read_array(file, "lower/time").shape,
            (std::vector<hsize_t>{n_records}));
  EXPECT_EQ(read_array(file, "lower/time").values[299], 0.1 * 299);

  const std::vector<std::pair<std::string, std::string>> units = {
    {"coordinates", "m"},
    {"weight", "m"},
    {"time", "s"},
    {"slip", "m"},
    {"slip_rate", "m/s"},
    {"shear_traction", "Pa"},
    {"normal_stress", "Pa"},
    {"state", "s"},
    {"contact_pressure", "Pa"},
    {"contact_weight", "m"},
    {"gap", "m"},
    {"opening_rate", "m/s"},
    {"contact_state", "1"},
    {"position", "m"},
    {"faces", "1"},
    {"axes", "1"},
    {"arc_length", "m"}};
  for (const auto &[name, unit] : units)
    {
      EXPECT_EQ(read_attribute(file, "upper/" + name, "units"), unit);
      EXPECT_FALSE(
        read_attribute(file, "upper/" + name, "description").empty());
    }

  const std::vector<double>      factors = {1, 2, 3};
  const std::vector<std::string> names   = {"slip",
                                            "slip_rate",
                                            "shear_traction"};
  for (unsigned int k = 0; k < 3; ++k)
    {
      const Array array = read_array(file, "upper/" + names[k]);
      ASSERT_EQ(array.shape, (std::vector<hsize_t>{n_records, 161}));
      for (unsigned int i = 0; i < n_records; ++i)
        for (unsigned int p = 0; p < 161; ++p)
          ASSERT_EQ(array.values[161 * i + p], factors[k] * (100. * i + p));
    }
  EXPECT_EQ(read_array(file, "lower/normal_stress").values[4 * 7 + 2], 10702);
  EXPECT_EQ(read_array(file, "lower/state").values[4 * 7 + 2], 702.5);
  EXPECT_EQ(read_array(file, "lower/contact_pressure").values[4 * 7 + 2],
            20702);
  EXPECT_EQ(read_array(file, "lower/contact_weight").values[4 * 7 + 2], 2.5);
  EXPECT_EQ(read_array(file, "lower/gap").values[4 * 7 + 2], 40702);
  EXPECT_EQ(read_array(file, "lower/opening_rate").values[4 * 7 + 2], 50702);
  EXPECT_EQ(read_array(file, "lower/contact_state").values[4 * 7 + 3], 3);
  const Array position = read_array(file, "lower/position");
  ASSERT_EQ(position.shape, (std::vector<hsize_t>{n_records, 4, 2}));
  EXPECT_EQ(position.values[2 * (4 * 7 + 2) + 1], 8 * 2.1);
  const Array faces = read_array(file, "lower/faces");
  EXPECT_EQ(faces.shape, (std::vector<hsize_t>{3, 2}));
  EXPECT_EQ(faces.values, (std::vector<double>{0, 1, 1, 2, 2, 3}));
  const Array axes = read_array(file, "lower/axes");
  ASSERT_EQ(axes.shape, (std::vector<hsize_t>{4, 2, 2}));
  EXPECT_EQ(axes.values[4 * 3 + 2 * 1 + 0], 310);
}



TEST(FaultHistory, HasTwoComponentsInThreeDimensions)
{
  const TemporaryFolder folder;
  FaultLayout<3>        shape = numbered_shape<3>(5);
  shape.surface.faces         = {{{0, 1, 2, 3}},
                                 {{2, 3, 4, numbers::invalid_unsigned_int}}};
  {
    FaultHistory<3> history(folder.file("faults.h5"),
                            {numbered_fault<3>("main", 5, 0)},
                            {shape},
                            all_fields());
    history.add(1, {numbered_fault<3>("main", 5, 1)});
  }
  const Hdf5Handle file = open_file(folder.file("faults.h5"));
  const Array      slip = read_array(file, "main/slip");
  EXPECT_EQ(slip.shape, (std::vector<hsize_t>{1, 5, 2}));
  EXPECT_EQ(slip.values[2 * 3 + 1], 103.1);
  EXPECT_EQ(read_attribute(file, "main/weight", "units"), "m^2");
  // One after the other around each face.
  const Array faces = read_array(file, "main/faces");
  EXPECT_EQ(faces.shape, (std::vector<hsize_t>{2, 4}));
  EXPECT_EQ(faces.values, (std::vector<double>{0, 1, 3, 2, 2, 3, 4, -1}));
  EXPECT_EQ(read_array(file, "main/axes").shape,
            (std::vector<hsize_t>{5, 3, 3}));
}



TEST(FaultHistory, HoldsWhatIsAskedFor)
{
  const TemporaryFolder folder;
  {
    FaultHistory<2> history(folder.file("faults.h5"),
                            {numbered_fault<2>("main", 3, 0)},
                            {numbered_shape<2>(3)},
                            {FaultField::state});
    history.add(0.5, {numbered_fault<2>("main", 3, 1)});
  }
  const Hdf5Handle file = open_file(folder.file("faults.h5"));
  H5G_info_t       info;
  const Hdf5Handle group(H5Gopen2(file, "main", H5P_DEFAULT),
                         H5Gclose,
                         "open main");
  ASSERT_GE(H5Gget_info(group, &info), 0);
  // With coordinates, weight, time, faces, axes and arc length.
  EXPECT_EQ(info.nlinks, 7u);
  EXPECT_EQ(read_array(file, "main/state").values.back(), 102.5);
}



TEST(FaultHistory, HasGapsOfFaultsThatMayOpen)
{
  const TemporaryFolder folder;
  {
    FaultSnapshot<2> bilateral = numbered_fault<2>("bilateral", 3, 0);
    bilateral.gap.clear();
    FaultHistory<2> history(folder.file("faults.h5"),
                            {bilateral, numbered_fault<2>("unilateral", 3, 0)},
                            {numbered_shape<2>(3), numbered_shape<2>(3)},
                            all_fields());
    history.add(0.5, {bilateral, numbered_fault<2>("unilateral", 3, 1)});
  }
  const Hdf5Handle file = open_file(folder.file("faults.h5"));
  for (const std::string field : {"gap", "opening_rate", "contact_state"})
    {
      EXPECT_GT(H5Lexists(file, ("unilateral/" + field).c_str(), H5P_DEFAULT),
                0);
      EXPECT_EQ(H5Lexists(file, ("bilateral/" + field).c_str(), H5P_DEFAULT),
                0);
    }
}



TEST(FaultHistory, CanBeReadWhileItGrows)
{
  const TemporaryFolder folder;
  FaultHistory<2>       history(folder.file("faults.h5"),
                          {numbered_fault<2>("main", 3, 0)},
                          {numbered_shape<2>(3)},
                          all_fields());
  for (unsigned int i = 0; i < 5; ++i)
    {
      history.add(i, {numbered_fault<2>("main", 3, i)});
      // A copy, since within a process HDF5 would see what it has in memory.
      std::filesystem::copy_file(
        folder.file("faults.h5"),
        folder.file("copy.h5"),
        std::filesystem::copy_options::overwrite_existing);
      const Hdf5Handle file = open_file(folder.file("copy.h5"));
      EXPECT_EQ(read_array(file, "main/time").values.size(), i + 1);
      EXPECT_EQ(read_array(file, "main/slip").values.back(), 100. * i + 2);
    }
}



TEST(FaultHistory, SurvivesTheSuddenEndOfTheProgram)
{
  const TemporaryFolder folder;
  const pid_t           child = fork();
  ASSERT_GE(child, 0);
  if (child == 0)
    {
      FaultHistory<2> history(folder.file("faults.h5"),
                              {numbered_fault<2>("main", 3, 0)},
                              {numbered_shape<2>(3)},
                              all_fields());
      for (unsigned int i = 0; i < 20; ++i)
        history.add(i, {numbered_fault<2>("main", 3, i)});
      kill(getpid(), SIGKILL);
    }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));

  const Hdf5Handle file = open_file(folder.file("faults.h5"));
  EXPECT_EQ(read_array(file, "main/time").values.size(), 20u);
  EXPECT_EQ(read_array(file, "main/state").values.back(), 1902.5);
}



TEST(FaultHistory, ReportsAFileThatCannotBeMade)
{
  const TemporaryFolder folder;
  EXPECT_THROW(FaultHistory<2>(folder.file("no/faults.h5"),
                               {},
                               std::vector<FaultLayout<2>>(),
                               {}),
               InputError);
}



TEST(FaultHistory, GoesOnAsItWas)
{
  const TemporaryFolder folder;
  const std::string     name = folder.file("faults.h5");
  // Chunks of 16 records, of which some are full.
  constexpr unsigned int n_nodes = 512, n_before = 40, n_all = 60;
  const auto             add = [&](FaultHistory<2>   &history,
                       const unsigned int from,
                       const unsigned int to) {
    for (unsigned int i = from; i < to; ++i)
      history.add(i, {numbered_fault<2>("main", n_nodes, i)});
  };
  FileState state;
  {
    FaultHistory<2> history(name,
                            {numbered_fault<2>("main", n_nodes, 0)},
                            {numbered_shape<2>(n_nodes)},
                            all_fields());
    add(history, 0, n_before);
    state                 = history.state();
    std::uint64_t n_bytes = 0;
    for (const auto &part : state.parts)
      n_bytes += part.second.size();
    EXPECT_EQ(state.size, std::filesystem::file_size(name));
    EXPECT_LT(n_bytes, 0.6 * state.size);
    const std::string then = content_of(name);
    // Other values, as of a run that has gone on differently.
    add(history, n_all, n_all + 30);
    EXPECT_NE(content_of(name).substr(0, then.size()), then);
    restore_file(name, state);
    EXPECT_TRUE(content_of(name) == then);
  }
  FaultHistory<2> history(name,
                          {numbered_fault<2>("main", n_nodes, 0)},
                          all_fields(),
                          state);
  add(history, n_before, n_all);
  std::filesystem::copy_file(name, folder.file("copy.h5"));
  const Hdf5Handle file  = open_file(folder.file("copy.h5"));
  const auto       times = read_array(file, "main/time").values,
             slip        = read_array(file, "main/slip").values;
  ASSERT_EQ(times.size(), n_all);
  ASSERT_EQ(slip.size(), n_all * n_nodes);
  for (unsigned int i = 0; i < n_all; ++i)
    {
      const FaultSnapshot<2> fault = numbered_fault<2>("main", n_nodes, i);
      EXPECT_EQ(times[i], i);
      for (unsigned int k = 0; k < n_nodes; ++k)
        EXPECT_EQ(slip[i * n_nodes + k], fault.slip[k][0]);
    }
}
