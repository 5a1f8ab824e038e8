// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Image.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "picture/procedural_images.h"
#include "commands/command_utilities.h"
#include "io/write_textured.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace program {

namespace {

struct Decal_options
{
  std::vector<std::string> base_vertices, base_points; // use one of them: "V,V,..." or "x,y,z" each
  // One value for all decals, one for each, or none.
  std::vector<std::string> images, up_vectors;
  std::vector<double> widths, heights;
  std::string method = "gradient";
  std::size_t texels = 0; // 0: derived from the images' resolution
};

// A decal's location, orientation, image and size.
struct Decal_placement
{
  std::size_t vertex = 0;
  std::string point; // "x,y,z"; if empty, `vertex` is used
  std::string up;
  Image image;
  double width = 0., height = 0.;
};

struct Decal_result
{
  std::vector<Color> colors;     // #vertices
  std::size_t faces = 0;         // number of covered faces
  std::set<std::size_t> covered; // covered vertices
  std::vector<Point> centers, normals;
  Image texture; // of a mesh
  std::vector<std::array<double, 2>> corner_uv;
};

// Returns the number of texel intervals along each face edge. The texture gets twice as many
// texels as an image has pixels, so that interpolation does not blur it. The total is limited to
// about 2^24 texels.
std::size_t choose_number_of_segments(const std::vector<GP::Decal_layer<Mesh>>& layers,
                                      const std::vector<Decal_placement>& placements)
{
  double max_segments = 2., faces = 1.;
  for(std::size_t i = 0; i < layers.size(); ++i)
  {
    const double pixels = double(placements[i].image.width) * double(placements[i].image.height),
                 covered = double(std::max<std::size_t>(layers[i].decal.faces.size(), 1));
    // A face uses half of the texels of a square.
    max_segments = std::max(max_segments, std::sqrt(2. * 2. * pixels / covered));
    faces += covered;
  }
  const double limit = std::sqrt(2. * double(1 << 24) / faces) - 5.;
  return static_cast<std::size_t>(std::clamp(std::ceil(max_segments), 1., std::max(1., limit)));
}

void bake(const std::vector<GP::Decal_layer<Mesh>>& layers, std::size_t number_of_segments,
          std::size_t number_of_corners, Decal_result& result)
{
  const auto texture =
      GP::bake_decals(layers, number_of_segments,
                      GP::parameters::background(GP::Decal_color{default_color[0], default_color[1],
                                                                 default_color[2], 1.}));
  result.texture.width = texture.width;
  result.texture.height = texture.height;
  for(const GP::Decal_color& texel : texture.texels)
    result.texture.pixels.push_back({texel[0], texel[1], texel[2]});
  result.corner_uv.assign(number_of_corners, texture.background);
  for(const auto& [face, coordinates] : texture.faces)
    std::copy(coordinates.begin(), coordinates.end(),
              result.corner_uv.begin() + 3 * static_cast<std::ptrdiff_t>(std::size_t(face)));
  result.faces = texture.faces.size();
}

template <typename Domain>
Decal_result place_decals(const Domain& domain, const std::vector<Decal_placement>& placements,
                          const Decal_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  using Placer = GP::Decal_placer<Surface_type, Runtime_method>;
  Log_kind kind;
  if(options.method == "exact")
    kind.method = Log_method::exact;
  Placer placer(domain, kind);
  job.begin_stage("query");
  Decal_result result;
  result.colors.assign(job.surface().file.points.size(), default_color);
  std::vector<GP::Decal_layer<Surface_type>> layers;
  for(const Decal_placement& placement : placements)
  {
    const auto place_at = [&](const auto& center)
    {
      if(placement.up.empty())
        return placer.place(center, placement.width, placement.height);
      const Point up = parse_point(placement.up, "--up");
      return placer.place(center, placement.width, placement.height,
                          GP::parameters::up_direction(Kernel::Vector_3(up[0], up[1], up[2])));
    };
    const GP::Decal_image image = [&placement](const GP::Decal_coordinates& p)
    { return placement.image.rgba_at(p[0], p[1]); };
    layers.push_back({placement.point.empty()
                          ? place_at(vertex_at<Surface_type>(placement.vertex))
                          : place_at(locate(domain, placement.point, "--base-at")),
                      image});
    const auto& decal = layers.back().decal;
    using Vertex = typename Domain::Vertex;
    GP::composite_decal(decal, image, Value_map<Vertex, Color>{&result.colors});
    result.centers.push_back(coordinates(decal.frame.origin));
    result.normals.push_back(coordinates(decal.frame.normal()));
    for(const auto& covered : decal.vertices)
      result.covered.insert(static_cast<std::size_t>(covered.vertex));
  }
  if constexpr(is_mesh<Surface_type>)
    bake(layers,
         options.texels > 0 ? options.texels : choose_number_of_segments(layers, placements),
         job.surface().file.corners.size(), result);
  return result;
}

// Computes the decals and the resulting vertex colors and texture.
template <typename Domain>
Decal_result find_decals(const Domain& domain, const std::vector<Decal_placement>& placements,
                         const Decal_options& options, Job& job)
{
  return place_decals(domain, placements, options, job);
}

std::vector<std::size_t> parse_base_vertices(const Decal_options& options)
{
  std::vector<std::size_t> result;
  for(const std::string& list : options.base_vertices)
    for(const std::size_t vertex : parse_indices(list, "--base"))
      result.push_back(vertex);
  return result;
}

void check(const Decal_options& options)
{
  if(options.base_vertices.empty() == options.base_points.empty())
    throw Usage_error("decal: either --base or --base-at is required, but not both.");
  const std::size_t number_of_places =
      parse_base_vertices(options).size() + options.base_points.size();
  const auto check_count = [&](const char* name, std::size_t number)
  {
    if(number > 1 && number != number_of_places)
      throw Usage_error(std::string(name) +
                        ": give one value for all decals, or one for each of the " +
                        std::to_string(number_of_places) + " decals.");
  };
  check_count("--image", options.images.size());
  check_count("--up", options.up_vectors.size());
  check_count("--width", options.widths.size());
  check_count("--height", options.heights.size());
  for(const std::string& point : options.base_points)
    parse_point(point, "--base-at");
  for(const std::string& point : options.up_vectors)
    parse_point(point, "--up");
  for(const auto& sizes : {options.widths, options.heights})
    for(const double size : sizes)
      if(!(size > 0. && std::isfinite(size)))
        throw Usage_error("--width, --height: the size must be positive and finite.");
  if(options.method != "gradient" && options.method != "exact")
    throw Usage_error("--method " + printable(options.method) +
                      ": the methods are gradient and exact.");
}

// Returns the only value (for all decals), the value of one decal, or the default if the list is
// empty.
template <typename T>
T value_at(const std::vector<T>& list, std::size_t place, const T& default_value)
{
  return list.empty() ? default_value : list[std::min(place, list.size() - 1)];
}

// Returns a quarter of the longest side of the bounding box.
double default_width(const std::vector<Point>& points)
{
  double result = 0.;
  for(std::size_t c = 0; c < 3; ++c)
  {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(), [c](const Point& p, const Point& q) { return p[c] < q[c]; });
    result = std::max(result, (*high)[c] / 4. - (*low)[c] / 4.);
  }
  return result;
}

