// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "queries.h"

#include "Scanner.h"

#include <algorithm>
#include <cmath>

namespace program {

void check_method(const std::string& word)
{
  const auto among = [&word](std::initializer_list<const char*> words)
  { return std::find(words.begin(), words.end(), word) != words.end(); };
  if(among({"exact", "spectral", "biharmonic", "emd"}))
    throw Usage_error("--method " + word + ": this method is not available yet.");
  if(!among({"dijkstra", "fast-marching", "euclidean", "heat"}))
    throw Usage_error("--method " + shown(word) +
                      ": the methods are dijkstra, fast-marching, euclidean and heat.");
}

const std::vector<double>& property(const Surface& surface, const std::string& name)
{
  const auto found = surface.file.properties.find(name);
  if(found != surface.file.properties.end())
    return found->second;
  std::string names;
  for(const auto& other : surface.file.properties)
    names += (names.empty() ? "" : ", ") + other.first;
  fail(surface.name, "its vertices have no property '" + shown(name) + "'" +
                         (names.empty() ? ", they have none" : ", only " + names));
}

void write_result(const Job& job, const std::string& name, const std::vector<double>& values,
                  double size)
{
  Surface_file file = job.surface().file;
  file.properties[name] = values;
  if(ending(job.output()) == "obj")
    for(const double x : values)
      file.uv.push_back({std::isfinite(x) && size > 0. ? std::clamp(x / size, 0., 1.) : 0., 0.5});
  write_surface_file(job.output(), file, name);
}

} // namespace program
