// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run.h"

#include "app/commands.h"
#include "app/manual_page.h"
#include "readers/Scanner.h"
#include "io/Output_file.h"
#include "io/errors.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace program {

namespace {

constexpr const char* version = "geodesic 0.1.0";

int fail(Exit_code code, std::string message)
{
  // Library messages may contain line breaks; an error is printed as one line.
  for(char& c : message)
    c = c == '\n' || c == '\r' ? ' ' : c;
  std::fprintf(stderr, "geodesic: %s\n", message.c_str());
  return code;
}

struct Named_command
{
  std::string_view name;
  void (*add)(CLI::App&);
};

constexpr Named_command commands[] = {
    {"info", add_info},
    {"distance", add_distance},
    {"isolines", add_isolines},
    {"ball", add_ball},
    {"diameter", add_diameter},
    {"path", add_path},
    {"loops", add_loops},
    {"curve", add_curve},
    {"logmap", add_logmap},
    {"decal", add_decal},
    {"flatten", add_flatten},
    {"atlas", add_atlas},
    {"matrix", add_matrix},
    {"merge-matrices", add_merge_matrices},
    {"sample", add_sample},
    {"voronoi", add_voronoi},
    {"segment", add_segment},
    {"remesh", add_remesh},
    {"base", add_base},
    {"semiregular", add_semiregular},
    {"wavelet", add_wavelet},
    {"surfels", add_surfels},
    {"emd", add_emd},
    {"plan", add_plan},
    {"barycenter", add_barycenter},
    {"karcher-mean", add_karcher_mean},
    {"feature-distance", add_feature_distance},
    {"fuzzy", add_fuzzy},
    {"streamlines", add_streamlines},
    {"volume", add_volume},
    {"view", add_view},
};

// Adds the command of this name, or all commands if none has it (for help and error messages). Most
// commands have many options: constructing the options of all commands takes longer than a command
// on a small surface.
void add_commands(CLI::App& program, std::string_view name)
{
  const auto named = std::find_if(std::begin(commands), std::end(commands),
                                  [&](const Named_command& c) { return c.name == name; });
  if(named != std::end(commands))
    return named->add(program);
  for(const Named_command& command : commands)
    command.add(program);
}

// Returns the message of a parser error. The parser does not name a command that does not exist.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error)
{
  if(!program.get_subcommands().empty())
    return error.what();
  const std::vector<std::string> words = program.remaining();
  if(words.empty())
    return "a command is required";
  const bool is_option = words.front().rfind('-', 0) == 0;
  return std::string("there is no ") + (is_option ? "option '" : "command '") +
         printable(words.front()) + "'";
}

// Returns a prefix with the input's file name, for errors that do not contain it.
std::string input_prefix(const CLI::App& program)
{
  for(const CLI::App* command : program.get_subcommands())
    if(const CLI::Option* input = command->get_option_no_throw("INPUT"))
      return input->as<std::string>() + ": ";
  return {};
}

} // namespace

int run(int argc, char** argv)
{
  // If the reader of a pipe exits or a file exceeds the limit of its size, the write must fail with
  // an error instead of ending the process.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  remove_unfinished_file_on_signals();

  CLI::App program(
      "Geodesic distances, shortest paths and related algorithms on triangle meshes and "
      "point clouds.",
      "geodesic");
  program.require_subcommand(1);
  program.footer("Exit codes: 0 success; 1 wrong usage, or a required component is not installed; "
                 "2 the input cannot be processed, or there is not enough memory; "
                 "3 the result cannot be written.");
  program.set_help_flag("-h,--help", "print this help and exit");
  program.set_version_flag("--version", version, "print the version and exit");
  // The parser prints the text of the exception that it throws for the version.
  program.add_flag_callback(
      "--manual-page", [&program] { throw CLI::CallForVersion(manual_page(program, version), 0); },
      "print the manual page in the format of man and exit");
  add_commands(program, argc > 1 ? argv[1] : "");
  try
  {
    program.parse(argc, argv);
    return success;
  }
  catch(const CLI::ParseError& error)
  {
    if(error.get_exit_code() == 0)
    {
      program.exit(error); // prints help or the version
      return std::fflush(stdout) == 0 ? success : not_written;
    }
    return fail(wrong_usage, usage_message(program, error) + "; see geodesic --help.");
  }
  catch(const Usage_error& error)
  {
    return fail(wrong_usage, error.what());
  }
  catch(const Input_error& error)
  {
    return fail(bad_input, error.what());
  }
  catch(const Output_error& error)
  {
    return fail(not_written, error.what());
  }
  catch(const CGAL::Geodesic_processing::Invalid_argument_error& error)
  {
    return fail(bad_input, input_prefix(program) + error.what());
  }
  catch(const CGAL::Geodesic_processing::Unsupported_surface_error& error)
  {
    return fail(bad_input, input_prefix(program) + error.what());
  }
  catch(const std::bad_alloc&)
  {
    return fail(bad_input, input_prefix(program) + "there is not enough memory.");
  }
  catch(const std::exception& error)
  {
    return fail(bad_input, input_prefix(program) + error.what());
  }
}

} // namespace program
