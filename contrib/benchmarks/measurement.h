// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_contrib_measurement_h
#define stickslip_contrib_measurement_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <malloc.h>
#include <stickslip/base/agreement.h>
#include <stickslip/base/libraries.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

/**
 * Parts that the measuring programs share.
 */
namespace Measure
{
  using namespace dealii;

  /** Wall time of the slowest process, s. */
  inline double
  seconds(const std::function<void()> &action)
  {
    MPI_Barrier(MPI_COMM_WORLD);
    Timer timer;
    action();
    timer.stop();
    return Utilities::MPI::max(timer.wall_time(), MPI_COMM_WORLD);
  }



  /** The shortest time of several, s. */
  inline double
  shortest(
    const unsigned int           repetitions,
    const std::function<void()> &action,
    const std::function<void()> &before = []() {})
  {
    double time = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < repetitions; ++i)
      {
        before();
        time = std::min(time, seconds(action));
      }
    return time;
  }



  /** Largest resident size so far of any process, MiB. */
  inline double
  largest_resident_size()
  {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    return Utilities::MPI::max(memory.VmHWM / 1024., MPI_COMM_WORLD);
  }



  /** Bytes that this process has allocated and not freed. The resident size
   * would also count what is kept for later. */
  inline double
  allocated_bytes()
  {
    const auto info = mallinfo2();
    return double(info.uordblks) + double(info.hblkhd);
  }



  /** A line of names and a line of values for each row, separated by
   * commas. */
  class ResultTable
  {
  public:
    /** A cell of the current row. */
    template <typename T>
    void
    add(const std::string &name, const T &value)
    {
      if (n_rows == 0)
        names << (is_row_empty ? "" : ",") << name;
      values << (is_row_empty ? "" : ",") << value;
      is_row_empty = false;
    }

    void
    end_row()
    {
      values << '\n';
      is_row_empty = true;
      ++n_rows;
    }

    /** On the first process. */
    void
    print() const
    {
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        std::cout << names.str() << '\n' << values.str() << std::flush;
    }

  private:
    std::ostringstream names, values;
    unsigned int       n_rows       = 0;
    bool               is_row_empty = true;
  };



  /** Arguments of the program that the program proper does not know, taken out
   * of the list. */
  class Options
  {
  public:
    Options(int argc, char *argv[])
      : arguments(argv + 1, argv + argc)
    {}

    /** True if an option without a value is given. */
    bool
    take(const std::string &name)
    {
      const auto position = std::find(arguments.begin(), arguments.end(), name);
      if (position == arguments.end())
        return false;
      arguments.erase(position);
      return true;
    }

    /** The value behind an option. */
    std::string
    take_value(const std::string &name, const std::string &otherwise)
    {
      const auto position = std::find(arguments.begin(), arguments.end(), name);
      if (position == arguments.end())
        return otherwise;
      AssertThrow(position + 1 != arguments.end(),
                  ExcMessage(name + " wants a value."));
      const std::string value = *(position + 1);
      arguments.erase(position, position + 2);
      return value;
    }

    const std::vector<std::string> &
    rest() const
    {
      return arguments;
    }

  private:
    std::vector<std::string> arguments;
  };



  /** The body of main() of a program that measures: failures end all processes,
   * with a sentence. */
  inline void
  carry_out(const std::string                    &name,
            int                                   argc,
            char                                 *argv[],
            const std::function<void(Options &)> &measure)
  {
    const StickSlip::Libraries libraries;
    try
      {
        Options options(argc, argv);
        measure(options);
      }
    catch (const std::exception &error)
      {
        std::cerr << name << ": " << StickSlip::sentence(error) << std::endl;
        MPI_Abort(MPI_COMM_WORLD, 1);
      }
  }
} // namespace Measure

#endif
