// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_ERROR_PLOT_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_ERROR_PLOT_H

#include "report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <limits>
#include <string>
#include <vector>

namespace benchmarks {

struct Series
{
  std::string name;
  std::size_t style; // index of the color and marker
  double order;
  std::vector<std::array<double, 2>> points; // edge length or seconds; relative error
};

struct Panel
{
  std::string title, axis; // label of the horizontal axis
  std::vector<Series> series;
};

// Writes an SVG file with one panel per element of `panels`, in a row. Each panel plots errors over
// a second quantity, both on logarithmic axes. Returns false if the file cannot be written.
inline bool write_error_plot(const std::string& file, const std::vector<Panel>& panels)
{
  // Palette for readers with color vision deficiency (Okabe and Ito 2008).
  constexpr std::array<const char*, 7> colors = {"#888888", "#D55E00", "#0072B2", "#009E73",
                                                 "#CC79A7", "#E69F00", "#56B4E9"};
  constexpr double width = 400., height = 380., left = 70., right = 14., top = 30., bottom = 44.;
  constexpr double legend_row_height = 17.;
  std::size_t rows = 0;
  for(const Panel& panel : panels)
    rows = std::max(rows, panel.series.size());
  const double legend_height = double(rows) * legend_row_height + 8.;
  const double total_height = height + legend_height;

  std::ofstream out(file);
  out << std::fixed << std::setprecision(1);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width * double(panels.size())
      << "\" height=\"" << total_height << "\" viewBox=\"0 0 " << width * double(panels.size())
      << ' ' << total_height << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";

  const auto draw_label = [&](double x, double y, const char* anchor, const std::string& label)
  {
    out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << label
        << "</text>\n";
  };
  const auto draw_line = [&](double x0, double y0, double x1, double y1, const char* style)
  {
    out << "<line x1=\"" << x0 << "\" y1=\"" << y0 << "\" x2=\"" << x1 << "\" y2=\"" << y1 << "\" "
        << style << "/>\n";
  };
  const auto draw_marker = [&](double x, double y, std::size_t style)
  {
    const char* color = colors[style % colors.size()];
    switch(style % colors.size())
    {
    case 0:
      out << "<path d=\"M" << x - 4 << ' ' << y - 4 << "l8 8m0 -8l-8 8\" stroke=\"" << color
          << "\" stroke-width=\"2\"/>\n";
      break;
    case 1:
      out << "<rect x=\"" << x - 3.5 << "\" y=\"" << y - 3.5
          << "\" width=\"7\" height=\"7\" fill=\"" << color << "\"/>\n";
      break;
    case 2:
      out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"" << color << "\"/>\n";
      break;
    case 3:
      out << "<path d=\"M" << x << ' ' << y - 5 << "l5 8h-10z\" fill=\"" << color << "\"/>\n";
      break;
    case 4:
      out << "<path d=\"M" << x << ' ' << y - 5 << "l5 5l-5 5l-5 -5z\" fill=\"white\" stroke=\""
          << color << "\" stroke-width=\"1.5\"/>\n";
      break;
    case 5:
      out << "<path d=\"M" << x << ' ' << y + 5 << "l5 -8h-10z\" fill=\"" << color << "\"/>\n";
      break;
    default:
      out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"white\" stroke=\""
          << color << "\" stroke-width=\"1.5\"/>\n";
    }
  };

  for(std::size_t p = 0; p < panels.size(); ++p)
  {
    const Panel& panel = panels[p];
    double x0 = std::numeric_limits<double>::infinity(), x1 = -x0, y0 = x0, y1 = x1;
    for(const Series& series : panel.series)
      for(const auto& point : series.points)
      {
        x0 = std::min(x0, std::log10(point[0]));
        x1 = std::max(x1, std::log10(point[0]));
        y0 = std::min(y0, std::log10(point[1]));
        y1 = std::max(y1, std::log10(point[1]));
      }
    if(x0 > x1)
      continue;
    x0 -= 0.1;
    x1 += 0.1;
    y0 = std::floor(y0);
    y1 = std::ceil(y1);
    const double begin = width * double(p) + left, end = width * double(p + 1) - right;
    const auto to_x = [&](double x) { return begin + (x - x0) / (x1 - x0) * (end - begin); };
    const auto to_y = [&](double y)
    { return top + (y1 - y) / (y1 - y0) * (height - bottom - top); };

    out << "<rect x=\"" << begin << "\" y=\"" << top << "\" width=\"" << end - begin
        << "\" height=\"" << height - bottom - top << "\" fill=\"none\" stroke=\"#444\"/>\n";
    draw_label((begin + end) / 2., top - 10., "middle", panel.title);
    draw_label((begin + end) / 2., height - 10., "middle", panel.axis);
    for(int decade = int(y0); decade <= int(y1); ++decade)
    {
      draw_line(begin, to_y(decade), end, to_y(decade), "stroke=\"#ddd\"");
      draw_label(begin - 6., to_y(decade) + 4., "end",
                 format_fixed(std::pow(10., decade + 2), std::max(0, -decade - 2)) + " %");
    }
    for(int decade = int(std::floor(x0)); decade <= int(std::ceil(x1)); ++decade)
      for(const double digit : {1., 2., 5.})
      {
        const double x = decade + std::log10(digit);
        if(x < x0 || x > x1)
          continue;
        draw_line(to_x(x), top, to_x(x), height - bottom, "stroke=\"#ddd\"");
        // If the axis spans two decades or more, only powers of ten fit as labels.
        if(digit == 1. || x1 - x0 < 2.)
          draw_label(to_x(x), height - bottom + 16., "middle",
                     format_significant(std::pow(10., x)));
      }
    for(std::size_t s = 0; s < panel.series.size(); ++s)
    {
      const Series& series = panel.series[s];
      out << "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\""
          << colors[series.style % colors.size()] << "\" points=\"";
      for(const auto& point : series.points)
        out << to_x(std::log10(point[0])) << ',' << to_y(std::log10(point[1])) << ' ';
      out << "\"/>\n";
      for(const auto& point : series.points)
        draw_marker(to_x(std::log10(point[0])), to_y(std::log10(point[1])), series.style);
      const double y = height + legend_row_height * (double(s) + 0.5);
      draw_marker(begin + 8., y - 4., series.style);
      draw_label(begin + 22., y, "start",
                 series.name + (std::isnan(series.order)
                                    ? std::string()
                                    : ": order " + format_fixed(series.order, 2)));
    }
  }
  out << "</svg>\n";
  out.close();
  return bool(out);
}

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_ERROR_PLOT_H
