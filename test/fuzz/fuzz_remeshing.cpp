// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sampling, remeshing, parameterization and location on small meshes and clouds.
#include "fuzz_library.h"

#include <CGAL/Geodesic_processing/Base_parameterization.h>
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_base_mesh.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/geodesic_lle.h>
#include <CGAL/Geodesic_processing/geodesic_mds.h>
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/logarithmic_map.h>
#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>
#include <CGAL/Geodesic_processing/straightest_geodesic.h>
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>

namespace {

using namespace fuzz;
using UV = std::array<double, 2>;

// ------------------------------------------------------------------------------------- topology

// Disjoint sets of numbers.
class Sets
{
public:
  explicit Sets(std::size_t number) : m_parent(number)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i) const
  {
    while(m_parent[i] != i)
      i = m_parent[i];
    return i;
  }
  void join(std::size_t i, std::size_t j) { m_parent[find(i)] = find(j); }

private:
  std::vector<std::size_t> m_parent;
};

// The Euler characteristic and the number of boundary cycles of each component, sorted. Fans that
// meet in a vertex are separate.
using Topology = std::vector<std::pair<int, int>>;

inline Topology topology_of(const Mesh& mesh)
{
  const auto has_face = [&](Mesh::Halfedge_index h) { return !mesh.is_border(h); };
  Sets corners(mesh.num_halfedges()), loops(mesh.num_halfedges()), faces(mesh.num_faces());
  for(const auto h : mesh.halfedges())
  {
    if(!has_face(h))
      continue;
    const auto twin = mesh.opposite(h);
    if(has_face(twin))
    {
      faces.join(mesh.face(h), mesh.face(twin));
      // The corner at the source of a halfedge has the number of the halfedge.
      corners.join(h, mesh.next(twin));
      continue;
    }
    auto last = mesh.next(h);
    while(has_face(mesh.opposite(last)))
      last = mesh.next(mesh.opposite(last));
    loops.join(h, last);
  }
  std::map<std::size_t, std::pair<int, int>> found;
  for(const auto f : mesh.faces())
    ++found[faces.find(f)].first;
  for(const auto h : mesh.halfedges())
  {
    if(!has_face(h))
      continue;
    auto& [euler, cycles] = found[faces.find(mesh.face(h))];
    const auto twin = mesh.opposite(h);
    if(corners.find(h) == h)
      ++euler;
    if(!has_face(twin) || h < twin)
      --euler;
    if(!has_face(twin) && loops.find(h) == h)
      ++cycles;
  }
  Topology result;
  for(const auto& component : found)
    result.push_back(component.second);
  std::sort(result.begin(), result.end());
  return result;
}

inline double area_of(const Mesh& mesh)
{
  double area = 0.;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Point a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h)),
                c = mesh.point(mesh.target(mesh.next(h)));
    area += 0.5 * length_of(CGAL::cross_product(b - a, c - a));
  }
  return area;
}

inline void require_valid_mesh(const Mesh& mesh)
{
  require(CGAL::is_valid_polygon_mesh(mesh), "an output mesh is valid");
  require(mesh.number_of_faces() == 0 || CGAL::is_triangle_mesh(mesh), "its faces are triangles");
  for(const auto v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
            "its points are finite");
  }
}

// ---------------------------------------------------------------------------------------- tests

template <typename Surface>
class Test
{
  static constexpr bool is_mesh = std::is_same_v<Surface, Mesh>;

public:
  using Domain = typename GP::Geodesic_distance_solver<Surface>::Domain;
  using Vertex = typename Domain::Vertex;
  using Location = GP::Location<Surface>;

  Test(Bytes& in, const Domain& domain, const Surface& surface)
      : m_in(in), m_domain(domain), m_surface(surface), m_scale(scale_of(surface))
  {}

