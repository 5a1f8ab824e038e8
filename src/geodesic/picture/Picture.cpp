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
#  include "picture/View.h"
#  include "io/colors.h"

#  include <CGAL/Orthogonal_k_neighbor_search.h>
#  include <CGAL/Search_traits_3.h>
#  include <CGAL/Simple_cartesian.h>

#  include <vtkActor.h>
#  include <vtkCamera.h>
#  include <vtkCellArray.h>
#  include <vtkCellData.h>
#  include <vtkContourFilter.h>
#  include <vtkFloatArray.h>
#  include <vtkIdList.h>
#  include <vtkImageData.h>
#  include <vtkLightKit.h>
#  include <vtkLookupTable.h>
#  include <vtkNew.h>
#  include <vtkPNGWriter.h>
#  include <vtkPointData.h>
#  include <vtkPoints.h>
#  include <vtkPolyData.h>
#  include <vtkPolyDataMapper.h>
#  include <vtkPolyDataNormals.h>
#  include <vtkProperty.h>
#  include <vtkRenderWindow.h>
#  include <vtkRenderer.h>
#  include <vtkScalarBarActor.h>
#  include <vtkSphereSource.h>
#  include <vtkStripper.h>
#  include <vtkTextProperty.h>
#  include <vtkTexture.h>
#  include <vtkTubeFilter.h>
#  include <vtkUnsignedCharArray.h>
#  include <vtkWindowToImageFilter.h>

#  include <algorithm>
#  include <cmath>
#  include <map>
#  include <random>
#  include <set>
#  include <utility>

namespace program {

namespace {

constexpr int width = 1600, height = 1200;
constexpr Color line_color = {0.08, 0.08, 0.12}, marker_color = {0.86, 0.11, 0.12};
// Radii in units of half the longest side of the bounding box
constexpr double thin_radius = 0.0022, thick_radius = 0.011, marker_radius = 0.024;

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator*(double t, const Point& a) { return {t * a[0], t * a[1], t * a[2]}; }

double length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

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

// Points and triangles for VTK, with one color per point or triangle
struct Render_mesh
{
  std::vector<Point> points;
  std::vector<Point> normals; // if empty, VTK computes them and splits creases
  std::vector<std::uint32_t> corners;
  std::vector<Color> colors; // #points or #triangles
};

vtkSmartPointer<vtkPoints> to_vtk(const std::vector<Point>& points)
{
  const auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for(std::size_t i = 0; i < points.size(); ++i)
    result->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  return result;
}

vtkSmartPointer<vtkPolyData> to_poly_data(const std::vector<Point>& points,
                                          const std::vector<std::uint32_t>& corners)
{
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(to_vtk(points));
  vtkNew<vtkCellArray> cells;
  for(std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    const vtkIdType triangle[] = {corners[i], corners[i + 1], corners[i + 2]};
    cells->InsertNextCell(3, triangle);
  }
  result->SetPolys(cells);
  return result;
}

vtkSmartPointer<vtkPolyData> to_polyline_data(const std::vector<std::vector<Point>>& polylines)
{
  std::vector<Point> points;
  vtkNew<vtkCellArray> cells;
  for(const std::vector<Point>& polyline : polylines)
  {
    // The tube filter fails for consecutive points that coincide.
    std::vector<vtkIdType> ids;
    for(const Point& p : polyline)
      if(ids.empty() || length(p - points.back()) > 1e-6)
      {
        ids.push_back(static_cast<vtkIdType>(points.size()));
        points.push_back(p);
      }
    if(ids.size() > 1)
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  const auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(to_vtk(points));
  result->SetLines(cells);
  return result;
}

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

void set_color(vtkActor* actor, const Color& color)
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
}

// Renders lines as tubes and returns their actor. If there are no lines, the actor is empty and
// not rendered.
vtkSmartPointer<vtkActor> add_tubes(vtkRenderer* renderer, vtkPolyData* lines, double radius,
                                    const Color& color)
{
  const auto actor = vtkSmartPointer<vtkActor>::New();
  if(lines->GetNumberOfLines() == 0)
    return actor;
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(10);
  tubes->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tubes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  set_color(actor, color);
  actor->GetProperty()->SetAmbient(0.25);
  renderer->AddActor(actor);
  return actor;
}

void add_sphere(vtkRenderer* renderer, const Point& center, double radius, const Color& color)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(24);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  set_color(actor, color);
  actor->GetProperty()->SetAmbient(0.2);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(30.);
  renderer->AddActor(actor);
}

// Computes normals. Points on creases are duplicated, one copy for each side.
vtkSmartPointer<vtkPolyData> compute_normals(vtkPolyData* triangles)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(triangles);
  normals->SetFeatureAngle(40.);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

// Sets the reflection properties of surfaces.
void set_material(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(0.12);
  actor->GetProperty()->SetDiffuse(0.9);
  actor->GetProperty()->SetSpecular(0.08);
  actor->GetProperty()->SetSpecularPower(25.);
}

void add_mesh(vtkRenderer* renderer, const Render_mesh& mesh, double opacity = 1.)
{
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(mesh.points, mesh.corners);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(mesh.colors.size()));
  for(std::size_t i = 0; i < mesh.colors.size(); ++i)
    for(int c = 0; c < 3; ++c)
      colors->SetComponent(static_cast<vtkIdType>(i), c,
                           std::round(255. * mesh.colors[i][static_cast<std::size_t>(c)]));
  if(mesh.colors.size() == mesh.points.size())
    data->GetPointData()->SetScalars(colors);
  else
    data->GetCellData()->SetScalars(colors);

