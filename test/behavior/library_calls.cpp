// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls functions of the library that the program does not cover and prints their results, one
// number per line, in the shortest form that reads back as the same number. compare.sh compiles
// this file against two source trees, so it uses few names and states each method explicitly.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace GP = CGAL::Geodesic_processing;
namespace params = GP::parameters;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Location = std::pair<Face, std::array<double, 3>>;
using Surfels = std::vector<std::pair<Point, Vector>>;
using Point_set = CGAL::Point_set_3<Point, Vector>;
using Callback = std::function<bool(double)>;

namespace {

// ------------------------------------------------------------------------------------- printing

std::string section;

void print(const std::string& name, double value)
{
  char buffer[32];
  const std::string number(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  std::printf("%s: %s %s\n", section.c_str(), name.c_str(), number.c_str());
}

template <typename Number, std::enable_if_t<std::is_integral_v<Number>, int> = 0>
void print(const std::string& name, Number value)
{
  std::printf("%s: %s %s\n", section.c_str(), name.c_str(), std::to_string(value).c_str());
}

template <typename P, typename = decltype(std::declval<P>().z())>
void print(const std::string& name, const P& p)
{
  print(name + " x", p.x());
  print(name + " y", p.y());
  print(name + " z", p.z());
}

void print(const std::string& name, const Location& location)
{
  print(name + " face", std::uint32_t(location.first));
  for(const double coordinate : location.second)
    print(name + " barycentric", coordinate);
}

template <typename Path>
void print_path(const std::string& name, const Path& path)
{
  print(name + " length", path.length);
  print(name + " front_distance", path.front_distance);
  print(name + " points", path.points.size());
  for(const auto& p : path.points)
    print(name, p);
}

// Prints the value and the bounds of a transport.
template <typename Cost>
void print_cost(const std::string& name, const Cost& cost)
{
  print(name + " value", cost.value);
  print(name + " lower", cost.lower);
  print(name + " upper", cost.upper);
  print(name + " residual", cost.residual);
}

template <typename Map>
void print_map(const std::string& name, const Mesh& mesh, const Map& map)
{
  for(const Vertex v : mesh.vertices())
    print(name + ' ' + std::to_string(std::uint32_t(v)), get(map, v));
}

// Returns true if a call reports by its result or by an exception that its callback canceled it.
template <typename Function>
bool is_canceled(const Function& call)
{
  try
  {
    if constexpr(std::is_void_v<std::invoke_result_t<Function>>)
    {
      call();
      return false;
    }
    else
      return !call();
  }
  catch(const std::exception&)
  {
    return true;
  }
}

// ---------------------------------------------------------------------------------------- models

// Returns a sphere with bumps. It has 10 * 4^levels + 2 vertices and the same triangles in each
// build.
Mesh bumpy_sphere(int levels)
{
  Mesh result;
  CGAL::make_icosahedron<Mesh, Point>(result);
  for(int i = 0; i < levels; ++i)
  {
    Mesh finer;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vertex> middles;
    for(const Vertex v : result.vertices())
      finer.add_vertex(result.point(v));
    const auto middle = [&](Vertex a, Vertex b)
    {
      const auto [at, is_new] =
          middles.try_emplace(std::minmax({std::uint32_t(a), std::uint32_t(b)}));
      if(is_new)
        at->second = finer.add_vertex(CGAL::midpoint(result.point(a), result.point(b)));
      return at->second;
    };
    for(const Face f : result.faces())
    {
      const auto h = result.halfedge(f);
      const Vertex a = result.source(h), b = result.target(h), c = result.target(result.next(h));
      const Vertex ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.add_face(a, ab, ca);
      finer.add_face(b, bc, ab);
      finer.add_face(c, ca, bc);
      finer.add_face(ab, bc, ca);
    }
    result = std::move(finer);
  }
  for(const Vertex v : result.vertices())
  {
    const Vector n = result.point(v) - CGAL::ORIGIN;
    const Vector unit = n / std::sqrt(n.squared_length());
    const double bump = std::sin(4. * unit.x() + 1.) * std::cos(3. * unit.y() - 2. * unit.z());
    result.point(v) = CGAL::ORIGIN + (1. + 0.1 * bump) * unit;
  }
  return result;
}

// Returns a square sheet of (n + 1)^2 vertices with a hill and a width of 2.
Mesh hill(int n)
{
  Mesh result;
  CGAL::make_grid(
      n, n, result,
      [n](int i, int j)
      {
        const double x = 2. * i / n - 1., y = 2. * j / n - 1.;
        return Point(x, y, 0.6 * std::exp(-3. * (x * x + y * y)));
      },
      true);
  return result;
}

Mesh torus(int length, int girth)
{
  Mesh result;
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < girth; ++j)
    {
      const double t = 2. * CGAL_PI * i / length, a = 2. * CGAL_PI * j / girth;
      const double r = 1. + 0.4 * std::cos(a);
      result.add_vertex(Point(r * std::cos(t), r * std::sin(t), 0.4 * std::sin(a)));
    }
  const auto at = [&](int i, int j)
  { return Vertex(Mesh::size_type((i % length) * girth + j % girth)); };
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < girth; ++j)
    {
      result.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      result.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return result;
}

// Returns surfels along a spiral on an ellipsoid, from pole to pole.
Surfels ellipsoid(int n, double noise)
{
  Surfels result;
  for(int i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * i + 1.) / n, r = std::sqrt(1. - z * z);
    const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
    const double x = r * std::cos(angle), y = r * std::sin(angle);
    const Vector normal(x / 1.5, y, z / 0.8);
    const Vector unit = normal / std::sqrt(normal.squared_length());
    result.emplace_back(Point(1.5 * x, y, 0.8 * z) + noise * std::sin(1000. * i * i) * unit, unit);
  }
  return result;
}

