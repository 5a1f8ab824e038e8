// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Surfel_domain.h>

#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>
#include <CGAL/Geodesic_processing/geodesic_path.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>

#include <boost/property_map/function_property_map.hpp>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <forward_list>
#include <limits>

namespace Surfel_domain_test {

// Indices of points that are stored elsewhere, so that their kernel must be named.
struct Index_range : std::vector<std::size_t>
{};

} // namespace Surfel_domain_test

template <>
struct CGAL::Geodesic_processing::Surfel_kernel<Surfel_domain_test::Index_range>
{
  using type = CGAL::Simple_cartesian<float>;
};

namespace Surfel_domain_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());

Point_set point_set_of(const Surfels& surfels)
{
  Point_set result(true);
  for(const auto& [point, normal] : surfels)
    result.insert(point, normal);
  return result;
}

TEST(Surfel_domain, represents_range)
{
  const Surfels surfels = sphere_surfels(3);
  const GP::Surfel_domain<Surfels> domain(surfels, maps);
  ASSERT_EQ(domain.number_of_vertices(), surfels.size());
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    EXPECT_EQ(domain.vertex(domain.index(i)), i);
    EXPECT_LT(CGAL::squared_distance(domain.point(domain.inner_vertex(i)), surfels[i].first),
              1e-28); // squared round-off errors of coordinates near 1
  }
}

TEST(Surfel_domain, represents_point_set)
{
  const Surfels surfels = sphere_surfels(3);
  Point_set points = point_set_of(surfels);
  const GP::Surfel_domain<Point_set> domain(points);
  ASSERT_EQ(domain.number_of_vertices(), surfels.size());
  EXPECT_EQ(domain.triangles()->length,
            GP::Surfel_domain<Surfels>(surfels, maps).triangles()->length);
  auto map = points.add_property_map<double>("value").first;
  domain.write([](GP::internal::Index i) { return 2. * i; }, map);
  for(const auto& index : points)
  {
    EXPECT_EQ(domain.vertex(domain.index(index)), index);
    EXPECT_EQ(map[index], 2. * domain.index(index));
  }
}

TEST(Surfel_domain, skips_removed_points)
{
  Point_set points = point_set_of(sphere_surfels(3));
  for(int i = 10; i < 30; ++i)
    points.remove(points.begin() + i);
  ASSERT_TRUE(points.has_garbage());
  const GP::Surfel_domain<Point_set> domain(points);
  EXPECT_EQ(domain.number_of_vertices(), points.size());
  for(const auto& index : points)
  {
    EXPECT_EQ(domain.vertex(domain.index(index)), index);
    // The square of a few round-off errors.
    EXPECT_LT(CGAL::squared_distance(domain.point(domain.inner_vertex(index)), points.point(index)),
              1e-28);
  }
  for(auto removed = points.garbage_begin(); removed != points.garbage_end(); ++removed)
    EXPECT_THROW(domain.inner_vertex(*removed), GP::Invalid_argument_error);
}

TEST(Surfel_domain, reads_named_property_maps)
{
  // Separate points and normals of an exact kernel, with radii too small to connect surfels.
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::vector<Exact::Point_3> points;
  std::vector<Exact::Vector_3> normals(30 * 30, Exact::Vector_3(0, 0, 5));
  std::vector<double> radii(30 * 30, 1e-3);
  std::vector<std::size_t> range;
  for(int j = 0; j < 30; ++j)
    for(int i = 0; i < 30; ++i)
    {
      points.emplace_back(i, j, 0);
      range.push_back(range.size());
    }
  const auto np = GP::parameters::point_map(CGAL::make_property_map(points))
                      .normal_map(CGAL::make_property_map(normals));
  const GP::Surfel_domain<std::vector<std::size_t>> domain(range, np),
      apart(range, np.radius_map(CGAL::make_property_map(radii)));
  EXPECT_EQ(domain.number_of_vertices(), 900u);
  EXPECT_GT(domain.triangles()->number_of_triangles(), 1600u);
  EXPECT_EQ(apart.triangles()->number_of_triangles(), 0u);
  EXPECT_TRUE(apart.triangles()->graph.target.empty());
}

