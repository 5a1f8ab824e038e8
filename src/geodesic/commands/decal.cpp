// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Image.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "picture/drawings.h"
#include "commands/queries.h"
#include "io/textured.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace program {

namespace {

struct Decal_options
{
  std::vector<std::string> bases, bases_at; // one of them: "V,V,...", and "x,y,z"
  // One for all places, one for each, or none.
  std::vector<std::string> images, ups;
  std::vector<double> widths, heights;
  std::string method = "gradient";
  std::size_t texels = 0; // 0: as many as the images have
};

// What a decal is made of.
struct Stamp
{
  std::size_t vertex = 0;
  std::string at; // a point; empty: the vertex
  std::string up;
  Image image;
  double width = 0., height = 0.;
};

struct Result
{
  std::vector<Colour> colours;   // #vertices
  std::size_t faces = 0;         // that are covered
  std::set<std::size_t> covered; // vertices
  std::vector<Point> middles, normals;
  Image texture; // of a mesh
  std::vector<std::array<double, 2>> corner_uv;
};

// So many steps from texel to texel along the sides of faces that they are twice as many as the pixels of an
// image, which interpolation then does not blur, but no more than 2^24 altogether.
std::size_t segments(const std::vector<GP::Decal_layer<Mesh>>& layers,
                     const std::vector<Stamp>& stamps)
{
  double most = 2., faces = 1.;
  for(std::size_t i = 0; i < layers.size(); ++i)
  {
    const double pixels = double(stamps[i].image.width) * double(stamps[i].image.height),
                 covered = double(std::max<std::size_t>(layers[i].decal.faces.size(), 1));
    // A face has half of the texels of a square.
    most = std::max(most, std::sqrt(2. * 2. * pixels / covered));
    faces += covered;
  }
  const double limit = std::sqrt(2. * double(1 << 24) / faces) - 5.;
  return static_cast<std::size_t>(std::clamp(std::ceil(most), 1., std::max(1., limit)));
}

void bake(const std::vector<GP::Decal_layer<Mesh>>& layers, std::size_t number_of_segments,
          std::size_t number_of_corners, Result& result)
{
  const auto texture =
      GP::bake_decals(layers, number_of_segments, {plain[0], plain[1], plain[2], 1.});
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

template <typename Surface_type, typename Method>
Result paint(const GP::internal::Domain_of<Surface_type>& domain, const std::vector<Stamp>& stamps,
             const Decal_options& options, Job& job)
{
  GP::Decal_placer<Surface_type, Method> placer(domain);
  job.stage("query");
  Result result;
  result.colours.assign(job.surface().file.points.size(), plain);
  std::vector<GP::Decal_layer<Surface_type>> layers;
  for(const Stamp& stamp : stamps)
  {
    const auto place = [&](const auto& middle)
    {
      if(stamp.up.empty())
        return placer.place(middle, stamp.width, stamp.height);
      const Point up = parse_point(stamp.up, "--up");
      return placer.place(middle, stamp.width, stamp.height,
                          GP::parameters::up_direction(Kernel::Vector_3(up[0], up[1], up[2])));
    };
    const GP::Decal_image image = [&stamp](const GP::Decal_coordinates& p)
    { return stamp.image.with_opacity_at(p[0], p[1]); };
    layers.push_back({stamp.at.empty() ? place(site<Surface_type>(stamp.vertex))
                                       : place(locate(domain, stamp.at, "--base-at")),
                      image});
    const auto& decal = layers.back().decal;
    using Site = typename GP::Decal_placer<Surface_type, Method>::Domain::Site;
    GP::composite_decal(decal, image, Value_map<Site, Colour>{&result.colours});
    result.middles.push_back(coordinates(decal.frame.origin));
    result.normals.push_back(coordinates(decal.frame.normal()));
    for(const auto& covered : decal.sites)
      result.covered.insert(static_cast<std::size_t>(covered.site));
  }
  if constexpr(is_mesh<Surface_type>)
    bake(layers, options.texels > 0 ? options.texels : segments(layers, stamps),
         job.surface().file.corners.size(), result);
  return result;
}

// The library's part.
template <typename Surface_type>
Result find_decals(const Surface_type& surface, const std::vector<Stamp>& stamps,
                   const Decal_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  if constexpr(is_mesh<Surface_type>)
    if(options.method == "exact")
      return paint<Surface_type, GP::Exact>(domain, stamps, options, job);
  return paint<Surface_type, GP::Gradient<>>(domain, stamps, options, job);
}

std::vector<std::size_t> vertices(const Decal_options& options)
{
  std::vector<std::size_t> result;
  for(const std::string& list : options.bases)
    for(const std::size_t vertex : parse_integers(list, "--base"))
      result.push_back(vertex);
  return result;
}

void check(const Decal_options& options)
{
  if(options.bases.empty() == options.bases_at.empty())
    throw Usage_error("decal: give either --base or --base-at, once or several times.");
  const std::size_t places = vertices(options).size() + options.bases_at.size();
  const auto check_number = [&](const char* name, std::size_t number)
  {
    if(number > 1 && number != places)
      throw Usage_error(std::string(name) + ": give one for all places, or one for each of the " +
                        std::to_string(places) + ".");
  };
  check_number("--image", options.images.size());
  check_number("--up", options.ups.size());
  check_number("--width", options.widths.size());
  check_number("--height", options.heights.size());
  for(const std::string& point : options.bases_at)
    parse_point(point, "--base-at");
  for(const std::string& point : options.ups)
    parse_point(point, "--up");
  for(const auto& sizes : {options.widths, options.heights})
    for(const double size : sizes)
      if(!(size > 0. && std::isfinite(size)))
        throw Usage_error("--width, --height: a size is positive and finite.");
  if(options.method != "gradient" && options.method != "exact")
    throw Usage_error("--method " + shown(options.method) +
                      ": the methods are gradient and exact.");
}

// The one for all, or that of a place.
template <typename T>
T of_place(const std::vector<T>& list, std::size_t place, const T& otherwise)
{
  return list.empty() ? otherwise : list[std::min(place, list.size() - 1)];
}

// A quarter of the longest side of the bounding box.
double usual_width(const std::vector<Point>& points)
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

std::vector<Stamp> make_stamps(const Surface& surface, const Decal_options& options)
{
  const std::vector<std::size_t> bases = vertices(options);
  std::vector<Stamp> stamps(std::max(bases.size(), options.bases_at.size()));
  for(std::size_t i = 0; i < stamps.size(); ++i)
  {
    Stamp& stamp = stamps[i];
    if(bases.empty())
      stamp.at = options.bases_at[i];
    else
      check_vertex(surface, stamp.vertex = bases[i]);
    stamp.up = of_place(options.ups, i, std::string());
    stamp.image = options.images.empty() ? compass_rose()
                                         : read_image(of_place(options.images, i, std::string()));
    const double aspect = double(stamp.image.height) / double(stamp.image.width),
                 height = of_place(options.heights, i, 0.);
    stamp.width = of_place(options.widths, i,
                           height > 0. ? height / aspect : usual_width(surface.file.points));
    stamp.height = height > 0. ? height : aspect * stamp.width;
  }
  return stamps;
}

// In bytes, as files have colours.
double byte(double part) { return std::round(255. * std::clamp(part, 0., 1.)); }

void write_output(const std::string& filename, const Surface& surface, const Result& result)
{
  Surface_file file = surface.file;
  if(ending(filename) == "obj")
  {
    file.corner_uv = result.corner_uv;
    write_textured(filename, file, result.texture);
    return;
  }
  for(std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double>& values = file.properties[colour_names[c]];
    values.clear();
    for(const Colour& colour : result.colours)
      values.push_back(byte(colour[c]));
  }
  write_surface_file(filename, file);
}

void run_decal(Job& job, const Decal_options& options)
{
  check(options);
  const Surface& surface = job.read({"ply", "obj", "vtp"});
  if(options.method == "exact")
    check_method(options.method, surface);
  if(ending(job.output()) == "obj")
  {
    if(!surface.is_mesh())
      fail(surface.name, "a cloud has no faces to carry a texture, its colours go to .ply or .vtp");
    check_images(job.output());
  }
  const std::vector<Stamp> stamps = make_stamps(surface, options);

  job.stage("prepare");
  Result result;
  on_surface(surface, [&](const auto& mesh_or_cloud)
             { result = find_decals(mesh_or_cloud, stamps, options, job); });
  job.result()["faces"] = result.faces;
  job.result()["covered"] = result.covered.size();
  if(surface.is_mesh())
    job.say("faces           " + std::to_string(result.faces));
  job.say("covered         " + std::to_string(result.covered.size()) + " vertices");

  job.stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const Colour& colour : result.colours)
          text += number_text(byte(colour[0])) + ' ' + number_text(byte(colour[1])) + ' ' +
                  number_text(byte(colour[2])) + '\n';
        return text;
      });
  if(!job.picture().empty())
  {
    Surface_file file = surface.file;
    file.corner_uv = result.corner_uv;
    Picture picture{&file};
    picture.colours = result.colours;
    if(surface.is_mesh())
      picture.texture = &result.texture;
    picture.places = result.middles;
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
  Command command(program, "decal", "images on a surface, without distortion in their middles");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Decal_options>();
  command.add("--base", options->bases, "V[,V...]",
              "the middles: vertices by their places in the file");
  command.add("--base-at", options->bases_at, "x,y,z", "a middle: the place nearest to a point");
  command.add("--image", options->images, "FILE",
              "a picture, .png, transparent or not; else a compass rose");
  command.add(
      "--width", options->widths, "W",
      "in the unit of the surface; else as --height asks, or a quarter of the longest side of "
      "the bounding box");
  command.add("--height", options->heights, "H", "else as the picture is high");
  command.add("--up", options->ups, "x,y,z", "where the upper side of the picture is");
  command
      .add("--method", options->method, "NAME",
           "gradient, of squared distances; or exact, by directions of shortest paths")
      .shows_default();
  command.add("--texels", options->texels, "N",
              "along the sides of faces in the texture; 0: as many as the pictures have");
  command.set_run([job, options] { run_decal(*job, *options); });
}

} // namespace program