  void run()
  {
    for(int step = 0; step < 3 && (step == 0 || !m_in.empty()); ++step)
      switch(m_in.below(is_mesh ? 11 : 7))
      {
      case 0:
        test_vertex_samples();
        break;
      case 1:
        test_samples();
        break;
      case 2:
        test_voronoi();
        break;
      case 3:
        test_remeshing();
        break;
      case 4:
        test_flattening();
        break;
      case 5:
        test_logarithmic_map();
        break;
      case 6:
        test_location_and_straight();
        break;
      default:
        if constexpr(is_mesh)
          test_on_mesh();
      }
  }

private:
  double tolerance(double distance = 0.) const
  {
    return 2e-7 * (m_scale.diameter + std::abs(distance)) + 1e-14 * m_scale.magnitude;
  }
  Point point(Vertex v) const { return point_of(m_surface, v); }

  void test_on_mesh()
  {
    switch(m_in.below(4))
    {
    case 0:
      test_base_parameterization();
      break;
    case 1:
      test_base_mesh();
      break;
    case 2:
      test_semi_regular();
      break;
    case 3:
      test_atlas();
      break;
    }
  }

  // --------------------------------------------------------------------------------- sampling

  static void check_radii(const std::vector<double>& radii, std::size_t number_of_samples)
  {
    require(radii.size() == number_of_samples, "each sample has a covering radius");
    for(std::size_t i = 0; i < radii.size(); ++i)
      require(radii[i] >= 0. && (i == 0 || radii[i] <= radii[i - 1]),
              "the covering radius never increases");
  }

  void test_vertex_samples()
  {
    const std::size_t number = m_in.below(8);
    const unsigned seed = unsigned(m_in.below(3));
    trace("vertex samples", number, seed);
    std::vector<Vertex> samples;
    std::vector<double> radii;
    std::vector<std::size_t> labels(size_of(m_surface), 0);
    GP::farthest_vertex_sampling<GP::Dijkstra>(
        m_domain, number, std::back_inserter(samples),
        GP::parameters::random_seed(seed)
            .covering_radius_output(std::back_inserter(radii))
            .source_label_map(CGAL::make_property_map(labels)));
    check_radii(radii, samples.size());
    require(samples.size() <= number, "there are not more samples than requested");
    if(samples.empty())
      return;
    std::vector<double> distances(size_of(m_surface), 0.);
    GP::Geodesic_distance_solver<Surface, GP::Dijkstra> solver(m_domain);
    solver.compute(samples);
    solver.write_distances(CGAL::make_property_map(distances));
    double radius = 0.;
    for(std::size_t i = 0; i < distances.size(); ++i)
    {
      require((distances[i] < infinity) == (labels[i] < samples.size()),
              "reached vertices have a label");
      if(distances[i] < infinity)
        radius = std::max(radius, distances[i]);
    }
    if(radii.back() < infinity)
      require_near(radii.back(), radius, tolerance(radius),
                   "the covering radius is the largest distance to a sample");
  }

  void test_samples()
  {
    const std::size_t number = m_in.flag() ? m_in.below(8) : std::size_t(-1);
    const double radius = number < 8 ? 0. : m_scale.diameter * m_in.one_of({0.5, 0.25, 2.});
    trace("samples", double(number), radius);
    std::vector<Location> samples, canceled;
    std::vector<double> radii;
    GP::farthest_point_sampling(
        m_domain, number, std::back_inserter(samples),
        GP::parameters::covering_radius(radius).covering_radius_output(std::back_inserter(radii)));
    check_radii(radii, samples.size());
    for(const Location& sample : samples)
      require_valid(m_domain, sample);
    if(number > 8 && !radii.empty())
      require_at_most(radii.back(), radius, 0., "the covering radius is reached");
    const bool is_stopped = is_canceled(
        m_in,
        [&](const Callback& callback)
        {
          GP::farthest_point_sampling(m_domain, number, std::back_inserter(canceled),
                                      GP::parameters::covering_radius(radius).callback(callback));
        });
    require(canceled.size() == (is_stopped ? 0 : samples.size()), "canceling writes no sample");
  }

