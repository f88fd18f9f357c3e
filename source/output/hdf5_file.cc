// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/exceptions.h>

#include <stickslip/base/input_error.h>
#include <stickslip/output/hdf5_file.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <type_traits>

namespace StickSlip
{
  using namespace dealii;

  namespace
  {
    void
    require(const bool success, const std::string &what)
    {
      if (success)
        return;
      Hdf5Handle::note_failure();
      AssertThrow(false, ExcMessage("HDF5 failed to " + what + "."));
    }



    hsize_t
    n_entries(const std::vector<hsize_t> &shape)
    {
      return std::accumulate(shape.begin(),
                             shape.end(),
                             hsize_t(1),
                             std::multiplies<hsize_t>());
    }



    // Records per chunk, such that a chunk has about 64 kB: small enough not
    // to waste space in a short run, large enough for fast reading.
    hsize_t
    chunk_length(const std::vector<hsize_t> &record_shape)
    {
      return std::clamp<hsize_t>(
        8192 / std::max<hsize_t>(n_entries(record_shape), 1), 1, 1024);
    }



    /** Access to a data set without a cache of its chunks, which are divided
     * for readers: the cache would write a whole chunk with each flush, here
     * each record reaches the file alone. */
    Hdf5Handle
    access_without_cache(const std::string &name)
    {
      Hdf5Handle access(H5Pcreate(H5P_DATASET_ACCESS),
                        H5Pclose,
                        "describe the data set '" + name + "'");
      require(H5Pset_chunk_cache(access,
                                 H5D_CHUNK_CACHE_NSLOTS_DEFAULT,
                                 0,
                                 H5D_CHUNK_CACHE_W0_DEFAULT) >= 0,
              "turn off the cache of the data set '" + name + "'");
      return access;
    }



    Hdf5Handle
    create_series(const hid_t                 group,
                  const std::string          &name,
                  const std::vector<hsize_t> &record_shape)
    {
      std::vector<hsize_t> extent = {0}, largest = {H5S_UNLIMITED},
                           chunk = {chunk_length(record_shape)};
      for (const hsize_t n : record_shape)
        {
          extent.push_back(n);
          largest.push_back(n);
          chunk.push_back(std::max<hsize_t>(n, 1));
        }

      const Hdf5Handle space(H5Screate_simple(extent.size(),
                                              extent.data(),
                                              largest.data()),
                             H5Sclose,
                             "describe the data set '" + name + "'");
      const Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE),
                                  H5Pclose,
                                  "describe the data set '" + name + "'");
      require(H5Pset_chunk(properties, chunk.size(), chunk.data()) >= 0,
              "divide the data set '" + name + "' into chunks");
      return Hdf5Handle(H5Dcreate2(group,
                                   name.c_str(),
                                   H5T_IEEE_F64LE,
                                   space,
                                   H5P_DEFAULT,
                                   properties,
                                   access_without_cache(name)),
                        H5Dclose,
                        "create the data set '" + name + "'");
    }
  } // namespace



  bool Hdf5Handle::has_failed = false;



  Hdf5Handle::Hdf5Handle(const hid_t        id,
                         const Closer       close,
                         const std::string &what)
    : id(id)
    , close(close)
  {
    require(id >= 0, what);
  }



  Hdf5Handle::Hdf5Handle(Hdf5Handle &&other) noexcept
    : id(other.id)
    , close(other.close)
  {
    other.id = H5I_INVALID_HID;
  }



  Hdf5Series::Hdf5Series(const hid_t                 group,
                         const std::string          &name,
                         const std::vector<hsize_t> &record_shape)
    : shape({0})
    , data_set(create_series(group, name, record_shape))
  {
    shape.insert(shape.end(), record_shape.begin(), record_shape.end());
  }



  Hdf5Series::Hdf5Series(const hid_t group, const std::string &name)
    : data_set(H5Dopen2(group, name.c_str(), access_without_cache(name)),
               H5Dclose,
               "open the data set '" + name + "'")
  {
    const std::string what = "describe the data set '" + name + "'";
    const Hdf5Handle  space(H5Dget_space(data_set), H5Sclose, what);
    shape.resize(H5Sget_simple_extent_ndims(space));
    require(H5Sget_simple_extent_dims(space, shape.data(), nullptr) > 0, what);
  }



  std::uint64_t
  Hdf5Series::growth() const
  {
    const std::vector<hsize_t> record_shape(shape.begin() + 1, shape.end());
    const hsize_t              length = chunk_length(record_shape);
    return shape[0] % length > 0 ?
             0 :
             sizeof(double) * length * n_entries(record_shape);
  }



  const ByteRanges &
  Hdf5Series::full_chunks()
  {
#if H5_VERSION_GE(1, 10, 5)
    const hsize_t length =
      chunk_length(std::vector<hsize_t>(shape.begin() + 1, shape.end()));
    std::vector<hsize_t> offset(shape.size(), 0);
    while ((chunks.size() + 1) * length <= shape[0])
      {
        offset[0]        = chunks.size() * length;
        haddr_t  address = HADDR_UNDEF;
        hsize_t  n_bytes = 0;
        unsigned filters = 0;
        require(H5Dget_chunk_info_by_coord(
                  data_set, offset.data(), &filters, &address, &n_bytes) >= 0 &&
                  address != HADDR_UNDEF,
                "find a record");
        chunks.emplace_back(address, n_bytes);
      }
#endif
    return chunks;
  }



  void
  Hdf5Series::append(const std::vector<double> &record)
  {
    std::vector<hsize_t> start(shape.size(), 0), count = shape;
    start[0] = shape[0];
    count[0] = 1;
    AssertDimension(record.size(), n_entries(count));

    ++shape[0];
    require(H5Dset_extent(data_set, shape.data()) >= 0, "extend a data set");
    const Hdf5Handle file_space(H5Dget_space(data_set),
                                H5Sclose,
                                "describe a record");
    require(H5Sselect_hyperslab(file_space,
                                H5S_SELECT_SET,
                                start.data(),
                                nullptr,
                                count.data(),
                                nullptr) >= 0,
            "select a record");
    const Hdf5Handle memory_space(H5Screate_simple(count.size(),
                                                   count.data(),
                                                   nullptr),
                                  H5Sclose,
                                  "describe a record");
    require(H5Dwrite(data_set,
                     H5T_NATIVE_DOUBLE,
                     memory_space,
                     file_space,
                     H5P_DEFAULT,
                     record.data()) >= 0,
            "write a record");
  }



  namespace
  {
    /** Without a lock, somebody may look at the file while the run goes on, and
     * file systems that know no locks are no obstacle. */
    Hdf5Handle
    access_without_lock(const std::string &file_name)
    {
      // Handles close themselves, and errors are thrown.
      static const herr_t no_closing_at_exit = H5dont_atexit();
      (void)no_closing_at_exit;
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
      Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS),
                        H5Pclose,
                        "describe the file '" + file_name + "'");
