// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/manual_page.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace program {

namespace {

// Returns a text as one line on which man interprets no character.
std::string escaped(const std::string& text)
{
  // A line that begins with a period or an apostrophe would be a request.
  std::string result = "\\&";
  for(const char c : text)
    switch(c)
    {
    case '\\':
      result += "\\e";
      break;
    case '-':
      result += "\\-";
      break;
    case '\n':
      result += ' ';
      break;
    default:
      result += c;
    }
  return result;
}

// The label and the description of an option, as in the help.
using Entry = std::pair<std::string, std::string>;

std::vector<Entry> option_entries(const CLI::App& command)
{
  const CLI::Formatter formatter;
  std::vector<Entry> result;
  for(const CLI::Option* const option : command.get_options())
    result.emplace_back(formatter.make_option_name(option, option->get_positional()) +
                            formatter.make_option_opts(option),
                        option->get_description());
  return result;
}

std::string section(const std::string& title, const std::string& text)
{
  return ".SH " + title + '\n' + escaped(text) + '\n';
}

std::string text_of(const Entry& entry)
{
  return ".TP\n.B " + escaped(entry.first) + '\n' + escaped(entry.second) + '\n';
}

} // namespace

std::string manual_page(const CLI::App& program, const std::string& version)
{
  // Most options of a command are those of most commands. They are listed once.
  const std::vector<const CLI::App*> commands = program.get_subcommands({});
  std::map<Entry, std::size_t> number_of_uses;
  std::vector<Entry> common;
  for(const CLI::App* const command : commands)
    for(const Entry& entry : option_entries(*command))
      if(2 * ++number_of_uses[entry] > commands.size() &&
         std::find(common.begin(), common.end(), entry) == common.end())
        common.push_back(entry);

  std::string page = ".TH GEODESIC 1 \"\" \"" + version + "\" \"User Commands\"\n";
  page += section("NAME", "geodesic - geodesics on triangle meshes and point clouds");
  page += section("SYNOPSIS", "geodesic COMMAND INPUT [OPTIONS]");
  page += section("DESCRIPTION", program.get_description());
  page += section("OPTIONS", "Without a command, the program has these options:");
  for(const Entry& entry : option_entries(program))
    page += text_of(entry);
  page += section("COMMON OPTIONS", "Most commands have the following options. "
                                    "The help of a command lists all of its options.");
  for(const Entry& entry : common)
    page += text_of(entry);
  page += ".SH COMMANDS\n";
  for(const CLI::App* const command : commands)
  {
    page += ".SS " + command->get_name() + '\n' + escaped(command->get_description()) + '\n';
    for(const Entry& entry : option_entries(*command))
      if(std::find(common.begin(), common.end(), entry) == common.end())
        page += text_of(entry);
  }
  return page + section("EXIT STATUS", program.get_footer());
}

} // namespace program