  vtkNew<vtkPolyDataMapper> mapper;
  if(mesh.normals.empty())
    mapper->SetInputData(compute_normals(data));
  else
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(mesh.normals.size()));
    for(std::size_t i = 0; i < mesh.normals.size(); ++i)
      normals->SetTuple(static_cast<vtkIdType>(i), mesh.normals[i].data());
    data->GetPointData()->SetNormals(normals);
    mapper->SetInputData(data);
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  set_material(actor);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}

// Adds a mesh with a texture.
void add_textured_mesh(vtkRenderer* renderer, const std::vector<Point>& points,
                       const Surface_file& surface, const Image& image)
{
  // Normals are computed first and creases are split. Afterwards each corner becomes a separate
  // point, because it has its own texture coordinates.
  const vtkSmartPointer<vtkPolyData> smooth =
      compute_normals(to_poly_data(points, surface.corners));
  std::vector<Point> corners;
  vtkNew<vtkFloatArray> corner_normals, texture_coordinates;
  corner_normals->SetNumberOfComponents(3);
  texture_coordinates->SetNumberOfComponents(2);
  std::vector<std::uint32_t> indices;
  vtkNew<vtkIdList> cell;
  for(vtkIdType f = 0; f < smooth->GetNumberOfCells(); ++f)
  {
    smooth->GetCellPoints(f, cell);
    for(vtkIdType k = 0; k < 3; ++k)
    {
      indices.push_back(static_cast<std::uint32_t>(corners.size()));
      texture_coordinates->InsertNextTuple(surface.corner_uv[corners.size()].data());
      corner_normals->InsertNextTuple(
          smooth->GetPointData()->GetNormals()->GetTuple(cell->GetId(k)));
      smooth->GetPoint(cell->GetId(k), corners.emplace_back().data());
    }
  }
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(corners, indices);
  data->GetPointData()->SetNormals(corner_normals);
  data->GetPointData()->SetTCoords(texture_coordinates);

  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(static_cast<int>(image.width), static_cast<int>(image.height), 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* byte = static_cast<unsigned char*>(pixels->GetScalarPointer());
  for(const Color& pixel : image.pixels)
    for(const double channel : pixel)
      *byte++ = static_cast<unsigned char>(std::lround(255. * channel));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(pixels);
  texture->InterpolateOn();
  texture->RepeatOff();

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  set_material(actor);
  renderer->AddActor(actor);
}

struct Range
{
  double low = INFINITY, high = -INFINITY;
  bool empty() const { return !(low < high); }
};

Range finite_range(const std::vector<double>& values)
{
  Range range;
  for(const double x : values)
    if(std::isfinite(x))
    {
      range.low = std::min(range.low, x);
      range.high = std::max(range.high, x);
    }
  return range;
}

// Returns the distance between isolines: 1, 2, 2.5 or 5 times a power of ten. It results in 12 to
// 25 isolines.
double isoline_step(const Range& range)
{
  const double min_step = (range.high - range.low) / 25.;
  const double power = std::pow(10., std::floor(std::log10(min_step)));
  for(const double factor : {1., 2., 2.5, 5., 10.})
    if(factor * power >= min_step)
      return factor * power;
  return min_step;
}

// Adds isolines on the triangles whose three values are finite.
vtkSmartPointer<vtkActor> add_isolines(vtkRenderer* renderer, const std::vector<Point>& points,
                                       const std::vector<std::uint32_t>& corners,
                                       const std::vector<double>& values, const Range& range)
{
  std::vector<std::uint32_t> finite;
  for(std::size_t i = 0; i + 2 < corners.size(); i += 3)
    if(std::isfinite(values[corners[i]]) && std::isfinite(values[corners[i + 1]]) &&
       std::isfinite(values[corners[i + 2]]))
      finite.insert(finite.end(), {corners[i], corners[i + 1], corners[i + 2]});
  const vtkSmartPointer<vtkPolyData> data = to_poly_data(points, finite);
  // Values are scaled to [0, 1] in single precision, because they may be as large or small as
  // double allows.
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  const double size = range.high - range.low;
  for(std::size_t i = 0; i < points.size(); ++i)
    scalars->SetValue(static_cast<vtkIdType>(i),
                      std::isfinite(values[i]) ? static_cast<float>((values[i] - range.low) / size)
                                               : 0.f);
  data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(data);
  const double step = isoline_step(range);
  int count = 0;
  for(double value = step * (std::floor(range.low / step) + 1.); value < range.high && count < 100;
      value += step)
    contours->SetValue(count++, (value - range.low) / size);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(contours->GetOutputPort());
  stripper->Update();
  return add_tubes(renderer, stripper->GetOutput(), thin_radius, line_color);
}

void add_color_bar(vtkRenderer* renderer, const Range& range, const std::string& title)
{
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  for(int i = 0; i < 256; ++i)
  {
    const Color color = viridis(i / 255.);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  table->SetRange(range.low, range.high);
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(table);
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(5);
  // Labels have three digits, without an exponent if that is short.
  const double digits = std::floor(std::log10(std::max(std::abs(range.low), range.high)));
  const std::string format =
      digits >= -3. && digits < 6.
          ? "%." + std::to_string(static_cast<int>(std::max(0., 2. - digits))) + "f"
          : "%.2e";
  bar->SetLabelFormat(format.c_str());
  bar->SetMaximumWidthInPixels(110);
  bar->SetPosition(0.885, 0.18);
  bar->SetWidth(0.1);
  bar->SetHeight(0.64);
  bar->UnconstrainedFontSizeOn();
  bar->SetVerticalTitleSeparation(12);
  for(vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()})
  {
    text->SetColor(line_color[0], line_color[1], line_color[2]);
    text->SetFontFamilyToArial();
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
    text->SetFontSize(26);
  }
  renderer->AddViewProp(bar);
}

// Splits triangles with several labels, so that each piece has a single label.
class Label_regions
{
public:
  Label_regions(const std::vector<Point>& points, const std::vector<std::uint32_t>& corners,
                const std::vector<long long>& labels)
      : m_number_of_points(points.size())
  {
    m_mesh.points = points;
    for(std::size_t i = 0; i + 2 < corners.size(); i += 3)
      split_triangle({corners[i], corners[i + 1], corners[i + 2]}, labels);
    smooth_boundaries();
  }

  const Render_mesh& mesh() const { return m_mesh; }

  std::vector<std::vector<Point>> boundaries() const
  {
    std::vector<std::vector<Point>> result;
    for(const auto& [p, q] : m_boundaries)
      result.push_back({m_mesh.points[p], m_mesh.points[q]});
    return result;
  }

private:
  using Triangle = std::array<std::uint32_t, 3>;

  void split_triangle(Triangle c, const std::vector<long long>& labels)
  {
    const auto label = [&](std::size_t k) { return labels[c[k]]; };
    if(label(0) == label(1) && label(1) == label(2))
      return add({c[0], c[1], c[2]}, label(0));
    if(label(0) != label(1) && label(1) != label(2) && label(2) != label(0))
    {
      const Triangle p = {edge_point(c[0], c[1]), edge_point(c[1], c[2]), edge_point(c[2], c[0])};
      const auto center = static_cast<std::uint32_t>(m_mesh.points.size());
      m_mesh.points.push_back({0., 0., 0.});
      m_point_edges.push_back({c[0], c[0]});
      for(std::size_t k = 0; k < 3; ++k)
      {
        add({c[k], p[k], center}, label(k));
        add({c[k], center, p[(k + 2) % 3]}, label(k));
        m_boundaries.emplace_back(p[k], center);
      }
      m_centers.push_back(center);
      update_center(center, p);
      m_center_corners.push_back(p);
      return;
    }
    // One corner differs from the other two; rotate it to the front.
    while(label(1) != label(2))
      std::rotate(c.begin(), c.begin() + 1, c.end());
    const std::uint32_t p = edge_point(c[0], c[1]), q = edge_point(c[2], c[0]);
    add({c[0], p, q}, label(0));
    add({p, c[1], c[2]}, label(1));
    add({p, c[2], q}, label(1));
    m_boundaries.emplace_back(p, q);
  }

  void add(const Triangle& corners, long long label)
  {
    m_mesh.corners.insert(m_mesh.corners.end(), corners.begin(), corners.end());
    m_mesh.colors.push_back(color_of_label(label));
  }

  // Returns the point at which an edge is cut, initially its midpoint.
  std::uint32_t edge_point(std::uint32_t a, std::uint32_t b)
  {
    const auto [low, high] = std::minmax(a, b);
    const auto [entry, is_new] =
        m_edge_points.try_emplace({low, high}, static_cast<std::uint32_t>(m_mesh.points.size()));
    if(is_new)
    {
      const Point midpoint = 0.5 * (m_mesh.points[low] + m_mesh.points[high]);
      m_mesh.points.push_back(midpoint);
      m_point_edges.push_back({low, high});
    }
    return entry->second;
  }

  void update_center(std::uint32_t middle, const Triangle& p)
  {
    m_mesh.points[middle] =
        (1. / 3.) * (m_mesh.points[p[0]] + m_mesh.points[p[1]] + m_mesh.points[p[2]]);
  }

  // Boundaries through edge midpoints are jagged. Each cut point is therefore moved along its
  // edge, to the projection of the average of its neighbors on the boundary.
  void smooth_boundaries()
  {
    const std::size_t number_of_cuts = m_point_edges.size();
    std::vector<Point> sum(number_of_cuts);
    std::vector<double> count(number_of_cuts);
    for(int iteration = 0; iteration < 30; ++iteration)
    {
      std::fill(sum.begin(), sum.end(), Point{0., 0., 0.});
      std::fill(count.begin(), count.end(), 0.);
      for(const auto& [p, q] : m_boundaries)
      {
        sum[p - m_number_of_points] = sum[p - m_number_of_points] + m_mesh.points[q];
        sum[q - m_number_of_points] = sum[q - m_number_of_points] + m_mesh.points[p];
        count[p - m_number_of_points] += 1.;
        count[q - m_number_of_points] += 1.;
      }
      for(std::size_t i = 0; i < number_of_cuts; ++i)
      {
        const Point &a = m_mesh.points[m_point_edges[i][0]],
                    &b = m_mesh.points[m_point_edges[i][1]];
        const Point edge = b - a, offset = (1. / std::max(count[i], 1.)) * sum[i] - a;
        const double squared_length = edge[0] * edge[0] + edge[1] * edge[1] + edge[2] * edge[2];
        // Boundary endpoints are fixed, and centers follow the cut points around them.
        if(count[i] < 2. || squared_length == 0.)
          continue;
        const double t =
            (offset[0] * edge[0] + offset[1] * edge[1] + offset[2] * edge[2]) / squared_length;
        m_mesh.points[m_number_of_points + i] = a + std::clamp(t, 0.03, 0.97) * edge;
      }
      for(std::size_t i = 0; i < m_centers.size(); ++i)
        update_center(m_centers[i], m_center_corners[i]);
    }
  }

  std::size_t m_number_of_points; // number of input points; cut points and centers follow
  Render_mesh m_mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_edge_points;
  std::vector<std::array<std::uint32_t, 2>>
      m_point_edges; // #cut points and centers: the edge that is cut
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_boundaries;
  std::vector<std::uint32_t> m_centers;
  std::vector<Triangle> m_center_corners; // #centers: the cut points around each
};

// Returns a disk for each point, orthogonal to its normal. The radius is chosen so that adjacent
// disks overlap.
Render_mesh make_splats(const std::vector<Point>& points, const std::vector<Point>& normals,
                        const std::vector<Color>& colors)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  std::vector<Kernel::Point_3> unique_points;
  for(const Point& p : points)
    unique_points.emplace_back(p[0], p[1], p[2]);
  std::sort(unique_points.begin(), unique_points.end());
  unique_points.erase(std::unique(unique_points.begin(), unique_points.end()), unique_points.end());
  Search::Tree tree(unique_points.begin(), unique_points.end());

  std::vector<double> radius(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Search search(tree, {points[i][0], points[i][1], points[i][2]}, 7);
    double max_squared_distance = 0.;
    for(const auto& neighbor : search)
      max_squared_distance = std::max(max_squared_distance, neighbor.second);
    radius[i] = 0.75 * std::sqrt(max_squared_distance);
  }
  // Disks of isolated points must neither vanish nor cover other points.
  std::vector<double> sorted = radius;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double median = std::max(sorted[sorted.size() / 2], 1e-3);

  constexpr std::uint32_t number_of_sides = 10;
  Render_mesh mesh;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& n = normals[i];
    const Point helper = std::abs(n[0]) < 0.6 ? Point{1., 0., 0.} : Point{0., 1., 0.};
    Point u = cross(n, helper);
    u = (1. / length(u)) * u;
    const Point v = cross(n, u);
    const double r = std::clamp(radius[i], 0.4 * median, 1.8 * median);
    const auto first_index = static_cast<std::uint32_t>(mesh.points.size());
    for(std::uint32_t k = 0; k < number_of_sides; ++k)
    {
      const double angle = 2. * 3.14159265358979 * k / number_of_sides;
      mesh.points.push_back(points[i] + (r * std::cos(angle)) * u + (r * std::sin(angle)) * v);
      mesh.normals.push_back(n);
      mesh.colors.push_back(colors[i]);
      if(k >= 2)
        mesh.corners.insert(mesh.corners.end(),
                            {first_index, first_index + k - 1, first_index + k});
    }
  }
  return mesh;
}

