// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"

#ifndef GEODESIC_PROCESSING_HAS_VTK

#  include "io/errors.h"

namespace program {

void draw(const std::string& filename, const Picture&)
{
  throw Usage_error("--picture " + filename +
                    ": pictures are not supported, because this program was built without VTK.");
}

} // namespace program

#else

#  include "io/Output_file.h"
#  include "picture/Label_regions.h"
#  include "picture/View.h"
#  include "picture/actors.h"
#  include "picture/isolines.h"
#  include "picture/splats.h"
#  include "readers/vectors.h"
#  include "io/colors.h"

#  include <vtkActor.h>
#  include <vtkCamera.h>
#  include <vtkLightKit.h>
#  include <vtkNew.h>
#  include <vtkPNGWriter.h>
#  include <vtkRenderWindow.h>
#  include <vtkRenderer.h>
#  include <vtkUnsignedCharArray.h>
#  include <vtkWindowToImageFilter.h>

#  include <algorithm>
#  include <set>
#  include <utility>

namespace program {

namespace {

constexpr int width = 1600, height = 1200;

// Maps points to the box [-1, 1]^3, because graphics hardware uses single precision.
class Unit_box_transform
{
public:
  explicit Unit_box_transform(const std::vector<Point>& points)
  {
    Point low = points[0], high = points[0];
    for(const Point& p : points)
      for(std::size_t c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    for(std::size_t c = 0; c < 3; ++c)
    {
      m_center[c] = low[c] / 2. + high[c] / 2.;
      m_size = std::max(m_size, high[c] / 2. - low[c] / 2.);
    }
  }

  Point operator()(const Point& p) const
  {
    Point q = {0., 0., 0.};
    if(m_size > 0.)
      for(std::size_t c = 0; c < 3; ++c)
        q[c] = (p[c] / 2. - m_center[c] / 2.) / m_size * 2.;
    return q;
  }

  std::vector<Point> operator()(const std::vector<Point>& points) const
  {
    std::vector<Point> result(points.size());
    std::transform(points.begin(), points.end(), result.begin(), *this);
    return result;
  }

  std::vector<std::vector<Point>> operator()(std::vector<std::vector<Point>> polylines) const
  {
    for(std::vector<Point>& polyline : polylines)
      polyline = (*this)(polyline);
    return polylines;
  }

private:
  Point m_center = {0., 0., 0.};
  double m_size = 0.;
};

// Returns the edges of the triangles; shared edges occur once.
std::vector<std::vector<Point>> unique_edges(const std::vector<Point>& points,
                                             const std::vector<std::uint32_t>& corners)
{
  std::set<std::pair<std::uint32_t, std::uint32_t>> vertex_pairs;
  for(std::size_t c = 0; c < corners.size(); ++c)
    vertex_pairs.insert(std::minmax(corners[c], corners[c % 3 == 2 ? c - 2 : c + 1]));
  std::vector<std::vector<Point>> result;
  for(const auto& [a, b] : vertex_pairs)
    result.push_back({points[a], points[b]});
  return result;
}

// Returns the range of the color bar, or an empty range if the picture has none.
Value_range color_bar_range(const Picture& picture)
{
  Value_range range = picture.labels.empty() ? finite_range(picture.values) : Value_range();
  // A range with a small positive minimum starts at zero, because distances start at zero even if
  // no vertex is a source.
  if(range.low > 0. && range.low < 0.2 * range.high)
    range.low = 0.;
  return range;
}

// Returns the color of each point.
std::vector<Color> point_colors(const Picture& picture, const Value_range& range)
{
  std::vector<Color> colors = picture.colors;
  if(!picture.labels.empty())
  {
    colors.resize(picture.labels.size());
    std::transform(picture.labels.begin(), picture.labels.end(), colors.begin(), color_of_label);
  }
  else if(!picture.values.empty())
    colors = colors_of(picture.values, range.low, range.high);
  else if(colors.empty())
    colors.resize(picture.surface->points.size(), default_color);
  return colors;
}

// A renderer with the actors, the lights and the camera of a picture
class Scene
{
public:
  explicit Scene(const Picture& picture)
      : m_picture(picture), m_to_unit_box(picture.surface->points),
        m_points(m_to_unit_box(picture.surface->points)), m_markers(m_to_unit_box(picture.markers)),
        m_polylines(m_to_unit_box(picture.polylines)), m_range(color_bar_range(picture))
  {
    m_renderer->SetBackground(1., 1., 1.);
    add_surface();
    add_lines();
    add_markers();
    if(!m_range.empty())
      add_color_bar(m_renderer, m_range, picture.title);
    set_camera();
    add_lights();
  }

  vtkRenderer* renderer() const { return m_renderer; }

private:
  bool is_mesh() const { return m_picture.surface->number_of_polygons() > 0; }
  bool has_regions() const { return !m_picture.labels.empty(); }
  // The triangles that carry isolines and boundaries of regions
  const std::vector<std::uint32_t>& triangles() const
  {
    return is_mesh() ? m_picture.surface->corners : m_picture.triangles;
  }

