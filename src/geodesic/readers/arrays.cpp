// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/arrays.h"

#include "readers/Scanner.h"

namespace program {

std::vector<double> decode_numbers(std::string_view bytes, Number_type type, bool big_endian)
{
  std::vector<double> numbers(bytes.size() / type.size);
  for(std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = to_value(bits_at(bytes.substr(i * type.size), type.size, big_endian), type);
  return numbers;
}

std::vector<double> numbers_in_text(std::string_view text, const std::string& name)
{
  std::vector<double> numbers;
  Scanner scanner(text, name, 0);
  for(double plain = 0.; !scanner.is_line_empty() || scanner.next_line();)
  {
    if(scanner.take_plain_number(plain))
    {
      numbers.push_back(plain);
      continue;
    }
    const std::string_view word = scanner.word();
    const std::optional<double> number = to_number(word);
    if(!number)
      fail(name, "'" + printable(word) + "' is not a number");
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<Point> to_points(const std::vector<double>& coordinates)
{
  std::vector<Point> points(coordinates.size() / 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    points[i] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  return points;
}

} // namespace program
