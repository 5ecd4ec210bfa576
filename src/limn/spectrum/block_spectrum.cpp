#include "limn/spectrum/frequency_blocks.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "limn/spectrum/connected_parts.h"

namespace limn {
namespace {

using Values = std::vector<std::complex<double>>;

constexpr double kZeroBelow = 1e-14;  // of entries, which are of order 1
constexpr double kRowSum = 1e-13;     // how far a sum that is 1 may be off

bool within(std::complex<double> a, std::complex<double> b, double radius) {
  return std::norm(a - b) < radius * radius;
}

/// Whether the numerical rank is at most this, by QR with column pivots: entries are of order 1.
template <class Matrix>
bool rank_is_within(Eigen::Index most, const Matrix& matrix, double threshold) {
  const bool is_zero = (matrix.array().abs() <= threshold).all();
  if (is_zero || most == 0) return is_zero;
  const Eigen::ColPivHouseholderQR<Matrix> qr(matrix);
  return (qr.matrixR().diagonal().cwiseAbs().array() > threshold).count() <= most;
}

template <class Matrix>
Matrix shifted(Matrix matrix, typename Matrix::Scalar lambda) {
  matrix.diagonal().array() -= lambda;
  return matrix;
}

/// Size of the largest Jordan block of λ: the powers of S-λ until their rank falls no more.
template <class Matrix>
int jordan_size(const Matrix& square, typename Matrix::Scalar lambda, int multiplicity) {
  const Matrix difference = shifted(square, lambda);
  Matrix power = difference;
  // the nullity grows with the power until it is the multiplicity
  for (int size = 1; size < multiplicity; ++size) {
    if (rank_is_within(square.rows() - multiplicity, power, 1e-9)) return size;
    power *= difference;
  }
  return multiplicity;
}

/// Whether λ is an eigenvalue of this multiplicity, up to rounding: the rank of (S-λ)^m is less by
/// m, however defective λ is.
template <class Matrix>
bool is_multiple(const Matrix& square, typename Matrix::Scalar lambda, int multiplicity) {
  const Matrix difference = shifted(square, lambda);
  Matrix power = difference;
  for (int i = 1; i < multiplicity; ++i) power *= difference;
  // rounding parts a double one by some 1e-8, and larger ones farther
  const double threshold = multiplicity > 2 ? 1e-12 : 1e-14;
  return rank_is_within(square.rows() - multiplicity, power, threshold);
}

/// λ as an entry of a real or of a complex matrix; a complex one of a real matrix stays as it is.
template <class Matrix, class Use>
auto with_scalar(const Matrix& matrix, std::complex<double> lambda, Use use) {
  if constexpr (std::is_same_v<typename Matrix::Scalar, double>) {
    if (lambda.imag() == 0) return use(matrix, lambda.real());
    return use(Eigen::MatrixXcd(matrix), lambda);
  } else {
    return use(matrix, lambda);
  }
}

/// Gives values within `radius` of one another their mean, where that is one multiple eigenvalue.
template <class Matrix>
void join_within(double radius, const Matrix& square, Values& values) {
  std::vector<bool> seen(values.size(), false);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<std::size_t> near;
    std::complex<double> mean = 0;
    double spread = 0;
    for (std::size_t j = i; j < values.size(); ++j) {
      if (seen[j] || std::abs(values[j] - values[i]) > radius) continue;
      near.push_back(j);
      mean += values[j];
      spread = std::max(spread, std::abs(values[j] - values[i]));
    }
    if (near.size() < 2 || spread < 1e-14) continue;
    mean /= static_cast<double>(near.size());
    if (std::abs(mean.imag()) < 1e-12) mean = mean.real();
    const int multiplicity = static_cast<int>(near.size());
    if (!with_scalar(square, mean, [&](const auto& matrix, auto lambda) {
          return is_multiple(matrix, lambda, multiplicity);
        }))
      continue;
    for (const std::size_t j : near) {
      values[j] = mean;
      seen[j] = true;
    }
  }
}

/// Rounding splits a defective eigenvalue of size k by the k-th root of its error; the mean of the
/// parts stays exact. So values near one another that are one multiple eigenvalue get their mean.
template <class Matrix>
void join_split_ones(const Matrix& square, Values& values) {
  constexpr double kFarthest = 1e-3;
  bool any = false;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) any = any || within(values[i], values[j], 2 * kFarthest);
  if (!any) return;
  for (const double radius : {kFarthest, 1e-5, 1e-7}) join_within(radius, square, values);
}

/// Eigenvalues of small matrices, with memory that is kept from one to the next.
class Solver {
 public:
  template <class Matrix>
  void append(const Matrix& square, Values& values) {
    if (square.rows() == 1) {
      values.emplace_back(square(0, 0));
      return;
    }
    if (square.rows() == 2) {
      const std::complex<double> middle = (square(0, 0) + square(1, 1)) / 2.0;
      const std::complex<double> half = (square(0, 0) - square(1, 1)) / 2.0;
      const std::complex<double> root = std::sqrt(half * half + square(0, 1) * square(1, 0));
      values.push_back(middle + root);
      values.push_back(middle - root);
      return;
    }
    const auto& found = solver(square).compute(square, false).eigenvalues();
    values.insert(values.end(), found.begin(), found.end());
  }

