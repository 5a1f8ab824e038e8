// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROCESSING_FUZZ_LIBRARY_H
#define GEODESIC_PROCESSING_FUZZ_LIBRARY_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

// Decodes bytes to small surfaces and to arguments of functions, and checks results. If the
// environment variable FUZZ_TRACE is set, surfaces and operations are printed.

namespace fuzz {

namespace GP = CGAL::Geodesic_processing;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Cloud = CGAL::Point_set_3<Point>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Reads small numbers, one byte each; zeros after the last byte. The first operation is at the
// beginning, so that bytes that are appended add operations.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : m_next(data), m_end(data + size) {}

  bool empty() const { return m_next == m_end; }
  // Returns a number in [0, number); `number` is at most 256.
  std::size_t below(std::size_t number) { return empty() ? 0 : *m_next++ % number; }
  // Returns a number in [first, last].
  int between(int first, int last) { return first + int(below(std::size_t(last - first + 1))); }
  bool flag() { return below(2) == 1; }
  template <typename T>
  T one_of(std::initializer_list<T> values)
  {
    return *(values.begin() + below(values.size()));
  }

private:
  const std::uint8_t* m_next;
  const std::uint8_t* m_end;
};

inline bool is_traced()
{
  static const bool result = std::getenv("FUZZ_TRACE") != nullptr;
  return result;
}

// Prints the name of an operation and its numbers.
template <typename... Numbers>
void trace(const char* name, const Numbers&... numbers)
{
  if(!is_traced())
    return;
  std::printf("%s", name);
  (std::printf(" %.17g", double(numbers)), ...);
  std::printf("\n");
  std::fflush(stdout);
}

// Ends the program if a guarantee is violated.
inline void require(bool holds, const char* guarantee)
{
  if(holds)
    return;
  std::fprintf(stderr, "Violated: %s\n", guarantee);
  std::abort();
}

// Requires smaller <= larger + tolerance.
inline void require_at_most(double smaller, double larger, double tolerance, const char* guarantee)
{
  if(smaller <= larger + tolerance)
    return;
  std::fprintf(stderr, "%.17g > %.17g + %g\n", smaller, larger, tolerance);
  require(false, guarantee);
}

// Requires that two values are both infinite or differ by at most the tolerance.
inline void require_near(double a, double b, double tolerance, const char* guarantee)
{
  if(a == b || std::abs(a - b) <= tolerance)
    return;
  std::fprintf(stderr, "%.17g and %.17g, tolerance %g\n", a, b, tolerance);
  require(false, guarantee);
}

// Requires equal bits.
inline void require_equal(const std::vector<double>& a, const std::vector<double>& b,
                          const char* guarantee)
{
  require(a.size() == b.size(), guarantee);
  for(std::size_t i = 0; i < a.size(); ++i)
    if(std::memcmp(&a[i], &b[i], sizeof(double)) != 0)
    {
      std::fprintf(stderr, "%zu: %.17g and %.17g\n", i, a[i], b[i]);
      require(false, guarantee);
    }
}

// ---------------------------------------------------------------------------------------- calls

// Calls a function that can refuse the surface or the arguments. Returns whether it did not.
template <typename Function>
bool accepts(Function f)
{
  try
  {
    f();
    return true;
  }
  catch(const GP::Invalid_argument_error& error)
  {
    require(*error.what() != 0, "an error has a sentence");
    if(is_traced())
      std::printf("  %s\n", error.what());
  }
  catch(const GP::Unsupported_surface_error& error)
  {
    require(*error.what() != 0, "an error has a sentence");
    if(is_traced())
      std::printf("  %s\n", error.what());
  }
  return false;
}

// Calls a function that must throw Invalid_argument_error.
template <typename Function>
void require_refusal(Function f)
{
  try
  {
    f();
  }
  catch(const GP::Invalid_argument_error&)
  {
    return;
  }
  require(false, "invalid arguments are refused");
}

using Callback = std::function<bool(double)>;

enum class Cancellation
{
  none,     // the function ended earlier, or refused the surface
  returned, // the callback returned false
  thrown    // the callback threw an exception
};