const auto maps = params::point_map(CGAL::First_of_pair_property_map<Surfels::value_type>())
                      .normal_map(CGAL::Second_of_pair_property_map<Surfels::value_type>());

Location location(Face::size_type face, double a, double b)
{
  return {Face(face), {a, b, 1. - a - b}};
}

// ----------------------------------------------------------------------------------------- calls

template <typename Method>
void distances(const char* name, Mesh& mesh)
{
  section = std::string("distances ") + name;
  using Source = GP::Source<Mesh>;
  const std::vector<Source> sources = {Source(Vertex(3)), Source(location(100, 0.2, 0.3), 0.1),
                                       Source(Vertex(200), 0.05, 7)};
  std::map<Vertex, double> found;
  std::vector<std::size_t> labels(mesh.number_of_vertices());
  const auto label_map = boost::make_iterator_property_map(
      labels.begin(), boost::make_function_property_map<Vertex>(
                          [](Vertex v) { return std::size_t(std::uint32_t(v)); }));
  GP::geodesic_distances<Method>(mesh, sources, boost::make_assoc_property_map(found),
                                 params::source_label_map(label_map));
  print_map("distance", mesh, boost::make_assoc_property_map(found));
  print_map("label", mesh, label_map);
}

void distances_with_speeds(Mesh& mesh)
{
  section = "distances with speeds";
  auto speed = mesh.add_property_map<Vertex, double>("v:speed").first;
  auto found = mesh.add_property_map<Vertex, double>("v:found").first;
  for(const Vertex v : mesh.vertices())
    speed[v] = 1. + 0.5 * std::sin(3. * mesh.point(v).x());
  GP::geodesic_distances<GP::Fast_marching>(mesh, Vertex(17), found, params::speed_map(speed));
  print_map("distance", mesh, found);
}

void solver(const Mesh& mesh)
{
  section = "distance solver";
  GP::Geodesic_distance_solver<Mesh, GP::Euclidean_front> bounded(mesh);
  bounded.compute(Vertex(40), params::maximum_distance(0.7));
  for(const Vertex v : bounded.reached())
    print("reached " + std::to_string(std::uint32_t(v)), bounded.distance(v));
  print_path("path", bounded.path(bounded.reached().back()));

  double last = 0.;
  bool is_rising = true;
  const Callback rising = [&](double fraction)
  {
    is_rising = is_rising && fraction >= last;
    last = fraction;
    return true;
  };
  GP::Geodesic_distance_solver<Mesh, GP::Exact> exact(mesh);
  print("finished",
        !is_canceled([&] { return exact.compute(Vertex(40), params::callback(rising)); }));
  print("rising", is_rising);
  print("last", last);
  print("location", exact.distance(location(50, 0.25, 0.25)));
  print_path("exact path", exact.path(location(50, 0.25, 0.25)));
  const auto departure = exact.departure(Vertex(5));
  print("departure", departure.direction);
  print("polar angle", departure.polar_angle);
  print("canceled", is_canceled(
                        [&] {
                          return exact.compute(
                              Vertex(1), params::callback(Callback([](double) { return false; })));
                        }));
}

