// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Results.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace mass_test {

namespace {

// The program writes null for infinity. These values can be infinite: the covering radius if there
// are more components than samples, and the angles if no face has area. So can areas, and integrals
// over the surface, if lengths are too large.
bool can_be_null(const std::string& key, bool areas_overflow)
{
  return key == "covering_radius" || key == "min_angle" || key == "max_angle" ||
         (areas_overflow && (key == "area" || key == "energy" || key == "energies"));
}

// Returns the key of a value that is null and must not be, or "" if there is none.
std::string find_null(const nlohmann::json& object, bool areas_overflow)
{
  for(const auto& [key, value] : object.items())
    if(!can_be_null(key, areas_overflow) &&
       (value.is_null() || (value.is_structured() && !find_null(value, areas_overflow).empty())))
      return key;
  return "";
}

// Returns whether the areas of a surface overflow, according to the JSON object of `info`.
bool areas_overflow(const nlohmann::json& info)
{
  if(info.contains("bounding_box"))
    for(const nlohmann::json& corner : info["bounding_box"])
      for(const nlohmann::json& x : corner)
        if(x.is_number() && std::abs(x.get<double>()) > 1e150)
          return true;
  return false;
}

} // namespace

std::optional<Soup> read_soup(const std::filesystem::path& file)
{
  Soup soup;
  try
  {
    if(!CGAL::IO::read_polygon_soup(file.string(), soup.points, soup.polygons))
      return std::nullopt;
  }
  catch(const std::exception&)
  {
    return std::nullopt;
  }
  return soup;
}

std::optional<Textured_mesh> read_textured_mesh(const std::filesystem::path& file)
{
  Textured_mesh mesh;
  std::ifstream stream(file);
  for(std::string line, word; std::getline(stream, line);)
  {
    std::istringstream words(line);
    words >> word;
    double x = 0., y = 0., z = 0.;
    if(word == "v" && words >> x >> y >> z)
      mesh.points.emplace_back(x, y, z);
    else if(word == "vt" && words >> x >> y)
      mesh.uv.emplace_back(x, y);
    else if(word == "f")
    {
      std::array<std::size_t, 3> corners, uv_corners;
      for(std::size_t k = 0; k < 3; ++k)
      {
        words >> word;
        std::istringstream corner(word); // point/uv or point/uv/normal; the indices begin with 1
        char slash = 0;
        if(!words || !(corner >> corners[k] >> slash >> uv_corners[k]) || slash != '/' ||
           corners[k] < 1 || corners[k] > mesh.points.size() || uv_corners[k] < 1 ||
           uv_corners[k] > mesh.uv.size())
          return std::nullopt;
        --corners[k];
        --uv_corners[k];
      }
      if(words >> word)
        return std::nullopt;
      mesh.corners.push_back(corners);
      mesh.uv_corners.push_back(uv_corners);
    }
  }
  return mesh.corners.empty() ? std::nullopt : std::optional(std::move(mesh));
}

Results::Results(const std::filesystem::path& folder) : m_folder(folder)
{
  std::string line;
  std::getline(std::ifstream(path("file")), line);
  m_surface = line;
  std::ifstream(path("target")) >> m_target;
  read_runs();
}

void Results::read_runs()
{
  const nlohmann::json info =
      nlohmann::json::parse(std::ifstream(path("info.json")), nullptr, false);
  const bool overflow = areas_overflow(info);
  std::ifstream stream(path("runs"));
  for(std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string command;
    int code = 0;
    double seconds = 0.;
    std::size_t number_of_lines = 0;
    words >> command >> code >> seconds >> number_of_lines;
    if(code == 2)
      expect(number_of_lines == 1 && line.back() == '.', command,
             "the program does not print exactly one sentence when it returns 2");
    if(code != 0)
      continue;
    nlohmann::json json =
        nlohmann::json::parse(std::ifstream(path(command + ".json")), nullptr, false);
    if(!json.is_object())
    {
      add_violation(command, "standard output is not a JSON object");
      continue;
    }
    const std::string key = find_null(json, overflow);
    expect(key.empty(), command, "the number \"" + key + "\" is not finite");
    m_json.emplace(command, std::move(json));
  }
}

void Results::add_violation(const std::string& command, const std::string& sentence)
{
  m_violations.push_back(command + '\t' + sentence);
}

void Results::expect(bool condition, const std::string& command, const std::string& sentence,
                     const std::vector<double>& numbers)
{
  if(condition)
    return;
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  auto number = numbers.begin();
  for(const char c : sentence)
    if(c == '%' && number != numbers.end())
      text << *number++;
    else
      text << c;
  add_violation(command, text.str());
}

double Results::number(const std::string& command, const std::string& key)
{
  const nlohmann::json& object = json(command);
  if(object.contains(key) && object[key].is_number())
    return object[key].get<double>();
  add_violation(command, "the JSON object has no number \"" + key + '"');
  return std::nan("");
}

std::vector<double> Results::values(const std::string& command, std::size_t columns, bool is_finite)
{
  std::vector<double> result;
  std::ifstream stream(path(command + ".txt"));
  std::size_t number_of_lines = 0;
  for(std::string line; std::getline(stream, line); ++number_of_lines)
  {
    const char* position = line.c_str();
    char* end = nullptr;
    for(double x = std::strtod(position, &end); end != position; x = std::strtod(position, &end))
    {
      if(std::isnan(x) || (is_finite && std::isinf(x)))
      {
        expect(false, command, "line % of the values has a number that is not finite",
               {number_of_lines + 1.});
        return {};
      }
      result.push_back(x);
      position = end;
    }
    if(*position != 0 || result.size() != columns * (number_of_lines + 1))
    {
      expect(false, command, "line % of the values does not have % numbers",
             {number_of_lines + 1., double(columns)});
      return {};
    }
  }
  expect(number_of_lines > 0, command, "there are no values");
  return result;
}

} // namespace mass_test