// The path on a sphere between two surfels has points of the kernel of the range, near the sphere.
template <typename Path>
void expect_float_path(const Path& path)
{
  using Float_point = CGAL::Simple_cartesian<float>::Point_3;
  static_assert(std::is_same_v<typename Path::Point_3, Float_point>);
  ASSERT_GE(path.points.size(), 3u);
  for(const Float_point& point : path.points)
    // Points of fitted spheres, in single precision.
    EXPECT_NEAR(CGAL::to_double(CGAL::squared_distance(point, Float_point(0., 0., 0.))), 1., 1e-6);
}

TEST(Surfel_domain, points_are_of_the_kernel_of_the_range)
{
  using Float_kernel = CGAL::Simple_cartesian<float>;
  std::vector<std::pair<Float_kernel::Point_3, Float_kernel::Vector_3>> surfels;
  std::vector<Float_kernel::Point_3> points;
  std::vector<Float_kernel::Vector_3> normals;
  Index_range range;
  for(const auto& [point, normal] : sphere_surfels(3))
  {
    range.push_back(range.size());
    points.emplace_back(float(point.x()), float(point.y()), float(point.z()));
    normals.emplace_back(float(normal.x()), float(normal.y()), float(normal.z()));
    surfels.emplace_back(points.back(), normals.back());
  }
  using Surfel = decltype(surfels)::value_type;
  const auto pair_maps = GP::parameters::point_map(CGAL::First_of_pair_property_map<Surfel>())
                             .normal_map(CGAL::Second_of_pair_property_map<Surfel>());
  expect_float_path(GP::geodesic_path(surfels, std::size_t(0), std::size_t(100), pair_maps));
  const auto index_maps = GP::parameters::point_map(CGAL::make_property_map(points))
                              .normal_map(CGAL::make_property_map(normals));
  expect_float_path(GP::geodesic_path(range, std::size_t(0), std::size_t(100), index_maps));
}

// Has what the concept SurfelRange requires, and nothing else.
class Surfel_range_archetype
{
public:
  struct Element
  {
    std::size_t row;
  };

  explicit Surfel_range_archetype(std::size_t size)
  {
    for(std::size_t row = size; row-- > 0;)
      m_elements.push_front({row});
  }
  Surfel_range_archetype(const Surfel_range_archetype&) = delete;
  Surfel_range_archetype& operator=(const Surfel_range_archetype&) = delete;
  std::forward_list<Element>::const_iterator begin() const { return m_elements.begin(); }
  std::forward_list<Element>::const_iterator end() const { return m_elements.end(); }

private:
  std::forward_list<Element> m_elements;
};

// Maps elements of the archetype to coordinates that are stored elsewhere.
template <typename Vector>
struct Archetype_map
{
  class Coordinates
  {
  public:
    explicit Coordinates(const Vector& v) : m_vector(v) {}
    double x() const { return m_vector.x(); }
    double y() const { return m_vector.y(); }
    double z() const { return m_vector.z(); }

  private:
    Vector m_vector;
  };
  using key_type = Surfel_range_archetype::Element;
  using value_type = Coordinates;
  using reference = Coordinates;
  using category = boost::readable_property_map_tag;

  const std::vector<Vector>* vectors;

  friend Coordinates get(const Archetype_map& map, const key_type& element)
  {
    return Coordinates((*map.vectors)[element.row]);
  }
};

TEST(Surfel_domain, reads_archetype_of_a_range)
{
  const Surfels surfels = sphere_surfels(2);
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Vector_3> normals;
  for(const auto& [point, normal] : surfels)
  {
    points.push_back(point);
    normals.push_back(normal);
  }
  const Surfel_range_archetype range(surfels.size());
  const GP::Surfel_domain<Surfel_range_archetype> domain(
      range, GP::parameters::point_map(Archetype_map<Kernel::Point_3>{&points})
                 .normal_map(Archetype_map<Kernel::Vector_3>{&normals}));
  ASSERT_EQ(domain.number_of_vertices(), surfels.size());
  EXPECT_EQ(domain.triangles()->length,
            GP::Surfel_domain<Surfels>(surfels, maps).triangles()->length);
  std::vector<double> distances(surfels.size());
  GP::geodesic_distances(domain, std::size_t(0), CGAL::make_property_map(distances));
  EXPECT_EQ(distances[0], 0.);
  EXPECT_NEAR(*std::max_element(distances.begin(), distances.end()), pi, 0.1); // coarse surfels
}

