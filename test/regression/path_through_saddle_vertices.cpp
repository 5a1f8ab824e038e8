// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace path_through_saddle_vertices {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A plate of cubes with two holes. Its edges, diagonals and corners lie on common straight lines.
TEST(Path_through_saddle_vertices, is_found)
{
  const Array_surface surface(double_torus(3));
  const Surface_arrays& t = surface.t();
  Window_propagation windows(surface.triangles());
  for(const Index from : {Index(0), Index(100), Index(surface.size() / 2)})
  {
    ASSERT_TRUE(windows.run({surface.source(from)}));
    for(const Index vertex : windows.reached())
    {
      const auto path = windows.path(vertex_location(t, vertex)).locations;
      ASSERT_FALSE(path.empty());
      expect_path_on_surface(t, path, vertex_location(t, vertex), surface.at(from));
      EXPECT_NEAR(path_length(t, path), windows.distance(vertex), 1e-12); // some tens of faces
    }
  }
}

} // namespace path_through_saddle_vertices
