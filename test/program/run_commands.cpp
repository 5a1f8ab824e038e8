// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// run_commands FOLDER SECONDS: runs the program on each command line of standard input, one after
// the other in this process: a sanitized process takes longer to start than most commands take.
//
// A line holds arguments separated by tabs. The n-th command, from 0, writes its standard output to
// FOLDER/n.out and its standard error to FOLDER/n.err. After each command, its exit code and its
// seconds are printed. A command that crashes or exceeds the time limit ends the process.
#include "app/run.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

// Redirects a file descriptor to a new file.
void redirect(int descriptor, const std::string& file)
{
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if(opened < 0 || ::dup2(opened, descriptor) < 0)
    std::abort();
  ::close(opened);
}

// Splits a line at its tabs. The pointers refer to the line.
std::vector<char*> split(std::string& line)
{
  std::vector<char*> result = {line.data()};
  for(char& c : line)
    if(c == '\t')
    {
      c = '\0';
      result.push_back(&c + 1);
    }
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc != 3)
    return 1;
  const std::string folder = argv[1];
  const unsigned limit = unsigned(std::atoi(argv[2]));
  std::FILE* report = ::fdopen(::dup(STDOUT_FILENO), "w");
  std::string name = "geodesic";
  std::size_t number = 0;
  for(std::string line; std::getline(std::cin, line); ++number)
  {
    std::vector<char*> arguments = split(line);
    arguments.insert(arguments.begin(), name.data());
    redirect(STDOUT_FILENO, folder + '/' + std::to_string(number) + ".out");
    redirect(STDERR_FILENO, folder + '/' + std::to_string(number) + ".err");
    const auto begin = std::chrono::steady_clock::now();
    ::alarm(limit); // its default action ends the process
    const int code = program::run(int(arguments.size()), arguments.data());
    ::alarm(0);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::fflush(stdout);
    std::fprintf(report, "%d %.0f\n", code, seconds.count());
    std::fflush(report);
  }
  std::fclose(report);
  return 0;
}
