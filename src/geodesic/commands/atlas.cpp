// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Image.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "picture/procedural_images.h"
#include "commands/command_utilities.h"
#include "io/write_textured.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

using UV = std::array<double, 2>;

struct Atlas_options
{
  std::size_t number_of_charts = 0, texels = 1024, gutter = 4, iterations = 5;
  std::string image;
  bool draws_plane = false;
};

struct Atlas_result
{
  Surface_file file;             // the input mesh, or the mesh that is reconstructed from a cloud
  std::vector<UV> corner_uv;     // #corners
  std::vector<long long> charts; // #faces
  Image texture;
};

// Computes the color of a point on the surface from a face and barycentric coordinates.
class Surface_painter
{
public:
  // If image.width is 0, no image is projected.
  Surface_painter(const Atlas_result& result, const Image& image)
      : m_file(result.file), m_result(result), m_image(image)
  {
    const Surface_file& file = result.file;
    if(std::all_of(color_names.begin(), color_names.end(),
                   [&](auto name) { return file.properties.count(name) > 0; }))
      for(const char* const name : color_names)
        m_colors.push_back(&file.properties.at(name));
    m_low.fill(std::numeric_limits<double>::infinity());
    m_high.fill(-std::numeric_limits<double>::infinity());
    for(const Point& p : file.points)
      for(std::size_t k = 0; k < 3; ++k)
      {
        m_low[k] = std::min(m_low[k], p[k]);
        m_high[k] = std::max(m_high[k], p[k]);
      }
  }

  GP::Decal_color operator()(std::size_t face, const std::array<double, 3>& barycentric) const
  {
    Color color;
    if(m_image.width > 0)
      color = projected_image_color(face, barycentric);
    else if(m_colors.empty())
      color = checkerboard_color(face, barycentric);
    else
      for(std::size_t c = 0; c < 3; ++c)
        color[c] = interpolate(face, barycentric,
                               [&](std::size_t corner)
                               { return (*m_colors[c])[m_file.corners[corner]] / 255.; });
    return {color[0], color[1], color[2], 1.};
  }

private:
  template <typename Value>
  static double interpolate(std::size_t face, const std::array<double, 3>& barycentric,
                            const Value& value)
  {
    double result = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result += barycentric[k] * value(3 * face + k);
    return result;
  }

  // Samples the image, which is projected along the z axis and spans the bounding box in x and y.
  Color projected_image_color(std::size_t face, const std::array<double, 3>& barycentric) const
  {
    UV uv;
    for(std::size_t k = 0; k < 2; ++k)
    {
      const double p = interpolate(face, barycentric,
                                   [&](std::size_t corner)
                                   { return m_file.points[m_file.corners[corner]][k] - m_low[k]; });
      const double size = m_high[k] - m_low[k];
      uv[k] = size > 0. ? std::clamp(p / size, 0., 1.) : 0.5;
    }
    return m_image.at(uv[0], uv[1]);
  }

  // Returns a checkerboard in UV space, tinted with the color of the chart.
  Color checkerboard_color(std::size_t face, const std::array<double, 3>& barycentric) const
  {
    UV uv;
    for(std::size_t k = 0; k < 2; ++k)
      uv[k] = 3. * interpolate(face, barycentric,
                               [&](std::size_t corner) { return m_result.corner_uv[corner][k]; });
    Color color = color_of_label(m_result.charts[face]);
    if(checkerboard_cell(uv) == 0)
      for(double& channel : color)
        channel = 0.25 * channel + 0.75;
    return color;
  }

  const Surface_file& m_file;
  const Atlas_result& m_result;
  const Image& m_image;
  std::vector<const std::vector<double>*> m_colors;
  Point m_low, m_high;
};

// Returns a mesh whose vertices are surfels, with the normals and properties of these surfels.
Surface_file
reconstructed_file(const Mesh& mesh,
                   const Mesh::Property_map<Mesh::Vertex_index, GP::Location<Cloud>>& locations,
                   const Surface_file& cloud)
{
  Surface_file result = to_file(mesh);
  for(const auto v : mesh.vertices())
  {
    const std::size_t surfel = locations[v].surfel;
    result.normals.push_back(cloud.normals[surfel]);
    for(const auto& [name, values] : cloud.properties)
      result.properties[name].push_back(values[surfel]);
  }
  return result;
}