  void test_voronoi()
  {
    std::vector<Vertex> seeds;
    trace("Voronoi diagram");
    for(std::size_t number = 1 + m_in.below(4); number > 0; --number)
      seeds.push_back(random_vertex(m_in, m_surface));
    std::vector<std::size_t> labels(size_of(m_surface), 0);
    const auto label_map = CGAL::make_property_map(labels);
    const auto is_label = [&](std::size_t label)
    { return label < seeds.size() || label == std::size_t(-1); };
    if constexpr(is_mesh)
    {
      std::vector<std::size_t> face_labels(m_surface.number_of_faces(), 0);
      std::vector<GP::Voronoi_bisector<Mesh>> bisectors;
      GP::geodesic_voronoi_diagram(
          m_domain, seeds, label_map,
          GP::parameters::face_label_map(CGAL::make_property_map(face_labels))
              .bisector_output(std::back_inserter(bisectors)));
      for(const std::size_t label : face_labels)
        require(is_label(label), "labels are positions of seeds");
      for(const auto& bisector : bisectors)
      {
        require(bisector.left < seeds.size() && bisector.right < seeds.size() &&
                    bisector.left != bisector.right,
                "a bisector separates two cells");
        require(bisector.locations.size() == bisector.points.size(), "locations have points");
        for(const Location& location : bisector.locations)
          require_valid(m_domain, location);
      }
      Mesh cells;
      std::map<Mesh::Face_index, std::size_t> cell_labels;
      if(accepts(
             [&]
             {
               GP::geodesic_voronoi_cells(m_domain, seeds, cells,
                                          boost::make_assoc_property_map(cell_labels));
             }))
      {
        // Isolated vertices of the surface are vertices of the output.
        require(cells.is_valid(), "an output mesh is valid");
        const double area = area_of(m_surface);
        require_near(area_of(cells), area, 1e-7 * m_scale.diameter * m_scale.diameter,
                     "the cells cover the surface");
        for(const auto f : cells.faces())
          require(is_label(cell_labels.at(f)), "labels are positions of seeds");
      }
    }
    else
      GP::geodesic_voronoi_diagram(m_domain, seeds, label_map);
    for(const std::size_t label : labels)
      require(is_label(label), "labels are positions of seeds");
    for(const Vertex seed : seeds)
      require(labels[seed] < seeds.size(), "a seed is in a cell");
  }

  // -------------------------------------------------------------------------------- remeshing

  void test_remeshing()
  {
    const std::size_t number = m_in.below(12), steps = m_in.one_of<std::size_t>({0, 0, 1, 30});
    const bool does_fit = m_in.flag(), does_avoid = m_in.flag();
    const double angle = m_in.one_of({180., 180., 60., 1.});
    const double deviation = m_scale.diameter * m_in.one_of({infinity, infinity, 0.125, 0.03125});
    trace("remeshing", number, steps, does_fit, does_avoid, angle, deviation);
    Mesh output;
    std::map<Mesh::Vertex_index, Location> locations;
    std::optional<GP::Remeshing_result> result;
    const auto np = GP::parameters::number_of_relaxation_steps(steps)
                        .do_fit(does_fit)
                        .do_avoid_self_intersections(does_avoid)
                        .sharp_angle(angle)
                        .maximum_deviation(deviation)
                        .location_map(boost::make_assoc_property_map(locations));
    const bool is_stopped = is_canceled(m_in,
                                        [&](const Callback& callback) {
                                          result = GP::geodesic_delaunay_remeshing(
                                              m_domain, number, output, np.callback(callback));
                                        });
    if(is_stopped)
    {
      require(output.number_of_vertices() == 0, "a canceled function writes nothing");
      accepts([&] { result = GP::geodesic_delaunay_remeshing(m_domain, number, output, np); });
    }
    require_valid_mesh(output);
    if(!result)
    {
      require(output.number_of_vertices() == 0, "a refused surface has no output");
      return;
    }
    require(number == 0 || output.number_of_vertices() <= number + result->number_of_added_vertices,
            "the number of vertices is reported");
    std::set<std::array<std::size_t, 3>> corners;
    for(const auto f : output.faces())
    {
      std::array<std::size_t, 3> face;
      std::size_t k = 0;
      for(const auto v : output.vertices_around_face(output.halfedge(f)))
        face[k++] = v;
      std::sort(face.begin(), face.end());
      require(corners.insert(face).second, "no two faces have the same vertices");
    }
    for(const auto& [v, location] : locations)
      require_valid(m_domain, location);
    if constexpr(is_mesh)
      require(topology_of(output) == topology_of(m_surface),
              "the output has the topology of the input");
  }

