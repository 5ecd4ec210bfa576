#pragma once
/// A large array of numbers of which only parts are in memory: those that were written since
/// `drop`.

#include <cstddef>
#include <utility>

namespace limn::base {

/// `size` numbers, zero until they are written; the pages of those that never are take no memory,
/// where the system can do that.
class SparseArray {
 public:
  /// Small ones hold what is written in many places, and little more; huge ones are for an array
  /// that is written as a whole, as their first touch costs a small part.
  enum class Pages { small, huge };

  SparseArray() = default;
  /// Throws std::bad_alloc where not even addresses are left.
  explicit SparseArray(std::size_t size, Pages pages = Pages::small);
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

  /// Numbers first … first + count - 1 will be written: their pages are had at once, where the
  /// system can do that, in place of by a fault each. From several threads at once.
  void prepare(std::size_t first, std::size_t count) noexcept;

  /// Gives the memory back; all numbers are unknown afterwards.
  void drop() noexcept;

 private:
  double* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace limn::base