// Computes the charts, the UV coordinates and the texture. A cloud is reconstructed first.
Atlas_result make_atlas(const Surface& surface, const Atlas_options& options, const Image& image,
                        Job& job)
{
  Mesh mesh = surface.is_mesh() ? surface.domain->mesh() : Mesh();
  const auto corner_uv = mesh.add_property_map<Mesh::Halfedge_index, UV>("h:uv").first;
  const auto charts = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:chart").first;
  const auto np = GP::parameters::texture_size(options.texels)
                      .gutter_width(options.gutter)
                      .maximum_number_of_iterations(unsigned(options.iterations))
                      .chart_map(charts)
                      .random_seed(job.seed())
                      .number_of_threads(job.threads())
                      .callback(job.progress_callback("charts"));
  Atlas_result result;
  GP::Texture_atlas atlas;
  if(surface.is_mesh())
  {
    job.begin_stage("query");
    atlas = GP::texture_atlas<GP::Euclidean_front, CGAL::Parallel_tag>(
        mesh, options.number_of_charts, corner_uv, np);
    result.file = surface.file;
  }
  else
  {
    const auto locations =
        mesh.add_property_map<Mesh::Vertex_index, GP::Location<Cloud>>("v:location").first;
    const Cloud cloud = make_cloud(surface);
    const Cloud_domain domain = make_domain(cloud, job);
    job.begin_stage("query");
    atlas = GP::texture_atlas<GP::Euclidean_front, CGAL::Parallel_tag>(
        domain, options.number_of_charts, mesh, corner_uv, np.location_map(locations));
    result.file = reconstructed_file(mesh, locations, surface.file);
  }
  const Surface_file& file = result.file;
  result.charts.assign(charts.begin(), charts.end());
  const GP::Flattening_distortion distortion = GP::flattening_distortion(mesh, corner_uv);
  job.report("charts", atlas.number_of_charts);
  job.report("flips", atlas.number_of_flips);
  job.report("overlaps", atlas.number_of_overlaps);
  job.report("coverage", atlas.coverage);
  job.report("texels_per_length", atlas.texels_per_length);
  job.report("conformal", distortion.conformal);
  job.report("authalic", distortion.authalic);
  job.report("symmetric_dirichlet", distortion.symmetric_dirichlet);

  result.corner_uv.resize(file.corners.size());
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h))
    {
      const std::size_t face(mesh.face(h));
      for(std::size_t corner = 3 * face; corner < 3 * face + 3; ++corner)
        if(file.corners[corner] == std::size_t(mesh.target(h)))
          result.corner_uv[corner] = corner_uv[h];
    }

  const Surface_painter paint(result, image);
  const auto texels = GP::bake_atlas(
      mesh, corner_uv,
      [&](const auto& location)
      {
        // The location's barycentric coordinates begin at the source of the face's halfedge.
        const auto h = mesh.halfedge(location.first);
        const std::size_t face(location.first);
        std::array<double, 3> barycentric = {0., 0., 0.};
        std::size_t k = 0;
        for(const auto vertex : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
        {
          for(std::size_t corner = 0; corner < 3; ++corner)
            if(file.corners[3 * face + corner] == std::size_t(vertex))
              barycentric[corner] = location.second[k];
          ++k;
        }
        return paint(face, barycentric);
      },
      options.texels,
      GP::parameters::gutter_width(options.gutter)
          .background(GP::Decal_color{default_color[0], default_color[1], default_color[2], 1.}));
  result.texture.width = result.texture.height = options.texels;
  for(const GP::Decal_color& texel : texels)
    result.texture.pixels.push_back({texel[0], texel[1], texel[2]});
  return result;
}

// Returns the triangles at their UV coordinates, in the plane z = 0.
Surface_file to_texture_plane(const Surface_file& file, const std::vector<UV>& corner_uv)
{
  Surface_file result;
  result.polygon_begin = file.polygon_begin;
  for(const auto& [u, v] : corner_uv)
  {
    result.corners.push_back(static_cast<std::uint32_t>(result.points.size()));
    result.points.push_back({u, v, 0.});
  }
  return result;
}

void check(const Job& job, const Atlas_options& options)
{
  if(options.number_of_charts == 0)
    throw Usage_error("atlas: --number is required and must be at least 1.");
  if(options.texels < 16 || options.texels > 16384)
    throw Usage_error("--texels " + std::to_string(options.texels) +
                      ": the value must be between 16 and 16384.");
  if(options.gutter > options.texels / 4)
    throw Usage_error("--gutter " + std::to_string(options.gutter) +
                      ": the value must be at most a quarter of --texels.");
  if(!job.output().empty())
    check_png_support(job.output());
}

void run_atlas(Job& job, const Atlas_options& options)
{
  check(job, options);
  const Surface& surface = job.read({"obj", "gltf", "glb"});
  const Image image = options.image.empty() ? Image() : read_image(options.image);
  job.begin_stage("prepare");
  const Atlas_result result = make_atlas(surface, options, image, job);

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(std::size_t corner = 0; corner < result.corner_uv.size(); ++corner)
          text += number_text(result.corner_uv[corner][0]) + ' ' +
                  number_text(result.corner_uv[corner][1]) + (corner % 3 == 2 ? '\n' : ' ');
        return text;
      });
  Surface_file file =
      options.draws_plane ? to_texture_plane(result.file, result.corner_uv) : result.file;
  file.corner_uv = result.corner_uv;
  if(!job.picture().empty())
  {
    Picture picture{&file};
    picture.texture = &result.texture;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_textured(job.output(), file, result.texture);
  job.finish();
}

} // namespace

void add_atlas(CLI::App& program)
{
  Command command(program, "atlas",
                  "compute a texture atlas: cut the mesh into charts, flatten and pack them; a "
                  "cloud is first reconstructed as a mesh");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output",
                   "write the mesh, or the mesh that is reconstructed from a cloud, with UV "
                   "coordinates and its texture: .obj .gltf .glb");
  command.describe(
      "--values",
      "write the UV coordinates of three corners, one line per face of the output mesh");
  const auto options = std::make_shared<Atlas_options>();
  command.add("--number", options->number_of_charts, "N",
              "initial number of charts; more are added if necessary");
  command.add("--image", options->image, "FILE",
              "PNG image that is projected onto the surface along the z axis (default: vertex "
              "colors, or a checkerboard if there are no colors)");
  command.add("--texels", options->texels, "N", "width and height of the texture in texels")
      .shows_default();
  command.add("--gutter", options->gutter, "N", "minimum number of texels between charts")
      .shows_default();
  command
      .add("--iterations", options->iterations, "N",
           "maximum number of iterations that move the chart centers")
      .shows_default();
  command.add_flag("--flat", options->draws_plane,
                   "write and draw the flattened charts instead of the surface");
  command.set_callback([job, options] { run_atlas(*job, *options); });
}

} // namespace program
