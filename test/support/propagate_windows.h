// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PROPAGATE_WINDOWS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PROPAGATE_WINDOWS_H

#include "distances/Window_propagator.h"

#include "Array_surface.h"

namespace CGAL::Geodesic_processing::test {

// Propagates windows from a location until the queue is empty.
inline internal::Window_state propagate_windows(const Array_surface& surface,
                                                const internal::Surface_location& source)
{
  internal::Window_state state(surface.triangles(), internal::find_pseudo_sources(surface.t()));
  internal::Window_propagator propagator(state);
  propagator.start({surface.source(source)});
  while(!state.queue.empty())
    propagator.step();
  return state;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_PROPAGATE_WINDOWS_H
