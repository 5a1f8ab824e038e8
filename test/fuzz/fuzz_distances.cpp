// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sequences of queries of distance solvers and path finders on small meshes and clouds.
#include "fuzz_library.h"

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/property_map.h>

#include <exception>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

namespace {

using namespace fuzz;

// The sources of a query, with an upper bound of the distances: those along edges.
template <typename Surface>
struct Query
{
  std::vector<GP::Source<Surface>> sources;
  std::vector<std::pair<Point, double>> points; // points and offsets of sources without extent
  double lowest_offset = infinity;
  double largest_offset = 0.;               // the largest absolute value
  std::vector<std::size_t> source_vertices; // only if it is the only source, without offset
  std::vector<double> along_edges;
};

template <typename Surface>
class Test
{
  static constexpr bool is_mesh = std::is_same_v<Surface, Mesh>;

public:
  using Domain = typename GP::Geodesic_distance_solver<Surface>::Domain;
  using Vertex = typename Domain::Vertex;
  using Location = GP::Location<Surface>;
  template <typename Method>
  using Solver = GP::Geodesic_distance_solver<Surface, Method>;

  Test(Bytes& in, const Domain& domain, const Surface& surface)
      : m_in(in), m_domain(domain), m_surface(surface), m_scale(scale_of(surface)),
        m_dijkstra(domain), m_front(domain), m_marching(domain), m_heat(domain),
        m_automatic(domain), m_finder(domain)
  {}

  void run()
  {
    for(int step = 0; step < 8 && (step == 0 || !m_in.empty()); ++step)
    {
      const Query<Surface> query = random_query();
      // Several operations with the same sources.
      for(std::size_t number = 1 + m_in.below(3); number > 0; --number)
        switch(m_in.below(5))
        {
        case 0:
          test(m_dijkstra, query);
          break;
        case 1:
          test(m_front, query);
          break;
        case 2:
          test(m_marching, query);
          break;
        case 3:
          test(m_heat, query);
          break;
        case 4:
          test(m_automatic, query);
          break;
        }
      if(m_in.flag())
        test_finder();
    }
  }

private:
  Point point(Vertex v) const { return point_of(m_surface, v); }

  // Round-off errors of a sum of lengths. On triangles of area zero, `Exact` documents an error of
  // 3e-8 of the lengths of their edges; a path crosses at most a few of them.
  double tolerance(double distance = 0.) const
  {
    return 2e-7 * (m_scale.diameter + (distance < infinity ? std::abs(distance) : 0.)) +
           1e-14 * m_scale.magnitude;
  }

  GP::Source<Surface> random_source(Query<Surface>& query)
  {
    const double offset = m_in.one_of({0., 0., 0., 0., -0.25, 0.25, 0.5}) * m_scale.diameter;
    query.lowest_offset = std::min(query.lowest_offset, offset);
    query.largest_offset = std::max(query.largest_offset, std::abs(offset));
    const std::size_t kind = has_locations(m_surface) ? m_in.below(4) : 0;
    if(offset != 0.)
      trace("  offset of the source", offset);
    if(kind < 2)
    {
      const Vertex v = random_vertex(m_in, m_surface);
      query.points.emplace_back(point(v), offset);
      if(offset == 0.)
        query.source_vertices.push_back(v);
      return {v, offset};
    }
    const Location location = random_location(m_in, m_surface);
    if constexpr(is_mesh)
      if(kind == 3)
      {
        Location other = location;
        other.second = {location.second[1], location.second[2], location.second[0]};
        trace("  polyline");
        return {typename GP::Source<Surface>::Polyline{location, other}, offset};
      }
    query.points.emplace_back(m_domain.point(location), offset);
    return {location, offset};
  }

  Query<Surface> random_query()
  {
    Query<Surface> query;
    trace("query");
    for(std::size_t number = 1 + m_in.below(3); number > 0; --number)
      query.sources.push_back(random_source(query));
    if(query.points.size() < query.sources.size())
      query.points.clear();
    Solver<GP::Dijkstra> fresh(m_domain);
    fresh.compute(query.sources);
    query.along_edges = distances(fresh);
    return query;
  }

  template <typename Method>
  std::vector<double> distances(const Solver<Method>& solver) const
  {
    std::vector<double> result(size_of(m_surface), -1.);
    solver.write_distances(CGAL::make_property_map(result));
    return result;
  }

