// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_REPORT_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_REPORT_H

#include "Record.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#  include <malloc.h>
#endif

// Measures time and memory, and prints tables.

namespace benchmarks {

// Returns the processor time of f() in seconds, summed over all threads. On a busy machine it is
// more reliable than wall-clock time.
template <typename Function>
double cpu_seconds(Function f)
{
  const std::clock_t begin = std::clock();
  f();
  return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

// Returns the wall-clock time of f() in seconds. Use it to measure the speed-up by threads.
template <typename Function>
double wall_seconds(Function f)
{
  const auto begin = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double median(std::vector<double> values)
{
  if(values.empty())
    return std::nan("");
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Returns the number of currently allocated bytes, or nan if the C library does not report it.
inline double allocated_bytes()
{
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const auto info = mallinfo2();
  return double(info.uordblks) + double(info.hblkhd);
#else
  return std::nan("");
#endif
}

// Returns the maximum resident memory since the last reset_peak_memory(), in bytes. Returns nan if
// the system does not report it (Linux only).
inline double peak_memory()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while(status >> word)
    if(word == "VmHWM:")
    {
      double kilobytes = 0.;
      status >> kilobytes;
      return 1024. * kilobytes;
    }
  return std::nan("");
}

// Resets the peak memory. Freed memory is first returned to the system; otherwise its reuse would
// hide later allocations.
inline void reset_peak_memory()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}

inline std::string format_fixed(double value, int decimals)
{
  if(std::isnan(value))
    return "-";
  if(std::isinf(value))
    return "inf";
  char text[64];
  const double max_zero = 0.5 * std::pow(10., -decimals); // avoids "-0.00"
  std::snprintf(text, sizeof(text), "%.*f", decimals, std::fabs(value) < max_zero ? 0. : value);
  return text;
}

// Formats `value` with three significant digits.
inline std::string format_significant(double value)
{
  if(std::isnan(value))
    return "-";
  char text[64];
  std::snprintf(text, sizeof(text), value != 0. && std::fabs(value) < 1e-3 ? "%.1e" : "%.3g",
                value);
  return text;
}

// Accumulates the mean and the maximum of the added values.
struct Mean_and_max
{
  double mean = 0., largest = 0.;
  std::size_t count = 0;

  void add(double x)
  {
    mean += (x - mean) / double(++count);
    largest = std::max(largest, x);
  }
  std::string percent(int decimals) const
  {
    return format_fixed(100. * mean, decimals) + " / " + format_fixed(100. * largest, decimals);
  }
};

// Prints a table with minimal column widths, and records it under its title. The first column is
// left-aligned, the others are right-aligned.
class Table
{
public:
  Table(std::string title, std::vector<std::string> header) : m_title(std::move(title))
  {
    m_rows.push_back(std::move(header));
  }

  void add(std::vector<std::string> row) { m_rows.push_back(std::move(row)); }

  void print() const
  {
    Record::add(m_title, m_rows);
    std::vector<std::size_t> width;
    for(const auto& row : m_rows)
      for(std::size_t i = 0; i < row.size(); ++i)
      {
        width.resize(std::max(width.size(), i + 1));
        width[i] = std::max(width[i], row[i].size());
      }
    for(const auto& row : m_rows)
    {
      for(std::size_t i = 0; i < row.size(); ++i)
        std::printf(i == 0 ? "%-*s" : "  %*s", int(width[i]), row[i].c_str());
      std::printf("\n");
    }
    std::printf("\n");
    std::fflush(stdout);
  }

private:
  std::string m_title;
  std::vector<std::vector<std::string>> m_rows;
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_REPORT_H
