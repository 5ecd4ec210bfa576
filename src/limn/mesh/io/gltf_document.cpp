#include "limn/mesh/io/gltf_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/text_scanner.h"

namespace limn::io {
namespace {

using Json = GltfDocument::Json;

constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53;

/// Bytes of a number of that type; 0: there is no such type.
std::size_t size_of_component(int component) {
  switch (component) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
    default: return 0;
  }
}

int parts_of(const std::string& type) {
  constexpr std::pair<const char*, int> kTypes[] = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& [name, parts] : kTypes)
    if (type == name) return parts;
  return 0;
}

/// Extensions that may be required without a change to where vertices are.
bool is_harmless(const std::string& extension) {
  constexpr std::string_view kHarmless[] = {"KHR_materials_",       "KHR_texture_", "KHR_lights_",
                                            "EXT_texture_",         "KHR_xmp",      "EXT_lights_",
                                            "KHR_mesh_quantization"};
  return std::any_of(std::begin(kHarmless), std::end(kHarmless),
                     [&](std::string_view head) { return extension.starts_with(head); });
}

bool decode_base64(std::string_view text, std::string& bytes) {
  std::array<int, 256> value{};
  value.fill(-1);
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t k = 0; k < kDigits.size(); ++k)
    value[static_cast<unsigned char>(kDigits[k])] = static_cast<int>(k);
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = value[static_cast<unsigned char>(c)];
    if (digit < 0) return false;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(held) & 0xFFU);
  }
  return true;
}

/// A URI's name of a file: %20 is a blank. Empty where it is none beside or below the file read.
std::string file_name_of(std::string_view uri) {
  std::string name;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    unsigned code = 0;
    const auto digit = [&](char c) {
      const int d = c >= '0' && c <= '9'   ? c - '0'
                    : c >= 'a' && c <= 'f' ? c - 'a' + 10
                    : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                           : -1;
      code = 16 * code + static_cast<unsigned>(std::max(d, 0));
      return d >= 0;
    };
    if (uri[k] == '%' && k + 2 < uri.size() && digit(uri[k + 1]) && digit(uri[k + 2])) {
      name += static_cast<char>(code);
      k += 2;
    } else {
      name += uri[k];
    }
  }
  const bool outside = name.starts_with('/') || name.find("://") != std::string::npos ||
                       name.find('\\') != std::string::npos ||
                       ("/" + name + "/").find("/../") != std::string::npos ||
                       name.find('\0') != std::string::npos;
  return outside ? std::string() : name;
}

/// Makes the JSON, without exceptions, and knows where it is wrong.
struct JsonBuilder : nlohmann::detail::json_sax_dom_parser<Json> {
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;
  explicit JsonBuilder(Json& json) : Base(json, false) {}
  template <class Fault>
  bool parse_error(std::size_t position, const std::string& token, const Fault& fault) {
    at = position;
    return Base::parse_error(position, token, fault);
  }
  std::size_t at = 0;  ///< bytes read until the fault
};

}  // namespace

double GltfAccessor::number(std::size_t index, int part) const {
  const char* const from =
      data + index * stride + static_cast<std::size_t>(part) * size_of_component(component);
  const auto scaled = [this](double value, double most) {
    return normalized ? std::max(value / most, -1.0) : value;
  };
  switch (component) {
    case 5120: return scaled(load_little<std::int8_t>(from), 127);
    case 5121: return scaled(load_little<std::uint8_t>(from), 255);
    case 5122: return scaled(load_little<std::int16_t>(from), 32767);
    case 5123: return scaled(load_little<std::uint16_t>(from), 65535);
    case 5125: return load_little<std::uint32_t>(from);
    default: return double{load_little<float>(from)};
  }
}

std::uint32_t GltfAccessor::whole(std::size_t index) const {
  const char* const from = data + index * stride;
  switch (component) {
    case 5121: return load_little<std::uint8_t>(from);
    case 5123: return load_little<std::uint16_t>(from);
    default: return load_little<std::uint32_t>(from);
  }
}

GltfDocument::GltfDocument(std::string_view content, std::string path, Open open)
    : content_(content), path_(std::move(path)), open_(std::move(open)) {}

bool GltfDocument::fail(const std::string& where, const std::string& what, std::string hint) {
  error_ = {(where.empty() ? "" : where + ": ") + what, std::move(hint), path_, 0, 0};
  return false;
}