// Calls f(callback) with a callback that returns false or throws after a few calls.
template <typename Function>
Cancellation cancel(Bytes& in, Function f)
{
  struct Stop
  {};
  const std::size_t number_of_calls = in.below(16);
  const bool does_throw = in.flag();
  trace("canceled", number_of_calls, does_throw);
  std::size_t calls = 0;
  bool is_stopped = false;
  double last = 0.;
  const Callback callback = [&](double fraction)
  {
    require(fraction >= last && fraction <= 1., "the fraction is in [0, 1] and never decreases");
    require(!is_stopped, "the callback is not called again");
    last = fraction;
    if(calls++ < number_of_calls)
      return true;
    is_stopped = true;
    if(does_throw)
      throw Stop();
    return false;
  };
  try
  {
    accepts([&] { f(callback); });
    require(!is_stopped, "the callback cancels the function");
  }
  catch(const GP::Cancelled&)
  {
    require(is_stopped && !does_throw, "a function is canceled by its callback only");
  }
  catch(const Stop&)
  {
    require(does_throw, "the exception of a callback is passed on");
  }
  return !is_stopped  ? Cancellation::none
         : does_throw ? Cancellation::thrown
                      : Cancellation::returned;
}

template <typename Function>
bool is_canceled(Bytes& in, Function f)
{
  return cancel(in, f) != Cancellation::none;
}

// ------------------------------------------------------------------------------------- surfaces

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

inline double needle_ratio(Bytes& in)
{
  return in.one_of({1., 1., 1., 1., 1., 1e-3, 1e-6, 1e-9, 1e-12, 0.});
}
inline double unit_of_length(Bytes& in)
{
  return in.one_of({1., 1., 1., 1., 1., 1e-6, 1e6, 1e-100, 1e100});
}

// Appends a grid of w by h squares, each of two triangles. The last column (row) is the first one
// if the grid is periodic, with reversed rows if it is twisted.
inline void add_grid(Soup& soup, int w, int h, bool is_periodic, bool is_twisted,
                     bool is_doubly_periodic)
{
  const int columns = is_periodic ? w : w + 1, rows = is_doubly_periodic ? h : h + 1;
  for(int y = 0; y < rows; ++y)
    for(int x = 0; x < columns; ++x)
    {
      const double angle = 6.283185307179586 * x / w, height = 6.283185307179586 * y / h;
      if(is_doubly_periodic)
        soup.points.emplace_back((3. + std::cos(height)) * std::cos(angle),
                                 (3. + std::cos(height)) * std::sin(angle), std::sin(height));
      else if(is_periodic)
        soup.points.emplace_back(2. * std::cos(angle), 2. * std::sin(angle), y);
      else
        soup.points.emplace_back(x, y, 0.);
    }
  const auto vertex = [&](int x, int y)
  {
    if(is_doubly_periodic)
      y %= h;
    if(is_periodic && x == w)
      return std::size_t(columns * (is_twisted ? rows - 1 - y : y));
    return std::size_t(x + columns * y);
  };
  for(int y = 0; y < h; ++y)
    for(int x = 0; x < w; ++x)
    {
      soup.polygons.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
      soup.polygons.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
    }
}

// Appends k triangles around an apex, and around a second one if it is closed.
inline void add_fan(Soup& soup, std::size_t k, bool is_disk, bool is_closed)
{
  const std::size_t first = soup.points.size();
  for(std::size_t i = 0; i < k; ++i)
    soup.points.emplace_back(3. * std::cos(6.283185307179586 * double(i) / double(k)),
                             3. * std::sin(6.283185307179586 * double(i) / double(k)), 0.);
  soup.points.emplace_back(0., 0., 1.);
  soup.points.emplace_back(0., 0., -1.);
  for(std::size_t i = 0; i + (is_disk ? 0 : 1) < k; ++i)
  {
    const std::size_t a = first + i, b = first + (i + 1) % k;
    soup.polygons.push_back({a, b, first + k});
    if(is_closed)
      soup.polygons.push_back({b, a, first + k + 1});
  }
}

