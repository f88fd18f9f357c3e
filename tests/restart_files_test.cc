// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#include <gtest/gtest.h>
#include <stickslip/base/checksum.h>
#include <stickslip/base/input_error.h>
#include <stickslip/output/file_state.h>
#include <stickslip/output/folder_lock.h>
#include <stickslip/output/interrupt.h>
#include <stickslip/output/table_file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <limits>
#include <random>
#include <sstream>
#include <thread>

#include "error_message.h"
#include "temporary_folder.h"

using namespace StickSlip;
using namespace StickSlip::Tests;

/* The check value of the catalogue of such codes, and two that zlib gives. */
TEST(Checksum, IsThatOfZlib)
{
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc32(""), 0u);
  EXPECT_EQ(crc32("stickslip"), 0xA5ECDAAEu);
  EXPECT_EQ(crc32("56789", 5, crc32("1234")), 0xCBF43926u);
}



TEST(FileState, MakesAFileAgainThatWasChangedAndGrew)
{
  const TemporaryFolder folder;
  const std::string     file = folder.write("file", "0123456789");
  // Bytes 2 to 4 and 7 are final.
  const FileState state = file_state(file, {{7, 1}, {2, 3}});
  ASSERT_EQ(state.parts.size(), 3u);
  EXPECT_EQ(state.parts[0].second, "01");
  EXPECT_EQ(state.parts[1].second, "56");
  EXPECT_EQ(state.parts[2].second, "89");
  folder.write("file", "ab234cd7ef and more");
  restore_file(file, state);
  EXPECT_EQ(content_of(file), "0123456789");

  folder.write("file", "0123");
  expect_one_sentence_with(message_of([&]() { restore_file(file, state); }),
                           {file, "is shorter than it was at the checkpoint"});
  EXPECT_EQ(content_of(file), "0123");
}



TEST(TableFile, GoesOnBehindACompleteRow)
{
  const TemporaryFolder folder;
  const std::string     name = folder.file("table.csv");
  FileState             state;
  {
    TableFile file(name);
    file << "a,b";
    file.end_row();
    file << 1 << ',' << 0.1;
    file.end_row();
    state = file.state();
    file << 2 << ',' << 0.2;
    file.end_row();
  }
  EXPECT_EQ(content_of(name),
            "a,b\n1,0.10000000000000001\n2,0.20000000000000001\n");
  TableFile file(name, state);
  EXPECT_EQ(content_of(name), "a,b\n1,0.10000000000000001\n");
  file << 3;
  file.end_row();
  EXPECT_EQ(content_of(name), "a,b\n1,0.10000000000000001\n3\n");
  std::filesystem::remove(name);
  file << 4;
  expect_one_sentence_with(message_of([&]() { file.end_row(); }),
                           {name, "it is not there any more"});
}



/* Rows that come fast wait for each other, no longer than a tenth of a second
 * behind the next one. */
TEST(TableFile, GathersRows)
{
  const TemporaryFolder folder;
  const std::string     name = folder.file("table.csv");
  std::string           expected;
  {
    TableFile  file(name);
    const auto add = [&](const unsigned int i) {
      file << i << ',' << 0.5 * i;
      file.end_waiting_row();
      std::ostringstream row;
      row << i << ',' << 0.5 * i << '\n';
      expected += row.str();
    };
    add(0);
    // The first row waits for nothing.
    EXPECT_EQ(content_of(name), expected);
    for (unsigned int i = 1; i <= 100; ++i)
      add(i);
    const std::string some = content_of(name);
    EXPECT_EQ(some.back(), '\n');
    EXPECT_EQ(expected.compare(0, some.size(), some), 0);
    EXPECT_EQ(file.state().size, expected.size());
    EXPECT_EQ(content_of(name), expected);
    add(101);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    add(102);
    EXPECT_EQ(content_of(name), expected);
    add(103);
    file << "no whole row";
  }
  EXPECT_EQ(content_of(name), expected);
}