  template <typename Method>
  static constexpr bool is_exact = is_mesh&& std::is_same_v<Method, GP::Automatic>;

  // Checks distances in all ways that do not need another query.
  template <typename Method>
  void check(const Query<Surface>& query, const std::vector<double>& found) const
  {
    constexpr bool is_heat = std::is_same_v<Method, GP::Heat>;
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      const double d = found[i], along_edges = query.along_edges[i];
      require(!std::isnan(d), "distances are numbers");
      // On needles, the front does not find polylines in its triangulation.
      if(!std::is_same_v<Method, GP::Euclidean_front> || !query.points.empty())
        require((d < infinity) == (along_edges < infinity), "all methods reach the same vertices");
      if(d == infinity || is_heat)
        continue;
      require_at_most(query.lowest_offset, d, tolerance(d), "distances are not below the offset");
      // The front divides a polyline into short pieces, so it is not exact around polylines. In
      // needles, its locations have round-off errors.
      if constexpr(is_mesh && !std::is_same_v<Method, GP::Fast_marching>)
        if(is_exact<Method> || (!query.points.empty() && !has_needles(m_surface)))
          require_at_most(d, along_edges, tolerance(along_edges),
                          "no distance exceeds the length of a path along edges");
      double straight = query.points.empty() ? -infinity : infinity;
      for(const auto& [p, offset] : query.points)
        straight = std::min(straight, offset + length_of(point(vertex_of(m_surface, i)) - p));
      if constexpr(is_mesh && !std::is_same_v<Method, GP::Fast_marching>)
        if(is_exact<Method> || std::is_same_v<Method, GP::Dijkstra> || query.sources.size() == 1)
          require_at_most(straight, d, tolerance(d) + tolerance(query.largest_offset),
                          "no distance is below the length of the straight line");
    }
    if(!is_heat && query.lowest_offset == 0.)
      for(const std::size_t source : query.source_vertices)
        require_near(found[source], 0., 0., "the distance of a source is zero");
    if constexpr(is_exact<Method>)
      for(const auto e : m_surface.edges())
      {
        const auto h = halfedge(e, m_surface);
        const Vertex a = source(h, m_surface), b = target(h, m_surface);
        const double length = length_of(point(a) - point(b));
        require_at_most(found[a], found[b] + length, tolerance(found[a]),
                        "along an edge the distance changes by at most its length");
        require_at_most(found[b], found[a] + length, tolerance(found[a]),
                        "along an edge the distance changes by at most its length");
      }
  }

  template <typename Method>
  void test(Solver<Method>& solver, const Query<Surface>& query)
  {
    trace(typeid(Method).name());
    solver.compute(query.sources);
    const std::vector<double> found = distances(solver);
    check<Method>(query, found);
    Solver<Method> fresh(m_domain);
    fresh.compute(query.sources);
    require_equal(found, distances(fresh), "earlier queries do not change a result");
    switch(m_in.below(8))
    {
    case 0:
      test_limit(solver, query, found);
      break;
    case 1:
      test_cancel(solver, query, found);
      break;
    case 2:
      test_copies(solver, query, found);
      break;
    case 3:
      test_errors(solver, query, found);
      break;
    case 4:
      test_paths(solver, query);
      break;
    case 5:
      test_locations(solver, query, found);
      break;
    case 6:
      test_speeds(solver, query, found);
      break;
    case 7:
      test_bounds(solver, query, found);
      break;
    }
  }

  template <typename Method>
  void test_limit(Solver<Method>& solver, const Query<Surface>& query,
                  const std::vector<double>& found)
  {
    double largest = 0.;
    for(const double d : found)
      if(d < infinity)
        largest = std::max(largest, d);
    const double maximum = 0.25 * double(m_in.below(5)) * largest;
    trace("limit", maximum);
    solver.compute(query.sources, GP::parameters::maximum_distance(maximum));
    const std::vector<double> limited = distances(solver);
    for(std::size_t i = 0; i < found.size(); ++i)
      if(!is_mesh)
        // Surfels beyond the maximum correct nearer ones.
        require_at_most(found[i], limited[i], tolerance(found[i]),
                        "a maximum distance does not decrease distances");
      else if(limited[i] == infinity)
        require_at_most(maximum, found[i], tolerance(found[i]), "near vertices are reached");
      else
      {
        require_at_most(limited[i], maximum, tolerance(maximum), "far vertices are not reached");
        require_near(limited[i], found[i], tolerance(found[i]),
                     "a maximum distance does not change distances");
      }
    for(const Vertex v : solver.reached())
      require(limited[v] < infinity || std::is_same_v<Method, GP::Heat>,
              "reached vertices have a distance");
  }