bool GltfDocument::read() {
  std::string_view text = content_;
  if (content_.starts_with("glTF") && !split_chunks(text)) return false;
  if (!parse(text, static_cast<std::size_t>(text.data() - content_.data()))) return false;
  if (!json_.is_object()) return fail("", "the JSON of a glTF file is an object");
  const Json* asset = object(json_, "asset");
  const std::string version =
      asset != nullptr && asset->contains("version") && asset->at("version").is_string()
          ? asset->at("version").get<std::string>()
          : "";
  if (!version.starts_with("2."))
    return fail("asset", version.empty() ? "no version of glTF is stated"
                                         : "glTF " + in_quotes(version) + " is not read, only 2.x");
  buffers_.resize(count("buffers"));
  return check_extensions();
}

/// The JSON and the binary chunk of a GLB; others are passed over.
bool GltfDocument::split_chunks(std::string_view& json) {
  const auto field = [&](std::size_t at) {
    return load_little<std::uint32_t>(content_.data() + at);
  };
  if (content_.size() < 20) return fail("", "the file ends inside the head of a glb file");
  if (field(4) != 2) return fail("", "glb version " + std::to_string(field(4)) + ", expected 2");
  const std::size_t stated = field(8);
  if (stated > content_.size())
    return fail("", "a glb file of " + std::to_string(stated) + " bytes, this one has " +
                        std::to_string(content_.size()));
  bool has_json = false;
  for (std::size_t at = 12; at < stated;) {
    if (stated - at < 8)
      return fail("", "the file ends inside a chunk at byte " + std::to_string(at));
    const std::size_t size = field(at), rest = stated - at - 8;
    if (size > rest)
      return fail("", "a chunk of " + std::to_string(size) + " bytes at byte " +
                          std::to_string(at) + ", where " + std::to_string(rest) + " are left");
    const std::string_view chunk = content_.substr(at + 8, size);
    if (!has_json) {
      if (field(at + 4) != kJsonChunk) return fail("", "the first chunk is not JSON");
      json = chunk;
      has_json = true;
    } else if (field(at + 4) == kBinaryChunk && !has_binary_) {
      binary_ = chunk;
      has_binary_ = true;
    }
    at += 8 + size;
  }
  return has_json || fail("", "the file has no JSON");
}

bool GltfDocument::parse(std::string_view text, std::size_t at) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  JsonBuilder builder(json_);
  if (Json::sax_parse(text, &builder)) return true;
  const std::size_t byte = std::min(std::max<std::size_t>(builder.at, 1) - 1, text.size());
  if (content_.starts_with("glTF"))
    return fail("", "the JSON is wrong at byte " + std::to_string(at + byte));
  const std::string_view before = text.substr(0, byte);
  fail("", "the JSON is wrong here");
  error_.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  error_.column = static_cast<int>(byte - (before.rfind('\n') + 1)) + 1;
  return false;
}

bool GltfDocument::check_extensions() {
  const Json* required = list(json_, "extensionsRequired");
  if (required == nullptr) return true;
  for (const Json& name : *required) {
    if (name.is_string() && is_harmless(name.get<std::string>())) continue;
    return fail("extensionsRequired",
                "the extension " + (name.is_string() ? in_quotes(name.get<std::string>()) : "?") +
                    " is not read",
                "export the mesh without compression and extensions");
  }
  return true;
}

const Json* GltfDocument::object(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_object() ? &*at : nullptr;
}
const Json* GltfDocument::list(const Json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_array() ? &*at : nullptr;
}

std::size_t GltfDocument::count(const char* name) const {
  const Json* all = list(json_, name);
  return all == nullptr ? 0 : all->size();
}

const Json* GltfDocument::entry(const char* name, std::uint64_t index, const std::string& from) {
  const Json* all = list(json_, name);
  const std::size_t size = all == nullptr ? 0 : all->size();
  if (index >= size) {
    fail(from, std::string(name) + "[" + std::to_string(index) + "] is meant, but there are " +
                   std::to_string(size));
    return nullptr;
  }
  const Json& found = (*all)[static_cast<std::size_t>(index)];
  if (found.is_object()) return &found;
  fail(std::string(name) + "[" + std::to_string(index) + "]", "expected an object");
  return nullptr;
}

bool GltfDocument::whole(const Json& object, const std::string& where, const char* key,
                         std::uint64_t& value, const std::uint64_t* standard) {
  const auto at = object.find(key);
  if (at == object.end()) {
    if (standard == nullptr) return fail(where, std::string("'") + key + "' is missing");
    value = *standard;
    return true;
  }
  if (at->is_number_unsigned()) {
    value = at->get<std::uint64_t>();
    if (value <= kMostExact) return true;
  } else if (at->is_number_float()) {  // some exporters write 3.0
    const double number = at->get<double>();
    if (number >= 0 && number <= static_cast<double>(kMostExact) && number == std::floor(number)) {
      value = static_cast<std::uint64_t>(number);
      return true;
    }
  }
  return fail(where, std::string("'") + key + "' is no whole number from 0 on");
}

