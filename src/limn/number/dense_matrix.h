#pragma once
/// A matrix of any number type, and no more than certificates need of one.

#include <cstddef>
#include <vector>

namespace limn::number {

/// Row by row.
template <class Number>
class DenseMatrix {
 public:
  DenseMatrix() = default;
  DenseMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), entries_(rows * columns) {}
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  Number& operator()(std::size_t row, std::size_t column) {
    return entries_[row * columns_ + column];
  }
  const Number& operator()(std::size_t row, std::size_t column) const {
    return entries_[row * columns_ + column];
  }

 private:
  std::size_t rows_ = 0, columns_ = 0;
  std::vector<Number> entries_;
};

}  // namespace limn::number
