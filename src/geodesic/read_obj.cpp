// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Scanner.h"
#include "Surface_file.h"
#include "append_polygon.h"

namespace program {

Surface_file read_obj(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  Scanner scanner(bytes, name, '#');
  // A face may name vertices that follow it, so that ranges are checked when all are known.
  while(scanner.next_line())
  {
    const std::string_view keyword = scanner.word();
    if(keyword == "v")
    {
      Point& point = surface.points.emplace_back();
      for(double& x : point)
        x = scanner.coordinate(scanner.word());
    }
    else if(keyword == "f")
    {
      for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      {
        // A backslash at the end of a line: the face goes on.
        if(word == "\\")
        {
          if(!scanner.next_line())
            break;
          continue;
        }
        const long long index = scanner.integer(word.substr(0, word.find('/')));
        const auto count = static_cast<long long>(surface.points.size());
        if(index == 0 || index < -count)
          scanner.fail("a face names vertex " + std::to_string(index));
        append_corner(surface, static_cast<double>(index > 0 ? index - 1 : count + index));
      }
      end_polygon(surface);
    }
  }
  return surface;
}

} // namespace program