 private:
  Eigen::EigenSolver<Eigen::MatrixXd>& solver(const Eigen::MatrixXd& /*square*/) { return real_; }
  Eigen::ComplexEigenSolver<Eigen::MatrixXcd>& solver(const Eigen::MatrixXcd& /*square*/) {
    return complex_;
  }

  Eigen::EigenSolver<Eigen::MatrixXd> real_;
  Eigen::ComplexEigenSolver<Eigen::MatrixXcd> complex_;
};

bool larger(const Eigenvalue& a, const Eigenvalue& b) {
  const double x = a.modulus();
  const double y = b.modulus();
  if (std::abs(x - y) > kEqualBelow) return x > y;
  if (std::abs(a.value.real() - b.value.real()) > kEqualBelow)
    return a.value.real() > b.value.real();
  if (a.ring != b.ring) return a.ring < b.ring;
  return a.value.imag() > b.value.imag();
}

}  // namespace

class SpectrumReader::Work {
 public:
  explicit Work(const FrequencyBlocks& blocks) : blocks_(blocks) {
    for (std::size_t a = 0; a < blocks.orbits.size(); ++a)
      for (std::size_t b = a + 1; b < blocks.orbits.size(); ++b) {
        const double turns = blocks.orbits[a].angle + blocks.orbits[b].angle;
        if (blocks.orbits[a].ring == blocks.orbits[b].ring &&
            std::abs(turns - std::nearbyint(turns)) < 1e-12)
          partners_.emplace_back(a, b);
      }
    constant_.assign(at(blocks.blocks.front().rows()), 1);
    const std::size_t shift = at(shift_of(blocks.blocks.front().rows()));
    for (const auto& [a, b] : partners_) {  // (1 + 1)/√2, and nothing of the difference
      constant_[a + shift] = std::sqrt(2.0);
      constant_[b + shift] = 0;
    }
  }

  BlockSpectrum at(int omega, Near near) {
    block_ = blocks_.blocks[static_cast<std::size_t>(omega)];
    mirror();
    if (block_.imag().cwiseAbs().maxCoeff() >= kZeroBelow)
      return {omega, eigenvalues(block_, omega, near)};
    real_block_ = block_.real();
    return {omega, eigenvalues(real_block_, omega, near)};
  }

 private:
  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  /// The rows before the orbits': the centre's, of frequency 0.
  [[nodiscard]] Eigen::Index shift() const { return shift_of(block_.rows()); }
  [[nodiscard]] Eigen::Index shift_of(Eigen::Index rows) const {
    return rows - static_cast<Eigen::Index>(blocks_.orbits.size());
  }

  /// Puts the block in real coordinates. A mirror through spoke 0 carries each orbit to one of its
  /// own ring and conjugates amplitudes, so (x + y)/√2 and i (x - y)/√2 of partners x, y map to one
  /// another by a real matrix.
  void mirror() {
    const double half = std::sqrt(0.5);
    const auto times_i = [](std::complex<double> z) {
      return std::complex<double>(-z.imag(), z.real());
    };
    for (const auto& [a, b] : partners_) {
      const Eigen::Index x = static_cast<Eigen::Index>(a) + shift();
      const Eigen::Index y = static_cast<Eigen::Index>(b) + shift();
      for (Eigen::Index j = 0; j < block_.cols(); ++j) {
        const std::complex<double> p = half * block_(x, j);
        const std::complex<double> q = half * block_(y, j);
        block_(x, j) = p + q;
        block_(y, j) = times_i(p - q);
      }
      for (Eigen::Index i = 0; i < block_.rows(); ++i) {
        const std::complex<double> p = half * block_(i, x);
        const std::complex<double> q = half * block_(i, y);
        block_(i, x) = p + q;
        block_(i, y) = times_i(q - p);
      }
    }
  }

  /// Finds parts and their rings, if the block's zeros are not those of the block before.
  template <class Matrix>
  void connect(const Matrix& block) {
    pattern_ = block.array().abs() > kZeroBelow;
    if (pattern_.rows() == known_.rows() && (pattern_ == known_).all()) return;
    known_ = pattern_;
    connected_ = spectrum::connected_parts(known_);
    rings_.assign(connected_.parts.size(), 0);
    Eigen::Index first = 0;
    for (Eigen::Index end = shift(); end < block.rows();) {
      const auto ring_of = [&](Eigen::Index row) {
        return blocks_.orbits[static_cast<std::size_t>(row - shift())].ring;
      };
      const int ring = ring_of(end);
      while (end < block.rows() && ring_of(end) == ring) ++end;
      if (known_.topRightCorner(end, block.rows() - end).any()) continue;
      // these rings are invariant, and have what rows first … end-1 add to those further in
      for (; first < end; ++first)
        rings_[connected_.part_of[static_cast<std::size_t>(first)]] = ring;
    }
  }

