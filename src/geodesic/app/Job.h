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

// A number for JSON, which has no infinity: null instead.
struct Json_number
{
  double value;
};
inline Json_number json_number(double value) { return {value}; }

// A value of an object for JSON.  Assignments are compiled once, as the JSON library takes long.
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

// One call of the program: what all commands share.
class Job
{
public:
  // Adds INPUT and the common options to a command.
  explicit Job(Command& command);
  ~Job();

  // Says what cannot be done before anything is computed, and reads the input.
  // The kinds of -o that hold the command's result are checked against its file name.
  const Surface& read(const std::vector<std::string>& extensions = {"ply", "off", "obj", "vtp"});
  const Surface& surface() const { return m_surface; }

  // The seconds from now on count for this stage: read, prepare, query or write.
  void begin_stage(const std::string& name);

  // What the command has found, for --json in this order.
  Json_object result() { return Json_object(*m_result); }

  // Finds a number: for --json under its name, and for people in a line.
  void report(const std::string& name, double value);
  void report(const std::string& name, std::size_t value);

  // Shows how far the work is, when it is long and somebody watches.  Never cancels.
  std::function<bool(double)> progress_callback(const std::string& title);

  // A line for people on standard output, one about the input on standard error.
  void print_line(const std::string& line) const;
  void print_warning(const std::string& line) const;

  // Composes the lines of --values where they are asked for, and writes them.
  void write_values(const std::function<std::string()>& text) const;

  // Prints the JSON.
  void finish();

  const std::string& input() const { return m_input; }
  const std::string& output() const { return m_output; }
  const std::string& values() const { return m_values; }
  const std::string& picture() const { return m_picture; }
  bool json() const { return m_json; }
  unsigned threads() const; // at least one
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

// A number for people: six digits.
std::string rounded_text(double value);

// Reads "3,17,4"; throws Usage_error naming the option.
std::vector<std::size_t> parse_indices(const std::string& text, const std::string& option);
// Numbers with commas between; nothing for other texts.
std::optional<std::vector<double>> parse_numbers(const std::string& text);
Point parse_point(const std::string& text, const std::string& option);

// Throws Input_error when the surface has no such vertex.
void check_vertex(const Surface& surface, std::size_t vertex);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_JOB_H
