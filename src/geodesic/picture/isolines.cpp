// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef GEODESIC_PROCESSING_HAS_VTK

#  include "picture/isolines.h"

#  include "io/colors.h"

#  include <vtkContourFilter.h>
#  include <vtkFloatArray.h>
#  include <vtkLookupTable.h>
#  include <vtkNew.h>
#  include <vtkPointData.h>
#  include <vtkPolyData.h>
#  include <vtkRenderer.h>
#  include <vtkScalarBarActor.h>
#  include <vtkStripper.h>
#  include <vtkTextProperty.h>

#  include <algorithm>
#  include <cmath>
#  include <cstdint>

namespace program {

namespace {

// Returns the distance between isolines: 1, 2, 2.5 or 5 times a power of ten. It results in 12 to
// 25 isolines.
double isoline_step(const Value_range& range)
{
  const double min_step = (range.high - range.low) / 25.;
  const double power = std::pow(10., std::floor(std::log10(min_step)));
  for(const double factor : {1., 2., 2.5, 5., 10.})
    if(factor * power >= min_step)
      return factor * power;
  return min_step;
}

} // namespace

Value_range finite_range(const std::vector<double>& values)
{
  Value_range range;
  for(const double x : values)
    if(std::isfinite(x))
    {
      range.low = std::min(range.low, x);
      range.high = std::max(range.high, x);
    }
  return range;
}

vtkActor* add_isolines(vtkRenderer* renderer, const std::vector<Point>& points,
                       const std::vector<std::uint32_t>& corners, const std::vector<double>& values,
                       const Value_range& range)
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

void add_color_bar(vtkRenderer* renderer, const Value_range& range, const std::string& title)
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

} // namespace program

#endif
