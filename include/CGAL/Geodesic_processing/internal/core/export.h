// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXPORT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXPORT_H

// Marks the symbols that a shared library exports. All others are hidden.
#if defined(_WIN32) && defined(CGAL_GEODESIC_PROCESSING_SHARED)
#  ifdef CGAL_GEODESIC_PROCESSING_BUILDING
#    define CGAL_GEODESIC_PROCESSING_EXPORT __declspec(dllexport)
#  else
#    define CGAL_GEODESIC_PROCESSING_EXPORT __declspec(dllimport)
#  endif
#elif defined(__GNUC__)
#  define CGAL_GEODESIC_PROCESSING_EXPORT __attribute__((visibility("default")))
#else
#  define CGAL_GEODESIC_PROCESSING_EXPORT
#endif

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXPORT_H
