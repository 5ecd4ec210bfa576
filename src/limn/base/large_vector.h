#pragma once
/// Vectors for results that are written once and handed out. Where the system has huge pages to
/// give, their first touch costs a few faults, not one for every 4 KiB: on a virtual machine these
/// faults may take longer than the work. (huge_array.h: memory that is nobody's but the engine's.)

#include <cstddef>
#include <vector>

namespace limn::base {

namespace detail {
/// Asks for huge pages where the range spans some; nothing happens where there are none.
void advise_huge(void* memory, std::size_t bytes) noexcept;
}  // namespace detail

/// Room for `size` values, to be filled by push_back. Cost: none but the allocation.
template <class T>
void reserve_large(std::vector<T>& values, std::size_t size) {
  values.reserve(size);
  detail::advise_huge(values.data(), values.capacity() * sizeof(T));
}

/// `size` values, each as T{} is, or as `value`. Cost O(size).
template <class T>
[[nodiscard]] std::vector<T> large_vector(std::size_t size, const T& value = T{}) {
  std::vector<T> values;
  reserve_large(values, size);
  values.resize(size, value);
  return values;
}

}  // namespace limn::base
