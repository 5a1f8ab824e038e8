// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL::Geodesic_processing::internal {

int orientation(const Vec2& p, const Vec2& q, const Vec2& r)
{
  return Epick().orientation_2_object()({p[0], p[1]}, {q[0], q[1]}, {r[0], r[1]});
}

} // namespace CGAL::Geodesic_processing::internal