// Returns points distributed over the surface. The result is deterministic.
std::vector<Point> sample_points(const std::vector<Point>& points,
                                 const std::vector<std::uint32_t>& corners)
{
  constexpr std::size_t number_of_samples = 60000;
  if(corners.empty())
    return points;
  std::vector<double> cumulative_area(corners.size() / 3);
  double sum = 0.;
  for(std::size_t f = 0; f < cumulative_area.size(); ++f)
  {
    const Point& a = points[corners[3 * f]];
    sum += length(cross(points[corners[3 * f + 1]] - a, points[corners[3 * f + 2]] - a));
    cumulative_area[f] = sum;
  }
  std::vector<Point> samples;
  std::mt19937 generator(1);
  const auto random = [&generator] { return static_cast<double>(generator()) / 4294967296.; };
  for(std::size_t i = 0; i < number_of_samples && sum > 0.; ++i)
  {
    const auto entry =
        std::upper_bound(cumulative_area.begin(), cumulative_area.end(), random() * sum);
    const std::size_t f = std::min<std::size_t>(
        static_cast<std::size_t>(entry - cumulative_area.begin()), cumulative_area.size() - 1);
    double s = random(), t = random();
    if(s + t > 1.)
    {
      s = 1. - s;
      t = 1. - t;
    }
    const Point& a = points[corners[3 * f]];
    samples.push_back(a + s * (points[corners[3 * f + 1]] - a) +
                      t * (points[corners[3 * f + 2]] - a));
  }
  // Corners are included, because the outermost ones limit the distance of the camera.
  const std::size_t stride = corners.size() / 100000 + 1;
  for(std::size_t i = 0; i < corners.size(); i += stride)
    samples.push_back(points[corners[i]]);
  return samples;
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
  Range range = picture.labels.empty() ? finite_range(picture.values) : Range();
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
  vtkSmartPointer<vtkActor> lines;
  if(!is_mesh)
    add_mesh(renderer, make_splats(points, surface.normals, colors));
  if(!picture.labels.empty())
  {
    const Label_regions regions(points, triangles, picture.labels);
    if(is_mesh)
      add_mesh(renderer, regions.mesh());
    lines = add_tubes(renderer, to_polyline_data(regions.boundaries()), thin_radius, line_color);
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
    add_tubes(renderer, to_polyline_data(unique_edges(points, triangles)), thin_radius, line_color);
  add_tubes(renderer, to_polyline_data(to_unit_boxes(picture.thin_polylines)), thin_radius,
            line_color);
  add_tubes(renderer, to_polyline_data(polylines), thick_radius, marker_color);
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
