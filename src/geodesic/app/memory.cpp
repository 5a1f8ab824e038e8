// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/memory.h"

#include <cstdio>

#if defined(__linux__)
#  include <sys/resource.h>
#  include <unistd.h>

#  include <algorithm>
#  include <fstream>
#endif

namespace program {

#if defined(__linux__)

namespace {

// Returns the first number after a word of a file, or the first number of the file if the word is
// empty. Nothing if there is none.
std::optional<double> number_in_file(const char* filename, const std::string& word)
{
  std::ifstream file(filename);
  std::string text;
  if(!word.empty())
    while(file >> text && text != word)
    {}
  double number = 0.;
  if(!(file >> number))
    return std::nullopt;
  return number;
}

} // namespace

std::optional<double> available_memory()
{
  std::optional<double> result = number_in_file("/proc/meminfo", "MemAvailable:");
  if(result)
    *result *= 1024.;
  const auto add = [&](double bytes) { result = std::min(result.value_or(bytes), bytes); };
  const auto limit = number_in_file("/sys/fs/cgroup/memory.max", ""),
             current = number_in_file("/sys/fs/cgroup/memory.current", "");
  if(limit && current)
    add(std::max(0., *limit - *current));
  rlimit address_space;
  const auto pages = number_in_file("/proc/self/statm", "");
  if(pages && getrlimit(RLIMIT_AS, &address_space) == 0 && address_space.rlim_cur != RLIM_INFINITY)
    add(std::max(0., double(address_space.rlim_cur) - *pages * double(sysconf(_SC_PAGESIZE))));
  return result;
}

#else

std::optional<double> available_memory() { return std::nullopt; }

#endif

std::string gigabytes(double bytes)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f GB", bytes / 1e9);
  return text;
}

std::string lack_of_memory(const std::string& what, double bytes, std::optional<double> available)
{
  if(!available || bytes <= *available)
    return {};
  return what + " needs about " + gigabytes(bytes) + " of memory, but only " +
         gigabytes(*available) + " are available";
}

} // namespace program