  /// The eigenvalue 1 of rows that sum to 1 is known: with it their matrix loses a row, and what is
  /// left has the others, however near to 1 they are.
  template <class Matrix>
  void take_constant(const std::vector<Eigen::Index>& rows, Matrix& square) {
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::VectorXd constant(size);
    for (Eigen::Index i = 0; i < size; ++i) constant(i) = constant_[at(rows[at(i)])];
    Eigen::Index pivot = 0;
    if (!(constant.cwiseAbs().maxCoeff(&pivot) > 0)) return;
    if (!((square * constant - constant).cwiseAbs().maxCoeff() < kRowSum)) return;
    values_.emplace_back(1);
    const Matrix whole = square;
    square.resize(size - 1, size - 1);
    const auto kept = [&](Eigen::Index i) { return i < pivot ? i : i + 1; };
    for (Eigen::Index i = 0; i + 1 < size; ++i)
      for (Eigen::Index j = 0; j + 1 < size; ++j)
        square(i, j) =
            whole(kept(i), kept(j)) - constant(kept(i)) / constant(pivot) * whole(pivot, kept(j));
  }

  template <class Matrix>
  std::vector<Eigenvalue> eigenvalues(const Matrix& block, int omega, Near near) {
    connect(block);
    std::vector<Eigenvalue> list;
    list.reserve(static_cast<std::size_t>(block.rows()));
    ends_.clear();
    for (std::size_t part = 0; part < connected_.parts.size(); ++part) {
      const std::vector<Eigen::Index>& rows = connected_.parts[part];
      values_.clear();
      if (rows.size() == 1) {
        values_.emplace_back(block(rows.front(), rows.front()));
      } else {
        Matrix square = block(rows, rows);
        if (omega == 0) take_constant(rows, square);
        others_.clear();
        solver_.append(square, others_);
        if (near == Near::joined) join_split_ones(square, others_);
        values_.insert(values_.end(), others_.begin(), others_.end());
      }
      for (const std::complex<double> value : values_) {
        list.push_back({value, omega, rings_[part], 1, 1});
        ends_.push_back(rows.front());
      }
    }
    find_multiples(block, list);
    std::sort(list.begin(), list.end(), larger);
    return list;
  }

  template <class Matrix>
  void find_multiples(const Matrix& block, std::vector<Eigenvalue>& list) const {
    std::vector<std::size_t> equal;
    for (std::size_t i = 0; i < list.size(); ++i) {
      equal.clear();
      for (std::size_t j = 0; j < list.size(); ++j)
        if (within(list[i].value, list[j].value, kEqualBelow)) equal.push_back(j);
      if (equal.size() == 1) continue;
      list[i].multiplicity = static_cast<int>(equal.size());
      list[i].jordan = equal.front() < i ? list[equal.front()].jordan
                                         : largest_jordan(block, list[i].value, equal);
    }
  }

  /// Of the eigenvalue that numbers `equal` of the list are. Parts of which none reaches another,
  /// and that have it once each, have an eigenvector each.
  template <class Matrix>
  int largest_jordan(const Matrix& block, std::complex<double> value,
                     const std::vector<std::size_t>& equal) const {
    bool linked = false;
    std::vector<Eigen::Index> ends;
    for (const std::size_t i : equal) {
      for (const Eigen::Index end : ends)
        linked = linked || connected_.reaches(end, ends_[i]) || connected_.reaches(ends_[i], end);
      ends.push_back(ends_[i]);
    }
    if (!linked) return 1;
    const std::vector<Eigen::Index> rows = spectrum::rows_between(connected_, ends);
    return with_scalar(Matrix(block(rows, rows)), value, [&](const auto& matrix, auto lambda) {
      return jordan_size(matrix, lambda, static_cast<int>(equal.size()));
    });
  }

  const FrequencyBlocks& blocks_;
  std::vector<std::pair<std::size_t, std::size_t>> partners_;  // orbits that the mirror exchanges
  Eigen::MatrixXcd block_;
  Eigen::MatrixXd real_block_;
  spectrum::BoolMatrix pattern_, known_;
  spectrum::ConnectedParts connected_;  // of known_
  std::vector<int> rings_;              // by part
  Values values_, others_;
  std::vector<double> constant_;    // what is 1 everywhere, in the coordinates of `mirror`
  std::vector<Eigen::Index> ends_;  // a row of its part for each eigenvalue
  Solver solver_;
};

SpectrumReader::SpectrumReader(const FrequencyBlocks& blocks)
    : work_(std::make_unique<Work>(blocks)) {}
SpectrumReader::~SpectrumReader() = default;

BlockSpectrum SpectrumReader::approx_spectrum(int omega, Near near) {
  return work_->at(omega, near);
}

BlockSpectrum approx_spectrum(const FrequencyBlocks& blocks, int omega, Near near) {
  return SpectrumReader(blocks).approx_spectrum(omega, near);
}

std::vector<BlockSpectrum> approx_spectra(const FrequencyBlocks& blocks) {
  SpectrumReader reader(blocks);
  std::vector<BlockSpectrum> spectra;
  spectra.reserve(blocks.blocks.size());
  for (int omega = 0; omega <= blocks.valence / 2; ++omega)
    spectra.push_back(reader.approx_spectrum(omega));
  return spectra;
}

}  // namespace limn
