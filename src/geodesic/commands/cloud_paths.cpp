// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/cloud_paths.h"

#include "io/errors.h"

#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace program {

namespace {

template <typename Enum>
void add_enum_option(Command& command, const std::string& name, Enum& value,
                     const std::string& text, const std::map<std::string, Enum>& values_by_name)
{
  std::string list;
  for(const auto& word : values_by_name)
    list += (list.empty() ? "" : ", ") + word.first;
  const std::function<void(const std::string&)> parse =
      [&value, name, values_by_name, list](const std::string& word)
  {
    const auto found = values_by_name.find(word);
    if(found == values_by_name.end())
      throw Usage_error(name + ' ' + word + ": the value must be one of " + list + '.');
    value = found->second;
  };
  command.add(name, parse, "NAME", "for clouds, " + text + ": " + list);
}

// CGAL 5 returns a map with a flag, and CGAL 6 an optional map.
template <typename Map>
std::optional<Map> optional_map(const std::pair<Map, bool>& map)
{
  return map.second ? std::optional<Map>(map.first) : std::nullopt;
}
template <typename Map>
std::optional<Map> optional_map(const std::optional<Map>& map)
{
  return map;
}

} // namespace

void add_surfel_options(Command& command, Surfel_options& options)
{
  using GP::Surfel_graph;
  using GP::Surfel_noise;
  add_enum_option<Surfel_graph>(command, "--surfel-graph", options.graph,
                                "edges of the surfel graph",
                                {{"extended-spheres", Surfel_graph::extended_spheres},
                                 {"spheres", Surfel_graph::spheres},
                                 {"nearest", Surfel_graph::nearest}});
  add_enum_option<Surfel_noise>(command, "--surfel-noise", options.noise, "treatment of noise",
                                {{"removed-when-found", Surfel_noise::removed_when_found},
                                 {"removed", Surfel_noise::removed},
                                 {"kept", Surfel_noise::kept}});
}

void add_cloud_path_options(Command& command, Cloud_path_options& options)
{
  using GP::Surfel_path_method;
  add_surfel_options(command, options.surfels);
  add_enum_option<Surfel_path_method>(
      command, "--surfel-path-method", options.method, "fitted surface that attracts the path",
      {{"projected-quadrics", Surfel_path_method::projected_quadrics},
       {"projected-spheres", Surfel_path_method::projected_spheres},
       {"projected-planes", Surfel_path_method::projected_planes},
       {"spheres", Surfel_path_method::spheres},
       {"robust-spheres", Surfel_path_method::robust_spheres},
       {"planes", Surfel_path_method::planes},
       {"disks", Surfel_path_method::disks}});
  command
      .add("--control-points", options.control_points, "N",
           "for clouds, maximum number of control points of the path")
      .shows_default();
}

Path_finder make_path_finder(const Cloud& cloud, const Cloud_path_options& options, const Job& job)
{
  const auto np = GP::parameters::surfel_graph(options.surfels.graph)
                      .surfel_noise(options.surfels.noise)
                      .surfel_path_method(options.method)
                      .number_of_control_points(options.control_points)
                      .number_of_threads(job.threads());
  const auto radius = optional_map(cloud.property_map<double>("radius"));
  return radius ? Path_finder(cloud, np.radius_map(*radius)) : Path_finder(cloud, np);
}

Surface_file denoised_surfels(const Cloud& cloud, const Path_finder& finder)
{
  Surface_file result;
  for(const Cloud::Index& surfel : cloud)
  {
    result.points.push_back(coordinates(finder.point(surfel)));
    result.normals.push_back(coordinates(finder.normal(surfel)));
  }
  return result;
}

} // namespace program
