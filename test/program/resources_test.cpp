// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/Program.h"

#include "io/Output_file.h"

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

#include <sys/resource.h>

// Too little memory, a full disk and signals.

namespace resources_test {

using program_test::Program;
using program_test::read_file;
using program_test::Run_result;
namespace fs = std::filesystem;

// Returns the text of an OFF file with the unit square, n x n vertices and a bump.
std::string bump(std::size_t n)
{
  std::ostringstream text;
  text << "OFF\n" << n * n << ' ' << 2 * (n - 1) * (n - 1) << " 0\n";
  for(std::size_t j = 0; j < n; ++j)
    for(std::size_t i = 0; i < n; ++i)
    {
      const double x = double(i) / double(n - 1), y = double(j) / double(n - 1);
      text << x << ' ' << y << ' ' << x * (1. - x) * y * (1. - y) << '\n';
    }
  for(std::size_t j = 0; j + 1 < n; ++j)
    for(std::size_t i = 0; i + 1 < n; ++i)
    {
      const std::size_t a = n * j + i;
      text << "3 " << a << ' ' << a + 1 << ' ' << a + n + 1 << "\n3 " << a << ' ' << a + n + 1
           << ' ' << a + n << '\n';
    }
  return text.str();
}

// Sanitizers reserve terabytes of address space, so they do not run with this limit.
#ifdef __SANITIZE_ADDRESS__
constexpr bool is_memory_limited = false;
#elif defined(__has_feature)
constexpr bool is_memory_limited =
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool is_memory_limited = true;
#endif

TEST_F(Program, exits_with_2_if_memory_is_insufficient)
{
  if(!is_memory_limited)
    GTEST_SKIP() << "A sanitizer needs more memory than the limit.";
  write("large.off", bump(250));
  // If OpenBLAS cannot allocate a buffer, it repeats the allocation forever. With one thread, the
  // program starts without a buffer, and these commands need none.
  const auto with_limit = [](std::size_t kilobytes)
  { return "export OPENBLAS_NUM_THREADS=1; ulimit -v " + std::to_string(kilobytes) + " && "; };
  // The smallest limit, to within 8 MB, with which the program starts.
  std::size_t too_small = 0, start = std::size_t(1) << 24;
  while(start - too_small > 8192)
  {
    const std::size_t middle = (too_small + start) / 2;
    (run("--version", with_limit(middle)).code == 0 ? start : too_small) = middle;
  }
  for(const char* command :
      {"distance large.off --source 0 --method exact -o a.ply",
       "distance large.off --source 0 --method fast-marching --values a.txt",
       "remesh large.off --number 300 -o a.ply", "sample large.off --number 300 --values a.txt",
       "matrix large.off --number 4 --method exact --threads 4 --values a.txt"})
  {
    std::size_t number_of_failures = 0;
    for(std::size_t more = 1024;; more *= 2)
    {
      const Run_result result = run(command, with_limit(start + more));
      if(result.code == 0)
        break;
      ++number_of_failures;
      ASSERT_EQ(result.code, 2) << command << " with " << start + more << " KB: " << result.err;
      // The lack of memory is found by the command, or before the computation.
      EXPECT_TRUE(std::regex_search(result.err, std::regex("there is not enough memory\\.\n|"
                                                           " are available\\.\n")))
          << result.err;
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
      EXPECT_FALSE(fs::exists(m_folder / "a.ply") || fs::exists(m_folder / "a.txt"));
    }
    EXPECT_GT(number_of_failures, 0u) << command;
    for(const char* file : {"a.ply", "a.txt"})
      fs::remove(m_folder / file);
  }
}

TEST_F(Program, exits_with_3_if_disk_is_full)
{
  if(!fs::exists("/dev/full"))
    GTEST_SKIP() << "Without /dev/full, the test has no file to which nothing can be written.";
  for(const char* extension : {"ply", "off", "obj", "vtp", "txt", "png"})
    fs::create_symlink("/dev/full", m_folder / (std::string("full.") + extension));
  for(const char* extension : {"ply", "off", "obj", "vtp"})
    expect_failure(std::string("distance square.ply --source 0 --quiet -o full.") + extension, 3,
                   "it cannot be written: No space left on device.");
  expect_failure("distance square.ply --source 0 --quiet --values full.txt", 3,
                 "No space left on device.");
  // Pictures need VTK and Xvfb; without them, the exit code is 1.
  if(run("info square.ply --picture a.png").code == 0)
    expect_failure("info square.ply --quiet --picture full.png", 3, "No space left on device.");
  for(const char* arguments :
      {"distance square.ply --source 0 --json > /dev/full", "info square.ply > /dev/full"})
  {
    const Run_result result = run(arguments);
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.err, "geodesic: standard output: it cannot be written.\n");
  }
}

TEST_F(Program, exits_with_3_if_file_exceeds_size_limit)
{
  write("a.ply", "old");
  const std::size_t files = number_of_files();
  const Run_result result = run("distance square.ply --source 0 -o a.ply", "ulimit -f 1 && ");
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.err, "geodesic: a.ply: it cannot be written: File too large.\n");
  EXPECT_EQ(read_file(m_folder / "a.ply"), "old");
  EXPECT_EQ(number_of_files(), files);
}

TEST_F(Program, keeps_output_file_if_terminated)
{
  write("large.off", bump(200));
  write("a.txt", "old");
  const std::size_t files = number_of_files();
  // The matrix takes minutes. SIGINT can be ignored by the process that runs the tests.
  const Run_result result = run("matrix large.off --number 2000 --method exact --values a.txt",
                                "timeout --preserve-status -s TERM 1 ");
  EXPECT_EQ(result.code, 128 + SIGTERM);
  EXPECT_EQ(read_file(m_folder / "a.txt"), "old");
  EXPECT_EQ(number_of_files(), files);
}

// Writes a file and interrupts the process after 4,096 bytes.
[[noreturn]] void write_and_interrupt(const std::string& filename)
{
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGXFSZ, [](int) { std::raise(SIGINT); });
  program::remove_unfinished_file_on_signals();
  const ::rlimit limit = {4096, 4096};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  program::write_file(filename, std::string(8192, 'x'));
  std::_Exit(0);
}

TEST_F(Program, removes_temporary_file_if_interrupted)
{
  write("a.txt", "old");
  const std::size_t files = number_of_files();
  EXPECT_EXIT(write_and_interrupt((m_folder / "a.txt").string()), testing::KilledBySignal(SIGINT),
              "");
  EXPECT_EQ(read_file(m_folder / "a.txt"), "old");
  EXPECT_EQ(number_of_files(), files);
}

} // namespace resources_test