  template <typename Method>
  void test_cancel(Solver<Method>& solver, const Query<Surface>& query,
                   const std::vector<double>& found)
  {
    const Cancellation cancellation =
        cancel(m_in, [&](const Callback& callback)
               { solver.compute(query.sources, GP::parameters::callback(callback)); });
    const std::vector<double> partial = distances(solver);
    for(std::size_t i = 0; i < found.size(); ++i)
      // If the callback throws an exception, no results are documented.
      if(cancellation == Cancellation::none ||
         (cancellation == Cancellation::returned && partial[i] < infinity))
        require_near(partial[i], found[i], 0., "after canceling only final distances remain");
    solver.compute(query.sources);
    require_equal(distances(solver), found, "a canceled query does not change the next one");
  }

  // Copies and moved solvers have the same results, also in two threads.
  template <typename Method>
  void test_copies(Solver<Method>& solver, const Query<Surface>& query,
                   const std::vector<double>& found)
  {
    trace("copies");
    Solver<Method> copy(solver);
    require_equal(distances(copy), found, "a copy has the results");
    const Query<Surface> other = random_query();
    solver.compute(other.sources);
    const std::vector<double> others = distances(solver);
    require_equal(distances(copy), found, "a query does not change a copy");
    Solver<Method> moved(std::move(copy));
    require_equal(distances(moved), found, "a moved solver has the results");
    copy = solver;
    std::exception_ptr error;
    std::thread thread(
        [&]
        {
          try
          {
            for(int i = 0; i < 2; ++i)
              moved.compute(other.sources);
          }
          catch(...)
          {
            error = std::current_exception();
          }
        });
    try
    {
      for(int i = 0; i < 2; ++i)
        copy.compute(query.sources);
    }
    catch(...)
    {
      thread.join();
      throw;
    }
    thread.join();
    if(error)
      std::rethrow_exception(error);
    require_equal(distances(moved), others, "copies compute concurrently");
    require_equal(distances(copy), found, "copies compute concurrently");
    solver = std::move(moved);
    require_equal(distances(solver), others, "an assigned solver has the results");
  }

  template <typename Method>
  void test_errors(Solver<Method>& solver, const Query<Surface>& query,
                   const std::vector<double>& found)
  {
    trace("errors");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    switch(m_in.below(5))
    {
    case 0:
      require_refusal([&] { solver.compute(std::vector<Vertex>()); });
      break;
    case 1:
      require_refusal([&]
                      { solver.compute(query.sources, GP::parameters::maximum_distance(-1.)); });
      break;
    case 2:
      require_refusal([&] { solver.compute(GP::Source<Surface>(vertex_of(m_surface, 0), nan)); });
      break;
    case 3:
      require_refusal([&]
                      { solver.compute(query.sources, GP::parameters::relative_tolerance(nan)); });
      break;
    case 4:
      require_refusal([&] { solver.compute(vertex_of(m_surface, size_of(m_surface) + 1)); });
      break;
    }
    require_equal(distances(solver), found, "after an error the last results remain");
  }

  template <typename Method>
  void test_paths(Solver<Method>& solver, const Query<Surface>& query)
  {
    for(std::size_t number = 1 + m_in.below(3); number > 0; --number)
    {
      trace("path");
      if(m_in.flag() && has_locations(m_surface))
        check_path(solver, query, random_location(m_in, m_surface));
      else
        check_path(solver, query, random_vertex(m_in, m_surface));
    }
  }

