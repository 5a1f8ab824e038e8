// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_SURFEL_PATHS_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_SURFEL_PATHS_H

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include "clouds.h"
#include "models.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Surfaces with known geodesics, clouds of their surfels, and the errors of paths on these clouds.

namespace benchmarks {

using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::test::Cloud;

using Curve = std::vector<Vec3>;
struct Geodesic
{
  Curve curve;
  double length;
};

// Returns the geodesics between the surfels a and b of the clean cloud, shortest first. `path` is a
// path between them, which selects one of several geodesics if there is no closed form.
using Geodesics = std::function<std::vector<Geodesic>(Index a, Index b, const Curve& path)>;

struct Surface
{
  std::string name;
  Cloud clean;
  Geodesics geodesics;
};

// If another geodesic is at most 2 % longer than the shortest one, a path may follow it.
constexpr double other_geodesic_tolerance = 0.02;

// Returns the root mean squared distance of the vertices of `points` to the polyline.
inline double rms_distance(const Curve& points, const Curve& polyline)
{
  double sum = 0.;
  for(const Vec3& p : points)
  {
    double min_squared_distance = infinity;
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      const Vec3 segment = polyline[i + 1] - polyline[i], offset = p - polyline[i];
      const double square = dot(segment, segment);
      const double t = square > 0. ? std::clamp(dot(offset, segment) / square, 0., 1.) : 0.;
      const Vec3 rest = offset - t * segment;
      min_squared_distance = std::min(min_squared_distance, dot(rest, rest));
    }
    sum += min_squared_distance;
  }
  return std::sqrt(sum / double(points.size()));
}

// The symmetric distance of Eq. 5 of the paper, not divided by the length.
inline double path_distance(const Curve& path, const Curve& geodesic)
{
  return std::max(rms_distance(path, geodesic), rms_distance(geodesic, path));
}

constexpr int curve_resolution = 2000; // segments of a reference curve

inline Geodesics straight_segments(const Cloud& cloud)
{
  return [points = cloud.points](Index a, Index b, const Curve&) -> std::vector<Geodesic>
  {
    const Vec3 &p = points[a], &q = points[b];
    Curve curve;
    for(int i = 0; i <= curve_resolution; ++i)
      curve.push_back(p + double(i) / curve_resolution * (q - p));
    return {{curve, norm(q - p)}};
  };
}

inline Geodesics great_circles(const Cloud& cloud)
{
  return [points = cloud.points](Index a, Index b, const Curve&) -> std::vector<Geodesic>
  {
    const Vec3 &p = points[a], &q = points[b];
    const double angle = 2. * std::asin(std::min(1., norm(q - p) / 2.));
    const Vec3 across = unit(q - dot(p, q) * p);
    Curve curve;
    for(int i = 0; i <= curve_resolution; ++i)
      curve.push_back(std::cos(angle * i / curve_resolution) * p +
                      std::sin(angle * i / curve_resolution) * across);
    return {{curve, angle}};
  };
}

// There are two helices between two points, one in each direction.
inline Geodesics helices(const Cloud& cloud, double radius)
{
  return [points = cloud.points, radius](Index a, Index b, const Curve&)
  {
    const Vec3 &p = points[a], &q = points[b];
    const double begin = std::atan2(p[1], p[0]);
    const double turn = std::remainder(std::atan2(q[1], q[0]) - begin, 2. * pi);
    std::vector<Geodesic> result;
    for(const double angle : {turn, turn - std::copysign(2. * pi, turn)})
    {
      Curve curve;
      for(int i = 0; i <= curve_resolution; ++i)
      {
        const double t = double(i) / curve_resolution, azimuth = begin + t * angle;
        curve.push_back(
            {radius * std::cos(azimuth), radius * std::sin(azimuth), p[2] + t * (q[2] - p[2])});
      }
      result.push_back({curve, std::hypot(radius * angle, q[2] - p[2])});
    }
    return result;
  };
}

// Geodesics without a closed form. `find(a, b)` computes a shortest one. If a path is farther from
// it than the tolerance, shorten(path) is another one.
template <typename Find, typename Shorten>
Geodesics computed_geodesics(Find find, Shorten shorten)
{
  const auto shortest = std::make_shared<std::map<std::pair<Index, Index>, Geodesic>>();
  return [=](Index a, Index b, const Curve& path)
  {
    if(shortest->count({a, b}) == 0)
      shortest->emplace(std::pair(a, b), find(a, b));
    std::vector<Geodesic> result = {shortest->at({a, b})};
    if(path_distance(path, result[0].curve) > other_geodesic_tolerance * result[0].length)
      result.push_back(shorten(a, b, path));
    if(result.back().length < result.front().length)
      std::swap(result.front(), result.back());
    return result;
  };
}

