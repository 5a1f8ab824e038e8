// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_BASE64_H
#define GEODESIC_PROGRAM_READERS_BASE64_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace program {

// Returns the number of digits, with padding, that encode a number of bytes.
constexpr std::size_t base64_length(std::size_t size) { return (size + 2) / 3 * 4; }

std::string to_base64(std::string_view bytes);

// Decodes base64. Returns std::nullopt if the text is invalid. Blanks are skipped. Padding may
// occur inside the text, because VTK encodes the header and the data of an array separately.
std::optional<std::string> from_base64(std::string_view text);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_BASE64_H