std::vector<Decal_placement> make_placements(const Surface& surface, const Decal_options& options)
{
  const std::vector<std::size_t> base_vertices = parse_base_vertices(options);
  std::vector<Decal_placement> placements(
      std::max(base_vertices.size(), options.base_points.size()));
  for(std::size_t i = 0; i < placements.size(); ++i)
  {
    Decal_placement& placement = placements[i];
    if(base_vertices.empty())
      placement.point = options.base_points[i];
    else
      check_vertex(surface, placement.vertex = base_vertices[i]);
    placement.up = value_at(options.up_vectors, i, std::string());
    placement.image = options.images.empty()
                          ? compass_rose()
                          : read_image(value_at(options.images, i, std::string()));
    const double aspect = double(placement.image.height) / double(placement.image.width),
                 height = value_at(options.heights, i, 0.);
    placement.width = value_at(options.widths, i,
                               height > 0. ? height / aspect : default_width(surface.file.points));
    placement.height = height > 0. ? height : aspect * placement.width;
  }
  return placements;
}

// Converts a color channel from [0, 1] to a byte value, as files store it.
double to_byte(double channel) { return std::round(255. * std::clamp(channel, 0., 1.)); }

void write_output(const std::string& filename, const Surface& surface, const Decal_result& result)
{
  Surface_file file = surface.file;
  if(file_extension(filename) == "obj")
  {
    file.corner_uv = result.corner_uv;
    write_textured(filename, file, result.texture);
    return;
  }
  for(std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double>& values = file.properties[color_names[c]];
    values.clear();
    for(const Color& color : result.colors)
      values.push_back(to_byte(color[c]));
  }
  write_surface_file(filename, file);
}

