// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FIELD_VECTORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FIELD_VECTORS_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

// Conversions between vectors in the planes of unfolded triangles and vectors in space.
namespace CGAL::Geodesic_processing::internal {

// Writes a vector per face of a mesh, or per surfel of a cloud the mean over its triangles.
template <typename Domain, typename VectorMap>
void write_vectors(const Domain& domain, const Field& field, VectorMap map)
{
  using Vector_3 = typename Domain::Vector_3;
  const Surface_arrays& t = *domain.triangles();
  const auto outer = [](const Vec3& v) { return Vector_3(v[0], v[1], v[2]); };
  if constexpr(!Is_cloud<typename Domain::Surface>::value)
    for(Index f = 0; f < t.number_of_triangles(); ++f)
      put(map, domain.face(f), outer(in_space(t, f, field[f])));
  else
    domain.write(
        [&](Index v)
        {
          Vec3 sum = {0., 0., 0.};
          const Index begin = t.ring_begin[v], end = t.ring_begin[v + 1];
          for(Index i = begin; i < end; ++i)
            sum = sum + in_space(t, t.ring[i] / 3, field[t.ring[i] / 3]);
          return outer(end > begin ? (1. / double(end - begin)) * sum : sum);
        },
        map);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FIELD_VECTORS_H
