// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"

#ifndef GEODESIC_PROCESSING_HAS_VTK

#  include "io/errors.h"

namespace program {

void draw(const std::string& filename, const Picture&)
{
  throw Usage_error("--picture " + filename + ": this program was built without VTK.");
}

} // namespace program

#else

#  include "io/Output_file.h"
#  include "picture/Label_regions.h"
#  include "picture/View.h"
#  include "picture/actors.h"
#  include "picture/isolines.h"
#  include "picture/splats.h"
#  include "picture/vectors.h"
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

View set_camera(vtkRenderer* renderer, const std::vector<Point>& samples,
                const std::vector<Point>& visible_points, const std::vector<Point>& normals,
                bool has_color_bar)
{
  // The color bar occupies a strip on the right.
  const double free_fraction = has_color_bar ? 0.86 : 1.;
  const View view = choose_view(samples, visible_points, free_fraction * width / height, normals);
  const Point position = view.center + view.distance * view.back;
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(view.center.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(view.up.data());
  camera->SetViewAngle(view_angle);
  camera->SetWindowCenter(has_color_bar ? 1. - free_fraction : 0., 0.);
  renderer->ResetCameraClippingRange();
  return view;
}

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
  const Surface_file& surface = *picture.surface;
  const bool is_mesh = surface.number_of_polygons() > 0;
  const Unit_box_transform to_unit_box(surface.points);
  const std::vector<Point> points = to_unit_box(surface.points),
                           markers = to_unit_box(picture.markers);
  const auto to_unit_boxes = [&](std::vector<std::vector<Point>> result)
  {
    for(std::vector<Point>& polyline : result)
      polyline = to_unit_box(polyline);
    return result;
  };
  const std::vector<std::vector<Point>> polylines = to_unit_boxes(picture.polylines);
  Value_range range = picture.labels.empty() ? finite_range(picture.values) : Value_range();
  // A range with a small positive minimum starts at zero, because distances start at zero even if
  // no vertex is a source.
  if(range.low > 0. && range.low < 0.2 * range.high)
    range.low = 0.;

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1., 1., 1.);
  std::vector<Color> colors =
      picture.colors.empty() ? std::vector<Color>(points.size(), default_color) : picture.colors;
  if(!picture.labels.empty())
    std::transform(picture.labels.begin(), picture.labels.end(), colors.begin(), color_of_label);
  else if(!picture.values.empty())
    colors = colors_of(picture.values, range.low, range.high);

  const std::vector<std::uint32_t>& triangles = is_mesh ? surface.corners : picture.triangles;
  vtkActor* lines = nullptr;
  if(!is_mesh)
    add_mesh(renderer, make_splats(points, surface.normals, colors));
  if(!picture.labels.empty())
  {
    const Label_regions regions(points, triangles, picture.labels);
    if(is_mesh)
      add_mesh(renderer, regions.mesh());
    lines = add_tubes(renderer, regions.boundaries(), thin_radius, line_color);
  }
  else
  {
    if(picture.texture != nullptr)
      add_textured_mesh(renderer, points, surface, *picture.texture);
    else if(is_mesh)
      add_mesh(renderer, {points, {}, triangles, colors}, picture.is_transparent ? 0.25 : 1.);
    if(!range.empty() && picture.show_isolines)
      lines = add_isolines(renderer, points, triangles, picture.values, range);
  }
  if(picture.show_edges)
    add_tubes(renderer, unique_edges(points, triangles), thin_radius, line_color);
  add_tubes(renderer, to_unit_boxes(picture.thin_polylines), thin_radius, line_color);
  add_tubes(renderer, polylines, thick_radius, marker_color);
  const bool has_regions = !picture.labels.empty();
  for(const Point& marker : markers)
    add_sphere(renderer, marker, has_regions ? 0.6 * marker_radius : marker_radius,
               has_regions ? line_color : marker_color);
  if(!range.empty())
    add_color_bar(renderer, range, picture.title);

  std::vector<Point> visible_points = to_unit_box(picture.visible_points);
  if(!has_regions)
    visible_points.insert(visible_points.end(), markers.begin(), markers.end());
  for(const std::vector<Point>& polyline : polylines)
    for(std::size_t i = 0; i < polyline.size(); i += polyline.size() / 200 + 1)
      visible_points.push_back(polyline[i]);
  const View view = set_camera(renderer, sample_points(points, surface.corners), visible_points,
                               picture.normals, !range.empty());
  // Splats extend beyond the triangles that carry a cloud's lines, so the lines are moved to the
  // front.
  if(!is_mesh && lines != nullptr)
  {
    const Point shift = 0.012 * view.back;
    lines->SetPosition(shift[0], shift[1], shift[2]);
  }

  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->SetKeyToFillRatio(2.2);
  lights->SetKeyToHeadRatio(3.);
  lights->AddLightsToRenderer(renderer);

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(picture.is_transparent ? 0 : 8);
  if(picture.is_transparent)
  {
    window->AlphaBitPlanesOn();
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(12);
    renderer->UseFXAAOn();
  }
  window->SetSize(width, height);
  window->AddRenderer(renderer);
  window->Render();
  write_png(window, filename);
}

} // namespace program

#endif
