// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_RECORD_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_RECORD_H

#include <CGAL/version.h>
#include <Eigen/Core>
#include <boost/version.hpp>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(__unix__)
#  include <unistd.h>
#endif

// Writes tables to a data file of doc/results, which describes the format.

namespace benchmarks {

// The data file of this benchmark. Nothing is written unless the environment variable
// GEODESIC_PROCESSING_RESULTS names a folder. GEODESIC_PROCESSING_COMMIT is the commit of the
// library; run.sh sets both.
class Record
{
public:
  // The first row contains the headings of the columns, which must be distinct.
  static void add(const std::string& title, const std::vector<std::vector<std::string>>& rows)
  {
    if(const char* const folder = std::getenv("GEODESIC_PROCESSING_RESULTS"))
    {
      static Record record(folder);
      record.write(title, rows);
    }
  }

private:
  explicit Record(const std::string& folder)
      : m_file(folder + "/" BENCHMARK_NAME ".tsv", std::ios::trunc)
  {
    const char* const commit = std::getenv("GEODESIC_PROCESSING_COMMIT");
    write("program", "benchmark " BENCHMARK_NAME);
    write("processor", processor());
    write("cores", number_of_cores());
    write("compiler", compiler());
    write("CGAL", CGAL_VERSION_STR);
    write("Eigen", version(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION));
    write("Boost",
          version(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
    write("commit", commit ? commit : unknown);
  }

  void write(const std::string& name, const std::string& value)
  {
    m_file << name << '\t' << value << '\n';
  }

  void write(const std::string& title, const std::vector<std::vector<std::string>>& rows)
  {
    m_file << "\ntable\t" << title << '\n';
    for(const auto& row : rows)
      for(std::size_t i = 0; i < rows.front().size(); ++i)
        m_file << (i < row.size() ? row[i] : "") << (i + 1 < rows.front().size() ? '\t' : '\n');
    m_file.flush();
    if(!m_file)
      throw std::runtime_error("The data file of benchmark " BENCHMARK_NAME " cannot be written.");
  }

  static std::string processor()
  {
    std::ifstream file("/proc/cpuinfo");
    for(std::string line; std::getline(file, line);)
      if(line.rfind("model name", 0) == 0)
        return line.substr(line.find(':') + 2);
    return unknown;
  }

  // The number of cores of the machine, also if the process is bound to one of them.
  static std::string number_of_cores()
  {
#if defined(_SC_NPROCESSORS_ONLN)
    return std::to_string(sysconf(_SC_NPROCESSORS_ONLN));
#else
    return unknown;
#endif
  }

  static std::string compiler()
  {
#if defined(__clang__)
    return "clang " + version(__clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return "gcc " + version(__GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return unknown;
#endif
  }

  static std::string version(int major, int minor, int patch)
  {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
  }

  static constexpr const char* unknown = "not recorded";

  std::ofstream m_file;
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_RECORD_H
