#pragma once
/// A large array of numbers of which only parts are in memory: those that were written since
/// `drop`.

#include <cstddef>
#include <utility>

namespace limn {

/// `size` numbers, zero until they are written; the pages of those that never are take no memory,
/// where the system can do that.
class SparseArray {
 public:
  SparseArray() = default;
  /// Throws std::bad_alloc where not even addresses are left.
  explicit SparseArray(std::size_t size);
  SparseArray(SparseArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  SparseArray& operator=(SparseArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  SparseArray(const SparseArray&) = delete;
  SparseArray& operator=(const SparseArray&) = delete;
  ~SparseArray();

  [[nodiscard]] double* data() { return data_; }
  [[nodiscard]] const double* data() const { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Gives the memory back; all numbers are unknown afterwards.
  void drop() noexcept;

 private:
  double* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace limn
