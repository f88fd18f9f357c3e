// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <deal.II/base/config.h>

#include <boost/version.hpp>

#include <dmumps_c.h>
#include <hdf5.h>
#include <metis.h>
#include <mpi.h>
#include <muParserDef.h>
#include <stickslip/scene/version_report.h>
#include <stickslip/version.h>
#include <stickslip_revision.h>
#include <umfpack.h>
#include <zlib.h>

#include <sstream>

namespace StickSlip
{
  namespace
  {
    std::string
    joined(const std::initializer_list<unsigned int> numbers)
    {
      std::string result;
      for (const unsigned int number : numbers)
        result += (result.empty() ? "" : ".") + std::to_string(number);
      return result;
    }



    /** The first words of what MPI says of itself, which may be lines long. */
    std::string
    mpi_version()
    {
      char text[MPI_MAX_LIBRARY_VERSION_STRING];
      int  length = 0;
      MPI_Get_library_version(text, &length);
      const std::string all(text, length);
      return all.substr(0, all.find_first_of(",\n\r"));
    }



    std::string
    hdf5_version()
    {
      unsigned int major = 0, minor = 0, release = 0;
      H5get_libversion(&major, &minor, &release);
      return joined({major, minor, release});
    }
  } // namespace



  std::string
  source_revision()
  {
    return STICKSLIP_REVISION;
  }



  std::string
  version_report()
  {
    std::ostringstream out;
    out << "stickslip " << version << "\n"
        << "revision     " << source_revision() << "\n"
        << "compiler     "
#if defined(__clang__)
        << "Clang " << joined({__clang_major__, __clang_minor__})
#elif defined(__GNUC__)
        << "GCC " << joined({__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__})
#else
        << "unknown"
#endif
        << ", " << STICKSLIP_BUILD_TYPE << "\n"
        << "deal.II      " << DEAL_II_PACKAGE_VERSION << "\n"
        << "MPI          " << mpi_version() << "\n"
        << "Trilinos     "
        << joined({DEAL_II_TRILINOS_VERSION_MAJOR,
                   DEAL_II_TRILINOS_VERSION_MINOR,
                   DEAL_II_TRILINOS_VERSION_SUBMINOR})
        << "\n"
        << "MUMPS        " << MUMPS_VERSION << "\n"
        << "UMFPACK      "
        << joined({UMFPACK_MAIN_VERSION,
                   UMFPACK_SUB_VERSION,
                   UMFPACK_SUBSUB_VERSION})
        << "\n"
        << "METIS        "
        << joined({METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR})
        << "\n"
        << "HDF5         " << hdf5_version() << "\n"
        << "zlib         " << zlibVersion() << "\n"
        << "Boost        "
        << joined({BOOST_VERSION / 100000,
                   BOOST_VERSION / 100 % 1000,
                   BOOST_VERSION % 100})
        << "\n"
        << "muParser     " << mu::ParserVersion << "\n";
    return out.str();
  }
} // namespace StickSlip
