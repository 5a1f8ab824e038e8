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
  std::vector<std::array<double, 2>>
      points; // edge length, seconds or number; relative error or distance
};

enum class Axes
{
  logarithmic, // the second coordinate is a relative error and labeled in percent
  linear       // the axes begin at zero and at a multiple of the step below the smallest value
};

struct Panel
{
  std::string title, axis; // label of the horizontal axis
  std::vector<Series> series;
  Axes axes = Axes::logarithmic;
};

// Layout of a panel in pixels.
constexpr double panel_width = 400., panel_height = 380.;
constexpr double left_margin = 70., right_margin = 14., top_margin = 30., bottom_margin = 44.;
constexpr double legend_row_height = 17.;

// Writes the elements of an SVG file.
class Svg_writer
{
public:
  Svg_writer(const std::string& file, double width, double height) : m_out(file)
  {
    m_out << std::fixed << std::setprecision(1);
    m_out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
          << height << "\" viewBox=\"0 0 " << width << ' ' << height
          << "\" font-family=\"sans-serif\" font-size=\"12\">\n"
          << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  }

  void draw_label(double x, double y, const char* anchor, const std::string& label)
  {
    m_out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << label
          << "</text>\n";
  }

  void draw_grid_line(double x0, double y0, double x1, double y1)
  {
    m_out << "<line x1=\"" << x0 << "\" y1=\"" << y0 << "\" x2=\"" << x1 << "\" y2=\"" << y1
          << "\" stroke=\"#ddd\"/>\n";
  }

  void draw_frame(double x, double y, double width, double height)
  {
    m_out << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << width << "\" height=\""
          << height << "\" fill=\"none\" stroke=\"#444\"/>\n";
  }

  void draw_polyline(const std::vector<std::array<double, 2>>& points, std::size_t style)
  {
    m_out << "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"" << color(style)
          << "\" points=\"";
    for(const auto& point : points)
      m_out << point[0] << ',' << point[1] << ' ';
    m_out << "\"/>\n";
  }

  void draw_marker(double x, double y, std::size_t style)
  {
    switch(style % colors.size())
    {
    case 0:
      m_out << "<path d=\"M" << x - 4 << ' ' << y - 4 << "l8 8m0 -8l-8 8\" stroke=\""
            << color(style) << "\" stroke-width=\"2\"/>\n";
      break;
    case 1:
      m_out << "<rect x=\"" << x - 3.5 << "\" y=\"" << y - 3.5
            << "\" width=\"7\" height=\"7\" fill=\"" << color(style) << "\"/>\n";
      break;
    case 2:
      m_out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"" << color(style)
            << "\"/>\n";
      break;
    case 3:
      m_out << "<path d=\"M" << x << ' ' << y - 5 << "l5 8h-10z\" fill=\"" << color(style)
            << "\"/>\n";
      break;
    case 4:
      m_out << "<path d=\"M" << x << ' ' << y - 5 << "l5 5l-5 5l-5 -5z\" fill=\"white\" stroke=\""
            << color(style) << "\" stroke-width=\"1.5\"/>\n";
      break;
    case 5:
      m_out << "<path d=\"M" << x << ' ' << y + 5 << "l5 -8h-10z\" fill=\"" << color(style)
            << "\"/>\n";
      break;
    default:
      m_out << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"white\" stroke=\""
            << color(style) << "\" stroke-width=\"1.5\"/>\n";
    }
  }

  // Closes the file. Returns false if it could not be written.
  bool close()
  {
    m_out << "</svg>\n";
    m_out.close();
    return bool(m_out);
  }

private:
  // Palette for readers with color vision deficiency (Okabe and Ito 2008).
  static constexpr std::array<const char*, 7> colors = {"#888888", "#D55E00", "#0072B2", "#009E73",
                                                        "#CC79A7", "#E69F00", "#56B4E9"};

  static const char* color(std::size_t style) { return colors[style % colors.size()]; }

  std::ofstream m_out;
};

// Draws one panel: the axes, the series, and the legend below them.
class Panel_plot
{
public:
  Panel_plot(Svg_writer& svg, const Panel& panel, std::size_t column)
      : m_svg(svg), m_panel(panel), m_left(panel_width * double(column) + left_margin),
        m_right(panel_width * double(column + 1) - right_margin)
  {
    for(const Series& series : panel.series)
      for(const auto& point : series.points)
      {
        m_x0 = std::min(m_x0, to_axis(point[0]));
        m_x1 = std::max(m_x1, to_axis(point[0]));
        m_y0 = std::min(m_y0, to_axis(point[1]));
        m_y1 = std::max(m_y1, to_axis(point[1]));
      }
    m_is_empty = m_x0 > m_x1;
    const double margin = is_linear() ? 0.03 * (m_x1 - m_x0) : 0.1;
    m_x0 -= margin;
    m_x1 += margin;
    m_y_step = is_linear() ? step(m_y1 - m_y0) : 1.;
    m_y0 = m_y_step * std::floor(m_y0 / m_y_step);
    m_y1 = m_y_step * std::ceil(m_y1 / m_y_step);
  }

