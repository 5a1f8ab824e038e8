// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_svg.h"

#include "io/Output_file.h"

#include <algorithm>

namespace program {

namespace {

using Planar_point = std::array<double, 2>;

// Appends the data of a path. In SVG the second axis points down.
void append_path_data(std::string& text, const std::vector<Planar_point>& points, bool is_closed)
{
  text += " d=\"";
  // SVG repeats the first point of a closed path itself.
  const std::size_t size = points.size() - (is_closed ? 1 : 0);
  for(std::size_t i = 0; i < size; ++i)
  {
    text += i == 0 ? "M" : i == 1 ? " L" : " ";
    append_number(text, points[i][0]);
    text += ' ';
    append_number(text, -points[i][1]);
  }
  text += is_closed ? " Z\"/>\n" : "\"/>\n";
}

} // namespace

std::string to_svg(const std::vector<Planar_line>& lines, const std::vector<Planar_point>& boundary)
{
  Planar_point low = boundary.front(), high = low;
  for(const Planar_point& p : boundary)
    for(std::size_t k = 0; k < 2; ++k)
    {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  const double width = high[0] - low[0], height = high[1] - low[1];
  const double size = std::max(width, height), margin = 0.01 * size;

  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
  text += number_text(low[0] - margin) + ' ' + number_text(-high[1] - margin) + ' ' +
          number_text(width + 2. * margin) + ' ' + number_text(height + 2. * margin) + "\">\n";
  text += "<g fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"" + number_text(0.001 * size) +
          "\">\n";
  text += "<path id=\"boundary\" stroke=\"gray\"";
  append_path_data(text, boundary, true);
  for(const Planar_line& line : lines)
  {
    text += "<path stroke=\"black\" data-value=\"" + number_text(line.value) + '"';
    append_path_data(text, line.points, line.is_closed);
  }
  return text + "</g>\n</svg>\n";
}

} // namespace program
