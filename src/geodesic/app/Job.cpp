// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Job.h"

#include "app/memory.h"

#include "app/Command.h"
#include "picture/Display.h"
#include "io/Output_file.h"
#include "readers/Scanner.h"
#include "io/errors.h"
#include "io/read_gpw.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include <unistd.h>

namespace program {

void Json_entry::set_flag(bool value) { m_value = value; }
void Json_entry::set_unsigned(unsigned long long value) { m_value = value; }
void Json_entry::set_signed(long long value) { m_value = value; }
void Json_entry::set(double value) { m_value = value; }
void Json_entry::set(const Json_number& number)
{
  if(std::isfinite(number.value))
    m_value = number.value;
  else
    m_value = nullptr;
}
void Json_entry::set(const std::string& value) { m_value = value; }
void Json_entry::set(const Point& value) { m_value = value; }
void Json_entry::set(const std::vector<std::size_t>& values) { m_value = values; }
void Json_entry::set(const std::vector<double>& values) { m_value = values; }
void Json_entry::set(const std::vector<Point>& values) { m_value = values; }

Json_entry Json_object::operator[](const std::string& name) const
{
  return Json_entry(m_object[name]);
}

Job::Job(Command& command) : m_result(std::make_unique<nlohmann::ordered_json>())
{
  command
      .add("INPUT", m_input, "TEXT",
           "mesh or point cloud: .ply .off .obj .stl .xyz .pwn .vtp .gpw .gltf .glb .gii, or one "
           "of these compressed by gzip (.ply.gz), or a FreeSurfer surface")
      .required();
  command.add("-o,--output", m_output, "FILE", "write the result: .ply .off .obj .vtp");
  command.add("--values", m_values, "FILE",
              "write the result as text, one line per vertex or element");
  command.add("--picture", m_picture, "FILE", "draw the result: .png");
  command.add_flag("--json", m_json, "print the results as one JSON object");
  command.add("--threads", m_threads, "N", "number of threads (default 0: one per processor)");
  command.add("--seed", m_seed, "N", "seed of the random number generator (default 0)");
  command.add_flag("--quiet", m_quiet, "suppress result lines, warnings and progress");
}

Job::~Job() = default;

const Surface& Job::read(const std::vector<std::string>& extensions)
{
  if(!m_output.empty())
  {
    if(std::find(extensions.begin(), extensions.end(), file_extension(m_output)) ==
       extensions.end())
    {
      std::string list;
      for(std::size_t i = 0; i < extensions.size(); ++i)
        list += (i == 0 ? "." : i + 1 < extensions.size() ? ", ." : " or .") + extensions[i];
      throw Usage_error("-o " + m_output + ": the file extension must be " + list + ".");
    }
    check_directory(m_output);
  }
  if(!m_values.empty())
    check_directory(m_values);
  if(!m_picture.empty())
  {
    if(file_extension(m_picture) != "png")
      throw Usage_error("--picture " + m_picture +
                        ": the file extension of a picture must be .png.");
    check_directory(m_picture);
    m_display = std::make_unique<Display>();
  }
  begin_stage("read");
  Surface_file file = read_surface_file(m_input, {{"gpw", read_gpw}}, threads());
  begin_stage("prepare");
  m_surface = repair(std::move(file), m_input, threads());
  (*m_result)["input"] = m_input;
  (*m_result)["repaired"] = m_surface.is_repaired;
  (*m_result)["kind"] = m_surface.is_mesh() ? "mesh" : "cloud";
  (*m_result)["vertices"] = m_surface.file.points.size();
  (*m_result)["faces"] = m_surface.file.number_of_polygons();
  if(m_surface.is_repaired)
    print_warning(m_surface.is_mesh()
                      ? "the faces were repaired (triangulated, reoriented or separated)"
                      : "missing normals were estimated");
  return m_surface;
}

unsigned Job::threads() const
{
  return m_threads != 0 ? m_threads : std::max(1u, std::thread::hardware_concurrency());
}

void Job::begin_stage(const std::string& name)
{
  const auto now = std::chrono::steady_clock::now();
  if(!m_stage.empty())
    m_seconds[m_stage] += std::chrono::duration<double>(now - m_stage_start).count();
  m_stage = name;
  m_stage_start = now;
}

std::function<bool(double)> Job::progress_callback(const std::string& title)
{
  if(m_quiet || ::isatty(STDERR_FILENO) == 0)
    return {};
  const auto start = std::chrono::steady_clock::now();
  return [title, start, last_percent = -1](double fraction) mutable
  {
    const int percent = static_cast<int>(100. * std::clamp(fraction, 0., 1.));
    // Runs shorter than one second show no progress bar.
    if(percent != last_percent &&
       std::chrono::steady_clock::now() - start > std::chrono::seconds(1))
    {
      last_percent = percent;
      const std::string bar(static_cast<std::size_t>(percent / 4), '=');
      std::fprintf(stderr, "\r%s [%-25s] %3d %%%s", title.c_str(), bar.c_str(), percent,
                   percent == 100 ? "\n" : "");
      std::fflush(stderr);
    }
    return true;
  };
}

void Job::print_line(const std::string& line) const
{
  if(!m_json && !m_quiet)
    std::printf("%s\n", line.c_str());
}

void Job::print_value(const std::string& name, const std::string& value) const
{
  constexpr std::size_t column = 16;
  std::string line = name;
  line.resize(std::max(line.size() + 1, column), ' ');
  print_line(line + value);
}

void Job::report(const std::string& name, double value)
{
  result()[name] = json_number(value);
  print_value(name, rounded_text(value));
}

void Job::report(const std::string& name, std::size_t value)
{
  (*m_result)[name] = value;
  print_value(name, std::to_string(value));
}

void Job::print_warning(const std::string& line) const
{
  if(!m_quiet)
    std::fprintf(stderr, "geodesic: %s: %s.\n", m_input.c_str(), line.c_str());
}

void Job::check_memory(const std::string& what, double bytes) const
{
  if(const std::string lack = lack_of_memory(what, bytes, available_memory()); !lack.empty())
    fail(m_input, lack);
  if(bytes > 1e9)
    print_warning(what + " needs about " + gigabytes(bytes) + " of memory");
}

void Job::write_values(const std::function<std::string()>& text) const
{
  if(!m_values.empty())
    write_file(m_values, text());
}

void Job::finish()
{
  begin_stage("");
  if(m_json)
  {
    for(const char* name : {"read", "prepare", "query", "write"})
      (*m_result)["seconds"][name] = m_seconds[name];
    // A file name may contain arbitrary bytes, but JSON must be UTF-8.
    const std::string text =
        m_result->dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    std::printf("%s\n", text.c_str());
  }
  if(std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Output_error("standard output: it cannot be written.");
}

std::string rounded_text(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

std::vector<std::size_t> parse_indices(const std::string& text, const std::string& option)
{
  std::vector<std::size_t> result;
  for(std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::optional<long long> number = to_integer(word);
    if(!number || *number < 0)
      throw Usage_error(option + " " + printable(text) + ": '" + printable(word) +
                        "' is not a vertex index.");
    result.push_back(static_cast<std::size_t>(*number));
    begin = end + 1;
  }
  return result;
}

std::optional<std::vector<double>> parse_numbers(const std::string& text)
{
  std::vector<double> result;
  for(std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<double> number =
        to_number(std::string_view(text).substr(begin, end - begin));
    if(!number)
      return std::nullopt;
    result.push_back(*number);
    begin = end + 1;
  }
  return result;
}

Point parse_point(const std::string& text, const std::string& option)
{
  const auto numbers = parse_numbers(text);
  if(!numbers || numbers->size() != 3 ||
     !std::all_of(numbers->begin(), numbers->end(), [](double x) { return std::isfinite(x); }))
    throw Usage_error(option + " " + printable(text) + ": a point must have the form x,y,z.");
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void check_vertex(const Surface& surface, std::size_t vertex)
{
  const std::size_t n = surface.file.points.size();
  if(vertex >= n)
    fail(surface.name, "there is no vertex " + std::to_string(vertex) + "; the largest index is " +
                           std::to_string(n - 1));
}

} // namespace program