  template <typename Method, typename Element>
  void check_path(const Solver<Method>& solver, const Query<Surface>& query, const Element& from)
  {
    const double distance = solver.distance(from);
    const auto path = solver.path(from);
    require(path.empty() == (distance == infinity), "a path leads to each reached location");
    if(path.empty())
      return;
    require_valid_path(m_domain, path, tolerance(path.length));
    require_near(path.front_distance, distance, tolerance(distance),
                 "a path knows the distance of the method");
    if constexpr(is_exact<Method>)
    {
      const double offset = distance - path.length;
      require_at_most(query.lowest_offset, offset, tolerance(path.length) + tolerance(distance),
                      "the length of an exact path is the distance");
      if(query.largest_offset == 0.)
      {
        require_near(path.length, distance, tolerance(distance),
                     "the length of an exact path is the distance");
        // The bound is smaller by the errors of thin triangles.
        if(!has_needles(m_surface))
          require_at_most(path.length, path.lower, tolerance(distance),
                          "exact paths are certified");
      }
      const auto paths = solver.shortest_paths(from);
      require(paths.size() <= 64, "there are at most 64 shortest paths");
      for(const auto& shortest : paths)
      {
        require_valid_path(m_domain, shortest, tolerance(distance));
        if(query.largest_offset == 0.)
          require_near(shortest.length, distance, tolerance(distance),
                       "the lengths of shortest paths are the distance");
      }
      const auto departure = solver.departure(from);
      if(query.largest_offset == 0. && departure.length < infinity)
        require_near(departure.length, distance, tolerance(distance),
                     "the length of a departure is the distance");
    }
  }