  std::size_t random_base(GP::Base_coordinates& coordinates)
  {
    coordinates = m_in.one_of({GP::Base_coordinates::heron, GP::Base_coordinates::mean_value,
                               GP::Base_coordinates::uniform});
    const std::size_t number = m_in.below(8);
    trace("base", number, int(coordinates));
    return number;
  }

  void test_base_parameterization()
  {
    GP::Base_coordinates coordinates;
    const std::size_t number = random_base(coordinates);
    std::optional<GP::Base_parameterization<Mesh>> base;
    if(!accepts([&]
                { base.emplace(m_domain, number, GP::parameters::base_coordinates(coordinates)); }))
      return;
    for(std::size_t f = 0; f < base->number_of_base_faces(); ++f)
      for(const std::size_t corner : base->base_face(f))
        require(corner < base->number_of_base_vertices(), "corners are base vertices");
    for(std::size_t v = 0; v < base->number_of_base_vertices(); ++v)
      require_valid(m_domain, base->base_vertex(v));
    for(int i = 0; i < 3; ++i)
    {
      const Location location = random_location(m_in, m_surface);
      const GP::Base_location mapped = (*base)(location);
      require(mapped.face < base->number_of_base_faces(), "locations are in a base face");
      const Point p = m_domain.point(location);
      // Barycentric coordinates have round-off errors relative to the base face; on needles, they
      // are multiplied by the stretch of the map.
      if(base->number_of_flips() == 0)
        require_at_most(length_of(m_domain.point(base->inverse(mapped)) - p), 0.,
                        1e-3 * m_scale.diameter, "the map is one-to-one");
      else
        require_valid(m_domain, base->inverse(mapped));
    }
  }

  void test_base_mesh()
  {
    GP::Base_coordinates coordinates;
    const std::size_t number = random_base(coordinates);
    Mesh base, divided;
    std::map<Mesh::Face_index, Mesh::Face_index> base_faces;
    if(!accepts(
           [&]
           {
             GP::geodesic_base_mesh(m_domain, number, base, divided,
                                    boost::make_assoc_property_map(base_faces));
           }))
    {
      require(base.number_of_vertices() == 0 && divided.number_of_vertices() == 0,
              "a refused surface has no output");
      return;
    }
    require_valid_mesh(base);
    require_valid_mesh(divided);
    const Topology topology = topology_of(m_surface);
    require(topology_of(base) == topology, "the base has the topology of the input");
    require(topology_of(divided) == topology, "the copy has the topology of the input");
    require_near(area_of(divided), area_of(m_surface), 1e-7 * m_scale.diameter * m_scale.diameter,
                 "the copy has the area of the input");
    std::set<std::size_t> used;
    for(const auto f : divided.faces())
      used.insert(base_faces.at(f));
    require(used.size() == base.number_of_faces(), "each base face is a set of faces");
  }

  void test_semi_regular()
  {
    GP::Base_coordinates coordinates;
    const std::size_t number = random_base(coordinates);
    const unsigned levels = unsigned(m_in.below(3));
    trace("semi-regular", levels);
    Mesh output;
    std::optional<GP::Semi_regular_result> result;
    if(!accepts(
           [&]
           {
             result = GP::semi_regular_remeshing(m_domain, number, levels, output,
                                                 GP::parameters::base_coordinates(coordinates));
           }))
      return;
    require_valid_mesh(output);
    require(result->number_of_levels == levels, "all levels are computed");
    require(output.number_of_faces() == result->number_of_base_faces << (2 * levels),
            "each level has four times as many faces");
    require(topology_of(output) == topology_of(m_surface),
            "the output has the topology of the input");
  }

