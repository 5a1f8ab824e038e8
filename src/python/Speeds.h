// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_SPEEDS_H
#define GEODESIC_PYTHON_SPEEDS_H

#include "python/Surface.h"

#include <optional>

namespace python {

// The speeds of vertices (or surfels), those of faces, or neither.
template <typename Domain>
class Speeds
{
  using Surface_type = Surface<Domain>;
  using Face_speed_map = Number_map<Mesh::Face_index>;

public:
  // Throws Invalid_argument_error if both are given, if an array has another shape, or if speeds of
  // faces are given for a cloud.
  Speeds(const Surface_type& surface, const py::object& speed, const py::object& face_speed)
      : m_of_vertices(surface.vertex_speeds(speed))
  {
    if(face_speed.is_none())
      return;
    if(Surface_type::is_cloud)
      reject("A cloud has no faces; pass speeds of surfels as speed.");
    if(m_of_vertices)
      reject("speed and face_speed cannot be combined.");
    m_of_faces.emplace(face_speed, "face_speed", Shape{py::ssize_t(surface.number_of_faces())});
  }

  // Adds the speeds to named parameters. Speeds that are not given are empty optionals, so that
  // functions are compiled once. This object must remain until the function returns.
  template <typename NamedParameters>
  auto add_to(const NamedParameters& np) const
  {
    const auto result = np.speed_map(Surface_type::speed_map(m_of_vertices));
    if constexpr(Surface_type::is_cloud)
      return result;
    else
      return result.face_speed_map(m_of_faces ? std::optional(Face_speed_map{&*m_of_faces})
                                              : std::nullopt);
  }

private:
  std::optional<Numbers> m_of_vertices, m_of_faces;
};

} // namespace python

#endif // GEODESIC_PYTHON_SPEEDS_H
