#include "limn/regular/smoothness/growth_power.h"

#include <algorithm>
#include <cmath>

#include "limn/regular/algebra/approx_matrix.h"
#include "limn/regular/smoothness/exact_radius.h"

namespace limn::regular {
namespace {

constexpr double kLowerBlock = 0.99;       // growth over the level: such a block is lower
constexpr int kParts = 1024;               // of the level, to which one between is rounded down
constexpr std::size_t kMostUnknowns = 80;  // of a change of basis
constexpr int kMostVertices = 1000;

enum class Kind { below, leading, unknown };

Kind kind_of(const DiagonalBlock& block, const Rational& level, int length, const Stop& stop) {
  if (block.size() == 1) {
    Rational greatest = 0;
    for (const RationalMatrix& entry : block.matrices)
      greatest = std::max(greatest, Rational(abs(entry[0][0])));
    return greatest > level ? Kind::unknown : greatest < level ? Kind::below : Kind::leading;
  }
  std::vector<Eigen::MatrixXd> matrices;
  matrices.reserve(block.matrices.size());
  for (const RationalMatrix& matrix : block.matrices) matrices.push_back(approx_matrix(matrix));
  const Product best = approx_best_product(matrices, length, stop);
  const ExactPolytopeLimits limits{kMostVertices, stop, {}};
  if (best.growth < kLowerBlock * to_double(level)) {
    const double part = (1 + best.growth / to_double(level)) / 2;
    const Rational between = level * Rational(static_cast<int>(part * kParts), kParts);
    if (bound_exactly(block.matrices, between, best, limits)) return Kind::below;
  }
  return bound_exactly(block.matrices, level, best, limits) ? Kind::leading : Kind::unknown;
}

/// The matrices in a basis along the chain, from which couplings are removed.
class Chain {
 public:
  Chain(const std::vector<RationalMatrix>& matrices, const std::vector<DiagonalBlock>& blocks) {
    RationalMatrix basis;
    for (const DiagonalBlock& block : blocks) {
      begin_.push_back(basis.size());
      basis.insert(basis.end(), block.basis.begin(), block.basis.end());
    }
    begin_.push_back(basis.size());
    const Coordinates<Rational> along(basis);
    for (const RationalMatrix& matrix : matrices) {
      RationalMatrix columns;
      for (const FieldVector<Rational>& v : basis) columns.push_back(*along.of(product(matrix, v)));
      matrices_.push_back(transposed(columns));
    }
  }

  /// A later block's basis is changed by vectors of earlier ones, nearest first: that leaves what
  /// was uncoupled before as it is.
  void uncouple() {
    for (std::size_t b = 1; b < count(); ++b)
      for (std::size_t a = b; a-- > 0;)
        if (is_coupled(a, b)) remove_coupling(a, b);
  }

  [[nodiscard]] bool is_coupled(std::size_t a, std::size_t b) const {
    for (const RationalMatrix& matrix : matrices_)
      for (std::size_t i = begin_[a]; i < begin_[a + 1]; ++i)
        for (std::size_t j = begin_[b]; j < begin_[b + 1]; ++j)
          if (matrix[i][j] != 0) return true;
    return false;
  }
  [[nodiscard]] std::size_t count() const { return begin_.size() - 1; }

 private:
  [[nodiscard]] std::size_t size(std::size_t block) const {
    return begin_[block + 1] - begin_[block];
  }

  /// The X with A X - X B = -C for every matrix, A and B being its diagonal blocks a and b and C
  /// what couples them; then b's basis is moved by a's times X.
  void remove_coupling(std::size_t a, std::size_t b) {
    const std::size_t rows = size(a);
    const std::size_t columns = size(b);
    const std::size_t unknowns = rows * columns;
    if (unknowns > kMostUnknowns) return;
    Echelon<Rational> equations(unknowns + 1);
    for (const RationalMatrix& matrix : matrices_)
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
          FieldVector<Rational> equation(unknowns + 1, Rational(0));
          for (std::size_t k = 0; k < rows; ++k)
            equation[k * columns + j] += matrix[begin_[a] + i][begin_[a] + k];
          for (std::size_t k = 0; k < columns; ++k)
            equation[i * columns + k] -= matrix[begin_[b] + k][begin_[b] + j];
          equation[unknowns] = -matrix[begin_[a] + i][begin_[b] + j];
          equations.insert(equation);
        }
    if (equations.is_pivot(unknowns)) return;  // no solution
    FieldVector<Rational> x(unknowns, Rational(0));
    for (std::size_t r = 0; r < equations.dimension(); ++r)
      x[equations.pivots()[r]] = equations.rows()[r][unknowns];
    move_basis(a, b, x);
  }

  void move_basis(std::size_t a, std::size_t b, const FieldVector<Rational>& x) {
    const std::size_t columns = size(b);
    for (RationalMatrix& matrix : matrices_)
      for (std::size_t i = 0; i < size(a); ++i)
        for (std::size_t j = 0; j < columns; ++j) {
          const Rational& factor = x[i * columns + j];
          if (factor == 0) continue;
          // e_b += factor e_a: columns of images, then coordinates of what has e_b in it
          for (FieldVector<Rational>& row : matrix)
            if (row[begin_[a] + i] != 0) row[begin_[b] + j] += factor * row[begin_[a] + i];
          const FieldVector<Rational> along_b = matrix[begin_[b] + j];
          for (std::size_t k = 0; k < along_b.size(); ++k)
            if (along_b[k] != 0) matrix[begin_[a] + i][k] -= factor * along_b[k];
        }
  }

  std::vector<std::size_t> begin_;  // of each block in the basis, and the end
  std::vector<RationalMatrix> matrices_;
};

}  // namespace

std::optional<int> bound_growth_power(const std::vector<RationalMatrix>& matrices,
                                      const Rational& level, int length, const Stop& stop) {
  const std::vector<DiagonalBlock> blocks = diagonal_blocks(matrices, stop);
  std::vector<Kind> kinds;
  for (const DiagonalBlock& block : blocks) {
    kinds.push_back(kind_of(block, level, length, stop));
    if (kinds.back() == Kind::unknown || asked(stop)) return std::nullopt;
  }
  Chain chain(matrices, blocks);
  chain.uncouple();
  std::vector<int> leading(chain.count());  // on one way that ends there, at most
  for (std::size_t b = 0; b < chain.count(); ++b) {
    for (std::size_t a = 0; a < b; ++a)
      if (chain.is_coupled(a, b)) leading[b] = std::max(leading[b], leading[a]);
    if (kinds[b] == Kind::leading) ++leading[b];
  }
  return std::max(*std::max_element(leading.begin(), leading.end()) - 1, 0);
}

}  // namespace limn::regular
