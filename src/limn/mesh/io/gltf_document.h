#pragma once
/// The JSON of a glTF file with its buffers, every access checked. [glTF 2.0 §5]

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "limn/base/error.h"

namespace limn::io {

/// The kinds of a GLB file's chunks: "JSON" and "BIN".
inline constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Numbers in a buffer: `count` elements of `parts` numbers of one type, `stride` bytes apart.
struct GltfAccessor {
  const char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int parts = 0;
  int component = 0;  ///< the type of its numbers, as glTF codes it
  bool normalized = false;

  /// Part `part` of element `index`, both within range.
  [[nodiscard]] double number(std::size_t index, int part) const;
  /// That of a type of whole numbers.
  [[nodiscard]] std::uint32_t whole(std::size_t index) const;
};

/// Finds what entries refer to. The first fault is kept: functions that can meet one return false
/// or null. What entries say of where they are is "accessors[3]".
class GltfDocument {
 public:
  using Json = nlohmann::json;
  /// Reads a file beside the one that is read.
  using Open = std::function<Result<std::string>(const std::string& name)>;

  /// `content`: a GLB, or the JSON alone; it must outlive the document.
  GltfDocument(std::string_view content, std::string path, Open open);

  /// Reads containers, JSON and version, and refuses what must be understood and is not.
  bool read();
  [[nodiscard]] const Json& json() const { return json_; }
  [[nodiscard]] const Error& error() const { return error_; }
  /// Records a fault, and returns false.
  bool fail(const std::string& where, const std::string& what, std::string hint = {});

  /// How many entries the list has; 0 where it is missing.
  [[nodiscard]] std::size_t count(const char* list) const;
  /// An entry of a list of the document, which is an object; null and a fault where there is none.
  const Json* entry(const char* list, std::uint64_t index, const std::string& from);
  /// A number from 0 to 2^53 under `key`; where that is missing, `standard`, or a fault if there is
  /// none of that either.
  bool whole(const Json& object, const std::string& where, const char* key, std::uint64_t& value,
             const std::uint64_t* standard = nullptr);
  /// An object or a list under `key`, or null where it is missing or is something else.
  static const Json* object(const Json& object, const char* key);
  static const Json* list(const Json& object, const char* key);

  /// The numbers of an accessor, checked to lie within their buffer.
  bool accessor(std::uint64_t index, const std::string& from, GltfAccessor& result);

 private:
  bool split_chunks(std::string_view& json);
  bool parse(std::string_view text, std::size_t at);
  bool check_extensions();
  bool buffer(std::uint64_t index, const std::string& from, std::string_view& bytes);
  bool load(const Json& entry, std::uint64_t index, const std::string& where);

  std::string_view content_;
  std::string path_;
  Open open_;
  Json json_;
  bool has_binary_ = false;
  std::string_view binary_;  ///< of a GLB
  struct Buffer {
    bool loaded = false;
    std::string own;
    std::string_view bytes;
  };
  std::vector<Buffer> buffers_;
  Error error_;
};

}  // namespace limn::io