// Changes polygons and points in a way that violates what surfaces usually have in common.
inline void damage(Bytes& in, Soup& soup)
{
  const auto point = [&] { return in.below(soup.points.size()); };
  for(std::size_t number = in.below(4); number > 0; --number)
    switch(in.below(7))
    {
    case 0: // a hole
      if(!soup.polygons.empty())
        soup.polygons.erase(soup.polygons.begin() + std::ptrdiff_t(in.below(soup.polygons.size())));
      break;
    case 1: // often an edge of three triangles
      soup.polygons.push_back({point(), point(), point()});
      break;
    case 2: // points that coincide
      soup.points[point()] = soup.points[point()];
      break;
    case 3: // another orientation
      if(!soup.polygons.empty())
      {
        auto& polygon = soup.polygons[in.below(soup.polygons.size())];
        std::reverse(polygon.begin(), polygon.end());
      }
      break;
    case 4: // a needle: a point that almost coincides with another one
    {
      const Point p = soup.points[point()];
      soup.points[point()] = p + in.one_of({1e-3, 1e-6, 1e-9, 1e-12}) * Vector(1., 1., 0.);
      break;
    }
    case 5: // a cap: a point on the segment between others
    {
      const Point p = soup.points[point()], q = soup.points[point()];
      soup.points[point()] = p + 0.25 * in.between(0, 4) * (q - p);
      break;
    }
    case 6: // a quadrilateral
      soup.polygons.push_back({point(), point(), point(), point()});
      break;
    }
}

