#include "limn/certify/vertex/curvature_proof.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "limn/certify/blocks/exact_spectrum.h"
#include "limn/spectrum/connected_parts.h"

namespace limn::certify {
namespace {

constexpr int kMostBlockSquarings = 40;
constexpr double kExactWork = 3e6;  // for one frequency: some tenths of a second

using Size = std::size_t;

number::BallMatrix rest_of(const ValenceBalls& balls, const EnclosedPair& leader, int frequency) {
  number::BallMatrix block = balls.block(frequency);
  return frequency == 1 ? deflated(block, leader) : block;
}

spectrum::ConnectedParts parts_of(const number::BallMatrix& a) {
  spectrum::BoolMatrix entries(static_cast<Eigen::Index>(a.rows()),
                               static_cast<Eigen::Index>(a.rows()));
  for (Size i = 0; i < a.rows(); ++i)
    for (Size j = 0; j < a.rows(); ++j)
      entries(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          !a(i, j).is_exactly_zero();
  return spectrum::connected_parts(entries);
}

number::BallMatrix square_of(const number::BallMatrix& a, const std::vector<Eigen::Index>& rows) {
  number::BallMatrix result(rows.size(), rows.size());
  for (Size i = 0; i < rows.size(); ++i)
    for (Size j = 0; j < rows.size(); ++j)
      result(i, j) = a(static_cast<Size>(rows[i]), static_cast<Size>(rows[j]));
  return result;
}

/// A real eigenvalue near `value` of the square matrix of one part.
std::optional<number::Ball> part_eigenvalue(const number::BallMatrix& a, double value) {
  if (a.rows() == 1) return a(0, 0);
  const ApproxPair near = approx_nearest(a, value);
  const Result<EnclosedPair> pair = enclose_eigenpair(a, near.value, near.vector);
  return pair ? std::optional(pair->value) : std::nullopt;
}

number::Ball squared(const EnclosedPair& leader) { return leader.value * leader.value; }

/// An eigenvalue that is larger than λ², if one can be shown; `ineffective` becomes one whose
/// surface is not shown to be other than 0.
std::optional<LargeEigenvalue> find_large(const ValenceBalls& balls, const EnclosedPair& leader,
                                          const Effective& effective,
                                          std::optional<LargeEigenvalue>& ineffective) {
  const number::Ball bound = squared(leader);
  for (int frequency = 0; frequency <= balls.valence() / 2; ++frequency) {
    const number::BallMatrix rest = rest_of(balls, leader, frequency);
    for (const auto& rows : parts_of(rest).parts) {
      const number::BallMatrix square = square_of(rest, rows);
      for (const std::complex<double>& value : approx_eigenvalues(square)) {
        if (value.imag() != 0 || !(std::abs(value.real()) > bound.approx())) continue;
        const std::optional<number::Ball> enclosed = part_eigenvalue(square, value.real());
        if (!enclosed || !number::is_less(bound, enclosed->magnitude())) continue;
        const LargeEigenvalue found{frequency, {rows.begin(), rows.end()}, enclosed->approx()};
        if (effective.is_shown(frequency, found.value)) return found;
        ineffective = found;
      }
    }
  }
  return std::nullopt;
}

Status check_large(const ValenceBalls& balls, const EnclosedPair& leader,
                   const Effective& effective, const LargeEigenvalue& claim) {
  if (claim.frequency < 0 || claim.frequency > balls.valence() / 2)
    return Error{"a larger eigenvalue of a frequency that the valence has not"};
  const number::BallMatrix rest = rest_of(balls, leader, claim.frequency);
  const std::vector<Eigen::Index> rows(claim.rows.begin(), claim.rows.end());
  const spectrum::ConnectedParts parts = parts_of(rest);
  if (std::find(parts.parts.begin(), parts.parts.end(), rows) == parts.parts.end())
    return Error{"rows that are no part of the block"};
  const std::optional<number::Ball> value = part_eigenvalue(square_of(rest, rows), claim.value);
  if (!value || !number::is_less(squared(leader), value->magnitude()))
    return Error{"an eigenvalue larger than the tangent's square is not shown"};
  if (!(std::abs(value->approx() - claim.value) <= 1e-12 * std::abs(claim.value)))
    return Error{"the larger eigenvalue is another one"};
  if (!effective.is_shown(claim.frequency, claim.value))
    return Error{"the larger eigenvalue's surface is not shown to be other than 0"};
  return Done{};
}

/// A block, and λ², in exact numbers; λ is shown to be an eigenvalue of frequency 1.
struct ExactSquare {
  number::DenseMatrix<number::Exact> block;
  number::Exact square;
};

std::optional<ExactSquare> exact_square(const Scheme& scheme, const ValenceBalls& balls,
                                        const EnclosedPair& leader, int frequency) {
  const Result<number::DenseMatrix<number::Exact>> first = balls.exact_block(scheme, 1);
  Result<number::DenseMatrix<number::Exact>> block = balls.exact_rest(scheme, frequency);
  if (!first || !block) return std::nullopt;
  const std::optional<number::Exact> value = exact_leader(*first, leader);
  if (!value) return std::nullopt;
  const Result<number::Exact> square = number::Exact::multiply(*value, *value);
  const auto own = null_space(*first, *value);
  if (!square || !own || own->size() != 1) return std::nullopt;
  return ExactSquare{std::move(*block), *square};
}

/// The exact eigenvectors of λ² in a block without 1.
std::optional<std::vector<std::vector<number::Exact>>> square_vectors(const Scheme& scheme,
                                                                      const ValenceBalls& balls,
                                                                      const EnclosedPair& leader,
                                                                      int frequency) {
  const number::ExactBudget budget(kExactWork);
  const auto exact = exact_square(scheme, balls, leader, frequency);
  return exact ? null_space(exact->block, exact->square) : std::nullopt;
}

/// Whether one of the vectors a·w, w in the null space of a², is effective.
bool any_effective(const number::DenseMatrix<number::Exact>& a,
                   const std::vector<std::vector<number::Exact>>& vectors,
                   const number::Ball& value, int frequency, const Effective& effective) {
  return std::any_of(vectors.begin(), vectors.end(), [&](const std::vector<number::Exact>& w) {
    EnclosedPair pair{value, {}, 0};
    bool zero = true;
    for (Size i = 0; i < a.rows(); ++i) {
      number::Exact sum;
      for (Size j = 0; j < a.rows(); ++j)
        if (!add_product(sum, a(i, j), w[j])) return false;
      zero = zero && sum.is_zero();
      pair.vector.push_back(enclosed(sum));
    }
    return !zero && effective.is_shown(frequency, pair);
  });
}

/// The multiplicity of λ² in the square of block - λ², where it is larger than in the block: then
/// λ² has a Jordan block. Nothing where its eigenvector is not shown to be effective.
std::optional<int> jordan_multiplicity(const Scheme& scheme, const ValenceBalls& balls,
                                       const EnclosedPair& leader, const Effective& effective,
                                       int frequency) {
  const number::ExactBudget budget(kExactWork);
  const auto exact = exact_square(scheme, balls, leader, frequency);
  if (!exact) return std::nullopt;
  number::DenseMatrix<number::Exact> shifted = exact->block;
  for (Size i = 0; i < shifted.rows(); ++i) shifted(i, i) += number::Exact(-1) * exact->square;
  number::DenseMatrix<number::Exact> squared_block(shifted.rows(), shifted.rows());
  for (Size i = 0; i < shifted.rows(); ++i)
    for (Size k = 0; k < shifted.rows(); ++k)
      if (!shifted(i, k).is_zero())
        for (Size j = 0; j < shifted.rows(); ++j)
          if (!add_product(squared_block(i, j), shifted(i, k), shifted(k, j))) return std::nullopt;
  const auto once = null_space(shifted, number::Exact(0));
  const auto twice = null_space(squared_block, number::Exact(0));
  if (!once || !twice || twice->size() <= once->size()) return std::nullopt;
  if (!any_effective(shifted, *twice, squared(leader), frequency, effective)) return std::nullopt;
  return static_cast<int>(twice->size());
}

/// `a` without the leader, whose eigenvector has become another one by earlier deflations.
std::optional<number::BallMatrix> without_leader(const number::BallMatrix& a,
                                                 const EnclosedPair& leader) {
  const ApproxPair near = approx_nearest(a, leader.value.approx());
  const Result<EnclosedPair> pair = enclose_eigenpair(a, leader.value.approx(), near.vector);
  if (!pair || !pair->value.overlaps(leader.value)) return std::nullopt;
  return deflated(a, *pair);
}

/// The block without 1, the leader and these eigenvectors of λ².
number::BallMatrix without(number::BallMatrix rest,
                           const std::vector<std::vector<number::Exact>>& vectors,
                           const number::Ball& square) {
  std::vector<std::vector<number::Ball>> left;
  for (const auto& vector : vectors) {
    left.emplace_back();
    for (const number::Exact& entry : vector) left.back().push_back(enclosed(entry));
  }
  while (!left.empty()) {
    std::vector<number::Ball> vector = std::move(left.back());
    left.pop_back();
    Size pivot = 0;
    for (Size i = 1; i < vector.size(); ++i)
      if (std::abs(vector[i].approx()) > std::abs(vector[pivot].approx())) pivot = i;
    const number::Ball scale = vector[pivot];
    for (number::Ball& entry : vector) entry /= scale;
    vector[pivot] = number::Ball(1);
    rest = deflated(rest, {square, vector, pivot});
    for (std::vector<number::Ball>& other : left) {  // what becomes of it by the deflation
      const number::Ball at = other[pivot];
      for (Size i = 0; i < other.size(); ++i) other[i] -= at * vector[i];
      other.erase(other.begin() + static_cast<std::ptrdiff_t>(pivot));
    }
  }
  return rest;
}

/// Squarings that show that all others of a frequency are less than λ², which it has exactly so
/// many times.
std::optional<int> squarings_beside(const Scheme& scheme, const ValenceBalls& balls,
                                    const EnclosedPair& leader, int frequency, int* multiplicity,
                                    int most_squarings) {
  number::BallMatrix rest = balls.block(frequency);
  std::vector<std::vector<number::Exact>> vectors;
  if (*multiplicity != 0) {
    const auto found = square_vectors(scheme, balls, leader, frequency);
    if (!found) return std::nullopt;
    if (*multiplicity > 0 && static_cast<int>(found->size()) != *multiplicity) return std::nullopt;
    *multiplicity = static_cast<int>(found->size());
    vectors = *found;
  }
  // exact vectors are of the block with the leader in it: take them off first
  rest = without(std::move(rest), vectors, squared(leader));
  if (frequency == 1) {
    const std::optional<number::BallMatrix> other = without_leader(rest, leader);
    if (!other) return std::nullopt;
    rest = *other;
  }
  return squarings_below(rest, squared(leader), most_squarings);
}

}  // namespace

bool holds_what_it_needs(const CurvatureClaim& claim) {
  const bool all = !claim.squarings.empty() || !claim.equal.empty();
  switch (claim.answer) {
    case CurvatureAnswer::undecided: return !all && !claim.large && !claim.jordan;
    case CurvatureAnswer::unbounded: return !all && !(claim.large && claim.jordan);
    case CurvatureAnswer::bounded:
    case CurvatureAnswer::flat: break;
  }
  return !claim.large && !claim.jordan;
}

CurvatureClaim search_curvature(const Scheme& scheme, const ValenceBalls& balls,
                                const EnclosedPair& leader, const RegularPart& regular,
                                const Effective& effective) {
  CurvatureClaim claim;
  if (regular.bounded == Truth::no) {
    claim.answer = CurvatureAnswer::unbounded;
    claim.reason =
        "the regular surface round the vertex has unbounded curvature: " + regular.reason;
    return claim;
  }
  std::optional<LargeEigenvalue> ineffective;
  if (const auto large = find_large(balls, leader, effective, ineffective)) {
    claim.answer = CurvatureAnswer::unbounded;
    claim.large = large;
    claim.reason = fmt::format("{:.6g} of frequency {} exceeds tangent² = {:.6g}", large->value,
                               large->frequency, squared(leader).approx());
    return claim;
  }
  if (ineffective) {
    claim.reason = fmt::format(
        "{:.6g} of frequency {} exceeds tangent² = {:.6g}, but its surface is not shown to be "
        "other "
        "than 0",
        ineffective->value, ineffective->frequency, squared(leader).approx());
    return claim;
  }
  for (int frequency = 0; frequency <= balls.valence() / 2; ++frequency) {
    int multiplicity = 0;
    auto squarings =
        squarings_beside(scheme, balls, leader, frequency, &multiplicity, kMostBlockSquarings);
    if (!squarings) {
      multiplicity = -1;
      squarings =
          squarings_beside(scheme, balls, leader, frequency, &multiplicity, kMostBlockSquarings);
    }
    if (!squarings) {
      claim.equal.clear();
      claim.squarings.clear();
      if (const auto jordan = jordan_multiplicity(scheme, balls, leader, effective, frequency)) {
        claim.answer = CurvatureAnswer::unbounded;
        claim.jordan = {frequency, *jordan};
        claim.reason = fmt::format("tangent² = {:.6g} has a Jordan block in frequency {}",
                                   squared(leader).approx(), frequency);
        return claim;
      }
      claim.reason = fmt::format(
          "eigenvalues of frequency {} could not be told from tangent² = {:.6g}, nor be shown to "
          "be "
          "equal to it in exact numbers of a bounded size",
          frequency, squared(leader).approx());
      return claim;
    }
    claim.squarings.push_back(*squarings);
    if (multiplicity > 0) claim.equal.push_back({frequency, multiplicity});
  }
  if (regular.bounded != Truth::yes) {
    claim.equal.clear();
    claim.squarings.clear();
    claim.reason = "the regular surface round the vertex: " + regular.reason;
    return claim;
  }
  claim.answer = claim.equal.empty() ? CurvatureAnswer::flat : CurvatureAnswer::bounded;
  claim.reason = claim.equal.empty()
                     ? "all other eigenvalues are smaller than tangent²"
                     : "all other eigenvalues are at most tangent², and semisimple where equal";
  claim.reason += "; " + regular.reason;
  return claim;
}

Status check_curvature(const Scheme& scheme, const ValenceBalls& balls, const EnclosedPair& leader,
                       const RegularPart& regular, const Effective& effective,
                       const CurvatureClaim& claim) {
  if (!holds_what_it_needs(claim))
    return Error{"curvature: what is shown is not of what is claimed"};
  if (claim.answer == CurvatureAnswer::undecided) return Done{};
  if (claim.answer == CurvatureAnswer::unbounded) {
    if (claim.large) return check_large(balls, leader, effective, *claim.large);
    if (claim.jordan) {
      const SquareEigenvalue& jordan = *claim.jordan;
      if (jordan.frequency >= 0 && jordan.frequency <= balls.valence() / 2 &&
          jordan_multiplicity(scheme, balls, leader, effective, jordan.frequency) ==
              jordan.multiplicity)
        return Done{};
      return Error{"a Jordan block of tangent² is not shown"};
    }
    if (regular.bounded == Truth::no) return Done{};
    return Error{"unbounded curvature of the regular surface is not shown"};
  }
  if (regular.bounded != Truth::yes)
    return Error{"bounded curvature of the regular surface is not shown"};
  if (claim.equal.empty() != (claim.answer == CurvatureAnswer::flat))
    return Error{"flat and bounded are told apart by eigenvalues equal to tangent²"};
  if (static_cast<int>(claim.squarings.size()) != balls.valence() / 2 + 1)
    return Error{"curvature: not one number of squarings for each frequency"};
  std::vector<int> multiplicities(claim.squarings.size());
  int last = -1;
  for (const SquareEigenvalue& one : claim.equal) {
    if (one.frequency <= std::exchange(last, one.frequency) ||
        one.frequency > balls.valence() / 2 || one.multiplicity < 1)
      return Error{"curvature: no such multiplicity of tangent²"};
    multiplicities[static_cast<Size>(one.frequency)] = one.multiplicity;
  }
  for (Size i = 0; i < claim.squarings.size(); ++i)
    if (squarings_beside(scheme, balls, leader, static_cast<int>(i), &multiplicities[i],
                         kMostBlockSquarings) != claim.squarings[i])
      return Error{fmt::format("curvature: the eigenvalues of frequency {} are not as claimed", i)};
  return Done{};
}

}  // namespace limn::certify
