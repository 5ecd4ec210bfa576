#include "limn/regular/algebra/invariant_subspaces.h"

#include <algorithm>
#include <cstdint>

#include <optional>

#include "limn/regular/algebra/modular.h"
#include "limn/regular/algebra/modular_roots.h"

namespace limn::regular {
namespace {

constexpr int kTries = 24;        // elements of the algebra that are looked at for one block
constexpr int kRootsForEach = 2;  // of their eigenvalues
constexpr std::size_t kMostNullVectors = 3;

using ModularFamily = std::vector<FieldMatrix<Modular>>;

std::optional<ModularFamily> shadow(const std::vector<RationalMatrix>& matrices) {
  ModularFamily family;
  for (const RationalMatrix& matrix : matrices) {
    FieldMatrix<Modular>& image = family.emplace_back();
    for (const FieldVector<Rational>& row : matrix) {
      image.emplace_back();
      for (const Rational& entry : row) {
        const std::optional<Modular> value = modular(entry);
        if (!value) return std::nullopt;
        image.back().push_back(*value);
      }
    }
  }
  return family;
}

ModularFamily transposed_family(const ModularFamily& family) {
  ModularFamily result;
  for (const FieldMatrix<Modular>& matrix : family) result.push_back(transposed(matrix));
  return result;
}

/// The matrices on an invariant subspace and on the quotient by it, and vectors of the whole space
/// that their coordinates multiply (of the quotient: representatives).
struct Halves {
  std::vector<RationalMatrix> sub, quotient;
  RationalMatrix sub_basis, quotient_basis;  // a vector a row
};

/// Nothing where the reconstructed subspace is not invariant.
std::optional<Halves> split_along(const std::vector<RationalMatrix>& matrices,
                                  const Echelon<Modular>& found) {
  Echelon<Rational> space(found.size());
  for (const FieldVector<Modular>& row : found.rows()) {
    FieldVector<Rational> lifted;
    for (const Modular entry : row) {
      const std::optional<Rational> value = reconstructed(entry);
      if (!value) return std::nullopt;
      lifted.push_back(*value);
    }
    space.insert(lifted);
  }
  Halves halves;
  halves.sub_basis = space.rows();
  const std::vector<std::size_t> others = space.free_columns();
  for (const std::size_t j : others) {
    halves.quotient_basis.emplace_back(space.size(), Rational(0));
    halves.quotient_basis.back()[j] = 1;
  }
  for (const RationalMatrix& matrix : matrices) {
    RationalMatrix& sub = halves.sub.emplace_back();  // its columns, for now
    for (const FieldVector<Rational>& row : space.rows()) {
      const FieldVector<Rational> image = product(matrix, row);
      if (!space.contains(image)) return std::nullopt;
      sub.emplace_back();
      for (const std::size_t pivot : space.pivots()) sub.back().push_back(image[pivot]);
    }
    sub = transposed(sub);
    RationalMatrix& quotient = halves.quotient.emplace_back();
    const RationalMatrix columns = transposed(matrix);
    for (const std::size_t j : others) {
      const FieldVector<Rational> image = space.reduced(columns[j]);
      quotient.emplace_back();
      for (const std::size_t i : others) quotient.back().push_back(image[i]);
    }
    quotient = transposed(quotient);
  }
  return halves;
}

/// Numbers without pattern, the same in every run.
class Random {
 public:
  Modular operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return {state_ >> 3};
  }

 private:
  std::uint64_t state_ = 2026;
};

FieldMatrix<Modular> combination(const FieldMatrix<Modular>& a, Modular factor,
                                 const FieldMatrix<Modular>& b) {
  FieldMatrix<Modular> sum = a;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) sum[i][j] += factor * b[i][j];
  return sum;
}

/// Elements of the algebra: first the matrices and their differences, whose null vectors are often
/// rational, then random ones.
FieldMatrix<Modular> element(const ModularFamily& family, int number, Random& random) {
  const auto count = static_cast<int>(family.size());
  if (number < count) return family[static_cast<std::size_t>(number)];
  if (number < 2 * count - 1)
    return combination(family[0], Modular(Modular::kPrime - 1),
                       family[static_cast<std::size_t>(number - count + 1)]);
  FieldMatrix<Modular> sum = family[0];
  for (const FieldMatrix<Modular>& matrix : family) sum = combination(sum, random(), matrix);
  FieldMatrix<Modular> other = family[0];
  for (const FieldMatrix<Modular>& matrix : family) other = combination(other, random(), matrix);
  return combination(product(sum, other), random(), sum);
}