void path_finder(const Mesh& mesh)
{
  section = "path finder";
  GP::Geodesic_path_finder<Mesh> find(mesh);
  for(const unsigned to : {1u, 77u, 300u})
    print_path("plain", find(location(200, 0.5, 0.2), Vertex(to)));
  find.add_landmarks(4);
  for(const unsigned to : {1u, 77u, 300u})
    print_path("landmarks", find(Vertex(11), Vertex(to)));
}

void straightest(const Mesh& closed, const Mesh& open)
{
  section = "straightest geodesic";
  print_path("torus",
             GP::straightest_geodesic(closed, location(10, 0.3, 0.4), Vector(1, 2, 1), 9.));
  print_path("hill", GP::straightest_geodesic(open, Vertex(55), Vector(1, 0.3, 0), 10.));
}

void logarithms(Mesh& mesh)
{
  section = "logarithmic map";
  const auto np = params::up_direction(Vector(0.2, 1., 0.3));
  GP::Logarithmic_map<Mesh, GP::Exact> exact(mesh);
  exact.compute(Vertex(220), np.maximum_distance(0.8));
  for(const Vertex v : exact.reached())
  {
    print("exact u", exact(v)[0]);
    print("exact v", exact(v)[1]);
  }
  print("normal", exact.frame().normal());
  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:log", Kernel::Point_2(0., 0.)).first;
  GP::logarithmic_map<GP::Discrete_exponential>(mesh, Vertex(220), uv, np);
  for(const Vertex v : mesh.vertices())
  {
    print("discrete u", uv[v].x());
    print("discrete v", uv[v].y());
  }
  for(const double angle : {0.1, 1.3, 2.9})
    print("exponential", GP::exponential_map(mesh, Vertex(220),
                                             {0.4 * std::cos(angle), 0.4 * std::sin(angle)}, np));
}

void hodge(Mesh& mesh)
{
  section = "hodge decomposition";
  const auto add = [&](const char* name)
  { return mesh.add_property_map<Face, Vector>(name, Vector(0., 0., 0.)).first; };
  auto field = add("f:field"), gradient = add("f:gradient"), rotation = add("f:rotation"),
       harmonic = add("f:harmonic");
  for(const Face f : mesh.faces())
  {
    const Point p = mesh.point(mesh.target(mesh.halfedge(f)));
    field[f] = Vector(-p.y() + p.z(), p.x() * p.x(), 0.3);
  }
  GP::hodge_decomposition(mesh, field, gradient, rotation, harmonic);
  for(const Face f : mesh.faces())
  {
    print("gradient", gradient[f]);
    print("rotation", rotation[f]);
    print("harmonic", harmonic[f]);
  }
}

void curvatures(const Mesh& mesh, const Surfels& surfels)
{
  section = "principal curvatures";
  std::map<Vertex, GP::Principal_curvatures<Mesh>> on_mesh;
  GP::principal_curvatures(mesh, boost::make_assoc_property_map(on_mesh));
  for(const auto& [vertex, here] : on_mesh)
  {
    print("mesh min", here.min_curvature);
    print("mesh max", here.max_curvature);
    print("mesh direction", here.max_direction);
  }
  std::vector<GP::Principal_curvatures<Surfels>> on_cloud(surfels.size());
  GP::principal_curvatures<CGAL::Parallel_tag>(surfels, CGAL::make_property_map(on_cloud), maps);
  for(const auto& here : on_cloud)
  {
    print("cloud min", here.min_curvature);
    print("cloud max", here.max_curvature);
  }
}

