// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_RANDOM_VALUES_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_RANDOM_VALUES_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>
#include <random>

namespace CGAL::Geodesic_processing::test {

// Returns uniformly distributed random numbers between -1 and 1.
inline internal::Vector random_function(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1., 1.);
  internal::Vector result(n);
  for(double& x : result)
    x = value(random);
  return result;
}

inline internal::Field random_field(std::size_t n, unsigned seed)
{
  const internal::Vector values = random_function(2 * n, seed);
  internal::Field result(n);
  for(std::size_t f = 0; f < n; ++f)
    result[f] = {values[2 * f], values[2 * f + 1]};
  return result;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_RANDOM_VALUES_H
