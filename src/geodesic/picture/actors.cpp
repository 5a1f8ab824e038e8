// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef GEODESIC_PROCESSING_HAS_VTK

#  include "picture/actors.h"

#  include "readers/vectors.h"

#  include <vtkActor.h>
#  include <vtkCellArray.h>
#  include <vtkCellData.h>
#  include <vtkFloatArray.h>
#  include <vtkIdList.h>
#  include <vtkImageData.h>
#  include <vtkNew.h>
#  include <vtkPointData.h>
#  include <vtkPoints.h>
#  include <vtkPolyData.h>
#  include <vtkPolyDataMapper.h>
#  include <vtkPolyDataNormals.h>
#  include <vtkProperty.h>
#  include <vtkRenderer.h>
#  include <vtkSphereSource.h>
#  include <vtkTexture.h>
#  include <vtkTubeFilter.h>
#  include <vtkUnsignedCharArray.h>

#  include <cmath>

namespace program {

namespace {

vtkSmartPointer<vtkPoints> to_vtk(const std::vector<Point>& points)
{
  const auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for(std::size_t i = 0; i < points.size(); ++i)
    result->SetPoint(static_cast<vtkIdType>(i), points[i].data());
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
      if(ids.empty() || norm(p - points.back()) > 1e-6)
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

void set_color(vtkActor* actor, const Color& color)
{
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
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

} // namespace

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

vtkActor* add_tubes(vtkRenderer* renderer, vtkPolyData* lines, double radius, const Color& color)
{
  if(lines->GetNumberOfLines() == 0)
    return nullptr;
  vtkNew<vtkActor> actor;
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

vtkActor* add_tubes(vtkRenderer* renderer, const std::vector<std::vector<Point>>& polylines,
                    double radius, const Color& color)
{
  return add_tubes(renderer, to_polyline_data(polylines), radius, color);
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

void add_mesh(vtkRenderer* renderer, const Render_mesh& mesh, double opacity)
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

} // namespace program

#endif
