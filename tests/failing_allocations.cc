// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

// To be loaded before a program: one of its processes runs out of memory at an
// allocation with a given number, counted from MPI_Init on. See
// check_failures.py.

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <new>

namespace
{
  /** The number of an allocation that fails, or zero to count them all; how
   * many there were is said at the end where none has failed. */
  struct Failure
  {
    bool          is_here = false;
    unsigned long number = 0, n_allocations = 0;

    Failure()
    {
      const char *const        process = std::getenv("OMPI_COMM_WORLD_RANK"),
                        *const chosen  = std::getenv("FAILING_PROCESS"),
                        *const at      = std::getenv("FAILING_ALLOCATION");
      if (process && chosen && at && std::atoi(process) == std::atoi(chosen))
        {
          is_here = true;
          number  = std::strtoul(at, nullptr, 10);
        }
    }

    ~Failure()
    {
      if (is_here && n_allocations > 0 &&
          (number == 0 || n_allocations < number))
        std::fprintf(stderr, "allocations: %lu\n", n_allocations);
    }
  } failure;



  bool
  has_begun()
  {
    using Initialised = int (*)(int *);
    static const auto initialised =
      reinterpret_cast<Initialised>(dlsym(RTLD_DEFAULT, "MPI_Initialized"));
    int flag = 0;
    if (initialised)
      initialised(&flag);
    return flag != 0;
  }



  void *
  allocate(const std::size_t size)
  {
    if (failure.is_here && has_begun() &&
        ++failure.n_allocations == failure.number)
      throw std::bad_alloc();
    void *const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr)
      throw std::bad_alloc();
    return memory;
  }
} // namespace



void *
operator new(const std::size_t size)
{
  return allocate(size);
}



void *
operator new[](const std::size_t size)
{
  return allocate(size);
}



void
operator delete(void *const memory) noexcept
{
  std::free(memory);
}



void
operator delete[](void *const memory) noexcept
{
  std::free(memory);
}



void
operator delete(void *const memory, std::size_t) noexcept
{
  std::free(memory);
}



void
operator delete[](void *const memory, std::size_t) noexcept
{
  std::free(memory);
}
