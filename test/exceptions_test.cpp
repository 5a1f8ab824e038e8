// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <string>

namespace exceptions_test {

using namespace CGAL::Geodesic_processing;

TEST(Exceptions, are_runtime_errors_with_message)
{
  try
  {
    throw Invalid_argument_error("There is no source.");
  }
  catch(const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()), "There is no source.");
  }
  EXPECT_THROW(throw Unsupported_surface_error("A face is not a triangle."), std::runtime_error);
  EXPECT_FALSE((std::is_base_of_v<Invalid_argument_error, Unsupported_surface_error>));
}

} // namespace exceptions_test
