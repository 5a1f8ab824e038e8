// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_JOB_H
#define GEODESIC_PROGRAM_APP_JOB_H

#include "repair/Surface.h"

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace program {

class Command;
class Display;

// A number for JSON. Infinity and NaN are written as null, because JSON cannot represent them.
struct Json_number
{
  double value;
};
inline Json_number json_number(double value) { return {value}; }

// A reference to a value of a JSON object. The assignments are compiled in one source file,
// because the JSON library is slow to compile.
class Json_entry
{
public:
  explicit Json_entry(nlohmann::ordered_json& value) : m_value(value) {}

  template <typename Value>
  void operator=(const Value& value)
  {
    if constexpr(std::is_same_v<Value, bool>)
      set_flag(value);
    else if constexpr(std::is_unsigned_v<Value>)
      set_unsigned(value);
    else if constexpr(std::is_integral_v<Value>)
      set_signed(value);
    else
      set(value);
  }

private:
  void set_flag(bool value);
  void set_unsigned(unsigned long long value);
  void set_signed(long long value);
  void set(double value);
  void set(const Json_number& value);
  void set(const std::string& value);
  void set(const Point& value);
  void set(const std::vector<std::size_t>& values);
  void set(const std::vector<double>& values);
  void set(const std::vector<Point>& values);

  nlohmann::ordered_json& m_value;
};

class Json_object
{
public:
  explicit Json_object(nlohmann::ordered_json& object) : m_object(object) {}
  Json_entry operator[](const std::string& name) const;

private:
  nlohmann::ordered_json& m_object;
};

// One run of a command: its common options, input, timing and results.
class Job
{
public:
  // Adds the INPUT argument and the common options to a command.
  explicit Job(Command& command);
  ~Job();

  // Rejects invalid options before any computation, and reads the input. The extension of the -o
  // file must be one of `extensions`, the formats that can store the command's result.
  const Surface& read(const std::vector<std::string>& extensions = {"ply", "off", "obj", "vtp"});
  const Surface& surface() const { return m_surface; }
  // Frees the memory of the file of the surface, of which only the domain is used from then on.
  void release_file() { m_surface.file = {}; }

  // Starts a timed stage: read, prepare, query or write. It lasts until the next stage starts.
  // If a stage is started several times, its times are added.
  void begin_stage(const std::string& name);

  // Returns the object that collects the results for --json, in order of insertion.
  Json_object result() { return Json_object(*m_result); }

  // Adds a number to the JSON result as `name`, and prints it in a line on standard output.
  void report(const std::string& name, double value);
  void report(const std::string& name, std::size_t value);

  // Returns a callback that draws a progress bar on standard error after one second. If --quiet is
  // given or standard error is not a terminal, the callback is empty. It never cancels.
  std::function<bool(double)> progress_callback(const std::string& title);

  // Announces a computation that needs more than a gigabyte, or throws Input_error if less than it
  // needs is available. `what` is the subject of the sentence.
  void check_memory(const std::string& what, double bytes) const;

  // Prints a line on standard output (results) or standard error (warnings about the input).
  // --quiet suppresses both, and --json the first.
  void print_line(const std::string& line) const;
  void print_warning(const std::string& line) const;

  // If --values is given, writes its file. `text` composes the lines and is called only then.
  void write_values(const std::function<std::string()>& text) const;

  // Prints the JSON result.
  void finish();

  const std::string& input() const { return m_input; }
  const std::string& output() const { return m_output; }
  const std::string& values() const { return m_values; }
  const std::string& picture() const { return m_picture; }
  bool json() const { return m_json; }
  unsigned threads() const; // at least 1
  unsigned seed() const { return m_seed; }

private:
  void print_value(const std::string& name, const std::string& value) const;

  std::string m_input, m_output, m_values, m_picture;
  bool m_json = false, m_quiet = false;
  unsigned m_threads = 0, m_seed = 0;

  Surface m_surface;
  std::unique_ptr<nlohmann::ordered_json> m_result;
  std::map<std::string, double> m_seconds;
  std::string m_stage;
  std::chrono::steady_clock::time_point m_stage_start;
  std::unique_ptr<Display> m_display;
};

// Formats a number for standard output, with six significant digits.
std::string rounded_text(double value);

// Parses "3,17,4". Throws Usage_error that names the option.
std::vector<std::size_t> parse_indices(const std::string& text, const std::string& option);
// Parses numbers that are separated by commas. Returns std::nullopt if the text is anything else.
std::optional<std::vector<double>> parse_numbers(const std::string& text);
Point parse_point(const std::string& text, const std::string& option);

// Throws Input_error if the surface does not contain the vertex.
void check_vertex(const Surface& surface, std::size_t vertex);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_JOB_H