  // ------------------------------------------------------------------------- parameterization

  void check_uv(const std::vector<UV>& uv) const
  {
    for(const UV& value : uv)
      require(std::isfinite(value[0]) == std::isfinite(value[1]) && !std::isinf(value[0]) &&
                  !std::isinf(value[1]),
              "coordinates are finite or not numbers");
  }

  void test_flattening()
  {
    const bool is_mds = m_in.flag();
    const std::size_t number = m_in.one_of<std::size_t>({200, 3, 5, 8});
    const std::size_t neighbors = m_in.one_of<std::size_t>({10, 3, 5});
    trace(is_mds ? "MDS" : "LLE", number, neighbors);
    std::vector<UV> uv(size_of(m_surface), UV{-1., -1.}), again = uv;
    const auto np = GP::parameters::number_of_base_points(number);
    const auto flatten = [&](std::vector<UV>& values, const Callback& callback)
    {
      const auto map = CGAL::make_property_map(values);
      if(is_mds)
        GP::geodesic_mds(m_domain, map, np.callback(callback));
      else
        GP::geodesic_lle(m_domain, map, np.callback(callback).number_of_neighbors(neighbors));
    };
    const bool is_accepted = accepts([&] { flatten(uv, Callback()); });
    const bool is_stopped =
        is_canceled(m_in, [&](const Callback& callback) { flatten(again, callback); });
    for(std::size_t i = 0; i < uv.size(); ++i)
      require(is_stopped ? again[i] == UV{-1., -1.}
                         : std::memcmp(&uv[i], &again[i], sizeof(UV)) == 0,
              "a canceled function writes nothing, others are reproducible");
    if(!is_accepted)
      return;
    check_uv(uv);
    if constexpr(is_mesh)
      for(const auto v : m_surface.vertices())
        if(!m_surface.is_isolated(v))
          require(std::isfinite(uv[v][0]), "vertices with faces have coordinates");
  }

  void test_atlas()
  {
    const std::size_t number = 1 + m_in.below(4);
    const std::size_t texels = m_in.one_of<std::size_t>({1024, 128, 16});
    trace("atlas", number, texels);
    std::vector<UV> uv(m_surface.number_of_halfedges(), UV{-1., -1.});
    std::vector<std::size_t> charts(m_surface.number_of_faces(), std::size_t(-1));
    GP::Texture_atlas atlas;
    if(!accepts(
           [&]
           {
             atlas = GP::texture_atlas(
                 m_domain, number, CGAL::make_property_map(uv),
                 GP::parameters::texture_size(texels).chart_map(CGAL::make_property_map(charts)));
           }))
      return;
    using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::size_t flips = 0;
    for(const auto f : m_surface.faces())
    {
      require(charts[f] < atlas.number_of_charts, "each face has a chart");
      std::vector<Exact::Point_2> corners;
      for(const auto h : m_surface.halfedges_around_face(m_surface.halfedge(f)))
      {
        for(const double x : uv[h])
          require(x >= 0. && x <= 1., "texture coordinates are in the unit square");
        corners.emplace_back(uv[h][0], uv[h][1]);
      }
      if(CGAL::orientation(corners[0], corners[1], corners[2]) != CGAL::LEFT_TURN)
        ++flips;
    }
    require(flips == atlas.number_of_flips, "the number of flips is exact");
    require(atlas.coverage >= 0. && atlas.coverage <= 1. + 1e-9, "the coverage is a fraction");
  }

