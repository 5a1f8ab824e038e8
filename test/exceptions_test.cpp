// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>

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
  EXPECT_THROW(throw File_error("matrix.npy: it cannot be written."), std::runtime_error);
  EXPECT_FALSE((std::is_base_of_v<Invalid_argument_error, Unsupported_surface_error>));
}

// Code that handles all errors of the package does not take a cancellation for one of them.
TEST(Exceptions, cancelled_is_no_runtime_error)
{
  EXPECT_TRUE((std::is_base_of_v<std::exception, Cancelled>));
  EXPECT_FALSE((std::is_base_of_v<std::runtime_error, Cancelled>));
  EXPECT_FALSE(std::string(Cancelled().what()).empty());
}

} // namespace exceptions_test