// The zero level set of a function.
class Implicit_surface : public Path_surface
{
public:
  using Function = std::function<double(const Vec3&, Vec3& gradient)>;

  explicit Implicit_surface(Function function) : m_function(std::move(function)) {}

  Projection project(const Vec3& point, Index) const override
  {
    Projection result = {point, {0., 0., 0.}, {0., 0., 0.}, 0};
    for(int i = 0; i < 6; ++i)
    {
      Vec3 gradient;
      const double value = m_function(result.point, gradient);
      result.normal = unit(gradient);
      result.point = result.point - value / dot(gradient, gradient) * gradient;
    }
    return result;
  }

private:
  Function m_function;
};

// Returns the geodesic near a path, computed with the given number of control points.
inline Geodesic shorten_on(const Implicit_surface& surface, const Curve& path,
                           std::size_t number_of_control_points)
{
  std::vector<Projection> chain;
  for(const Vec3& p : path)
    chain.push_back(surface.project(p, none));
  Path_options options;
  options.number_of_control_points = number_of_control_points;
  const Shortened_path result = shorten_path(surface, options, chain);
  Geodesic geodesic = {{}, result.length};
  for(const Projection& projection : result.points)
    geodesic.curve.push_back(projection.point);
  return geodesic;
}

// Finds paths between surfels of a cloud, in the order and the unit of the caller.
class Path_source
{
public:
  Path_source(const Cloud& cloud, const Cloud_path_options& options)
      : m_finder(std::make_shared<const Fitted_cloud>(cloud.points, cloud.normals,
                                                      std::vector<double>(), options))
  {}

  const Surfel_cloud& cloud() const { return m_finder.fitted_cloud()->cloud(); }

  Cloud_path find(Index a, Index b)
  {
    return m_finder({cloud().internal_vertex[a], {0., 0.}}, {cloud().internal_vertex[b], {0., 0.}});
  }
  double length(const Shortened_path& path) const { return cloud().frame.scale * path.length; }
  Curve curve(const Shortened_path& path) const
  {
    Curve curve;
    for(const auto& projection : path.points)
      curve.push_back(cloud().frame.origin + cloud().frame.scale * projection.point);
    return curve;
  }

private:
  Cloud_path_finder m_finder;
};

// Reference geodesics start from the paths of the default method on the clean cloud. 300 control
// points suffice: on a torus and an ellipsoid, lengths differ from those with 1,000 by at most
// 3e-11.
inline Surface implicit_surface(const std::string& name, const Cloud& cloud,
                                const Implicit_surface::Function& function)
{
  const auto surface = std::make_shared<const Implicit_surface>(function);
  const auto paths = std::make_shared<Path_source>(cloud, Cloud_path_options());
  const auto shorten = [=, points = cloud.points](Index a, Index b, Curve path)
  {
    path.front() = points[a];
    path.back() = points[b];
    return shorten_on(*surface, path, 300);
  };
  return {name, cloud,
          computed_geodesics([=](Index a, Index b)
                             { return shorten(a, b, paths->curve(paths->find(a, b).path)); },
                             shorten)};
}

