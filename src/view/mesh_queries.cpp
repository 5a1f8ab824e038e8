// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Surface_queries.h"

#include <CGAL/Geodesic_processing/isolines.h>

namespace view {

namespace {

class Mesh_queries : public Surface_queries<GP::Mesh_domain<Mesh>>
{
public:
  explicit Mesh_queries(const program::Surface& surface)
      : Surface_queries(surface, *surface.domain), m_surface(&surface)
  {}

  std::vector<std::uint32_t> triangles() const override
  {
    std::vector<std::uint32_t> result;
    const std::size_t number_of_faces = m_surface->domain->number_of_faces();
    result.reserve(3 * number_of_faces);
    for(std::size_t f = 0; f < number_of_faces; ++f)
      for(const std::size_t corner :
          m_surface->domain->corners(Mesh::Face_index(static_cast<Mesh::size_type>(f))))
        result.push_back(static_cast<std::uint32_t>(corner));
    return result;
  }

  std::vector<std::vector<Point>> isolines(const std::vector<double>& values,
                                           const std::vector<double>& isovalues) const override
  {
    if(values.size() != number_of_vertices())
      throw GP::Invalid_argument_error("There must be one value for each vertex.");
    std::vector<GP::Isoline<Mesh>> lines;
    GP::isolines(domain(), Value_map<Mesh::Vertex_index>{&values}, isovalues,
                 std::back_inserter(lines), GP::parameters::do_fit_circles(true));
    std::vector<std::vector<Point>> result;
    for(const auto& line : lines)
      result.push_back(coordinates_of(line.points));
    return result;
  }

  Path path(const Place& from, const Place& to, bool is_shortest) override
  {
    if(!m_finder)
      m_finder.emplace(domain());
    return find_path(*m_finder, from, to, is_shortest);
  }

  Cells voronoi(const std::vector<Place>& places, const Callback& callback) const override
  {
    const auto seeds = positions(places);
    Cells result;
    result.labels = labels(seeds, callback);
    Mesh cells;
    const auto label = cells.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
    GP::geodesic_voronoi_cells(domain(), seeds, cells, label, GP::parameters::callback(callback));
    result.points.reserve(cells.number_of_vertices());
    for(const Mesh::Vertex_index v : cells.vertices())
      result.points.push_back(program::coordinates(cells.point(v)));
    for(const Mesh::Face_index face : cells.faces())
    {
      for(const Mesh::Vertex_index v : vertices_around_face(cells.halfedge(face), cells))
        result.corners.push_back(v);
      result.triangle_labels.push_back(static_cast<std::uint32_t>(label[face]));
    }
    return result;
  }

private:
  const program::Surface* m_surface;
  std::optional<GP::Geodesic_path_finder<Mesh>> m_finder;
};

} // namespace

std::unique_ptr<Queries> mesh_queries(const program::Surface& surface)
{
  return std::make_unique<Mesh_queries>(surface);
}

} // namespace view