bool GltfDocument::load(const Json& entry, std::uint64_t index, const std::string& where) {
  Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
  const auto uri = entry.find("uri");
  if (uri == entry.end()) {
    if (index > 0 || !has_binary_) return fail(where, "has no 'uri', and the file no data for it");
    buffer.bytes = binary_;
    return true;
  }
  if (!uri->is_string()) return fail(where, "'uri' is no text");
  const auto& text = uri->get_ref<const std::string&>();
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    const std::string_view head = std::string_view(text).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
      return fail(where, "data in the file are read in base64 only");
    if (!decode_base64(std::string_view(text).substr(comma + 1), buffer.own))
      return fail(where, "the base64 data hold other characters");
  } else {
    const std::string name = file_name_of(text);
    if (name.empty()) return fail(where, "the file " + in_quotes(text) + " is not beside this one");
    if (!open_)
      return fail(where, "the data are in another file, " + in_quotes(text),
                  "read the mesh by its name, or export glb, which is one file");
    Result<std::string> content = open_(name);
    if (!content) {
      error_ = content.error();
      return false;
    }
    buffer.own = *std::move(content);
  }
  buffer.bytes = buffer.own;
  return true;
}

bool GltfDocument::buffer(std::uint64_t index, const std::string& from, std::string_view& bytes) {
  const Json* found = entry("buffers", index, from);
  if (found == nullptr) return false;
  const std::string where = "buffers[" + std::to_string(index) + "]";
  Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
  if (!buffer.loaded) {
    if (!load(*found, index, where)) return false;
    std::uint64_t length = 0;
    if (!whole(*found, where, "byteLength", length)) return false;
    if (length > buffer.bytes.size())
      return fail(where, "'byteLength' is " + std::to_string(length) + ", but there are " +
                             std::to_string(buffer.bytes.size()) + " bytes");
    buffer.bytes = buffer.bytes.substr(0, static_cast<std::size_t>(length));
    buffer.loaded = true;
  }
  bytes = buffer.bytes;
  return true;
}

bool GltfDocument::accessor(std::uint64_t index, const std::string& from, GltfAccessor& result) {
  const Json* found = entry("accessors", index, from);
  if (found == nullptr) return false;
  const std::string where = "accessors[" + std::to_string(index) + "]";
  if (found->contains("sparse"))
    return fail(where, "sparse accessors are not read", "export the mesh without them");
  if (!found->contains("bufferView")) return fail(where, "has no 'bufferView', so no data");
  std::uint64_t view = 0, offset = 0, count = 0, component = 0;
  const std::uint64_t zero = 0;
  if (!whole(*found, where, "bufferView", view) ||
      !whole(*found, where, "byteOffset", offset, &zero) || !whole(*found, where, "count", count) ||
      !whole(*found, where, "componentType", component))
    return false;
  const auto type = found->find("type");
  result.parts = type != found->end() && type->is_string() ? parts_of(type->get<std::string>()) : 0;
  result.component = static_cast<int>(std::min<std::uint64_t>(component, 1U << 20U));
  const std::size_t size = size_of_component(result.component);
  if (result.parts == 0 || size == 0) return fail(where, "unknown 'type' or 'componentType'");
  const auto normalized = found->find("normalized");
  result.normalized =
      normalized != found->end() && normalized->is_boolean() && normalized->get<bool>();

  const Json* view_entry = entry("bufferViews", view, where);
  if (view_entry == nullptr) return false;
  const std::string view_where = "bufferViews[" + std::to_string(view) + "]";
  std::uint64_t number = 0, begin = 0, length = 0, stride = 0;
  const std::uint64_t packed = size * static_cast<std::size_t>(result.parts);
  if (!whole(*view_entry, view_where, "buffer", number) ||
      !whole(*view_entry, view_where, "byteOffset", begin, &zero) ||
      !whole(*view_entry, view_where, "byteLength", length) ||
      !whole(*view_entry, view_where, "byteStride", stride, &packed))
    return false;
  std::string_view bytes;
  if (!buffer(number, view_where, bytes)) return false;
  if (begin > bytes.size() || length > bytes.size() - begin)
    return fail(view_where,
                "reaches beyond its buffer of " + std::to_string(bytes.size()) + " bytes");
  if (stride < packed) return fail(view_where, "'byteStride' is less than an element");
  if (count == 0) return fail(where, "'count' is 0");
  // in this order nothing overflows
  if (offset > length || length - offset < packed ||
      count - 1 > (length - offset - packed) / stride)
    return fail(where, std::to_string(count) + " elements do not fit into " + view_where + " of " +
                           std::to_string(length) + " bytes");
  result.data = bytes.data() + begin + offset;
  result.count = static_cast<std::size_t>(count);
  result.stride = static_cast<std::size_t>(stride);
  return true;
}

}  // namespace limn::io