#if H5_VERSION_GE(1, 10, 7)
      require(H5Pset_file_locking(access, false, true) >= 0,
              "turn off the lock of '" + file_name + "'");
#endif
      return access;
    }
  } // namespace



  void
  require_space(const std::string &file_name, const std::uint64_t n_bytes)
  {
    // Bytes by which tables of records grow.
    constexpr std::uint64_t of_tables = 32768;
    std::error_code         error;
    const auto              space =
      std::filesystem::space(std::filesystem::path(file_name).parent_path(),
                             error);
    if (!error && space.available < n_bytes + of_tables)
      throw InputError("The file '" + file_name +
                       "' cannot be written (no space left).");
  }



  Hdf5Handle
  open_hdf5_file(const std::string &file_name)
  {
    const Hdf5Handle access = access_without_lock(file_name);
    return Hdf5Handle(H5Fopen(file_name.c_str(), H5F_ACC_RDWR, access),
                      H5Fclose,
                      "open the file '" + file_name + "'");
  }



  Hdf5Handle
  open_hdf5_group(const hid_t parent, const std::string &name)
  {
    return Hdf5Handle(H5Gopen2(parent, name.c_str(), H5P_DEFAULT),
                      H5Gclose,
                      "open the group '" + name + "'");
  }



  Hdf5Handle
  create_hdf5_file(const std::string &file_name)
  {
    const Hdf5Handle access = access_without_lock(file_name);
    return Hdf5Handle(
      H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access),
      H5Fclose,
      "create the file '" + file_name + "'");
  }



  Hdf5Handle
  create_hdf5_group(const hid_t parent, const std::string &name)
  {
    return Hdf5Handle(
      H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Gclose,
      "create the group '" + name + "'");
  }



  template <typename Number>
  Hdf5Handle
  write_hdf5_array(const hid_t                 group,
                   const std::string          &name,
                   const std::vector<hsize_t> &shape,
                   const std::vector<Number>  &values)
  {
    constexpr bool is_whole = std::is_same<Number, int>::value;
    AssertDimension(values.size(), n_entries(shape));
    const Hdf5Handle space(H5Screate_simple(shape.size(),
                                            shape.data(),
                                            nullptr),
                           H5Sclose,
                           "describe the data set '" + name + "'");
    Hdf5Handle       data_set(H5Dcreate2(group,
                                   name.c_str(),
                                   is_whole ? H5T_STD_I32LE : H5T_IEEE_F64LE,
                                   space,
                                   H5P_DEFAULT,
                                   H5P_DEFAULT,
                                   H5P_DEFAULT),
                        H5Dclose,
                        "create the data set '" + name + "'");
    require(H5Dwrite(data_set,
                     is_whole ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE,
                     H5S_ALL,
                     H5S_ALL,
                     H5P_DEFAULT,
                     values.data()) >= 0,
            "write the data set '" + name + "'");
    return data_set;
  }



  template decltype(write_hdf5_array<double>) write_hdf5_array<double>;
  template decltype(write_hdf5_array<int>)    write_hdf5_array<int>;



  void
  write_hdf5_attribute(const hid_t        object,
                       const std::string &name,
                       const std::string &text)
  {
    const std::string what = "write the attribute '" + name + "'";
    const Hdf5Handle  type(H5Tcopy(H5T_C_S1), H5Tclose, what);
    require(H5Tset_size(type, text.size() + 1) >= 0 &&
              H5Tset_cset(type, H5T_CSET_UTF8) >= 0,
            what);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
    const Hdf5Handle attribute(
      H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose,
      what);
    require(H5Awrite(attribute, type, text.c_str()) >= 0, what);
  }
} // namespace StickSlip