  // Distances of locations are consistent with those of the corners of their faces.
  template <typename Method>
  void test_locations(Solver<Method>& solver, const Query<Surface>& query,
                      const std::vector<double>& found)
  {
    if(!has_locations(m_surface))
      return;
    std::vector<Location> locations;
    for(std::size_t number = 1 + m_in.below(3); number > 0; --number)
      locations.push_back(random_location(m_in, m_surface));
    std::vector<double> together;
    solver.distances(locations, std::back_inserter(together));
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      const double d = solver.distance(locations[i]);
      require(!std::isnan(d), "distances are numbers");
      require_near(together[i], d, tolerance(d), "distances of many locations are those of one");
      if constexpr(is_exact<Method>)
        for(const Vertex v : m_surface.vertices_around_face(m_surface.halfedge(locations[i].first)))
        {
          const double length = length_of(m_domain.point(locations[i]) - point(v));
          require_at_most(d, found[v] + length, tolerance(found[v]), "the slope is at most one");
          require_at_most(found[v], d + length, tolerance(found[v]), "the slope is at most one");
        }
    }
    solver.compute(query.sources, GP::parameters::targets(locations));
    for(std::size_t i = 0; i < locations.size(); ++i)
      require_near(solver.distance(locations[i]), together[i], tolerance(together[i]),
                   "targets have the distances of a complete query");
  }

  template <typename Method>
  void test_speeds(Solver<Method>& solver, const Query<Surface>& query,
                   const std::vector<double>& found)
  {
    const bool is_constant = m_in.flag();
    const double constant = m_in.one_of({0.5, 2., 3.});
    std::vector<double> speeds(size_of(m_surface), constant);
    if(!is_constant)
      for(double& speed : speeds)
        speed = m_in.one_of({1., 1., 2., 0.5, 1e-3, 0.});
    trace(is_constant ? "constant speed" : "speeds", constant);
    const bool is_accepted = accepts(
        [&] {
          solver.compute(query.sources, GP::parameters::speed_map(CGAL::make_property_map(speeds)));
        });
    const std::vector<double> times = distances(solver);
    if(!is_accepted)
    {
      require_equal(times, found, "after an error the last results remain");
      return;
    }
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      require(!std::isnan(times[i]), "travel times are numbers");
      if(times[i] == infinity)
        continue;
      require(found[i] < infinity, "only reached vertices have a travel time");
      // Speeds are those of triangles. Without one, they have no effect.
      if(is_constant && query.largest_offset == 0. &&
         m_domain.triangles()->number_of_triangles() > 0)
        require_near(constant * times[i], found[i], tolerance(found[i]),
                     "the travel time is the distance divided by the speed");
    }
    if constexpr(is_exact<Method>)
    {
      // Obstacles.
      std::vector<double> face_speeds(m_surface.number_of_faces());
      for(double& speed : face_speeds)
        speed = m_in.one_of({1., 1., 0.});
      solver.compute(query.sources,
                     GP::parameters::face_speed_map(CGAL::make_property_map(face_speeds)));
      const std::vector<double> around = distances(solver);
      for(std::size_t i = 0; i < found.size(); ++i)
        require_at_most(found[i], around[i], tolerance(found[i]), "obstacles shorten no path");
    }
  }

  // Certified bounds.
  template <typename Method>
  void test_bounds(Solver<Method>& solver, const Query<Surface>& query,
                   const std::vector<double>& found)
  {
    if constexpr(is_exact<Method>)
    {
      const double fraction = m_in.one_of({1e-6, 1e-3, 0.1, 1.});
      trace("relative tolerance", fraction);
      solver.compute(query.sources, GP::parameters::relative_tolerance(fraction));
      for(std::size_t i = 0; i < found.size(); ++i)
      {
        const Vertex v = vertex_of(m_surface, i);
        const double lower = solver.lower(v), upper = solver.upper(v);
        require_at_most(lower, found[i], tolerance(found[i]), "lower bounds are below");
        require_at_most(found[i], upper, tolerance(found[i]), "upper bounds are above");
        // Thin triangles add their errors.
        if(found[i] < infinity && query.largest_offset == 0. && !has_needles(m_surface))
          require_at_most(upper - lower, fraction * lower, tolerance(found[i]),
                          "bounds differ by at most the tolerance");
      }
    }
    else
      test_limit(solver, query, found);
  }

  void test_finder()
  {
    trace("finder");
    if(has_locations(m_surface) && m_in.flag())
      check_finder(random_location(m_in, m_surface), random_vertex(m_in, m_surface));
    else
      check_finder(random_vertex(m_in, m_surface), random_vertex(m_in, m_surface));
  }

  template <typename From>
  void check_finder(const From& from, const Vertex& to)
  {
    const auto path = m_finder(from, to);
    const auto local = m_finder.locally_shortest_path(from, to);
    require_valid_path(m_domain, path, tolerance(path.length));
    require_valid_path(m_domain, local, tolerance(local.length));
    if constexpr(is_mesh)
    {
      Solver<GP::Automatic> exact(m_domain);
      exact.compute(from);
      const double distance = exact.distance(to);
      require(path.empty() == (distance == infinity), "a path leads to each reached location");
      require(local.empty() == path.empty(), "both searches find a path");
      if(path.empty())
        return;
      require_near(path.length, distance, tolerance(distance),
                   "the length of a shortest path is the exact distance");
      require_at_most(path.length, local.length, tolerance(distance),
                      "shortest paths are not longer than others");
      exact.compute(to);
      require_near(exact.distance(from), distance, tolerance(distance),
                   "exact distances are symmetric");
      if(m_in.flag() && m_surface.number_of_faces() > 0)
        m_finder.add_landmarks(unsigned(1 + m_in.below(3)));
    }
    const Vertex middle = random_vertex(m_in, m_surface);
    const auto first = m_finder.locally_shortest_path(to, middle);
    const auto second = m_finder.locally_shortest_path(middle, to);
    const auto loop = m_finder.shorten(std::vector<Vertex>{to, middle, to});
    require(loop.empty() == (first.empty() || second.empty()), "a polyline has a path");
    require_valid_path(m_domain, loop, tolerance(loop.length));
    if constexpr(is_mesh)
      if(!loop.empty())
        require_at_most(loop.length, first.length + second.length, tolerance(loop.length),
                        "shortening makes no path longer");
  }

  Bytes& m_in;
  Domain m_domain;
  const Surface& m_surface;
  Scale m_scale;
  Solver<GP::Dijkstra> m_dijkstra;
  Solver<GP::Euclidean_front> m_front;
  Solver<GP::Fast_marching> m_marching;
  Solver<GP::Heat> m_heat;
  Solver<GP::Automatic> m_automatic;
  GP::Geodesic_path_finder<Surface> m_finder;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes in(data, size);
  run_on_random_surface<Test>(in, 4, 30, 20,
                              [&](const Soup& soup)
                              {
                                const bool does_merge = in.flag();
                                trace("merge", does_merge);
                                return does_merge
                                           ? GP::make_domain(soup.points, soup.polygons,
                                                             GP::parameters::merge_tolerance(0.))
                                           : GP::make_domain(soup.points, soup.polygons);
                              });
  return 0;
}
