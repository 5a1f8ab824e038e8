// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Gltf_document.h"

#include "readers/base64.h"
#include "readers/read_bytes.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace program {

namespace {

// Primitives and nodes can share arrays, so a short file can describe a large surface. This bounds
// the memory to about a thousand times the size of the file.
constexpr std::size_t max_values_per_byte = 32;

// Extensions that can be required without changing the shape. KHR_mesh_quantization allows types of
// numbers that accessors have anyway.
bool is_supported_extension(std::string_view name)
{
  for(const std::string_view prefix :
      {"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"})
    if(name.substr(0, prefix.size()) == prefix)
      return true;
  return false;
}

// Replaces %XX in a URI by the character of this code.
std::string decode_uri(std::string_view uri)
{
  std::string result;
  for(std::size_t i = 0; i < uri.size(); ++i)
  {
    unsigned code = 0;
    const char* const begin = uri.data() + i + 1;
    if(uri[i] == '%' && i + 2 < uri.size() &&
       std::from_chars(begin, begin + 2, code, 16).ptr == begin + 2)
    {
      result += static_cast<char>(code);
      i += 2;
    }
    else
      result += uri[i];
  }
  return result;
}

} // namespace

const Json& member(const Json& object, const char* key)
{
  static const Json null;
  const auto found = object.find(key);
  return found == object.end() ? null : *found;
}

Gltf_document::Gltf_document(std::string_view bytes, const std::string& name)
    : m_name(name), m_max_values(max_values_per_byte * bytes.size())
{
  // The parser is not recursive, so deeply nested values cannot exhaust the stack.
  const std::string_view text = bytes.substr(0, 4) == "glTF" ? split(bytes) : bytes;
  m_json = Json::parse(text.begin(), text.end(), nullptr, false);
  const Json& version = member(member(m_json, "asset"), "version");
  if(!version.is_string() || version.get_ref<const std::string&>().substr(0, 2) != "2.")
    fail("it is not a glTF 2.0 file");
  for(const Json& extension : member(m_json, "extensionsRequired"))
    if(extension.is_string() && !is_supported_extension(extension.get_ref<const std::string&>()))
      fail("it requires the extension '" + printable(extension.get_ref<const std::string&>()) +
           "', which is not supported");
}

const Json& Gltf_document::element(const char* array, std::size_t index) const
{
  const Json& elements = member(m_json, array);
  if(!elements.is_array() || index >= elements.size())
    fail("it refers to element " + std::to_string(index) + " of '" + array +
         "', which does not exist");
  return elements[index];
}

std::size_t Gltf_document::as_integer(const Json& value, const char* key) const
{
  if(!value.is_number_unsigned())
    fail(std::string("'") + key + "' is missing or not a nonnegative integer");
  return value.get<std::size_t>();
}

void Gltf_document::count_values(std::size_t number)
{
  if(number > m_max_values)
    fail("its arrays are repeated too often for the size of the file");
  m_max_values -= number;
}

std::string_view Gltf_document::split(std::string_view bytes)
{
  const auto word = [&](std::size_t offset) { return bits_at(bytes.substr(offset), 4, false); };
  if(bytes.size() < 20 || word(8) > bytes.size())
    fail("it is truncated");
  if(word(4) != 2)
    fail("it is not a glTF 2.0 file");
  bytes = bytes.substr(0, static_cast<std::size_t>(word(8)));
  std::optional<std::string_view> json;
  for(bytes.remove_prefix(std::min<std::size_t>(12, bytes.size())); bytes.size() >= 8;)
  {
    const std::uint64_t length = word(0);
    const std::string_view type = bytes.substr(4, 4);
    bytes.remove_prefix(8);
    if(length > bytes.size())
      fail("it is truncated");
    const std::string_view chunk = bytes.substr(0, static_cast<std::size_t>(length));
    if(type == "JSON" && !json)
      json = chunk;
    else if(type == std::string_view("BIN\0", 4) && !m_binary)
      m_binary = chunk;
    bytes.remove_prefix(chunk.size());
  }
  return json.value_or(std::string_view());
}

Number_type Gltf_document::number_type(const Json& object) const
{
  switch(integer(object, "componentType"))
  {
  case 5120:
    return {'i', 1};
  case 5121:
    return {'u', 1};
  case 5122:
    return {'i', 2};
  case 5123:
    return {'u', 2};
  case 5125:
    return {'u', 4};
  case 5126:
    return {'f', 4};
  default:
    fail("a component type is unknown");
  }
}

