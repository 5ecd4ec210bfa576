#pragma once
/// Numbers as bytes, in a byte order that does not depend on the machine.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>

namespace limn::io {

inline constexpr bool kLittleEndianHost = std::endian::native == std::endian::little;

/// The number stored at `from`; `swap`: in the other byte order than the machine's.
template <class T>
T load(const char* from, bool swap) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, from, sizeof(T));
  if (swap) std::reverse(bytes, bytes + sizeof(T));
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T>
T load_little(const char* from) {
  return load<T>(from, !kLittleEndianHost);
}

/// Stores `value` at `to` in little-endian order and returns the place behind it.
template <class T>
char* store_little(char* to, T value) {
  std::memcpy(to, &value, sizeof(T));
  if (!kLittleEndianHost) std::reverse(to, to + sizeof(T));
  return to + sizeof(T);
}

/// Appends the values, one after the other, in little-endian order.
template <class... T>
void append_little(std::string& out, T... values) {
  char bytes[(sizeof(T) + ...)];
  char* to = bytes;
  ((to = store_little(to, values)), ...);
  out.append(bytes, sizeof bytes);
}

}  // namespace limn::io
