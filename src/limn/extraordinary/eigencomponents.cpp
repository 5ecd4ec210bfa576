#include "limn/extraordinary/eigencomponents.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <fmt/core.h>

namespace limn {
namespace {

/// A step of a block from one set of invariant rings to the next: the orbits first … last-1 (rows
/// of the block), whose square part has the eigenvalues that these rings add.
struct RingPart {
  int ring;
  Eigen::Index first, last;
};

template <class Matrix>
std::vector<RingPart> ring_parts(const FrequencyBlocks& blocks, const Matrix& block) {
  const Eigen::Index shift = block.rows() - static_cast<Eigen::Index>(blocks.orbits.size());
  std::vector<RingPart> parts;
  Eigen::Index first = 0;
  for (Eigen::Index end = shift; end < block.rows();) {
    const int ring = blocks.orbits[static_cast<std::size_t>(end - shift)].ring;
    while (end < block.rows() && blocks.orbits[static_cast<std::size_t>(end - shift)].ring == ring)
      ++end;
    const Eigen::Index beyond = block.rows() - end;
    if (block.topRightCorner(end, beyond).cwiseAbs().sum() > 1e-14) continue;
    parts.push_back({ring, first, end});
    first = end;
  }
  return parts;
}

/// The block in real coordinates. A mirror through spoke 0 carries each orbit to one of its own
/// ring and conjugates amplitudes, so (x + y)/√2 and i (x - y)/√2 of partners x, y map to one
/// another by a real matrix.
Eigen::MatrixXcd mirrored(const FrequencyBlocks& blocks, const Eigen::MatrixXcd& block) {
  const Eigen::Index shift = block.rows() - static_cast<Eigen::Index>(blocks.orbits.size());
  Eigen::MatrixXcd basis = Eigen::MatrixXcd::Identity(block.rows(), block.cols());
  const double half = std::sqrt(0.5);
  for (std::size_t a = 0; a < blocks.orbits.size(); ++a)
    for (std::size_t b = a + 1; b < blocks.orbits.size(); ++b) {
      const double turns = blocks.orbits[a].angle + blocks.orbits[b].angle;
      const bool partners = blocks.orbits[a].ring == blocks.orbits[b].ring &&
                            std::abs(turns - std::nearbyint(turns)) < 1e-12;
      if (!partners) continue;
      const Eigen::Index x = static_cast<Eigen::Index>(a) + shift;
      const Eigen::Index y = static_cast<Eigen::Index>(b) + shift;
      basis(x, x) = basis(x, y) = half;
      basis(y, x) = std::complex<double>(0, half);
      basis(y, y) = std::complex<double>(0, -half);
    }
  return basis * block * basis.adjoint();
}

/// Numerical rank, by QR with column pivots: entries are of order 1.
template <class Matrix>
Eigen::Index rank(const Matrix& matrix, double threshold) {
  const Eigen::ColPivHouseholderQR<Matrix> qr(matrix);
  return (qr.matrixR().diagonal().cwiseAbs().array() > threshold).count();
}

template <class Matrix>
Matrix shifted(const Matrix& matrix, typename Matrix::Scalar lambda) {
  return matrix - lambda * Matrix::Identity(matrix.rows(), matrix.cols());
}

/// Size of the largest Jordan block of λ: the powers of S-λ until their rank falls no more.
template <class Matrix>
int jordan_size(const Matrix& block, typename Matrix::Scalar lambda, int multiplicity) {
  const Matrix difference = shifted(block, lambda);
  Matrix power = difference;
  // the nullity grows with the power until it is the multiplicity
  for (int size = 1; size < multiplicity; ++size) {
    if (rank(power, 1e-9) <= block.rows() - multiplicity) return size;
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
  return rank(power, 1e-12) <= square.rows() - multiplicity;
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

/// Rounding splits a defective eigenvalue of size k by the k-th root of its error; the mean of the
/// parts stays exact. So values near one another that are one multiple eigenvalue get their mean.
template <class Matrix>
void join_split_ones(const Matrix& square, Eigen::VectorXcd& values) {
  for (const double radius : {1e-3, 1e-5, 1e-7}) {
    std::vector<bool> seen(static_cast<std::size_t>(values.size()), false);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      std::vector<Eigen::Index> near;
      std::complex<double> mean = 0;
      double spread = 0;
      for (Eigen::Index j = i; j < values.size(); ++j) {
        if (seen[static_cast<std::size_t>(j)] || std::abs(values(j) - values(i)) > radius) continue;
        near.push_back(j);
        mean += values(j);
        spread = std::max(spread, std::abs(values(j) - values(i)));
      }
      if (near.size() < 2 || spread < 1e-14) continue;
      mean /= static_cast<double>(near.size());
      if (std::abs(mean.imag()) < 1e-12) mean = mean.real();
      const int multiplicity = static_cast<int>(near.size());
      if (!with_scalar(square, mean, [&](const auto& matrix, auto lambda) {
            return is_multiple(matrix, lambda, multiplicity);
          }))
        continue;
      for (const Eigen::Index j : near) {
        values(j) = mean;
        seen[static_cast<std::size_t>(j)] = true;
      }
    }
  }
}

bool larger(const Eigenvalue& a, const Eigenvalue& b) {
  const double x = std::abs(a.value);
  const double y = std::abs(b.value);
  if (std::abs(x - y) > kEqualBelow) return x > y;
  if (std::abs(a.value.real() - b.value.real()) > kEqualBelow)
    return a.value.real() > b.value.real();
  if (a.ring != b.ring) return a.ring < b.ring;
  return a.value.imag() > b.value.imag();
}

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& square) {
  return Eigen::EigenSolver<Eigen::MatrixXd>(square, false).eigenvalues();
}
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXcd& square) {
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(square, false).eigenvalues();
}

template <class Matrix>
std::vector<Eigenvalue> eigenvalues(const FrequencyBlocks& blocks, const Matrix& block, int omega,
                                    Near near) {
  std::vector<Eigenvalue> list;
  for (const RingPart& part : ring_parts(blocks, block)) {
    const Eigen::Index size = part.last - part.first;
    const Matrix square = block.block(part.first, part.first, size, size);
    Eigen::VectorXcd values = eigenvalues_of(square);
    if (near == Near::joined) join_split_ones(square, values);
    for (const std::complex<double> value : values) list.push_back({value, omega, part.ring, 1, 1});
  }
  for (Eigenvalue& one : list)
    one.multiplicity =
        static_cast<int>(std::count_if(list.begin(), list.end(), [&](const Eigenvalue& other) {
          return std::abs(other.value - one.value) < kEqualBelow;
        }));
  for (auto one = list.begin(); one != list.end(); ++one) {
    if (one->multiplicity == 1) continue;
    const auto known = std::find_if(list.begin(), one, [&](const Eigenvalue& other) {
      return std::abs(other.value - one->value) < kEqualBelow;
    });
    one->jordan = known != one
                      ? known->jordan
                      : with_scalar(block, one->value, [&](const auto& matrix, auto lambda) {
                          return jordan_size(matrix, lambda, one->multiplicity);
                        });
  }
  std::sort(list.begin(), list.end(), larger);
  return list;
}

/// -1, 0, 1 for smaller, equal, larger; nothing in between.
std::optional<int> compare(double a, double b) {
  const double difference = a - b;
  if (std::abs(difference) <= kEqualBelow) return 0;
  if (std::abs(difference) < kUndecidedBelow) return std::nullopt;
  return difference < 0 ? -1 : 1;
}

std::string described(const Eigenvalue& eigenvalue) {
  const std::string number =
      std::abs(eigenvalue.value.imag()) <= kEqualBelow
          ? fmt::format("{:.6g}", eigenvalue.value.real())
          : fmt::format("{:.6g}{:+.6g}i", eigenvalue.value.real(), eigenvalue.value.imag());
  return fmt::format("{} of frequency {} (ring {})", number, eigenvalue.frequency, eigenvalue.ring);
}

/// Makes the verdict of one valence.
class Judge {
 public:
  explicit Judge(Eigencomponents& found) : found_(found), verdict_(found.verdict) {}

