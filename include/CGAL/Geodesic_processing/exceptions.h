// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
#define CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H

#include <stdexcept>

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingErrors
/// @{

/// is thrown if an argument is invalid, for example an empty range of sources, a negative distance
/// or a coordinate that is not a number.
class Invalid_argument_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// is thrown if a method cannot process a surface. Examples are faces that are not triangles, more
/// than 2<SUP>31</SUP> halfedges, or a cloud if a manifold is needed.
class Unsupported_surface_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EXCEPTIONS_H