bool is_proper(const Echelon<Modular>& space) {
  return space.dimension() > 0 && space.dimension() < space.size();
}

/// What one block gave.
struct SplitVerdict {
  std::optional<Halves> halves;
  bool irreducible = false;
};

/// Norton's criterion with the eigenvalue `root` of `a`: null vectors are spun, and those of the
/// transposes.
SplitVerdict try_root(const std::vector<RationalMatrix>& matrices, const ModularFamily& family,
                      const ModularFamily& dual, FieldMatrix<Modular> a, Modular root) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i][i] -= root;
  const Echelon<Modular> null = null_space(a);
  for (std::size_t i = 0; i < std::min(null.dimension(), kMostNullVectors); ++i) {
    const Echelon<Modular> space = spun(family, {null.rows()[i]});
    if (is_proper(space))
      if (std::optional<Halves> halves = split_along(matrices, space)) return {halves, false};
  }
  const Echelon<Modular> null_of_dual = null_space(transposed(a));
  bool full = null.dimension() == 1;
  if (full) full = spun(family, {null.rows()[0]}).dimension() == null.size();
  for (std::size_t i = 0; i < std::min(null_of_dual.dimension(), kMostNullVectors); ++i) {
    const Echelon<Modular> space = spun(dual, {null_of_dual.rows()[i]});
    if (is_proper(space)) {
      full = false;
      if (std::optional<Halves> halves = split_along(matrices, annihilator(space)))
        return {halves, false};
    }
  }
  return {std::nullopt, full && null_of_dual.dimension() == 1};
}

/// The subspace that all matrices annihilate, and the span of all their images.
std::optional<Halves> split_trivially(const std::vector<RationalMatrix>& matrices,
                                      const ModularFamily& family, const ModularFamily& dual) {
  FieldMatrix<Modular> stacked;
  Echelon<Modular> images(family.front().size());
  for (const FieldMatrix<Modular>& matrix : family)
    for (const FieldVector<Modular>& row : matrix) stacked.push_back(row);
  for (const FieldMatrix<Modular>& matrix : dual)
    for (const FieldVector<Modular>& column : matrix) images.insert(column);
  for (const Echelon<Modular>& space : {null_space(stacked), images})
    if (is_proper(space))
      if (std::optional<Halves> halves = split_along(matrices, space)) return halves;
  return std::nullopt;
}

SplitVerdict split(const std::vector<RationalMatrix>& matrices, const Stop& stop) {
  if (matrices.front().size() == 1) return {std::nullopt, true};
  const std::optional<ModularFamily> family = shadow(matrices);
  if (!family) return {};
  const ModularFamily dual = transposed_family(*family);
  if (std::optional<Halves> halves = split_trivially(matrices, *family, dual))
    return {halves, false};
  Random random;
  for (int number = 0; number < kTries && !asked(stop); ++number) {
    const FieldMatrix<Modular> a = element(*family, number, random);
    for (const Modular root : eigenvalues_in_field(a, kRootsForEach)) {
      SplitVerdict verdict = try_root(matrices, *family, dual, a, root);
      if (verdict.halves || verdict.irreducible) return verdict;
    }
  }
  return {};
}

RationalMatrix identity(std::size_t size) {
  RationalMatrix result(size, FieldVector<Rational>(size, Rational(0)));
  for (std::size_t i = 0; i < size; ++i) result[i][i] = 1;
  return result;
}

}  // namespace

std::vector<DiagonalBlock> diagonal_blocks(std::vector<RationalMatrix> matrices, const Stop& stop) {
  SplitVerdict verdict = split(matrices, stop);
  if (!verdict.halves) {
    RationalMatrix basis = identity(matrices.front().size());
    return {{std::move(matrices), std::move(basis), verdict.irreducible}};
  }
  Halves& halves = *verdict.halves;
  std::vector<DiagonalBlock> blocks = diagonal_blocks(std::move(halves.sub), stop);
  for (DiagonalBlock& block : blocks) block.basis = product(block.basis, halves.sub_basis);
  for (DiagonalBlock& block : diagonal_blocks(std::move(halves.quotient), stop)) {
    block.basis = product(block.basis, halves.quotient_basis);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

}  // namespace limn::regular
