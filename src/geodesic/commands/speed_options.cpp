// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/speed_options.h"

#include "io/Image.h"
#include "readers/Scanner.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

const std::string similar_prefix = "curvature-like-";

bool is_color_speed(const std::string& speed) { return speed == "colors" || speed == "colours"; }

bool is_computed_speed(const std::string& speed)
{
  return speed.rfind(similar_prefix, 0) == 0 || speed == "curvature-attractive" ||
         speed == "curvature-repulsive" || is_color_speed(speed);
}

// Returns the properties with the given names, or an empty array if one is missing.
std::vector<const std::vector<double>*> find_properties(const Surface_file& file,
                                                        const std::vector<std::string>& names)
{
  std::vector<const std::vector<double>*> result;
  for(const std::string& name : names)
  {
    const auto found = file.properties.find(name);
    if(found == file.properties.end())
      return {};
    result.push_back(&found->second);
  }
  return result;
}

// Returns the coordinates at which the image is sampled. If the file has no texture coordinates,
// the image covers the bounding box. It is then projected along the shortest axis of the box.
std::vector<std::array<double, 2>> image_coordinates(const Surface_file& file)
{
  if(!file.uv.empty())
    return file.uv;
  std::vector<std::array<double, 2>> result(file.points.size());
  using Names = std::vector<std::string>;
  for(const Names& names : {Names{"s", "t"}, Names{"u", "v"}, Names{"texture_u", "texture_v"}})
    if(const auto uv = find_properties(file, names); !uv.empty())
    {
      for(std::size_t i = 0; i < result.size(); ++i)
        result[i] = {(*uv[0])[i], (*uv[1])[i]};
      return result;
    }

  Point low = file.points[0], size = {0., 0., 0.};
  for(std::size_t c = 0; c < 3; ++c)
  {
    double high = low[c];
    for(const Point& p : file.points)
    {
      low[c] = std::min(low[c], p[c]);
      high = std::max(high, p[c]);
    }
    size[c] = high / 2. - low[c] / 2.;
  }
  const auto shortest_axis =
      static_cast<std::size_t>(std::min_element(size.begin(), size.end()) - size.begin());
  const std::size_t axes[2] = {shortest_axis == 0 ? std::size_t{1} : 0,
                               shortest_axis == 2 ? std::size_t{1} : 2};
  for(std::size_t i = 0; i < result.size(); ++i)
    for(std::size_t k = 0; k < 2; ++k)
      if(const std::size_t c = axes[k]; size[c] > 0.)
        result[i][k] = (file.points[i][c] / 2. - low[c] / 2.) / size[c];
  return result;
}

} // namespace

void add_speed_options(Command& command, Speed_options& options)
{
  command.add("--speed", options.speed, "NAME",
              "speed of the fronts; samples are denser in regions of low speed. NAME is a "
              "property of the vertices, curvature-attractive (low at creases), "
              "curvature-repulsive (high at creases), curvature-like-V (high if the curvature "
              "is similar to the curvature at vertex V), or colors (low in regions of varying "
              "vertex colors)");
  command.add("--density-image", options.image, "FILE",
              "PNG image that defines a speed, which is low in regions of varying color. The "
              "image is applied through texture coordinates (vt in OBJ; s, t or u, v in PLY). "
              "Without them, it covers the bounding box and is projected along the shortest "
              "edge");
  command.add("--strength", options.strength, "X",
              "influence of curvature (default 0.14), colors or an image (default 20) on the "
              "speed");
}

void check(const Speed_options& options)
{
  if(!options.speed.empty() && !options.image.empty())
    throw Usage_error("--density-image: this option cannot be combined with --speed.");
  if(!options.strength)
    return;
  if(!(*options.strength >= 0. && std::isfinite(*options.strength)))
    throw Usage_error("--strength: the strength must be finite and not negative.");
  if(options.image.empty() && !is_computed_speed(options.speed))
    throw Usage_error(
        "--strength: this option requires a speed from curvature, colors or an image.");
}

void check(const Speed_options& options, const std::string& method)
{
  check(options);
  const auto methods = {"automatic", "exact", "euclidean", "fast-marching"};
  if(options.is_given() && std::find(methods.begin(), methods.end(), method) == methods.end())
    throw Usage_error("--speed, --density-image: only the methods automatic, exact, euclidean and "
                      "fast-marching support speeds.");
}

std::optional<std::size_t> similar_vertex(const Speed_options& options)
{
  if(options.speed.rfind(similar_prefix, 0) != 0)
    return std::nullopt;
  const auto vertices =
      parse_indices(options.speed.substr(similar_prefix.size()), "--speed " + similar_prefix);
  if(vertices.size() != 1)
    throw Usage_error("--speed " + printable(options.speed) + ": exactly one vertex is required.");
  return vertices.front();
}

std::vector<Color> vertex_colors(const Surface& surface, const Speed_options& options)
{
  const Surface_file& file = surface.file;
  std::vector<Color> result(file.points.size());
  if(options.image.empty())
  {
    const auto channels = find_properties(file, {color_names.begin(), color_names.end()});
    if(channels.empty())
      fail(surface.name, "the vertices have no red, green and blue properties");
    for(std::size_t i = 0; i < result.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        result[i][c] = (*channels[c])[i];
    return result;
  }
  const Image image = read_image(options.image);
  const auto texture_coordinates = image_coordinates(file);
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    if(!std::isfinite(texture_coordinates[i][0]) || !std::isfinite(texture_coordinates[i][1]))
      fail(surface.name, "a texture coordinate of vertex " + std::to_string(i) + " is not finite");
    result[i] = image.at(texture_coordinates[i][0], texture_coordinates[i][1]);
  }
  return result;
}

template <typename Domain>
std::vector<double> compute_speeds(const Domain& domain, const Speed_options& options,
                                   const Job& job)
{
  if(!options.is_given())
    return {};
  using Vertex = typename Domain::Vertex;
  std::vector<double> result(domain.number_of_vertices());
  const Value_map<Vertex> map{&result};
  const auto make = [&](const auto& np)
  {
    if(options.speed == "curvature-attractive")
      GP::curvature_speeds<GP::Edge_attractive, CGAL::Parallel_tag>(domain, map, np);
    else if(options.speed == "curvature-repulsive")
      GP::curvature_speeds<GP::Edge_repulsive, CGAL::Parallel_tag>(domain, map, np);
    else if(const auto vertex = similar_vertex(options))
    {
      check_vertex(job.surface(), *vertex);
      GP::similar_curvature_speeds<CGAL::Parallel_tag>(domain, Vertex(*vertex), map, np);
    }
    else if(is_color_speed(options.speed) || !options.image.empty())
    {
      const std::vector<Color> colors = vertex_colors(job.surface(), options);
      GP::image_speeds(domain, Property_map<Vertex, Color>{&colors}, map, np);
    }
    else
      result = property(job.surface(), options.speed);
  };
  const auto np = GP::parameters::number_of_threads(job.threads());
  if(options.strength)
    make(np.strength(*options.strength));
  else
    make(np);
  return result;
}

template std::vector<double> compute_speeds(const Mesh_domain&, const Speed_options&, const Job&);
template std::vector<double> compute_speeds(const Cloud_domain&, const Speed_options&, const Job&);

} // namespace program