TEST(Surfel_domain, locations_round_trip)
{
  const Surfels surfels = flat_surfels(2000);
  const GP::Surfel_domain<Surfels> domain(surfels, maps);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> offset(-1e-5, 1e-5); // within the one-ring
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const auto p = surfels[i].first;
    if(p.x() < 0.1 || p.x() > 0.9 || p.y() < 0.1 || p.y() > 0.9)
      continue;
    const GP::Location<Surfels> location{i, {offset(random), offset(random)}};
    const auto inner = domain.inner(location);
    const auto again = domain.inner(domain.outer(inner));
    // In a plane, conversion back and forth yields the same point, possibly in another surfel's
    // plane.
    EXPECT_LT(CGAL::squared_distance(domain.point(inner), domain.point(again)), 1e-26);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(domain.point(inner), p)),
                std::hypot(location.offset[0], location.offset[1]), 1e-12);
  }
}

TEST(Surfel_domain, returns_points_and_axes_of_locations)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    // Squares of a few round-off errors.
    const double squared_error = 1e-28;
    Surfels surfels = sphere_surfels(2);
    for(auto& [point, normal] : surfels)
    {
      point = CGAL::ORIGIN + scale * (point - CGAL::ORIGIN);
      normal = 3. * normal;
    }
    const GP::Surfel_domain<Surfels> domain(surfels, maps);
    const GP::Surface_locator<Surfels> locate(domain);
    for(std::size_t i = 0; i < surfels.size(); ++i)
    {
      const auto& [point, normal] = surfels[i];
      const auto [u, v] = domain.axes(i);
      // A few round-off errors.
      EXPECT_NEAR(u.squared_length(), 1., 1e-14);
      EXPECT_NEAR(v.squared_length(), 1., 1e-14);
      EXPECT_NEAR((CGAL::cross_product(u, v) - normal / 3.).squared_length(), 0., squared_error);
      const double x = 0.01 * scale, y = -0.02 * scale;
      EXPECT_LT(CGAL::squared_distance(domain.point({i, {x, y}}), point + x * u + y * v),
                squared_error * scale * scale);
      // The location of a point is its projection to the tangent plane.
      const auto above = point + x * u + y * v + 0.1 * x * normal;
      const auto location = locate(above);
      EXPECT_EQ(location.surfel, i);
      EXPECT_LT(CGAL::squared_distance(domain.point(location), point + x * u + y * v),
                squared_error * scale * scale);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(domain.point({0, {nan, 0.}}), GP::Invalid_argument_error);
    EXPECT_THROW(domain.point({surfels.size(), {0., 0.}}), GP::Invalid_argument_error);
    EXPECT_THROW(domain.axes(surfels.size()), GP::Invalid_argument_error);
  }
}

TEST(Surfel_domain, result_is_independent_of_threads)
{
  const Surfels surfels = sphere_surfels(4);
  const auto one = GP::make_domain(surfels, maps).triangles();
  for(const auto& several :
      {GP::make_domain<CGAL::Parallel_tag>(surfels, maps).triangles(),
       GP::make_domain<CGAL::Parallel_tag>(surfels, maps.number_of_threads(3u)).triangles(),
       GP::Surfel_domain<Surfels>(surfels, maps.number_of_threads(3u)).triangles()})
  {
    EXPECT_EQ(one->corner, several->corner);
    EXPECT_EQ(one->length, several->length);
    EXPECT_EQ(one->graph.target, several->graph.target);
  }
}

