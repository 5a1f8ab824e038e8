// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `SurfelRange` describes a cloud of surfels: oriented disks, each with a centre, a unit
normal and a radius.

It is a range of random access (`begin()`, `end()`, `size()`), whose elements are the keys of the
maps that are passed as named parameters:

- `point_map`: a readable property map from the range's elements to `geom_traits::Point_3`. It has a
  default where the range brings its own.
- `normal_map`: a readable property map from the range's elements to `geom_traits::Vector_3`. Normals
  need not have unit length.
- `radius_map`: a readable property map from the range's elements to a floating point number. By
  default radii follow from the distances to near surfels.

A surfel is addressed in sources and results by its position in the range (`std::size_t`), except in
a `CGAL::Point_set_3`, whose own indices and property maps are used.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Point_set_3<Point, Vector>` with normals, for which no map need be passed}
\cgalHasModels{`std::vector<std::pair<Point, Vector>>` with `CGAL::First_of_pair_property_map` and
`CGAL::Second_of_pair_property_map`}
\cgalHasModelsEnd
*/
class SurfelRange
{};