  void test_logarithmic_map()
  {
    const double maximum = m_scale.diameter * m_in.one_of({infinity, 0.5, 0.});
    trace("logarithmic map", maximum);
    const Vertex base = random_vertex(m_in, m_surface);
    GP::Logarithmic_map<Surface> map(m_domain);
    if(accepts([&] { map.compute(base, GP::parameters::maximum_distance(maximum)); }))
    {
      std::vector<UV> uv(size_of(m_surface), UV{-1., -1.});
      map.write(CGAL::make_property_map(uv));
      check_uv(uv);
      for(const Vertex v : map.reached())
        require(map.is_inside(v), "reached vertices are inside");
      const auto frame = map.frame();
      require_near(length_of(frame.normal()), 1., 1e-6, "the normal is a unit vector");
      for(int i = 0; i < 2; ++i)
      {
        const UV vector = {0.25 * m_scale.diameter * m_in.between(-4, 4),
                           0.25 * m_scale.diameter * m_in.between(-4, 4)};
        trace("  vector", vector[0], vector[1]);
        require_valid(m_domain, map.exponential(vector));
      }
    }
    if constexpr(is_mesh)
    {
      GP::Logarithmic_map<Mesh, GP::Exact> exact(m_domain);
      if(!accepts([&] { exact.compute(base, GP::parameters::maximum_distance(maximum)); }))
        return;
      GP::Geodesic_distance_solver<Mesh> solver(m_domain);
      solver.compute(base);
      for(const Vertex v : exact.reached())
      {
        const UV vector = exact(v);
        require_near(std::hypot(vector[0], vector[1]), solver.distance(v),
                     tolerance(solver.distance(v)), "the norm of a tangent vector is the distance");
      }
    }
  }

  // ----------------------------------------------------------------------------------- location

  template <typename From>
  void check_straight(const From& from)
  {
    const Vector direction(m_in.between(-2, 2), m_in.between(-2, 2), m_in.between(-2, 2));
    const double length = 0.25 * m_scale.diameter * double(m_in.below(9));
    trace("straightest", direction.x(), direction.y(), direction.z(), length);
    GP::Straightest_geodesic<Surface> path;
    if(!accepts([&] { path = GP::straightest_geodesic(m_domain, from, direction, length); }))
      return;
    require(!path.empty(), "a straightest geodesic has a point");
    // On a cloud, the length is that of a smooth curve.
    if constexpr(is_mesh)
      require_valid_path(m_domain, path, tolerance(path.length));
    require_at_most(path.length, length, tolerance(length), "it is not longer than requested");
    if(!path.is_cut_by_boundary)
      require_at_most(length, path.length, tolerance(length),
                      "it has the requested length unless the boundary cuts it");
  }

  void test_location_and_straight()
  {
    if(!has_locations(m_surface))
      return;
    const Location location = random_location(m_in, m_surface);
    if(m_in.flag())
      check_straight(location);
    else
      check_straight(random_vertex(m_in, m_surface));
    const GP::Surface_locator<Surface> locate(m_domain);
    const Point p = m_domain.point(location);
    const double unit = 0.125 * m_scale.diameter;
    const Point q =
        p + unit * Vector(m_in.between(-4, 4), m_in.between(-4, 4), m_in.between(-4, 4));
    trace("locate", q.x(), q.y(), q.z());
    const Location found = locate(q);
    require_valid(m_domain, found);
    if constexpr(is_mesh)
    {
      require_at_most(length_of(m_domain.point(found) - q), length_of(p - q), tolerance(),
                      "no location is closer than the closest one");
      for(const auto v : m_surface.vertices())
        if(!m_surface.is_isolated(v))
          require_at_most(length_of(m_domain.point(found) - q), length_of(point(v) - q),
                          tolerance(), "no location is closer than the closest one");
    }
  }

  Bytes& m_in;
  Domain m_domain;
  const Surface& m_surface;
  Scale m_scale;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes in(data, size);
  run_on_random_surface<Test>(
      in, 6, 30, 20, [](const Soup& soup) { return GP::make_domain(soup.points, soup.polygons); });
  return 0;
}
