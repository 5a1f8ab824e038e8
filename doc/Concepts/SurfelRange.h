// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgGeodesicProcessingConcepts
\cgalConcept

The concept `SurfelRange` describes a cloud of surfels. A surfel is an oriented disk with a center, a
unit normal and a radius.

A model has the const member functions `begin()` and `end()`, which return forward iterators. It need
not be copyable. Its elements are of any type. They are the keys of the property maps that are passed as
named parameters:

- `point_map`: a readable property map whose values have the member functions `x()`, `y()` and `z()`, of
  which `CGAL::to_double()` is a finite number. The default is the point map of a `CGAL::Point_set_3`, or
  otherwise the identity.
- `normal_map`: a readable property map with the same members. Normals can have any positive length.
  This map must be passed, unless the range is a `CGAL::Point_set_3` with normals.
- `radius_map`: a readable property map whose values convert to `double`. If it is not passed, radii are
  computed from the distances to neighboring surfels.

The range and the maps are read when a domain is constructed. Afterwards they can be changed or
destroyed.

The elements are the keys of these three maps only. In sources, results and all other property maps, the
position of a surfel in the range (`std::size_t`) represents it. A map of a vector with one value for each
surfel, as `CGAL::make_property_map()` returns it, is therefore a speed map or an output map. If the range
is a `CGAL::Point_set_3`, its own indices represent the surfels. Computed points and vectors are of the
kernel of the elements. If the elements have none, it is named by
`CGAL::Geodesic_processing::Surfel_kernel`.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Point_set_3<Point, Vector>` with normals, for which no map must be passed}
\cgalHasModels{`std::vector<std::pair<Point, Vector>>` with `CGAL::First_of_pair_property_map` and
`CGAL::Second_of_pair_property_map`}
\cgalHasModelsEnd
*/
class SurfelRange
{};