// Random points on a mesh, with interpolated vertex normals. The geodesics are exact shortest paths
// on the mesh.
inline std::optional<Surface> sampled_mesh(const std::string& name, std::size_t number_of_surfels,
                                           unsigned seed)
{
  namespace GP = CGAL::Geodesic_processing;
  const std::optional<Mesh> mesh = load_model(name);
  if(!mesh)
    return std::nullopt;
  const auto spatial = [](const auto& p) -> Vec3 { return {p.x(), p.y(), p.z()}; };
  std::vector<double> area;
  for(const Face f : mesh->faces())
  {
    const auto h = mesh->halfedge(f);
    area.push_back(
        std::sqrt(CGAL::squared_area(mesh->point(mesh->source(h)), mesh->point(mesh->target(h)),
                                     mesh->point(mesh->target(mesh->next(h))))));
  }
  const GP::Mesh_domain<Mesh> domain(*mesh);
  std::mt19937 random(seed);
  std::discrete_distribution<Mesh::size_type> random_face(area.begin(), area.end());
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<GP::Location<Mesh>> locations;
  Cloud cloud;
  while(cloud.size() < number_of_surfels)
  {
    const Face f(random_face(random));
    const double u = std::sqrt(uniform(random)), v = uniform(random);
    locations.push_back({f, {1. - u, u * (1. - v), u * v}});
    Vec3 normal = {0., 0., 0.};
    auto h = mesh->halfedge(f);
    for(const double weight : locations.back().second)
    {
      normal = normal + weight * spatial(CGAL::Polygon_mesh_processing::compute_vertex_normal(
                                     mesh->source(h), *mesh));
      h = mesh->next(h);
    }
    cloud.add(spatial(domain.point(locations.back())), unit(normal));
  }
  const auto finder = std::make_shared<GP::Geodesic_path_finder<Mesh>>(domain);
  const auto locate = std::make_shared<const GP::Surface_locator<Mesh>>(domain);
  const auto geodesic = [spatial](const GP::Surface_path<Mesh>& path)
  {
    Geodesic result = {{}, path.length};
    for(const auto& p : path.points)
      result.curve.push_back(spatial(p));
    return result;
  };
  return Surface{name, cloud,
                 computed_geodesics([=](Index a, Index b)
                                    { return geodesic((*finder)(locations[a], locations[b])); },
                                    [=](Index a, Index b, const Curve& path)
                                    {
                                      std::vector<GP::Location<Mesh>> polyline = {locations[a]};
                                      for(std::size_t i = 1; i + 1 < path.size(); ++i)
                                        polyline.push_back((*locate)(
                                            Kernel::Point_3(path[i][0], path[i][1], path[i][2])));
                                      polyline.push_back(locations[b]);
                                      return geodesic(finder->shorten(polyline));
                                    })};
}

// Returns random pairs of surfels. Pairs closer than a twentieth of the bounding box diagonal are
// drawn again. Their relative errors measure the noise of two surfels rather than the path.
inline std::vector<std::pair<Index, Index>> random_pairs(const Cloud& cloud, std::size_t number)
{
  Vec3 low = cloud.points[0], high = low;
  for(const Vec3& p : cloud.points)
    for(int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  std::mt19937 random(1);
  std::vector<std::pair<Index, Index>> result;
  while(result.size() < number)
  {
    const Index a = Index(random() % cloud.size()), b = Index(random() % cloud.size());
    if(norm(cloud.points[a] - cloud.points[b]) > 0.05 * norm(high - low))
      result.emplace_back(a, b);
  }
  return result;
}

// Relative errors, root mean squares over the pairs: of the length of the smooth curve, of the length
// of the polyline through its points, and of the path. `control_points` is a mean.
struct Errors
{
  double length = 0., polyline = 0., path = 0., control_points = 0.;
  std::size_t number_of_longer_paths = 0; // longer than the initial path
};

inline Errors errors(const Surface& surface, const Cloud& cloud, const Cloud_path_options& options,
                     std::size_t number_of_pairs)
{
  Path_source paths(cloud, options);
  Errors result;
  for(const auto& [a, b] : random_pairs(surface.clean, number_of_pairs))
  {
    const auto found = paths.find(a, b);
    const Curve path = paths.curve(found.path);
    const std::vector<Geodesic> geodesics = surface.geodesics(a, b, path);
    const double truth = geodesics.front().length;
    const double e = paths.length(found.path) / truth - 1.;
    double polyline = 0.;
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
      polyline += norm(path[i + 1] - path[i]);
    polyline = polyline / truth - 1.;
    double d = infinity;
    for(const auto& [curve, length] : geodesics)
      if(length <= (1. + other_geodesic_tolerance) * truth)
        d = std::min(d, path_distance(path, curve) / truth);
    result.length += e * e;
    result.polyline += polyline * polyline;
    result.path += d * d;
    result.control_points += double(found.path.number_of_control_points);
    result.number_of_longer_paths += found.path.length > found.initial_length;
  }
  result.length = std::sqrt(result.length / double(number_of_pairs));
  result.polyline = std::sqrt(result.polyline / double(number_of_pairs));
  result.path = std::sqrt(result.path / double(number_of_pairs));
  result.control_points /= double(number_of_pairs);
  return result;
}

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_SURFEL_PATHS_H
