#pragma once
/// Large arrays of plain numbers: nothing is cleared before it is filled, and the memory comes in
/// huge pages where the system gives them, so that the first touch costs a few faults, not one per
/// 4 KiB.

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace limn::base {

namespace detail {
/// Memory of at least `bytes`, aligned to 64; throws std::bad_alloc.
[[nodiscard]] void* allocate_huge(std::size_t bytes);
void free_huge(void* memory) noexcept;
}  // namespace detail

/// `size` elements whose values are whatever the memory holds until they are written.
template <class T>
class HugeArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  /// No elements, no memory.
  HugeArray() = default;
  /// Memory for `size` elements, not written yet. Throws std::bad_alloc.
  explicit HugeArray(std::size_t size)
      : data_(static_cast<T*>(detail::allocate_huge(size * sizeof(T)))), size_(size) {}
  /// A copy of `values`.
  explicit HugeArray(std::span<const T> values) : HugeArray(values.size()) {
    std::copy(values.begin(), values.end(), data_);
  }
  /// Takes the memory; `other` is empty afterwards.
  HugeArray(HugeArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  /// Exchanges the memory of the two.
  HugeArray& operator=(HugeArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  HugeArray(const HugeArray&) = delete;
  HugeArray& operator=(const HugeArray&) = delete;
  ~HugeArray() { detail::free_huge(data_); }

  ///@{
  /// As of std::vector; an index is not checked.
  [[nodiscard]] T* data() { return data_; }
  [[nodiscard]] const T* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return data_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return data_[i]; }
  [[nodiscard]] T* begin() { return data_; }
  [[nodiscard]] T* end() { return data_ + size_; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }
  [[nodiscard]] operator std::span<T>() { return {data_, size_}; }
  [[nodiscard]] operator std::span<const T>() const { return {data_, size_}; }
  ///@}

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace limn::base