  void judge() {
    convergence();
    if (!found_.tangent || !(*found_.tangent > 0)) {
      verdict_.c1_necessary = verdict_.bounded_curvature = Truth::no;
      reasons().push_back("not C1: frequency 1 is not led by a positive eigenvalue");
      return;
    }
    tangent_plane();
    curvature();
    shape("cup", "elliptic", found_.spectra[0].eigenvalues, 1, verdict_.cup);
    if (found_.valence > 3)
      shape("saddle", "hyperbolic", found_.spectra[2].eigenvalues, 0, verdict_.saddle);
  }

 private:
  std::vector<std::string>& reasons() { return verdict_.reasons; }
  [[nodiscard]] double tangent() const { return *found_.tangent; }

  /// What holds of all eigenvalues but the leaders: `skip` leading ones of ω = 0 and of ω = 1. The
  /// first, and so largest, refusal of each block is a reason.
  template <class Say>
  Truth over_others(std::size_t skip_0, std::size_t skip_1, Say say) {
    Truth all = Truth::yes;
    for (const BlockSpectrum& block : found_.spectra) {
      const std::size_t skip = block.frequency == 0 ? skip_0 : block.frequency == 1 ? skip_1 : 0;
      bool refused = false;
      for (std::size_t i = skip; i < block.eigenvalues.size(); ++i) {
        const Said said = say(block.eigenvalues[i]);
        all = all && said.truth;
        if (said.truth == Truth::no && !refused) reasons().push_back(said.reason);
        refused = refused || said.truth == Truth::no;
      }
    }
    return all;
  }

  struct Said {
    Truth truth;
    std::string reason;  ///< of a no
  };
  static Said refusal(std::string reason) { return {Truth::no, std::move(reason)}; }
  static Said agreement() { return {Truth::yes, {}}; }
  static Said silence() { return {Truth::undecided, {}}; }

