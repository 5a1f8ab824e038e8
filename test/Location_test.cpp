// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Location.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <list>
#include <tuple>
#include <utility>
#include <vector>

namespace Location_test {

namespace GP = CGAL::Geodesic_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using Points = std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>>;

TEST(Location, distinguishes_meshes_from_clouds)
{
  EXPECT_FALSE(GP::internal::Is_cloud<Mesh>::value);
  EXPECT_FALSE(GP::internal::Is_cloud<Polyhedron>::value);
  EXPECT_TRUE(GP::internal::Is_cloud<Point_set>::value);
  EXPECT_TRUE(GP::internal::Is_cloud<Points>::value);
}

TEST(Location, is_face_location_on_meshes)
{
  EXPECT_TRUE((std::is_same_v<GP::Location<Mesh>,
                              CGAL::Polygon_mesh_processing::Face_location<Mesh, double>>));
  EXPECT_TRUE((std::is_same_v<GP::Location<Polyhedron>,
                              CGAL::Polygon_mesh_processing::Face_location<Polyhedron, double>>));
}

TEST(Location, is_surfel_and_offset_on_clouds)
{
  EXPECT_TRUE((std::is_same_v<decltype(GP::Location<Point_set>::surfel), Point_set::Index>));
  EXPECT_TRUE((std::is_same_v<decltype(GP::Location<Points>::surfel), std::size_t>));
  const GP::Location<Points> location{3};
  EXPECT_EQ(location.offset, (std::array<double, 2>{0., 0.}));
}

template <typename Range>
using Kernel_of = typename GP::Surfel_kernel<Range>::type;
using Float_kernel = CGAL::Simple_cartesian<float>;

struct Scanned_surfel
{
  using R = Float_kernel;
  R::Point_3 point;
};

TEST(Location, kernel_of_range_is_that_of_its_elements)
{
  using Float_point = Float_kernel::Point_3;
  EXPECT_TRUE((std::is_same_v<Kernel_of<Points>, Kernel>));
  EXPECT_TRUE((std::is_same_v<Kernel_of<std::vector<Float_point>>, Float_kernel>));
  EXPECT_TRUE((std::is_same_v<Kernel_of<std::list<std::tuple<Float_point, int>>>, Float_kernel>));
  EXPECT_TRUE((std::is_same_v<Kernel_of<std::vector<Scanned_surfel>>, Float_kernel>));
  using Traits = GP::internal::Surface_traits<std::vector<Scanned_surfel>>;
  EXPECT_TRUE((std::is_same_v<Traits::Vector_3, Float_kernel::Vector_3>));
}

} // namespace Location_test