std::string_view Gltf_document::buffer(std::size_t index)
{
  const Json& uri = member(element("buffers", index), "uri");
  if(uri.is_null() && index == 0 && m_binary)
    return *m_binary;
  if(!uri.is_string())
    fail("a buffer has no data");
  const std::string_view text = uri.get_ref<const std::string&>();
  if(text.substr(0, 5) == "data:")
  {
    const auto [entry, is_new] = m_buffers.try_emplace(index);
    if(is_new)
      entry->second = decode_data(text);
    return entry->second;
  }
  const std::string path = std::filesystem::path(decode_uri(text)).lexically_normal().string();
  const auto [entry, is_new] = m_files.try_emplace(path);
  if(is_new)
  {
    entry->second = read_referenced_bytes(m_name, path);
    m_max_values += max_values_per_byte * entry->second.size();
  }
  return entry->second;
}

std::string Gltf_document::decode_data(std::string_view uri) const
{
  const std::size_t comma = std::min(uri.find(','), uri.size() - 1);
  const std::string_view header = uri.substr(0, comma), mark = ";base64";
  const std::optional<std::string> bytes = from_base64(uri.substr(comma + 1));
  if(header.substr(header.size() - std::min(mark.size(), header.size())) != mark || !bytes)
    fail("a buffer is not valid base64");
  return *bytes;
}

// Reads an array at `byteOffset` of the `bufferView` of an object.
std::vector<double> Gltf_document::read_view(const Json& object, const Array& array)
{
  const Json& view = element("bufferViews", integer(object, "bufferView"));
  std::string_view bytes = buffer(integer(view, "buffer"));
  const auto skip = [&](std::size_t offset)
  {
    if(offset > bytes.size())
      fail("an array exceeds its buffer");
    bytes.remove_prefix(offset);
  };
  skip(integer(view, "byteOffset", 0));
  bytes = bytes.substr(0, integer(view, "byteLength"));
  skip(integer(object, "byteOffset", 0));
  const std::size_t size = array.components * array.type.size,
                    stride = integer(view, "byteStride", size);
  if(stride < size)
    fail("'byteStride' is too small");
  if(array.count > 0 && (bytes.size() < size || (bytes.size() - size) / stride < array.count - 1))
    fail("an array exceeds its buffer");
  count_values(array.count * array.components);
  std::vector<double> values;
  values.reserve(array.count * array.components);
  for(std::size_t i = 0; i < array.count; ++i)
    for(std::size_t k = 0; k < array.components; ++k)
      values.push_back(
          to_value(bits_at(bytes.substr(i * stride + k * array.type.size), array.type.size, false),
                   array.type));
  return values;
}

// Replaces single elements of an array.
void Gltf_document::replace_sparse(const Json& sparse, const Array& array,
                                   std::vector<double>& values)
{
  const Json& indices = member(sparse, "indices");
  const std::size_t count = integer(sparse, "count");
  const std::vector<double> index = read_view(indices, {number_type(indices), 1, count});
  const std::vector<double> replacement =
      read_view(member(sparse, "values"), {array.type, array.components, count});
  for(std::size_t i = 0; i < count; ++i)
  {
    if(!(index[i] >= 0. && index[i] < static_cast<double>(array.count)))
      fail("an index of a sparse array is out of range");
    std::copy_n(replacement.begin() + static_cast<std::ptrdiff_t>(i * array.components),
                array.components,
                values.begin() + static_cast<std::ptrdiff_t>(index[i]) *
                                     static_cast<std::ptrdiff_t>(array.components));
  }
}

std::vector<double> Gltf_document::values(std::size_t accessor_index, const char* type)
{
  const Json& accessor = element("accessors", accessor_index);
  if(member(accessor, "type") != Json(type))
    fail("an accessor does not have the type " + std::string(type));
  const std::size_t components = type == std::string_view("SCALAR") ? 1 : type[3] == '2' ? 2 : 3;
  const Array array = {number_type(accessor), components, integer(accessor, "count")};
  const Json& sparse = member(accessor, "sparse");
  std::vector<double> result;
  if(!member(accessor, "bufferView").is_null())
    result = read_view(accessor, array);
  else if(sparse.is_null())
    fail("an accessor has no data");
  else
  {
    count_values(array.count);
    result.resize(array.count * components);
  }
  if(!sparse.is_null())
    replace_sparse(sparse, array, result);
  const Json& normalized = member(accessor, "normalized");
  if(normalized.is_boolean() && normalized.get<bool>() && array.type.kind != 'f')
  {
    const std::size_t bits = 8 * array.type.size - (array.type.kind == 'i' ? 1 : 0);
    for(double& x : result)
      x = std::max(x / static_cast<double>((std::uint64_t{1} << bits) - 1), -1.);
  }
  return result;
}

} // namespace program
