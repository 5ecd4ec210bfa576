#pragma once
/// Linear algebra over an exact field (Rational, Modular): matrices, subspaces, spinning.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace limn::regular {

template <class Field>
using FieldVector = std::vector<Field>;
/// Row by row.
template <class Field>
using FieldMatrix = std::vector<FieldVector<Field>>;

/// Cost: entries of the matrix; zeros of the vector are cheap.
template <class Field>
[[nodiscard]] FieldVector<Field> product(const FieldMatrix<Field>& a, const FieldVector<Field>& x) {
  const Field zero(0);
  std::vector<std::size_t> support;
  for (std::size_t j = 0; j < x.size(); ++j)
    if (x[j] != zero) support.push_back(j);
  FieldVector<Field> y(a.size(), zero);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const std::size_t j : support)
      if (a[i][j] != zero) y[i] += a[i][j] * x[j];
  return y;
}

template <class Field>
[[nodiscard]] FieldMatrix<Field> transposed(const FieldMatrix<Field>& a) {
  FieldMatrix<Field> result(a.empty() ? 0 : a.front().size(),
                            FieldVector<Field>(a.size(), Field(0)));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a[i].size(); ++j) result[j][i] = a[i][j];
  return result;
}

template <class Field>
[[nodiscard]] FieldMatrix<Field> product(const FieldMatrix<Field>& a, const FieldMatrix<Field>& b) {
  FieldMatrix<Field> columns;
  for (const FieldVector<Field>& column : transposed(b)) columns.push_back(product(a, column));
  return transposed(columns);
}

/// A subspace by its reduced row echelon basis: each row has a 1 at its pivot, where the others
/// have 0. The basis depends on the subspace alone.
template <class Field>
class Echelon {
 public:
  explicit Echelon(std::size_t size) : size_(size), row_at_(size, kNone) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t dimension() const { return rows_.size(); }
  [[nodiscard]] const std::vector<FieldVector<Field>>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<std::size_t>& pivots() const { return pivots_; }
  [[nodiscard]] bool is_pivot(std::size_t column) const { return row_at_[column] != kNone; }
  [[nodiscard]] std::vector<std::size_t> free_columns() const {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < size_; ++c)
      if (!is_pivot(c)) columns.push_back(c);
    return columns;
  }

  /// The vector less that combination of the basis which leaves 0 at every pivot.
  [[nodiscard]] FieldVector<Field> reduced(FieldVector<Field> v) const {
    const Field zero(0);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Field factor = v[pivots_[r]];
      if (factor == zero) continue;
      for (std::size_t c = 0; c < size_; ++c)
        if (rows_[r][c] != zero) v[c] -= factor * rows_[r][c];
    }
    return v;
  }
  [[nodiscard]] bool contains(const FieldVector<Field>& v) const {
    const FieldVector<Field> rest = reduced(v);
    for (const Field& entry : rest)
      if (entry != Field(0)) return false;
    return true;
  }
  /// Adds a vector; false where it lies in the subspace already. Cost: dimension · size.
  bool insert(const FieldVector<Field>& vector) {
    const Field zero(0);
    FieldVector<Field> v = reduced(vector);
    std::size_t pivot = 0;
    while (pivot < size_ && v[pivot] == zero) ++pivot;
    if (pivot == size_) return false;
    const Field lead = v[pivot];
    for (Field& entry : v)
      if (entry != zero) entry /= lead;
    for (FieldVector<Field>& row : rows_) {
      const Field factor = row[pivot];
      if (factor == zero) continue;
      for (std::size_t c = 0; c < size_; ++c)
        if (v[c] != zero) row[c] -= factor * v[c];
    }
    row_at_[pivot] = rows_.size();
    pivots_.push_back(pivot);
    rows_.push_back(std::move(v));
    return true;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::size_t size_;
  std::vector<FieldVector<Field>> rows_;
  std::vector<std::size_t> pivots_;
  std::vector<std::size_t> row_at_;
};

/// The vectors x with row·x = 0 for every row of the subspace, as a subspace.
template <class Field>
[[nodiscard]] Echelon<Field> annihilator(const Echelon<Field>& rows) {
  Echelon<Field> result(rows.size());
  for (const std::size_t free : rows.free_columns()) {
    FieldVector<Field> x(rows.size(), Field(0));
    x[free] = Field(1);
    for (std::size_t r = 0; r < rows.dimension(); ++r)
      x[rows.pivots()[r]] = Field(0) - rows.rows()[r][free];
    result.insert(x);
  }
  return result;
}

/// Coordinates along given vectors.
template <class Field>
class Coordinates {
 public:
  /// Cost: count · dimension · (size + count). Precondition: at least one vector, all of one size.
  explicit Coordinates(const std::vector<FieldVector<Field>>& vectors)
      : size_(vectors.front().size()), span_(size_ + vectors.size()) {
    // the row (v_i, e_i) for each vector: what reduces u to 0 tells the coefficients
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      FieldVector<Field> row = vectors[i];
      row.resize(span_.size(), Field(0));
      row[size_ + i] = Field(1);
      span_.insert(row);
    }
  }
  /// Some c with Σ c_i v_i = u; nothing where u lies outside the span.
  [[nodiscard]] std::optional<FieldVector<Field>> of(FieldVector<Field> u) const {
    u.resize(span_.size(), Field(0));
    const FieldVector<Field> rest = span_.reduced(std::move(u));
    for (std::size_t j = 0; j < size_; ++j)
      if (rest[j] != Field(0)) return std::nullopt;
    FieldVector<Field> coordinates;
    for (std::size_t i = size_; i < rest.size(); ++i) coordinates.push_back(Field(0) - rest[i]);
    return coordinates;
  }

 private:
  std::size_t size_;
  Echelon<Field> span_;
};

/// The null space of a matrix.
template <class Field>
[[nodiscard]] Echelon<Field> null_space(const FieldMatrix<Field>& a) {
  Echelon<Field> rows(a.front().size());
  for (const FieldVector<Field>& row : a) rows.insert(row);
  return annihilator(rows);
}

/// The least subspace that holds the seeds and that every matrix maps to itself.
/// Cost: dimension² · size · number of matrices.
template <class Field>
[[nodiscard]] Echelon<Field> spun(const std::vector<FieldMatrix<Field>>& matrices,
                                  std::vector<FieldVector<Field>> seeds) {
  Echelon<Field> space(matrices.front().size());
  while (!seeds.empty() && space.dimension() < space.size()) {
    const FieldVector<Field> v = std::move(seeds.back());
    seeds.pop_back();
    if (!space.insert(v)) continue;
    for (const FieldMatrix<Field>& matrix : matrices) seeds.push_back(product(matrix, v));
  }
  return space;
}

}  // namespace limn::regular