  // Adds the surface with its isolines or the boundaries of its regions.
  void add_surface()
  {
    const std::vector<Color> colors = point_colors(m_picture, m_range);
    if(!is_mesh())
      add_mesh(m_renderer, make_splats(m_points, m_picture.surface->normals, colors));
    if(has_regions())
    {
      const Label_regions regions(m_points, triangles(), m_picture.labels);
      if(is_mesh())
        add_mesh(m_renderer, regions.mesh());
      m_surface_lines = add_tubes(m_renderer, regions.boundaries(), thin_radius, line_color);
      return;
    }
    if(m_picture.texture != nullptr)
      add_textured_mesh(m_renderer, m_points, *m_picture.surface, *m_picture.texture);
    else if(is_mesh())
      add_mesh(m_renderer, {m_points, {}, triangles(), colors},
               m_picture.is_transparent ? 0.25 : 1.);
    if(!m_range.empty() && m_picture.show_isolines)
      m_surface_lines = add_isolines(m_renderer, m_points, triangles(), m_picture.values, m_range);
  }

  void add_lines()
  {
    if(m_picture.show_edges)
      add_tubes(m_renderer, unique_edges(m_points, triangles()), thin_radius, line_color);
    add_tubes(m_renderer, m_to_unit_box(m_picture.thin_polylines), thin_radius, line_color);
    add_tubes(m_renderer, m_polylines, thick_radius, marker_color);
  }

  void add_markers()
  {
    for(const Point& marker : m_markers)
      add_sphere(m_renderer, marker, has_regions() ? 0.6 * marker_radius : marker_radius,
                 has_regions() ? line_color : marker_color);
  }

  // Returns the points that the camera should show.
  std::vector<Point> visible_points() const
  {
    std::vector<Point> result = m_to_unit_box(m_picture.visible_points);
    if(!has_regions())
      result.insert(result.end(), m_markers.begin(), m_markers.end());
    for(const std::vector<Point>& polyline : m_polylines)
      for(std::size_t i = 0; i < polyline.size(); i += polyline.size() / 200 + 1)
        result.push_back(polyline[i]);
    return result;
  }

  void set_camera()
  {
    // The color bar occupies a strip on the right.
    const double free_fraction = m_range.empty() ? 1. : 0.86;
    const View view =
        choose_view(sample_points(m_points, m_picture.surface->corners), visible_points(),
                    free_fraction * width / height, m_picture.normals);
    const Point position = view.center + view.distance * view.back;
    vtkCamera* const camera = m_renderer->GetActiveCamera();
    camera->SetFocalPoint(view.center.data());
    camera->SetPosition(position.data());
    camera->SetViewUp(view.up.data());
    camera->SetViewAngle(view_angle);
    camera->SetWindowCenter(m_range.empty() ? 0. : 1. - free_fraction, 0.);
    m_renderer->ResetCameraClippingRange();
    // Splats extend beyond the triangles that carry a cloud's lines, so the lines are moved to the
    // front.
    if(!is_mesh() && m_surface_lines != nullptr)
    {
      const Point shift = 0.012 * view.back;
      m_surface_lines->SetPosition(shift[0], shift[1], shift[2]);
    }
  }

  void add_lights()
  {
    vtkNew<vtkLightKit> lights;
    lights->SetKeyLightIntensity(0.85);
    lights->SetKeyToFillRatio(2.2);
    lights->SetKeyToHeadRatio(3.);
    lights->AddLightsToRenderer(m_renderer);
  }

  const Picture& m_picture;
  Unit_box_transform m_to_unit_box;
  std::vector<Point> m_points, m_markers;      // in the unit box
  std::vector<std::vector<Point>> m_polylines; // likewise
  Value_range m_range;
  vtkNew<vtkRenderer> m_renderer;
  vtkActor* m_surface_lines = nullptr; // isolines or boundaries of regions
};

void write_png(vtkRenderWindow* window, const std::string& filename)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  write_file(filename, {reinterpret_cast<const char*>(bytes->GetPointer(0)),
                        static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

} // namespace

void draw(const std::string& filename, const Picture& picture)
{
  // VTK's warnings would be mixed with the program's own messages on standard error.
  vtkObject::GlobalWarningDisplayOff();
  const Scene scene(picture);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(picture.is_transparent ? 0 : 8);
  if(picture.is_transparent)
  {
    window->AlphaBitPlanesOn();
    scene.renderer()->UseDepthPeelingOn();
    scene.renderer()->SetMaximumNumberOfPeels(12);
    scene.renderer()->UseFXAAOn();
  }
  window->SetSize(width, height);
  window->AddRenderer(scene.renderer());
  window->Render();
  write_png(window, filename);
}

} // namespace program

#endif