template <typename T>
std::size_t bytes_of(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

TEST(Surfel_domain, uses_about_260_bytes_per_surfel)
{
  const Surfels surfels = sphere_surfels(5);
  const GP::Surfel_domain<Surfels> domain(surfels, maps);
  const auto& t = *domain.triangles();
  const auto& s = domain.surfels();
  const std::size_t bytes =
      bytes_of(t.corner) + bytes_of(t.twin) + bytes_of(t.length) + bytes_of(t.ring_begin) +
      bytes_of(t.ring) + bytes_of(t.weight) + bytes_of(t.graph.begin) + bytes_of(t.graph.target) +
      bytes_of(t.graph.length) + bytes_of(t.point) + bytes_of(t.normal) + bytes_of(s.radius) +
      bytes_of(s.internal_vertex) + bytes_of(s.caller_vertex);
  // The tree of points, which is not counted here, takes 8 to 16 bytes of the documented 260.
  EXPECT_LE(bytes, 250 * surfels.size());
}

void expect_equal(const GP::Surfel_domain<Surfels>& a, const GP::Surfel_domain<Surfels>& b)
{
  const GP::internal::Surfel_arrays &s = a.surfels(), &t = b.surfels();
  EXPECT_EQ(s.arrays.origin, t.arrays.origin);
  EXPECT_EQ(s.arrays.scale, t.arrays.scale);
  EXPECT_EQ(s.arrays.point, t.arrays.point);
  EXPECT_EQ(s.arrays.normal, t.arrays.normal);
  EXPECT_EQ(s.arrays.corner, t.arrays.corner);
  EXPECT_EQ(s.arrays.length, t.arrays.length);
  EXPECT_EQ(s.arrays.weight, t.arrays.weight);
  EXPECT_EQ(s.arrays.graph.begin, t.arrays.graph.begin);
  EXPECT_EQ(s.arrays.graph.target, t.arrays.graph.target);
  EXPECT_EQ(s.radius, t.radius);
  EXPECT_EQ(s.internal_vertex, t.internal_vertex);
  EXPECT_EQ(s.caller_vertex, t.caller_vertex);
}

TEST(Surfel_domain, is_built_again_from_its_frame_without_round_off_errors)
{
  using Domain = GP::Surfel_domain<Surfels>;
  Surfels surfels = sphere_surfels(3);
  surfels.insert(surfels.end(), surfels.begin(), surfels.begin() + 20); // coincident surfels
  for(auto& [point, normal] : surfels)
  {
    point = Kernel::Point_3(0.1 + 0.37 * point.x(), 5.3 + 0.37 * point.y(), 0.37 * point.z() - 3.7);
    normal = 3. * normal;
  }
  const auto again = [&](const Domain& domain)
  { return Domain(surfels, domain.framed_surfels(), GP::parameters::number_of_threads(2u)); };
  const Domain domain(surfels, maps);
  expect_equal(again(domain), domain);
  expect_equal(again(again(domain)), domain);
  const auto radius = boost::make_function_property_map<Surfels::value_type>(
      [](const Surfels::value_type& surfel) { return 0.02 + 0.01 * surfel.first.x(); });
  const Domain with_radii(surfels, maps.radius_map(radius));
  expect_equal(again(with_radii), with_radii);
}

TEST(Surfel_domain, throws_on_invalid_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Point_set without_normals;
  without_normals.insert(Kernel::Point_3(0., 0., 0.));
  EXPECT_THROW(GP::Surfel_domain<Point_set>{without_normals}, GP::Unsupported_surface_error);
  const auto domain_of = [](const Surfels& surfels)
  { return GP::Surfel_domain<Surfels>(surfels, maps); };
  Surfels surfels = flat_surfels(20);
  surfels[3].first = Kernel::Point_3(0., nan, 0.);
  EXPECT_THROW(domain_of(surfels), GP::Invalid_argument_error);
  surfels = flat_surfels(20);
  surfels[3].second = Kernel::Vector_3(0., 0., 0.);
  EXPECT_THROW(domain_of(surfels), GP::Invalid_argument_error);
  surfels = flat_surfels(20);
  for(const double bad : {-1., nan, std::numeric_limits<double>::infinity()})
  {
    const auto radius = boost::make_function_property_map<Surfels::value_type>(
        [=](const Surfels::value_type&) { return bad; });
    EXPECT_THROW((GP::Surfel_domain<Surfels>(surfels, maps.radius_map(radius))),
                 GP::Invalid_argument_error);
  }
  const auto domain = domain_of(surfels);
  EXPECT_THROW(domain.inner_vertex(20), GP::Invalid_argument_error);
  EXPECT_THROW(domain.inner({20, {0., 0.}}), GP::Invalid_argument_error);
  EXPECT_THROW(domain.inner({3, {nan, 0.}}), GP::Invalid_argument_error);
}

TEST(Surfel_domain, accepts_empty_cloud_and_single_surfels)
{
  EXPECT_EQ(GP::Surfel_domain<Surfels>(Surfels(), maps).number_of_vertices(), 0u);
  EXPECT_EQ(GP::Surfel_domain<Surfels>(flat_surfels(1), maps).number_of_vertices(), 1u);
}

} // namespace Surfel_domain_test