// Returns at most about `size` triangles.
inline Soup random_soup(Bytes& in, std::size_t size)
{
  Soup soup;
  const int side = size >= 18 ? 3 : 2;
  switch(in.below(6))
  {
  case 0:
    for(std::size_t number = 3 + in.below(size / 2); number > 0; --number)
      soup.points.emplace_back(in.between(-3, 3), in.between(-3, 3), in.between(-3, 3));
    for(std::size_t number = 1 + in.below(size); number > 0; --number)
      soup.polygons.push_back({in.below(soup.points.size()), in.below(soup.points.size()),
                               in.below(soup.points.size())});
    break;
  case 1:
    add_grid(soup, in.between(1, side), in.between(1, side), false, false, false);
    break;
  case 2: // an annulus, or a Moebius strip
    add_grid(soup, 3 + in.between(0, side), in.between(1, 2), true, in.flag(), false);
    break;
  case 3: // a torus
    add_grid(soup, 3, size >= 18 ? 3 : 2, true, false, true);
    break;
  case 4: {
    const std::size_t number = 3 + in.below(size / 2 - 2), kind = in.below(3);
    add_fan(soup, number, kind > 0, kind > 1);
    break;
  }
  case 5: // two components
    add_fan(soup, 3 + in.below(2), true, true);
    add_fan(soup, 3, true, in.flag());
    for(std::size_t i = soup.points.size() - 5; i < soup.points.size(); ++i)
      soup.points[i] = soup.points[i] + Vector(8., 0., 0.);
    break;
  }
  if(in.flag())
    for(Point& p : soup.points)
      p = p + Vector(0., 0., 0.25 * in.between(-4, 4));
  damage(in, soup);
  const double ratio = needle_ratio(in), unit = unit_of_length(in);
  const double shift = in.one_of({0., 0., 0., 1., 1e3}) * unit;
  for(Point& p : soup.points)
    p = Point(unit * p.x() + shift, unit * ratio * p.y() + shift, unit * p.z());
  if(is_traced())
  {
    std::printf("OFF\n%zu %zu 0\n", soup.points.size(), soup.polygons.size());
    for(const Point& p : soup.points)
      std::printf("%.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    for(const auto& polygon : soup.polygons)
    {
      std::printf("%zu", polygon.size());
      for(const std::size_t corner : polygon)
        std::printf(" %zu", corner);
      std::printf("\n");
    }
  }
  return soup;
}

// Returns at most `size` surfels.
inline Cloud random_cloud(Bytes& in, std::size_t size)
{
  Cloud cloud;
  cloud.add_normal_map();
  const std::size_t kind = in.below(4), number = in.below(size + 1);
  for(std::size_t i = 0; i < number; ++i)
  {
    Point p;
    Vector n(0., 0., 1.);
    if(kind == 0) // anything
    {
      p = Point(in.between(-3, 3), in.between(-3, 3), in.between(-3, 3));
      n = Vector(in.between(-1, 1), in.between(-1, 1), in.between(2, 3));
    }
    else if(kind == 1) // a grid
      p = Point(double(i % 6), double(i / 6), 0.);
    else if(kind == 2) // a sphere
    {
      const double z = 1. - 2. * (double(i) + 0.5) / double(number), angle = 2.399963 * double(i);
      const double r = std::sqrt(1. - z * z);
      n = Vector(r * std::cos(angle), r * std::sin(angle), z);
      p = CGAL::ORIGIN + 2. * n;
    }
    else // two sheets
    {
      p = Point(double(i % 5), double(i / 10), 0.125 * double(i / 5 % 2));
      n = Vector(0., 0., i / 5 % 2 == 0 ? 1. : -1.);
    }
    cloud.insert(p, n);
  }
  if(number > 0)
  {
    for(std::size_t moved = in.below(4); moved > 0; --moved)
    {
      Point& p = cloud.point(Cloud::Index(in.below(number)));
      if(in.flag())
        p = cloud.point(Cloud::Index(in.below(number)));
      else
        p = p + 0.25 * Vector(in.between(-4, 4), in.between(-4, 4), in.between(-4, 4));
    }
  }
  const double ratio = needle_ratio(in), unit = unit_of_length(in);
  trace("cloud", number);
  for(const auto& i : cloud)
  {
    const Point p = cloud.point(i);
    cloud.point(i) = Point(unit * p.x(), unit * ratio * p.y(), unit * p.z());
    const Point q = cloud.point(i);
    const Vector n = cloud.normal(i);
    trace(" ", q.x(), q.y(), q.z(), n.x(), n.y(), n.z());
  }
  return cloud;
}

// ---------------------------------------------------------------------------- sizes, locations

inline std::size_t size_of(const Mesh& mesh) { return mesh.number_of_vertices(); }
inline std::size_t size_of(const Cloud& cloud) { return cloud.size(); }
inline Point point_of(const Mesh& mesh, Mesh::Vertex_index v) { return mesh.point(v); }
inline Point point_of(const Cloud& cloud, Cloud::Index i) { return cloud.point(i); }
inline Mesh::Vertex_index vertex_of(const Mesh&, std::size_t i)
{
  return Mesh::Vertex_index(Mesh::size_type(i));
}
inline Cloud::Index vertex_of(const Cloud&, std::size_t i) { return Cloud::Index(i); }

inline double length_of(const Vector& v) { return std::hypot(v.x(), v.y(), v.z()); }

// The sizes to which round-off errors are relative.
struct Scale
{
  double diameter = 0.;  // of the bounding box
  double magnitude = 0.; // the maximum absolute coordinate
};

template <typename Surface>
Scale scale_of(const Surface& surface)
{
  Scale scale;
  std::array<double, 3> low = {infinity, infinity, infinity},
                        high = {-infinity, -infinity, -infinity};
  for(std::size_t i = 0; i < size_of(surface); ++i)
    for(int k = 0; k < 3; ++k)
    {
      const double x = point_of(surface, vertex_of(surface, i))[k];
      low[k] = std::min(low[k], x);
      high[k] = std::max(high[k], x);
      scale.magnitude = std::max(scale.magnitude, std::abs(x));
    }
  if(size_of(surface) > 0)
    scale.diameter = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  return scale;
}

// Returns whether a triangle is a needle or a cap whose height is below 1e-7 of its longest edge,
// so that half of the digits are lost. The triangles of a cloud are unknown.
inline bool has_needles(const Mesh& mesh)
{
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const Vector a = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                 b = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.source(h));
    const double longest = std::max({length_of(a), length_of(b), length_of(b - a)});
    if(!(length_of(CGAL::cross_product(a / longest, b / longest)) > 1e-7))
      return true;
  }
  return false;
}
inline bool has_needles(const Cloud&) { return true; }

template <typename Surface>
auto random_vertex(Bytes& in, const Surface& surface)
{
  const std::size_t i = in.below(size_of(surface));
  trace("  vertex", i);
  return vertex_of(surface, i);
}

