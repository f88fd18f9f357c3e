// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_tests_run_program_h
#define stickslip_tests_run_program_h

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "project_directories.h"
#include "temporary_folder.h"

namespace StickSlip::Tests
{
  struct Outcome
  {
    int         exit_status;
    std::string output;
    std::string errors;
  };



  /** The program with none of this process's environment, which would make it
   * part of the same MPI job, by itself or by a launcher like mpirun. To be
   * used in a shell. Processes of one machine talk through its memory, also
   * where it has no network, and have time to end after a signal. */
  inline std::string
  program(const std::string &launcher = "")
  {
    const std::string path = STICKSLIP_BINARY_DIR "/stickslip";
    EXPECT_TRUE(std::filesystem::exists(path)) << path;
    return "env -i PATH=\"$PATH\" HOME=\"$HOME\" OMPI_ALLOW_RUN_AS_ROOT=1 "
           "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl=^tcp "
           "${ASAN_OPTIONS:+ASAN_OPTIONS=\"$ASAN_OPTIONS\"} "
           "PRTE_MCA_odls_base_sigkill_timeout=30 " +
           launcher + " '" + path + "'";
  }



  /** Messages without those of mpirun itself, which stand between two rules. */
  inline std::string
  without_launcher(std::string messages)
  {
    const std::string rule(74, '-');
    std::size_t       begin;
    while ((begin = messages.find(rule)) != std::string::npos)
      {
        const std::size_t end = messages.find(rule, begin + rule.size());
        messages.erase(begin,
                       end == std::string::npos ?
                         end :
                         end + rule.size() + 1 - begin);
      }
    return messages;
  }



  /** Run a shell command in a folder. */
  inline Outcome
  run_command(const TemporaryFolder &folder, const std::string &command)
  {
    const std::string whole = "cd '" + folder.path.string() + "' && { " +
                              command + "\n} > output.txt 2> errors.txt";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            content_of(folder.file("output.txt")),
            without_launcher(content_of(folder.file("errors.txt")))};
  }



  /** Run the program in a folder. */
  inline Outcome
  run_program(const TemporaryFolder &folder, const std::string &arguments)
  {
    return run_command(folder, program() + " " + arguments);
  }



  /** Start a command that writes to output/scene, interrupt it by a signal when
   * the run is well under way, and wait for its end. */
  inline Outcome
  run_and_interrupt(const TemporaryFolder &folder,
                    const std::string     &command,
                    const std::string     &signal = "INT")
  {
    return run_command(
      folder,
      command +
        " &\n"
        "pid=$!\n"
        "for i in $(seq 600); do\n"
        "  rows=$(cat output/scene/time_series.csv 2> /dev/null | wc -l)\n"
        "  [ \"$rows\" -gt 30 ] && break\n"
        "  sleep 0.1\n"
        "done\n"
        "kill -" +
        signal +
        " $pid\n"
        "wait $pid");
  }



  /** Mistakes in the files of a run with the one fault "fault"; empty:
   * nothing. */
  inline std::string
  problems_of_output(const TemporaryFolder &folder, const std::string &output)
  {
    const Outcome outcome =
      run_command(folder,
                  "/usr/bin/python3 '" STICKSLIP_SOURCE_DIR
                  "/tests/check_output_folder.py' '" +
                    output + "' fault");
    EXPECT_EQ(outcome.errors, "");
    return outcome.output;
  }
} // namespace StickSlip::Tests

#endif
