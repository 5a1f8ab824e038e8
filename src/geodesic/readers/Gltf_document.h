// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_GLTF_DOCUMENT_H
#define GEODESIC_PROGRAM_READERS_GLTF_DOCUMENT_H

#include "readers/Scanner.h"
#include "readers/binary_numbers.h"
#include "readers/read_bytes.h"

#include <nlohmann/json.hpp>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace program {

using Json = nlohmann::json;

// Returns a member of an object, or null if there is none.
const Json& member(const Json& object, const char* key);

// The JSON of a file, its buffers, and the arrays in them.
class Gltf_document
{
public:
  // Keeps a view of the bytes. Throws Input_error if they are not glTF 2.0 or require an extension
  // that is not supported.
  Gltf_document(std::string_view bytes, const std::string& name);

  [[noreturn]] void fail(const std::string& reason) const { program::fail(m_name, reason); }

  const Json& json() const { return m_json; }

  // Returns an element of a top-level array.
  const Json& element(const char* array, std::size_t index) const;

  // Returns a value, or a member of an object, as an integer. `key` is used in error messages.
  std::size_t as_integer(const Json& value, const char* key) const;
  std::size_t integer(const Json& object, const char* key) const
  {
    return as_integer(member(object, key), key);
  }
  std::size_t integer(const Json& object, const char* key, std::size_t otherwise) const
  {
    return member(object, key).is_null() ? otherwise : integer(object, key);
  }

  // Returns an array of N numbers, or `otherwise` if the object has no such member.
  template <std::size_t N>
  std::array<double, N> numbers(const Json& object, const char* key,
                                const std::array<double, N>& otherwise) const
  {
    const Json& values = member(object, key);
    if(values.is_null())
      return otherwise;
    std::array<double, N> result;
    for(std::size_t i = 0; i < N; ++i)
    {
      if(!values.is_array() || values.size() != N || !values[i].is_number())
        fail(std::string("'") + key + "' is not an array of " + std::to_string(N) + " numbers");
      result[i] = values[i].get<double>();
    }
    return result;
  }

  // Counts values that are read. Throws Input_error if they are too many for the size of the file.
  void count_values(std::size_t number);

  // Returns the values of an accessor, whose elements have this type: SCALAR, VEC2 or VEC3.
  std::vector<double> values(std::size_t accessor_index, const char* type);

private:
  struct Array
  {
    Number_type type;
    std::size_t components; // of an element
    std::size_t count;
  };

  // Stores the binary chunk of a GLB file and returns its JSON chunk.
  std::string_view split(std::string_view bytes);

  Number_type number_type(const Json& object) const;
  std::string_view buffer(std::size_t index);
  std::string decode_data(std::string_view uri) const;
  std::vector<double> read_view(const Json& object, const Array& array);
  void replace_sparse(const Json& sparse, const Array& array, std::vector<double>& values);

  std::string m_name;
  std::size_t m_max_values;
  Json m_json;
  std::optional<std::string_view> m_binary;     // of a GLB file
  std::map<std::size_t, std::string> m_buffers; // in data URIs, once they are decoded
  std::map<std::string, Bytes> m_files;         // other files, once they are read
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_GLTF_DOCUMENT_H
