// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/feature_sampling.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace feature_sampling_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Feature_sampling, default_spacing_is_divided_by_slowness)
{
  const Array_surface arrays(square(4));
  Remeshing_options options;
  options.slowness =
      std::make_shared<const std::vector<double>>(arrays.t().number_of_triangles(), 2.);
  const Refined_surface surface(arrays.triangles(), options);
  const std::vector<double> spacing = feature_spacing(surface, 0.5, {});
  ASSERT_EQ(spacing.size(), arrays.t().corner.size());
  for(Index h = 0; h < spacing.size(); ++h)
    EXPECT_EQ(spacing[h], arrays.t().twin[h] == none ? 0.25 : 0.);
}

TEST(Feature_sampling, requested_spacing_is_converted_to_refined_scale)
{
  const Array_surface arrays(square(4));
  Refined_surface surface(arrays.triangles(), {});
  surface.split(std::vector<bool>(arrays.t().corner.size(), true));
  const std::vector<double> requested(arrays.t().corner.size(), 0.125);
  const std::vector<double> spacing = feature_spacing(surface, 0.5, requested);
  for(Index h = 0; h < spacing.size(); ++h)
    EXPECT_EQ(surface.unit_size() * spacing[h], surface.is_feature()[h] ? 0.125 : 0.);
}

TEST(Feature_sampling, infinite_spacing_becomes_finite)
{
  const Array_surface arrays(square(4));
  const Refined_surface surface(arrays.triangles(), {});
  for(const double spacing : feature_spacing(surface, infinity, {}))
    EXPECT_LT(spacing, infinity);
}

TEST(Feature_sampling, number_requested_is_length_divided_by_spacing)
{
  const Array_surface arrays(square(4));
  const Refined_surface surface(arrays.triangles(), {});
  const double unit = arrays.scale();
  EXPECT_EQ(number_requested_on_features(surface, {}), 0u);
  // The boundary has length 4.
  EXPECT_EQ(number_requested_on_features(
                surface, std::vector<double>(arrays.t().corner.size(), 0.25 / unit)),
            16u);
}

TEST(Feature_sampling, throws_if_too_many_samples_are_requested)
{
  const Array_surface arrays(square(4));
  const Refined_surface surface(arrays.triangles(), {});
  EXPECT_THROW(
      number_requested_on_features(surface, std::vector<double>(arrays.t().corner.size(), 1e-12)),
      CGAL::Geodesic_processing::Invalid_argument_error);
}

} // namespace feature_sampling_test
