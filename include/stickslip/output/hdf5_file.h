// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_hdf5_file_h
#define stickslip_output_hdf5_file_h

#include <hdf5.h>
#include <stickslip/output/file_state.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /*
   * HDF5 as far as time series need it, with handles that close themselves
   * and errors that throw. deal.II's HDF5 classes cannot extend a
   * data set.
   */

  /**
   * Owner of an HDF5 handle.
   */
  class Hdf5Handle
  {
  public:
    using Closer = herr_t (*)(hid_t);

    /**
     * Take over a handle; throws if it is invalid, with @p what in the message.
     */
    Hdf5Handle(const hid_t id, const Closer close, const std::string &what);

    Hdf5Handle(Hdf5Handle &&other) noexcept;
    Hdf5Handle(const Hdf5Handle &) = delete;
    Hdf5Handle &
    operator=(const Hdf5Handle &) = delete;

    /** Leaves the handle open if anything has failed: HDF5 may crash when it
     * closes a file that it could not write. */
    ~Hdf5Handle()
    {
      if (id >= 0 && !has_failed)
        close(id);
    }

    /** Take note that HDF5 has failed. */
    static void
    note_failure()
    {
      has_failed = true;
    }

    operator hid_t() const
    {
      return id;
    }

  private:
    static bool has_failed;

    hid_t  id;
    Closer close;
  };

  /**
   * A data set of doubles that grows along its first extent.
   */
  class Hdf5Series
  {
  public:
    /**
     * A data set without records; @p record_shape is empty where a record is a
     * single number.
     */
    Hdf5Series(const hid_t                 group,
               const std::string          &name,
               const std::vector<hsize_t> &record_shape);

    /** A data set that is there, to go on with. */
    Hdf5Series(const hid_t group, const std::string &name);

    /**
     * Append a record, whose values run through the last extent fastest.
     */
    void
    append(const std::vector<double> &record);

    hid_t
    id() const
    {
      return data_set;
    }

    /** Bytes that the file grows by with the next record, at most; without
     * tables of HDF5. */
    std::uint64_t
    growth() const;

    /** Places in the file of the chunks that are full, which are not written
     * any more once they are there. Empty where this HDF5 does not tell. */
    const ByteRanges &
    full_chunks();

  private:
    std::vector<hsize_t> shape;
    Hdf5Handle           data_set;
    ByteRanges           chunks;
  };

  /** Throw InputError if there is not so much space for a file. HDF5 leaves a
   * file that nobody can read where it runs out of space. */
  void
  require_space(const std::string &file_name, const std::uint64_t n_bytes);

  /**
   * Create a file, replacing an existing one. Others may read it meanwhile.
   */
  Hdf5Handle
  create_hdf5_file(const std::string &file_name);

  /**
   * Open a file that is there, to go on writing. Others may read it meanwhile.
   */
  Hdf5Handle
  open_hdf5_file(const std::string &file_name);

  Hdf5Handle
  open_hdf5_group(const hid_t parent, const std::string &name);

  Hdf5Handle
  create_hdf5_group(const hid_t parent, const std::string &name);

  /**
   * Write a data set of fixed shape, of numbers in double precision or of whole
   * numbers (int).
   */
  template <typename Number>
  Hdf5Handle
  write_hdf5_array(const hid_t                 group,
                   const std::string          &name,
                   const std::vector<hsize_t> &shape,
                   const std::vector<Number>  &values);

  void
  write_hdf5_attribute(const hid_t        object,
                       const std::string &name,
                       const std::string &text);
} // namespace StickSlip

#endif