  void convergence() {
    const Eigenvalue& first = found_.spectra.front().eigenvalues.front();
    if (std::abs(first.value - 1.0) > kEqualBelow || first.multiplicity > 1) {
      verdict_.convergent = Truth::no;
      reasons().push_back(
          fmt::format("not convergent: frequency 0 is led by {}, where a simple 1 is needed",
                      described(first)));
      return;
    }
    verdict_.convergent = over_others(1, 0, [&](const Eigenvalue& other) -> Said {
      const std::optional<int> sign = compare(std::abs(other.value), 1);
      if (!sign) return silence();
      if (*sign < 0) return agreement();
      return refusal(fmt::format("not convergent: {} is not less than 1", described(other)));
    });
  }

  void tangent_plane() {
    const Eigenvalue& leader = found_.spectra[1].eigenvalues.front();
    Truth truth = over_others(1, 1, [&](const Eigenvalue& other) -> Said {
      const std::optional<int> sign = compare(std::abs(other.value), tangent());
      if (!sign) return silence();
      if (*sign < 0) return agreement();
      return refusal(fmt::format("not C1: {} {} the tangent's {:.6g}", described(other),
                                 *sign == 0 ? "ties with" : "leads", tangent()));
    });
    if (leader.jordan > 1) {
      truth = Truth::no;
      reasons().push_back(fmt::format("not C1: the tangent's {:.6g} has a Jordan block of size {}",
                                      tangent(), leader.jordan));
    }
    verdict_.c1_necessary = truth && verdict_.convergent;
  }

  void curvature() {
    const double square = tangent() * tangent();
    verdict_.bounded_curvature = over_others(1, 1, [&](const Eigenvalue& other) -> Said {
      const std::optional<int> sign = compare(std::abs(other.value), square);
      if (!sign) return silence();
      if (*sign < 0 || (*sign == 0 && other.jordan == 1)) return agreement();
      if (*sign == 0)
        return refusal(
            fmt::format("unbounded curvature: {} is tangent² with a Jordan block of size {}",
                        described(other), other.jordan));
      return refusal(fmt::format("unbounded curvature: {} exceeds tangent² = {:.6g}",
                                 described(other), square));
    });
    verdict_.bounded_curvature = verdict_.bounded_curvature && verdict_.c1_necessary;
  }

  void shape(const char* name, const char* lost, const std::vector<Eigenvalue>& list,
             std::size_t index, std::optional<Curvature>& result) {
    if (index >= list.size()) return;
    result = Curvature::undecided;
    const double square = tangent() * tangent();
    const double modulus = std::abs(list[index].value);
    const std::optional<int> sign = compare(modulus, square);
    if (!sign) return;
    result = *sign < 0 ? Curvature::flat : *sign == 0 ? Curvature::bounded : Curvature::unbounded;
    if (*sign < 0)
      reasons().push_back(fmt::format("flat {}: {:.6g} < tangent² = {:.6g}, so no {} shapes", name,
                                      modulus, square, lost));
  }

  Eigencomponents& found_;
  Verdict& verdict_;
};

}  // namespace

std::string_view to_string(Curvature curvature) {
  switch (curvature) {
    case Curvature::flat: return "flat";
    case Curvature::bounded: return "bounded";
    case Curvature::unbounded: return "unbounded";
    case Curvature::undecided: break;
  }
  return "undecided";
}

std::optional<double> labelled(const Component& component, const BlockSpectrum& spectrum) {
  const std::vector<Eigenvalue>& list = spectrum.eigenvalues;
  if (component.index >= list.size()) return std::nullopt;
  const std::complex<double> value = list[component.index].value;
  if (std::abs(value.imag()) > kEqualBelow) return std::nullopt;
  return value.real();
}

BlockSpectrum approx_spectrum(const FrequencyBlocks& blocks, int omega, Near near) {
  const Eigen::MatrixXcd block = mirrored(blocks, blocks.blocks[static_cast<std::size_t>(omega)]);
  if (block.imag().cwiseAbs().maxCoeff() < 1e-14)
    return {omega, eigenvalues(blocks, Eigen::MatrixXd(block.real()), omega, near)};
  return {omega, eigenvalues(blocks, block, omega, near)};
}

Eigencomponents approx_eigencomponents(const FrequencyBlocks& blocks) {
  Eigencomponents result;
  result.valence = blocks.valence;
  result.rings = blocks.rings;
  for (int omega = 0; omega <= blocks.valence / 2; ++omega)
    result.spectra.push_back(approx_spectrum(blocks, omega));
  const std::array<std::optional<double>*, kComponents.size()> values{
      &result.position, &result.cup, &result.tangent, &result.saddle};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Component& component = kComponents[i]; component.exists_at(blocks.valence))
      *values[i] =
          labelled(component, result.spectra[static_cast<std::size_t>(component.frequency)]);
  Judge(result).judge();
  return result;
}

}  // namespace limn