/* In a child, since the limit is that of a process. */
TEST(TableFile, KeepsTheRowsForWhichThereIsSpace)
{
  const TemporaryFolder folder;
  const std::string     name  = folder.file("table.csv");
  const pid_t           child = fork();
  if (child == 0)
    {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit limit = {1000, 1000};
      setrlimit(RLIMIT_FSIZE, &limit);
      TableFile file(name);
      file << "123456";
      file.end_row();
      std::string message;
      try
        {
          for (unsigned int i = 0; i < 300; ++i)
            {
              file << "123456";
              file.end_waiting_row();
            }
          file.write_waiting_rows();
        }
      catch (const InputError &error)
        {
          message = error.what();
        }
      _exit(message.find("cannot be written (File too large)") ==
            std::string::npos);
    }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  std::string expected;
  for (unsigned int i = 0; i < 1000 / 7; ++i)
    expected += "123456\n";
  EXPECT_EQ(content_of(name), expected);
}



/* A stream of 17 digits is what they have been written with before. */
TEST(TableFile, WritesNumbersAsAStreamDoes)
{
  using Limits                                   = std::numeric_limits<double>;
  std::vector<double>                    numbers = {0.,
                                                    -0.,
                                                    1.,
                                                    -100.,
                                                    1e15,
                                                    1e16,
                                                    123456789012345678.,
                                                    1e-4,
                                                    1e-5,
                                                    0.1,
                                                    1. / 3,
                                                    Limits::max(),
                                                    Limits::min(),
                                                    Limits::denorm_min(),
                                                    Limits::infinity(),
                                                    -Limits::infinity(),
                                                    Limits::quiet_NaN(),
                                                    -Limits::quiet_NaN()};
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> digits(-1., 1.);
  std::uniform_int_distribution<int>     exponent(-300, 300);
  for (unsigned int i = 0; i < 2000; ++i)
    numbers.push_back(digits(generator) * std::pow(10., exponent(generator)));

  const TemporaryFolder folder;
  std::ostringstream    expected;
  expected.precision(Limits::max_digits10);
  TableFile file(folder.file("table.csv"));
  for (const double number : numbers)
    {
      expected << number << ',';
      file << number << ',';
    }
  expected << "text" << 7u << ' ' << std::string("more") << -3 << '\n';
  file << "text" << 7u << ' ' << std::string("more") << -3;
  file.end_row();
  EXPECT_EQ(content_of(folder.file("table.csv")), expected.str());
}



TEST(TableFile, MissesItsFolder)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("results"));
  const std::string name = folder.file("results/table.csv");
  TableFile         file(name);
  file << "a,b";
  file.end_row();
  std::filesystem::rename(folder.file("results"), folder.file("elsewhere"));
  file << 1;
  expect_one_sentence_with(message_of([&]() { file.end_row(); }),
                           {name, "it is not there any more"});
}



TEST(FolderLock, IsThatOfOneProgramAndEndsWithIt)
{
  const TemporaryFolder folder;
  {
    const FolderLock lock(folder.path.string());
    expect_one_sentence_with(message_of([&]() {
                               FolderLock second(folder.path.string());
                             }),
                             {"another run is writing there"});
  }
  const pid_t child = fork();
  if (child == 0)
    {
      const FolderLock lock(folder.path.string());
      kill(getpid(), SIGKILL);
    }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  const FolderLock lock(folder.path.string());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path));
}



TEST(Interrupt, NotesAClosedTerminalAndPipe)
{
  for (const int signal : {SIGHUP, SIGPIPE})
    {
      const Interrupt interrupt;
      EXPECT_FALSE(interrupt.is_requested(MPI_COMM_SELF));
      std::raise(signal);
      EXPECT_TRUE(interrupt.is_requested(MPI_COMM_SELF));
      // Each line of progress brings it again.
      if (signal == SIGPIPE)
        for (unsigned int i = 0; i < 5; ++i)
          std::raise(signal);
    }
}
