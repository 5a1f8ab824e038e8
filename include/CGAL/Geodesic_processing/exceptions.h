// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
#define CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H

#include <exception>
#include <stdexcept>

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingErrors
/// @{

/// Thrown if an argument is invalid, for example an empty range of sources, a negative distance
/// or a coordinate that is not finite. It is derived from `std::runtime_error`.
class Invalid_argument_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown if a method cannot process a surface. Examples are faces that are not triangles, more
/// than 2<SUP>31</SUP> halfedges, or a cloud if a manifold is needed. It is derived from
/// `std::runtime_error`.
class Unsupported_surface_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown if a file cannot be read or written, or if its content is not what the function needs. The
/// message begins with the name of the file. It is derived from `std::runtime_error`.
class File_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Thrown by each function whose named parameter `callback` returns false.
///
/// Property maps, output iterators and graphs that the function would have written are unchanged.
/// A solver can be used again; its documentation states which results are valid. If the function
/// uses several threads, the exception is thrown in the thread that called it, after the others
/// have ended.
class Cancelled : public std::exception
{
public:
  /// Returns a sentence that states the reason. O(1).
  const char* what() const noexcept override { return "The callback canceled the computation."; }
};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