  void draw()
  {
    if(m_is_empty)
      return;
    m_svg.draw_frame(m_left, top_margin, m_right - m_left, bottom - top_margin);
    m_svg.draw_label((m_left + m_right) / 2., top_margin - 10., "middle", m_panel.title);
    m_svg.draw_label((m_left + m_right) / 2., panel_height - 10., "middle", m_panel.axis);
    draw_vertical_axis();
    draw_horizontal_axis();
    for(std::size_t s = 0; s < m_panel.series.size(); ++s)
      draw_series(m_panel.series[s], panel_height + legend_row_height * (double(s) + 0.5));
  }

private:
  static constexpr double bottom = panel_height - bottom_margin;

  bool is_linear() const { return m_panel.axes == Axes::linear; }

  // Returns the coordinate on an axis: the value or its base-10 logarithm.
  double to_axis(double value) const { return is_linear() ? value : std::log10(value); }

  // Returns 1, 2 or 5 times a power of ten, at least a sixth of the length of a linear axis.
  static double step(double length)
  {
    const double power = std::pow(10., std::floor(std::log10(length / 6.)));
    for(const double digit : {1., 2., 5.})
      if(digit * power >= length / 6.)
        return digit * power;
    return 10. * power;
  }

  // Convert coordinates on the axes to pixels.
  double to_x(double x) const { return m_left + (x - m_x0) / (m_x1 - m_x0) * (m_right - m_left); }
  double to_y(double y) const
  {
    return top_margin + (m_y1 - y) / (m_y1 - m_y0) * (bottom - top_margin);
  }

  void draw_vertical_axis()
  {
    if(is_linear())
    {
      const int number = int(std::lround((m_y1 - m_y0) / m_y_step));
      for(int i = 0; i <= number; ++i)
      {
        const double y = m_y0 + m_y_step * i;
        m_svg.draw_grid_line(m_left, to_y(y), m_right, to_y(y));
        m_svg.draw_label(m_left - 6., to_y(y) + 4., "end", format_significant(y));
      }
      return;
    }
    for(int decade = int(m_y0); decade <= int(m_y1); ++decade)
    {
      m_svg.draw_grid_line(m_left, to_y(decade), m_right, to_y(decade));
      m_svg.draw_label(m_left - 6., to_y(decade) + 4., "end",
                       format_fixed(std::pow(10., decade + 2), std::max(0, -decade - 2)) + " %");
    }
  }

  void draw_horizontal_axis()
  {
    if(is_linear())
    {
      const double x_step = step(m_x1 - m_x0);
      for(double x = x_step * std::ceil(m_x0 / x_step); x <= m_x1; x += x_step)
      {
        m_svg.draw_grid_line(to_x(x), top_margin, to_x(x), bottom);
        m_svg.draw_label(to_x(x), bottom + 16., "middle",
                         format_significant(x + 0.)); // -0 becomes 0
      }
      return;
    }
    for(int decade = int(std::floor(m_x0)); decade <= int(std::ceil(m_x1)); ++decade)
      for(const double digit : {1., 2., 5.})
      {
        const double x = decade + std::log10(digit);
        if(x < m_x0 || x > m_x1)
          continue;
        m_svg.draw_grid_line(to_x(x), top_margin, to_x(x), bottom);
        // If the axis spans two decades or more, only powers of ten fit as labels.
        if(digit == 1. || m_x1 - m_x0 < 2.)
          m_svg.draw_label(to_x(x), bottom + 16., "middle", format_significant(std::pow(10., x)));
      }
  }

  void draw_series(const Series& series, double legend_y)
  {
    std::vector<std::array<double, 2>> points;
    for(const auto& point : series.points)
      points.push_back({to_x(to_axis(point[0])), to_y(to_axis(point[1]))});
    m_svg.draw_polyline(points, series.style);
    for(const auto& point : points)
      m_svg.draw_marker(point[0], point[1], series.style);
    m_svg.draw_marker(m_left + 8., legend_y - 4., series.style);
    m_svg.draw_label(m_left + 22., legend_y, "start",
                     series.name + (std::isnan(series.order)
                                        ? std::string()
                                        : ": order " + format_fixed(series.order, 2)));
  }

  Svg_writer& m_svg;
  const Panel& m_panel;
  double m_left, m_right; // of the frame
  // Ranges of the axes, as values or base-10 logarithms.
  double m_x0 = std::numeric_limits<double>::infinity(), m_x1 = -m_x0, m_y0 = m_x0, m_y1 = m_x1;
  double m_y_step = 1.; // between grid lines
  bool m_is_empty = true;
};

// Records the points of a panel as a table.
inline void record_points(const Panel& panel)
{
  std::vector<std::vector<std::string>> rows = {
      {"series", panel.axis, panel.axes == Axes::linear ? "distance" : "relative error"}};
  for(const Series& series : panel.series)
    for(const auto& [x, y] : series.points)
      rows.push_back({series.name, format_significant(x), format_significant(y)});
  Record::add("plot: " + panel.title, rows);
}

// Writes an SVG file with one panel per element of `panels`, in a row, and records its points. Each
// panel plots errors or distances over a second quantity. Returns false if the file cannot be
// written.
inline bool write_error_plot(const std::string& file, const std::vector<Panel>& panels)
{
  std::size_t rows = 0;
  for(const Panel& panel : panels)
    rows = std::max(rows, panel.series.size());
  const double legend_height = double(rows) * legend_row_height + 8.;
  Svg_writer svg(file, panel_width * double(panels.size()), panel_height + legend_height);
  for(std::size_t p = 0; p < panels.size(); ++p)
  {
    Panel_plot(svg, panels[p], p).draw();
    record_points(panels[p]);
  }
  return svg.close();
}

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_ERROR_PLOT_H