// Returns a location in a face, often on an edge or at a corner. The mesh has a face.
inline GP::Location<Mesh> random_location(Bytes& in, const Mesh& mesh)
{
  const std::size_t face = in.below(mesh.number_of_faces());
  const std::array<int, 3> weights = {in.between(0, 3), in.between(0, 3), in.between(0, 3)};
  const int sum = weights[0] + weights[1] + weights[2];
  GP::Location<Mesh> location(Mesh::Face_index(Mesh::size_type(face)), {1., 0., 0.});
  if(sum > 0)
    for(int k = 0; k < 3; ++k)
      location.second[k] = double(weights[k]) / sum;
  trace("  location", face, location.second[0], location.second[1], location.second[2]);
  return location;
}
inline GP::Location<Cloud> random_location(Bytes& in, const Cloud& cloud)
{
  GP::Location<Cloud> location;
  location.surfel = random_vertex(in, cloud);
  const double unit = 0.02 * scale_of(cloud).diameter;
  location.offset = {unit * in.between(-2, 2), unit * in.between(-2, 2)};
  trace("  offset", location.offset[0], location.offset[1]);
  return location;
}
inline bool has_locations(const Mesh& mesh) { return mesh.number_of_faces() > 0; }
inline bool has_locations(const Cloud& cloud) { return cloud.size() > 0; }

// Returns whether a location has the null face, which stands for a vertex without faces.
inline bool is_isolated(const GP::Location<Mesh>& location)
{
  return location.first == Mesh::null_face();
}
inline bool is_isolated(const GP::Location<Cloud>&) { return false; }

// Returns whether a location is a vertex or a surfel.
inline bool is_at_vertex(const GP::Location<Mesh>& location)
{
  return *std::max_element(location.second.begin(), location.second.end()) == 1.;
}
inline bool is_at_vertex(const GP::Location<Cloud>& location)
{
  return location.offset == std::array<double, 2>{0., 0.};
}

// Checks that a location is on the surface: domain.point() refuses other ones.
template <typename Domain, typename Location>
void require_valid(const Domain& domain, const Location& location)
{
  if(is_isolated(location))
    return;
  const Point p = domain.point(location);
  require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
          "points of locations are finite");
}

// Checks a path: valid locations, a length that is not below the straight distance of its ends.
template <typename Domain, typename Path>
void require_valid_path(const Domain& domain, const Path& path, double tolerance)
{
  require(path.locations.size() == path.points.size(), "each location of a path has a point");
  if(path.empty())
    return;
  for(std::size_t i = 0; i < path.points.size(); ++i)
  {
    require_valid(domain, path.locations[i]);
    // On a cloud, a location is the projection of the point to a tangent plane.
    if(std::is_same_v<typename Domain::Surface, Mesh> && !is_isolated(path.locations[i]))
      require_at_most(length_of(path.points[i] - domain.point(path.locations[i])), 0., tolerance,
                      "the points of a path are those of its locations");
  }
  double length = 0.;
  for(std::size_t i = 1; i < path.points.size(); ++i)
    length += length_of(path.points[i] - path.points[i - 1]);
  require_at_most(length_of(path.points.back() - path.points.front()), path.length, tolerance,
                  "a path is not shorter than the straight line between its ends");
  require_at_most(path.lower, path.length, tolerance, "lower bounds are below the length");
  require_near(path.length, length, tolerance, "the length is that of the polyline");
}

// Runs a test on a surface. Where it does not expect that a method refuses the surface, for example
// because exact distances need too many windows, the test ends.
template <typename Test, typename Domain, typename Surface>
void run_test(Bytes& in, const Domain& domain, const Surface& surface)
{
  try
  {
    Test(in, domain, surface).run();
  }
  catch(const GP::Unsupported_surface_error& error)
  {
    trace(error.what());
  }
}

// Runs Test<Cloud> on a random cloud for one of `period` inputs, otherwise Test<Mesh> on the mesh
// of a random soup. `domain_of` returns the domain of a soup.
template <template <typename> class Test, typename Domain_of>
void run_on_random_surface(Bytes& in, std::size_t period, std::size_t max_surfels,
                           std::size_t max_triangles, const Domain_of& domain_of)
{
  if(in.below(period) == period - 1)
  {
    const Cloud cloud = random_cloud(in, max_surfels);
    if(cloud.size() > 0)
      run_test<Test<Cloud>>(in, GP::make_domain(cloud), cloud);
    return;
  }
  // Most edges can be too short.
  std::optional<GP::Soup_domain<Point>> domain;
  const Soup soup = random_soup(in, max_triangles);
  if(accepts([&] { domain.emplace(domain_of(soup)); }))
    run_test<Test<Mesh>>(in, *domain, domain->mesh());
}

} // namespace fuzz

#endif // GEODESIC_PROCESSING_FUZZ_LIBRARY_H
