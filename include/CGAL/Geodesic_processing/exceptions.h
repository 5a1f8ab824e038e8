// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
#define CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H

#include <stdexcept>

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingErrors
/// @{

/// is thrown when an argument cannot be used: an empty range of sources, a negative distance,
/// a coordinate that is not a number.
class Invalid_argument_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// is thrown when a surface cannot be treated by the method asked for: faces that are not
/// triangles, more than 2<SUP>31</SUP> half-edges, a cloud where a manifold is needed.
class Unsupported_surface_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
