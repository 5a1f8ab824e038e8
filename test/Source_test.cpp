// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Source.h>

#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <limits>

namespace Source_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Source = GP::Source<Mesh>;

TEST(Source, is_constructed_from_vertex_location_or_polyline)
{
  const Mesh::Vertex_index vertex(3);
  const GP::Location<Mesh> location(Mesh::Face_index(2), {0.25, 0.25, 0.5});
  const Source vertex_source(vertex), location_source(location, 0.25, 3),
      line(Source::Polyline{location, location}, -1.);
  EXPECT_EQ(std::get<Mesh::Vertex_index>(vertex_source.location()), vertex);
  EXPECT_EQ(vertex_source.offset(), 0.);
  EXPECT_EQ(vertex_source.label(17), 17u); // the default label is the index in the range
  EXPECT_EQ(std::get<Source::Polyline>(location_source.location()), Source::Polyline{location});
  EXPECT_EQ(location_source.offset(), 0.25);
  EXPECT_EQ(location_source.label(17), 3u);
  EXPECT_EQ(std::get<Source::Polyline>(line.location()).size(), 2u);
  EXPECT_EQ(line.offset(), -1.);
}

template <typename TestedMesh>
void expect_border_sources()
{
  const Triangulation shape = annulus(12, 3, 1., 2.);
  Numbered<TestedMesh> mesh;
  fill(mesh, shape);
  std::vector<GP::Source<TestedMesh>> sources;
  GP::border_sources(mesh.mesh, std::back_inserter(sources));
  ASSERT_EQ(sources.size(), 2u);
  std::vector<GP::Source<TestedMesh>> sources_of_domain;
  GP::border_sources(GP::make_domain(mesh.mesh), std::back_inserter(sources_of_domain));
  ASSERT_EQ(sources_of_domain.size(), 2u);
  for(const std::size_t i : {0u, 1u})
    EXPECT_EQ(sources_of_domain[i].location(), sources[i].location());
  for(const auto& border : sources)
  {
    const auto& line = std::get<1>(border.location());
    ASSERT_EQ(line.size(), 13u);
    EXPECT_EQ(line.front(), line.back());
    const double radius = distance(point_of(mesh.mesh, line[0]), {0., 0., 0.});
    EXPECT_TRUE(std::abs(radius - 1.) < 1e-12 || std::abs(radius - 2.) < 1e-12);
    for(std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const Point p = point_of(mesh.mesh, line[i]), q = point_of(mesh.mesh, line[i + 1]);
      // Round-off errors of coordinates below 3.
      EXPECT_NEAR(distance(p, {0., 0., 0.}), radius, 1e-12);
      EXPECT_NEAR(distance(p, q), 2. * radius * std::sin(GP::test::pi / 12.), 1e-12);
      // The next location lies in a common face: on an edge with one halfedge on the boundary.
      const Point middle = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.};
      bool is_edge_midpoint = false;
      for(const auto h : halfedges(mesh.mesh))
        if(CGAL::is_border(h, mesh.mesh))
        {
          const Point a = to_array(get(CGAL::vertex_point, mesh.mesh, source(h, mesh.mesh))),
                      b = to_array(get(CGAL::vertex_point, mesh.mesh, target(h, mesh.mesh)));
          is_edge_midpoint |=
              distance({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.}, middle) < 1e-12;
        }
      EXPECT_TRUE(is_edge_midpoint);
    }
  }
}

TEST(Source, boundary_sources_are_closed_polylines)
{
  expect_border_sources<Mesh>();
  expect_border_sources<CGAL::Polyhedron_3<Kernel>>();
}

TEST(Source, closed_surface_has_no_boundary_sources)
{
  Numbered<Mesh> mesh;
  fill(mesh, tetrahedron());
  std::vector<Source> sources;
  GP::border_sources(mesh.mesh, std::back_inserter(sources));
  EXPECT_TRUE(sources.empty());
}

TEST(Source, throws_on_invalid_sources)
{
  Numbered<Mesh> mesh;
  fill(mesh, square(2));
  const auto domain = GP::make_domain(mesh.mesh);
  std::vector<std::size_t> labels;
  const auto try_source = [&](const Source& source)
  { GP::internal::sources(domain, source, labels); };
  const GP::Location<Mesh> inside(mesh.faces[0], {0.25, 0.25, 0.5});
  EXPECT_NO_THROW(try_source(Source(inside)));
  const double infinity = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(try_source(Source(inside, infinity)), GP::Invalid_argument_error);
  EXPECT_THROW(try_source(Source(inside, nan)), GP::Invalid_argument_error);
  EXPECT_THROW(try_source(Source(Source::Polyline{})), GP::Invalid_argument_error);
  EXPECT_THROW(try_source(Source({mesh.faces[0], {2., -1., 0.}})), GP::Invalid_argument_error);
  EXPECT_THROW(try_source(Source({mesh.faces[0], {nan, 0.5, 0.5}})), GP::Invalid_argument_error);
  // Consecutive locations of a polyline lie in a common face.
  const GP::Location<Mesh> elsewhere(mesh.faces[6], {0.25, 0.25, 0.5});
  EXPECT_THROW(try_source(Source(Source::Polyline{inside, elsewhere})), GP::Invalid_argument_error);
  EXPECT_THROW(try_source(Source(Mesh::null_vertex())), GP::Invalid_argument_error);
  EXPECT_THROW(GP::internal::sources(domain, std::vector<Source>(), labels),
               GP::Invalid_argument_error);
}

} // namespace Source_test
