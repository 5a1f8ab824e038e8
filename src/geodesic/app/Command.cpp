// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Command.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <sstream>
#include <type_traits>
#include <vector>

namespace program {

namespace {

template <typename Value>
struct Element_type
{
  using type = Value;
};
template <typename Value>
struct Element_type<std::optional<Value>>
{
  using type = Value;
};
template <typename Value>
struct Element_type<std::vector<Value>>
{
  using type = Value;
};

using Function = const std::function<void(const std::string&)>;

// Rejects negative numbers, because a conversion to an unsigned count would make them large.
CLI::Validator non_negative()
{
  return CLI::Validator([](const std::string& text)
                        { return text.rfind('-', 0) == 0 ? text + " is negative" : std::string(); },
                        "");
}

} // namespace

Option& Option::required()
{
  m_option->required();
  return *this;
}

Option& Option::shows_default()
{
  m_option->capture_default_str();
  return *this;
}

Option& Option::in_range(double min_value, double max_value)
{
  // The message of CLI::Range prints the limits with six decimals.
  std::ostringstream range;
  range << '[' << min_value << ", " << max_value << ']';
  const auto check = [=, text = range.str()](const std::string& word)
  {
    double value = 0.;
    return CLI::detail::lexical_cast(word, value) && value >= min_value && value <= max_value
               ? std::string()
               : word + " is not in the range " + text;
  };
  m_option->check(CLI::Validator(check, "in " + range.str()));
  return *this;
}

Option& Option::value_is_optional()
{
  m_option->expected(0, 1);
  return *this;
}

Command::Command(CLI::App& program, const std::string& name, const std::string& description)
    : m_command(program.add_subcommand(name, description))
{}

template <typename Value>
Option Command::add(const std::string& names, Value& value, const std::string& placeholder,
                    const std::string& description)
{
  CLI::Option* option;
  if constexpr(std::is_same_v<Value, Function>)
    option = m_command->add_option_function<std::string>(names, value, description);
  else
    option = m_command->add_option(names, value, description);
  option->type_name(placeholder);
  if constexpr(std::is_unsigned_v<typename Element_type<Value>::type>)
    option->check(non_negative());
  if constexpr(std::is_same_v<Value, std::vector<typename Element_type<Value>::type>>)
    option->type_size(1)->allow_extra_args(false);
  return Option(*option);
}

template Option Command::add(const std::string&, std::string&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, double&, const std::string&, const std::string&);
template Option Command::add(const std::string&, unsigned&, const std::string&, const std::string&);
template Option Command::add(const std::string&, std::size_t&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, std::optional<double>&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, std::optional<std::size_t>&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, std::vector<std::string>&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, std::vector<double>&, const std::string&,
                             const std::string&);
template Option Command::add(const std::string&, Function&, const std::string&, const std::string&);

void Command::add_flag(const std::string& name, bool& value, const std::string& description)
{
  m_command->add_flag(name, value, description);
}

void Command::describe(const std::string& name, const std::string& description)
{
  m_command->get_option(name)->description(description);
}

void Command::set_callback(const std::function<void()>& run) { m_command->callback(run); }

} // namespace program
