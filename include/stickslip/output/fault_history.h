// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_fault_history_h
#define stickslip_output_fault_history_h

#include <stickslip/output/fault_layout.h>
#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/file_state.h>
#include <stickslip/output/output_fields.h>

#include <memory>
#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Writes faults.h5: the fields of all faults over time, in HDF5.
   *
   * One group per fault holds the data sets
   *
   *   coordinates       nodes x dim             reference positions, m
   *   weight            nodes                   of the first record, m^(dim-1)
   *   faces             faces x 2 or 4          nodes around each face, whole
   *                                             numbers; the last one of a
   *                                             triangle is -1
   *   axes              nodes x dim x dim       tangents, normal; at the start
   *   arc_length        nodes                   arc_lengths(), m; two
   *                                             dimensions only
   *   time              records                 s
   *
   * and, as far as they are asked for,
   *
   *   slip              records x nodes [x 2]   m
   *   slip_rate         records x nodes [x 2]   m/s
   *   shear_traction    records x nodes [x 2]   Pa
   *   normal_stress     records x nodes         Pa
   *   state             records x nodes         s
   *   contact_pressure  records x nodes         Pa
   *   contact_weight    records x nodes         m^(dim-1)
   *   position          records x nodes x dim   of the moment, m
   *
   * and of faults that may open
   *
   *   gap               records x nodes         m
   *   opening_rate      records x nodes         m/s
   *   contact_state     records x nodes         ContactState
   *
   * where the last extent of tangential vectors is there in three dimensions
   * only. Each data set has the attributes `units` and `description`; the root
   * group names the program, its version and the layout. The file is flushed
   * after each record: it can be copied or read at any time, and what was
   * recorded survives the end of the program, however that comes.
   *
   * Only one process may use an object of this class.
   */
  template <int dim>
  class FaultHistory
  {
  public:
    /**
     * Create or replace the file. @p faults gives the names and nodes, and
     * @p shapes one entry for each of them; a record is not made of them.
     * Throws InputError if the file cannot be made.
     */
    FaultHistory(const std::string                     &file_name,
                 const std::vector<FaultSnapshot<dim>> &faults,
                 const std::vector<FaultLayout<dim>>   &shapes,
                 const std::vector<FaultField>         &fields);

    /**
     * Go on with the file of another run with the same faults and fields, as it
     * was. Throws InputError if that is impossible.
     */
    FaultHistory(const std::string                     &file_name,
                 const std::vector<FaultSnapshot<dim>> &faults,
                 const std::vector<FaultField>         &fields,
                 const FileState                       &earlier);

    ~FaultHistory();

    /** The file as it is now; without the records that are in their final
     * place. */
    FileState
    state() const;

    /**
     * Append a record; faults and nodes as in the constructor. Throws an
     * exception if the file cannot be written.
     */
    void
    add(const double time, const std::vector<FaultSnapshot<dim>> &faults);

  private:
    class File;

    std::string           file_name;
    std::unique_ptr<File> file;
  };
} // namespace StickSlip

#endif