void transport_metric(Mesh& mesh)
{
  section = "transport metric";
  const std::vector<Vertex> places = {Vertex(0), Vertex(50), Vertex(100), Vertex(150)};
  auto found = mesh.add_property_map<Vertex, double>("v:transport").first;
  for(const std::size_t k : {0, 12})
  {
    const GP::Transport_metric<Mesh> metric(mesh, k);
    const std::string name = "k " + std::to_string(k);
    print(name + " basis", metric.basis_size());
    print_cost(name, metric.cost(places[0], places[2]));
    const auto matrix = metric.distance_matrix<CGAL::Parallel_tag>(places);
    for(int i = 0; i < matrix.rows(); ++i)
      for(int j = 0; j < matrix.cols(); ++j)
        print(name + " matrix", matrix(i, j));
    metric.write_distances(places[1], found);
    print_map(name + " distance", mesh, found);
  }
}

void streamlines(Mesh& mesh)
{
  section = "streamlines";
  const auto blob = [&mesh](Vertex middle, double width)
  {
    const auto density = [&mesh, middle, width](Vertex v)
    {
      return std::exp(-0.5 * CGAL::squared_distance(mesh.point(v), mesh.point(middle)) /
                      (width * width));
    };
    return GP::mass_density(boost::make_function_property_map<Vertex>(density));
  };
  GP::Earth_movers_solver<Mesh> solver(mesh);
  print_cost("cost", solver.compute(blob(Vertex(60), 0.15), blob(Vertex(370), 0.25),
                                    params::do_normalize(true)));
  auto potential = mesh.add_property_map<Vertex, double>("v:potential").first;
  auto flow = mesh.add_property_map<Face, Vector>("f:flow").first;
  solver.write_potential(potential);
  solver.write_flow(flow);
  print_map("potential", mesh, potential);
  for(const Face f : mesh.faces())
    print("flow", flow[f]);

  const auto trace = solver.streamlines();
  std::vector<GP::Streamline<Mesh>> lines;
  trace(30, std::back_inserter(lines));
  for(const auto& line : lines)
  {
    print_path("line", line);
    print("arrived", line.has_arrived);
  }
  std::vector<std::pair<Location, Location>> pairs;
  trace.assignment(10, std::back_inserter(pairs));
  for(const auto& [from, to] : pairs)
  {
    print("from", from);
    print("to", to);
  }
}

void region(const Mesh& mesh)
{
  section = "transport to a region";
  const std::vector<Vertex> doors = {Vertex(0), Vertex(20), Vertex(440)};
  const std::vector<Vertex> people = {Vertex(210), Vertex(220), Vertex(300)};
  const std::vector<double> capacities = {0.2, 0.5, 0.6};
  GP::Region_transport_solver<Mesh> solver(mesh, doors, params::capacities(capacities));
  print_cost("cost", solver.compute(people));
  for(const Vertex door : doors)
    print("arrival", solver.arrival(door));
  print_map(
      "potential", mesh,
      boost::make_function_property_map<Vertex>([&](Vertex v) { return solver.potential(v); }));
}

void barycenters(const Mesh& mesh)
{
  section = "barycenter";
  const std::vector<Vertex> points = {Vertex(0), Vertex(50), Vertex(101), Vertex(300)};
  const std::vector<double> weights = {1., 2., 0.5, 1.};
  std::map<Vertex, double> objective;
  const auto [where, value] = GP::geodesic_barycenter<GP::Exact>(
      mesh, points,
      params::weights(weights).objective_map(boost::make_assoc_property_map(objective)));
  print("vertex", std::uint32_t(where));
  print("value", value);
  print_map("objective", mesh, boost::make_assoc_property_map(objective));
  const auto mean = GP::karcher_mean(mesh, points, params::weights(weights));
  print("mean", mean.point.x());
  print("mean value", mean.value);
}

void volumes(Mesh& mesh)
{
  section = "volume";
  auto coordinates = mesh.add_property_map<Vertex, double>("v:mean-value").first;
  GP::mean_value_coordinates(mesh, Point(0.1, 0.3, -0.2), coordinates);
  print_map("mean value", mesh, coordinates);
  const GP::Volumetric_metric<Mesh> metric(mesh, params::number_of_refinements(0u));
  const Point p(0.3, 0.1, 0.);
  const std::vector<Point> points = {Point(-0.4, 0.2, 0.1), Point(0., 0., 0.5), Point(2., 0., 0.)};
  for(const auto& cost : metric.costs<CGAL::Parallel_tag>(p, points))
    print_cost("cost", cost);
  std::vector<Point> path;
  print("found", metric.write_path(p, points[0], std::back_inserter(path)));
  for(const Point& q : path)
    print("path", q);
}