void run_decal(Job& job, const Decal_options& options)
{
  check(options);
  const Surface& surface = job.read({"ply", "obj", "vtp"});
  if(options.method == "exact")
    check_method(options.method, surface);
  if(file_extension(job.output()) == "obj")
  {
    if(!surface.is_mesh())
      fail(surface.name,
           "a cloud has no faces for a texture; its colors can be written to .ply or .vtp");
    check_png_support(job.output());
  }
  const std::vector<Decal_placement> placements = make_placements(surface, options);

  job.begin_stage("prepare");
  Decal_result result;
  visit_domain(job,
               [&](const auto& domain) { result = find_decals(domain, placements, options, job); });
  job.result()["faces"] = result.faces;
  job.result()["covered"] = result.covered.size();
  if(surface.is_mesh())
    job.print_line("faces           " + std::to_string(result.faces));
  job.print_line("covered         " + std::to_string(result.covered.size()) + " vertices");

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const Color& color : result.colors)
          text += number_text(to_byte(color[0])) + ' ' + number_text(to_byte(color[1])) + ' ' +
                  number_text(to_byte(color[2])) + '\n';
        return text;
      });
  if(!job.picture().empty())
  {
    Surface_file file = surface.file;
    file.corner_uv = result.corner_uv;
    Picture picture{&file};
    picture.colors = result.colors;
    if(surface.is_mesh())
      picture.texture = &result.texture;
    picture.visible_points = result.centers;
    picture.normals = result.normals;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_output(job.output(), surface, result);
  job.finish();
}

} // namespace

void add_decal(CLI::App& program)
{
  Command command(program, "decal", "place images (decals) on the surface by logarithmic maps");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write vertex colors: .ply .vtp; or a texture: .obj");
  const auto options = std::make_shared<Decal_options>();
  command.add("--base", options->base_vertices, "V[,V...]",
              "indices of the vertices at the centers of the decals");
  command.add("--base-at", options->base_points, "x,y,z",
              "center of a decal: the location closest to a point; can be repeated");
  command.add("--image", options->images, "FILE",
              "PNG image, which can be transparent (default: a compass rose); can be repeated");
  command.add("--width", options->widths, "W",
              "width in the unit of the coordinates (default: from --height, or a quarter of "
              "the longest edge of the bounding box); can be repeated");
  command.add("--height", options->heights, "H",
              "height (default: from the width and the aspect ratio of the image); can be "
              "repeated");
  command.add("--up", options->up_vectors, "x,y,z",
              "direction that points up in the image; can be repeated");
  command
      .add("--method", options->method, "NAME",
           "logarithmic map: gradient (of squared distances) or exact (directions of "
           "shortest paths)")
      .shows_default();
  command.add("--texels", options->texels, "N",
              "number of texels along each edge of a face in the texture (default 0: from the "
              "resolution of the images)");
  command.set_callback([job, options] { run_decal(*job, *options); });
}

} // namespace program
