// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_COMMAND_H
#define GEODESIC_PROGRAM_APP_COMMAND_H

#include <functional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace program {

class Option
{
public:
  explicit Option(CLI::Option& option) : m_option(&option) {}

  Option& required();
  Option& shows_default(); // in the help
  Option& in_range(double min_value, double max_value);
  Option& value_is_optional();

private:
  CLI::Option* m_option;
};

// A subcommand with its options. This class is the only code that compiles the CLI parser. The
// parser takes longer to compile than the commands, so this header only declares its types.
class Command
{
public:
  Command(CLI::App& program, const std::string& name, const std::string& description);

  // Adds an option that stores its argument in `value`. The help text shows `placeholder` for the
  // argument and `description`. A list receives one element each time that the option is given.
  // Negative counts are rejected. Functions throw Usage_error.
  //
  // Value: std::string, double, unsigned or std::size_t, std::optional or std::vector of some of
  // them, or const std::function<void(const std::string&)>.
  template <typename Value>
  Option add(const std::string& names, Value& value, const std::string& placeholder,
             const std::string& description);
  void add_flag(const std::string& name, bool& value, const std::string& description);

  // Replaces the description of an existing option.
  void describe(const std::string& name, const std::string& description);

  void set_callback(const std::function<void()>& run);

private:
  CLI::App* m_command;
};

} // namespace program

#endif // GEODESIC_PROGRAM_APP_COMMAND_H