void base(Mesh& mesh)
{
  section = "parameterization over a base";
  auto found = mesh.add_property_map<Vertex, GP::Base_location>("v:base").first;
  const auto over = GP::parameterize_over_base(mesh, 20, found);
  print("faces", over.number_of_base_faces());
  print("folds", over.number_of_flips());
  for(const Vertex v : mesh.vertices())
  {
    print("face", found[v].face);
    for(const double coordinate : found[v].barycentric)
      print("barycentric", coordinate);
    print("point", over.point(found[v]));
  }
}

void polyline()
{
  section = "shortened polyline";
  // The obstacle is a unit sphere, given only by its squared distance function.
  std::vector<Point> chain;
  for(int i = 0; i <= 40; ++i)
    chain.emplace_back(std::cos(0.05 * i), std::sin(0.05 * i), 0.3 * std::sin(CGAL_PI * i / 40.));
  const auto squared_distance = [](const Point& p)
  {
    const double distance = std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1.;
    return distance * distance;
  };
  const auto path = GP::shorten_polyline(chain, squared_distance);
  print("length", path.length);
  print("distance", path.distance);
  for(const Point& p : path.points)
    print("point", p);
}

void isolines_and_holes(Mesh mesh)
{
  section = "isolines";
  auto distance = mesh.add_property_map<Vertex, double>("v:source_distance").first;
  GP::geodesic_distances(mesh, Vertex(3), distance);
  std::vector<GP::Isoline<Mesh>> lines;
  GP::isolines(mesh, distance, std::vector<double>{0.2, 0.4}, std::back_inserter(lines),
               params::do_fit_circles(true));
  for(const auto& line : lines)
  {
    print("closed", int(line.is_closed));
    for(const Point& p : line.points)
      print("point", p);
  }
  section = "holes";
  for(const auto method :
      {GP::Hole_filling_method::minimal_dihedral_angles, GP::Hole_filling_method::unfolding})
  {
    Mesh filled = mesh;
    print("faces", GP::fill_holes(filled, params::hole_filling_method(method)).number_of_faces);
    for(const Face f : filled.faces())
      for(const Vertex v : filled.vertices_around_face(filled.halfedge(f)))
        print("corner", std::uint32_t(v));
  }
}

void wavelets(Mesh mesh)
{
  section = "wavelets";
  const GP::Subdivision_wavelet<Mesh> wavelet(mesh);
  GP::Wavelet_details details = wavelet.analyze(mesh.points(), params::do_use_frames(true));
  std::vector<std::uint8_t> stream = wavelet.encode(details);
  print("levels", wavelet.number_of_levels());
  print("bytes", stream.size());
  for(const std::uint8_t byte : stream)
    print("byte", unsigned(byte));
  wavelet.keep_largest(details, mesh.number_of_vertices() / 10);
  wavelet.synthesize(details, mesh.points());
  print_map("tenth", mesh, mesh.points());
  stream.resize(stream.size() / 2);
  Mesh decoded;
  print("planes", GP::decode_wavelets(stream, decoded).number_of_bit_planes);
  print_map("half", decoded, decoded.points());
}

void flattening(Mesh& mesh)
{
  section = "flattening";
  auto uv = mesh.add_property_map<Vertex, Kernel::Point_2>("v:uv").first;
  const auto report = [&](const char* name)
  {
    const GP::Flattening_distortion found = GP::flattening_distortion(mesh, uv);
    print(std::string(name) + " conformal", found.conformal);
    print(std::string(name) + " authalic", found.authalic);
    print(std::string(name) + " flips", found.number_of_flips);
    for(const Vertex v : mesh.vertices())
    {
      print(std::string(name) + " u", uv[v].x());
      print(std::string(name) + " v", uv[v].y());
    }
  };
  GP::geodesic_mds<GP::Euclidean_front>(mesh, uv, params::number_of_base_points(60));
  report("mds");
  GP::geodesic_lle<GP::Euclidean_front>(mesh, uv, params::number_of_base_points(60));
  report("lle");
  GP::minimize_distortion(mesh, uv);
  report("minimum");
}

