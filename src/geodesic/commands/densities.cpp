// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/densities.h"

#include "io/Image.h"
#include "io/Scanner.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

const std::string like = "curvature-like-";

bool is_word(const std::string& speed)
{
  return speed.rfind(like, 0) == 0 || speed == "curvature-attractive" ||
         speed == "curvature-repulsive" || speed == "colours";
}

// Columns of the file by their names; empty when one is missing.
std::vector<const std::vector<double>*> columns(const Surface_file& file,
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

// Where an image is seen: by texture coordinates where the file has them, else it is spread over the
// bounding box, seen along its shortest side.
std::vector<std::array<double, 2>> places_in_image(const Surface_file& file)
{
  if(!file.uv.empty())
    return file.uv;
  std::vector<std::array<double, 2>> result(file.points.size());
  using Names = std::vector<std::string>;
  for(const Names& names : {Names{"s", "t"}, Names{"u", "v"}, Names{"texture_u", "texture_v"}})
    if(const auto uv = columns(file, names); !uv.empty())
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
  const auto shortest =
      static_cast<std::size_t>(std::min_element(size.begin(), size.end()) - size.begin());
  const std::size_t axes[2] = {shortest == 0 ? std::size_t{1} : 0,
                               shortest == 2 ? std::size_t{1} : 2};
  for(std::size_t i = 0; i < result.size(); ++i)
    for(std::size_t k = 0; k < 2; ++k)
      if(const std::size_t c = axes[k]; size[c] > 0.)
        result[i][k] = (file.points[i][c] / 2. - low[c] / 2.) / size[c];
  return result;
}

} // namespace

void add_density_options(Command& command, Density_options& options)
{
  command.add("--speed", options.speed, "NAME",
              "of the fronts; samples are dense where it is low: a property of the vertices; "
              "curvature-attractive, low at creases; curvature-repulsive, high there; "
              "curvature-like-V, high where it is as at vertex V; or colours, "
              "low where the vertices' red, green and blue vary");
  command.add("--density-image", options.image, "FILE",
              "a picture, .png: the speed is low where it varies. It is seen through "
              "texture coordinates (vt in OBJ; s, t or u, v in PLY), without these it is spread "
              "over the bounding box, seen along its shortest side");
  command.add("--strength", options.strength, "X",
              "how much curvature (default 0.14) or an image (20) changes the speed");
}

void check(const Density_options& options)
{
  if(!options.speed.empty() && !options.image.empty())
    throw Usage_error("--density-image: --speed says already how fast fronts are.");
  if(!options.strength)
    return;
  if(!(*options.strength >= 0. && std::isfinite(*options.strength)))
    throw Usage_error("--strength: it is finite and not negative.");
  if(options.image.empty() && !is_word(options.speed))
    throw Usage_error("--strength: only curvature, colours and images have one.");
}

std::optional<std::size_t> similar_vertex(const Density_options& options)
{
  if(options.speed.rfind(like, 0) != 0)
    return std::nullopt;
  const auto vertices = parse_integers(options.speed.substr(like.size()), "--speed " + like);
  if(vertices.size() != 1)
    throw Usage_error("--speed " + shown(options.speed) + ": give one vertex.");
  return vertices.front();
}

std::vector<Colour> colours_on(const Surface& surface, const Density_options& options)
{
  const Surface_file& file = surface.file;
  std::vector<Colour> result(file.points.size());
  if(options.image.empty())
  {
    const auto channels = columns(file, {colour_names.begin(), colour_names.end()});
    if(channels.empty())
      fail(surface.name, "its vertices have no red, green and blue");
    for(std::size_t i = 0; i < result.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        result[i][c] = (*channels[c])[i];
    return result;
  }
  const Image image = read_image(options.image);
  const auto places = places_in_image(file);
  for(std::size_t i = 0; i < result.size(); ++i)
  {
    if(!std::isfinite(places[i][0]) || !std::isfinite(places[i][1]))
      fail(surface.name, "a texture coordinate of vertex " + std::to_string(i) + " is not finite");
    result[i] = image.at(places[i][0], places[i][1]);
  }
  return result;
}

} // namespace program
