// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_output_catalogue_h
#define stickslip_output_catalogue_h

#include <deal.II/base/exceptions.h>

#include <stickslip/output/fault_snapshot.h>
#include <stickslip/output/table_columns.h>
#include <stickslip/output/table_file.h>

#include <string>
#include <vector>

namespace StickSlip
{
  /**
   * Memory of a catalogue from step to step.
   */
  template <typename FaultMemory>
  struct CatalogueState
  {
    using Entry = typename FaultMemory::Entry;

    /** One for each fault. */
    std::vector<FaultMemory> faults;

    /** Entries that have ended. */
    std::vector<Entry> written;

    /** Members to or from a boost archive. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &faults &written;
    }
  };

  /**
   * Finds what happens on faults in a sequence of accepted steps, and writes a
   * row of a table for each such entry as soon as it has ended.
   *
   * @p FaultMemory is what is remembered of a fault: its type Entry, the member
   * `entry`, and `is_open`, true while that goes on.
   */
  template <int dim, typename FaultMemory>
  class Catalogue
  {
  public:
    using State = CatalogueState<FaultMemory>;
    using Entry = typename State::Entry;

    virtual ~Catalogue() = default;

    /** The columns of the file. */
    virtual TableColumns
    columns() const = 0;

    /**
     * Take in an accepted step; @p faults are always the same, in the same
     * order.
     */
    void
    add(const double time, const std::vector<FaultSnapshot<dim>> &faults)
    {
      AssertDimension(faults.size(), memory.faults.size());
      for (unsigned int i = 0; i < faults.size(); ++i)
        take_in(i, time, faults[i]);
    }

    /**
     * Write the entries that have not ended, as they are so far. To be called
     * once after the last step.
     */
    void
    finish()
    {
      for (FaultMemory &fault : memory.faults)
        if (fault.is_open)
          end(fault);
    }

    /**
     * The entries that have been written.
     */
    const std::vector<Entry> &
    entries() const
    {
      return memory.written;
    }

    /**
     * Memory of all that has been taken in.
     */
    const State &
    state() const
    {
      return memory;
    }

    /**
     * Go on from the state of another catalogue, before anything is taken in;
     * its entries are written.
     */
    void
    resume(const State &state)
    {
      AssertDimension(state.faults.size(), memory.faults.size());
      memory.faults = state.faults;
      for (const Entry &entry : state.written)
        write(entry);
    }

  protected:
    /** Throws InputError if the file cannot be written. */
    Catalogue(const std::string &file_name, const unsigned int n_faults)
      : file(file_name)
    {
      memory.faults.resize(n_faults);
    }

    /** Write the names of the columns, before anything else. */
    void
    write_header()
    {
      file << header_of(columns());
      file.end_row();
    }

    /** Take in a step of one fault. */
    virtual void
    take_in(const unsigned int        fault,
            const double              time,
            const FaultSnapshot<dim> &snapshot) = 0;

    /** Put the values of all columns into a row of the file. */
    virtual void
    fill_row(TableFile &row, const Entry &entry) const = 0;

    /** Write the entry of a fault, which has ended. */
    void
    end(FaultMemory &fault)
    {
      fault.is_open = false;
      write(fault.entry);
    }

    State memory;

  private:
    void
    write(const Entry &entry)
    {
      memory.written.push_back(entry);
      fill_row(file, entry);
      file.end_row();
    }

    TableFile file;
  };
} // namespace StickSlip

#endif
