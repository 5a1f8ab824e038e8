// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/Surface_queries.h"

#include <boost/property_map/function_property_map.hpp>

namespace view {

namespace {

// Holds the cloud of the other base class, which must be constructed earlier.
struct Cloud_holder
{
  Cloud cloud;
};

class Cloud_queries : private Cloud_holder, public Surface_queries<GP::Surfel_domain<Cloud>>
{
public:
  explicit Cloud_queries(const program::Surface& surface)
      : Cloud_holder{program::make_cloud(surface)},
        Surface_queries(surface, GP::Surfel_domain<Cloud>(cloud)), m_surface(&surface)
  {}

  std::vector<std::uint32_t> triangles() const override { return {}; }

  std::vector<std::vector<Point>> isolines(const std::vector<double>&,
                                           const std::vector<double>&) const override
  {
    return {};
  }

  Path path(const Place& from, const Place& to, bool) override
  {
    if(!m_finder)
      prepare_finder();
    const auto path = (*m_finder)(from.element, to.element);
    return {coordinates_of(path.points), path.length};
  }

  Cells voronoi(const std::vector<Place>& places, const Callback& callback) const override
  {
    Cells result;
    result.labels = labels(positions(places), callback);
    return result;
  }

private:
  // Uses the radii of the file if it has some, like the program.
  void prepare_finder()
  {
    const auto radii = m_surface->file.properties.find("radius");
    if(radii == m_surface->file.properties.end())
    {
      m_finder.emplace(cloud);
      return;
    }
    const auto radius = [&values = radii->second](const Cloud::Index& i) { return values[i]; };
    m_finder.emplace(
        cloud, GP::parameters::radius_map(boost::make_function_property_map<Cloud::Index>(radius)));
  }

  const program::Surface* m_surface;
  std::optional<GP::Surfel_path_finder<Cloud>> m_finder;
};

} // namespace

std::unique_ptr<Queries> cloud_queries(const program::Surface& surface)
{
  return std::make_unique<Cloud_queries>(surface);
}

} // namespace view