void samples(Mesh& mesh)
{
  section = "samples";
  std::vector<Location> found;
  std::vector<double> radii;
  double last = 0.;
  const Callback watch = [&](double fraction) { return last = fraction, true; };
  GP::farthest_point_sampling<GP::Euclidean_front>(
      mesh, 40, std::back_inserter(found),
      params::random_seed(3u).covering_radius_output(std::back_inserter(radii)).callback(watch));
  for(const Location& sample : found)
    print("sample", sample);
  for(const double radius : radii)
    print("radius", radius);
  print("last", last);

  section = "Voronoi diagram";
  auto label = mesh.add_property_map<Vertex, std::size_t>("v:label").first;
  auto face_label = mesh.add_property_map<Face, std::size_t>("f:label").first;
  std::vector<GP::Voronoi_bisector<Mesh>> bisectors;
  GP::geodesic_voronoi_diagram<GP::Euclidean_front>(
      mesh, found, label,
      params::face_label_map(face_label).bisector_output(std::back_inserter(bisectors)));
  print_map("label", mesh, label);
  for(const Face f : mesh.faces())
    print("face label", face_label[f]);
  for(const auto& bisector : bisectors)
  {
    print("left", bisector.left);
    print("right", bisector.right);
    for(const Point& p : bisector.points)
      print("bisector", p);
  }
}

void clouds()
{
  section = "clouds";
  const Surfels clean = ellipsoid(2000, 0.), noisy = ellipsoid(2000, 0.01);
  print_path("clean path",
             GP::surfel_geodesic_path(clean, std::size_t(0), std::size_t(1500), maps));
  const GP::Surfel_path_finder<Surfels> find(noisy, maps);
  print("noise", find.noise());
  const std::vector<std::pair<std::size_t, std::size_t>> pairs = {{0, 1999}, {5, 900}, {1, 1000}};
  for(const auto& path : GP::surfel_geodesic_paths<CGAL::Parallel_tag>(find, pairs))
    print_path("noisy path", path);

  Point_set cloud(true);
  for(const auto& [point, normal] : clean)
    cloud.insert(point, normal);
  auto found = cloud.add_property_map<double>("distance").first;
  GP::geodesic_distances<GP::Euclidean_front>(cloud, *cloud.begin(), found);
  for(const Point_set::Index i : cloud)
    print("distance", found[i]);
}

void exceptions(const Mesh& open)
{
  section = "exceptions";
  std::map<Vertex, double> found;
  const auto map = boost::make_assoc_property_map(found);
  const auto throws = [](const auto& call)
  {
    try
    {
      call();
    }
    catch(const GP::Invalid_argument_error&)
    {
      return 1;
    }
    catch(const GP::Unsupported_surface_error&)
    {
      return 2;
    }
    return 0;
  };
  print("no source",
        throws([&] { GP::geodesic_distances<GP::Exact>(open, std::vector<Vertex>(), map); }));
  print("open", throws([&] { GP::mean_value_coordinates(open, Point(0., 0., 1.), map); }));
  print("negative distance", throws(
                                 [&] {
                                   GP::geodesic_distances<GP::Exact>(open, Vertex(0), map,
                                                                     params::maximum_distance(-1.));
                                 }));
}

} // namespace

int main()
{
  Mesh sphere = bumpy_sphere(3), small_sphere = bumpy_sphere(2), sheet = hill(20);
  Mesh ring = torus(36, 16);
  distances<GP::Dijkstra>("Dijkstra", sphere);
  distances<GP::Fast_marching>("fast marching", sphere);
  distances<GP::Euclidean_front>("Euclidean front", sphere);
  distances<GP::Exact>("exact", sphere);
  distances<GP::Heat>("heat", sphere);
  distances_with_speeds(sheet);
  solver(sphere);
  path_finder(sphere);
  straightest(ring, sheet);
  logarithms(sheet);
  hodge(ring);
  curvatures(sphere, ellipsoid(1000, 0.));
  transport_metric(small_sphere);
  streamlines(sheet);
  isolines_and_holes(sheet);
  region(sheet);
  barycenters(sphere);
  volumes(small_sphere);
  base(sphere);
  polyline();
  wavelets(sphere);
  flattening(sheet);
  samples(sphere);
  clouds();
  exceptions(sheet);
  return 0;
}
