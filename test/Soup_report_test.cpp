// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Soup_report.h>

#include <gtest/gtest.h>

namespace soup_report_test {

using CGAL::Geodesic_processing::Soup_report;

TEST(Soup_report, is_changed_by_each_repair)
{
  EXPECT_FALSE(Soup_report().is_changed());
  for(const auto repair :
      {&Soup_report::number_of_merged_points, &Soup_report::number_of_triangulated_polygons,
       &Soup_report::number_of_degenerate_faces, &Soup_report::number_of_duplicate_triangles,
       &Soup_report::number_of_reversed_triangles, &Soup_report::number_of_split_edges})
  {
    Soup_report report;
    report.*repair = 1;
    EXPECT_TRUE(report.is_changed());
  }
}

TEST(Soup_report, is_manifold_without_split_edges_and_points)
{
  Soup_report report;
  report.number_of_components = 3;
  EXPECT_TRUE(report.is_manifold());
  report.number_of_nonmanifold_points = 1;
  EXPECT_FALSE(report.is_manifold());
  EXPECT_FALSE(report.is_changed()); // the triangles are those of the soup
  report = {};
  report.number_of_split_edges = 1;
  EXPECT_FALSE(report.is_manifold());
}

} // namespace soup_report_test
