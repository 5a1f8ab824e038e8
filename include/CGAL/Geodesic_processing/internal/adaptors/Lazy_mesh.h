// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LAZY_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LAZY_MESH_H

#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

// A mesh that is built when it is first used. Several threads may use it.
template <typename Mesh>
class Lazy_mesh
{
public:
  explicit Lazy_mesh(std::function<Mesh()> build) : m_build(std::move(build)) {}

  // Builds the mesh in the first call. If that throws, the next call tries again.
  const Mesh& get() const
  {
    std::call_once(m_is_built,
                   [this]
                   {
                     m_mesh.emplace(m_build());
                     m_build = nullptr; // frees what it captures
                   });
    return *m_mesh;
  }

private:
  mutable std::once_flag m_is_built;
  mutable std::function<Mesh()> m_build;
  mutable std::optional<Mesh> m_mesh;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_LAZY_MESH_H
