#include "limn/spectrum/eigencomponents.h"

#include <cmath>

#include <fmt/core.h>

namespace limn {
namespace {

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
    if (found_.valence == 2) {
      verdict_.c1_necessary = verdict_.curvature_necessary = Truth::undecided;
      verdict_.bounded_curvature = Truth::undecided;
      reasons().push_back(
          "undecided: at valence 2 frequency 1 is real, so there is no tangent pair, of which the "
          "theorems speak");
      return;
    }
    if (!found_.tangent || !(*found_.tangent > 0)) {
      verdict_.c1_necessary = verdict_.curvature_necessary = Truth::no;
      verdict_.bounded_curvature = Truth::no;
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
  /// first, and so largest, refusal of each block has a reason.
  template <class Holds, class Reason>
  Truth over_others(std::size_t skip_0, std::size_t skip_1, Truth refusal, Holds holds,
                    Reason reason) {
    Truth all = Truth::yes;
    for (const BlockSpectrum& block : found_.spectra) {
      const std::size_t skip = block.frequency == 0 ? skip_0 : block.frequency == 1 ? skip_1 : 0;
      bool refused = false;
      for (std::size_t i = skip; i < block.eigenvalues.size(); ++i) {
        const Truth truth = holds(block.eigenvalues[i]);
        all = all && (truth == Truth::no ? refusal : truth);
        if (truth == Truth::no && !refused) reasons().push_back(reason(block.eigenvalues[i]));
        refused = refused || truth == Truth::no;
      }
    }
    return all;
  }

  /// What an eigenvalue that is too large says of surfaces. Its eigenvector may have the surface 0.
  [[nodiscard]] Truth refusal() const {
    return verdict_.regular_part.stable ? Truth::no : Truth::undecided;
  }

  /// "not C1: ", or what can be said of it.
  [[nodiscard]] std::string opening(const char* what, const char* undecided) const {
    return verdict_.regular_part.stable ? std::string(what)
                                        : fmt::format(
                                              "undecided {}: shifts are not proved to be "
                                              "stable, so that the surface of an "
                                              "eigenvector may be 0; ",
                                              undecided);
  }

  /// Whether a modulus is less than a bound.
  static Truth is_less(double modulus, double bound) {
    const std::optional<int> sign = compare(modulus, bound);
    return !sign ? Truth::undecided : *sign < 0 ? Truth::yes : Truth::no;
  }

  void convergence() {
    const Eigenvalue& first = found_.spectra.front().eigenvalues.front();
    if (std::abs(first.value - 1.0) > kEqualBelow || first.multiplicity > 1) {
      verdict_.convergent = Truth::no;
      reasons().push_back(
          fmt::format("not convergent: frequency 0 is led by {}, where a simple 1 is needed",
                      described(first)));
      return;
    }
    verdict_.convergent = over_others(
        1, 0, Truth::no, [](const Eigenvalue& other) { return is_less(other.modulus(), 1); },
        [](const Eigenvalue& other) {
          return fmt::format("not convergent: {} is not less than 1", described(other));
        });
  }

  /// Whether it is of the tangent's own Jordan chain, or less than the chain's k λ^k.
  [[nodiscard]] bool is_drowned(const Eigenvalue& other, const Eigenvalue& leader) const {
    if (leader.jordan == 1) return false;
    return other.jordan < leader.jordan || (other.frequency == leader.frequency &&
                                            compare(std::abs(other.value - leader.value), 0) == 0);
  }

  void tangent_plane() {
    const Eigenvalue& leader = found_.spectra[1].eigenvalues.front();
    Truth truth = over_others(
        1, 1, refusal(),
        [&](const Eigenvalue& other) {
          if (compare(other.modulus(), tangent()) == 0 && is_drowned(other, leader))
            return Truth::yes;
          return is_less(other.modulus(), tangent());
        },
        [&](const Eigenvalue& other) {
          const bool ties = compare(other.modulus(), tangent()) == 0;
          return fmt::format("{}{} {} the tangent's {:.6g}{}", opening("not C1: ", "C1"),
                             described(other), ties ? "ties with" : "leads", tangent(),
                             ties ? fmt::format(" to {}", kEqualBelow) : "");
        });
    if (leader.jordan > 1) {
      truth = truth && Truth::undecided;
      reasons().push_back(
          fmt::format("undecided C1: the tangent's {:.6g} has a Jordan block of size {}, which the "
                      "standard theorem leaves out; the map of the chain's eigenvector decides",
                      tangent(), leader.jordan));
    }
    verdict_.c1_necessary = truth && verdict_.convergent;
  }

  void curvature() {
    const double square = tangent() * tangent();
    const auto ties = [&](const Eigenvalue& other) {
      return compare(other.modulus(), square) == 0;
    };
    const Truth others = over_others(
        1, 1, refusal(),
        [&](const Eigenvalue& other) {
          if (ties(other)) return other.jordan == 1 ? Truth::yes : Truth::no;
          return is_less(other.modulus(), square);
        },
        [&](const Eigenvalue& other) {
          if (ties(other))
            return fmt::format("{}{} is tangent² with a Jordan block of size {}",
                               opening("unbounded curvature: ", "curvature"), described(other),
                               other.jordan);
          return fmt::format("{}{} exceeds tangent² = {:.6g}",
                             opening("unbounded curvature: ", "curvature"), described(other),
                             square);
        });
    verdict_.curvature_necessary = others && verdict_.c1_necessary;
    verdict_.bounded_curvature = verdict_.curvature_necessary && verdict_.regular_part.bounded;
    say_regular_part();
  }

  void say_regular_part() {
    const Truth bounded = verdict_.regular_part.bounded;
    const std::string& reason = verdict_.regular_part.reason;
    if (bounded == Truth::no)
      reasons().push_back("unbounded curvature of the regular surface round it: " + reason);
    else if (bounded == Truth::undecided && verdict_.curvature_necessary != Truth::no)
      reasons().push_back("undecided curvature of the regular surface round it: " + reason);
  }

  void shape(const char* name, const char* lost, const std::vector<Eigenvalue>& list,
             std::size_t index, std::optional<Curvature>& result) {
    if (index >= list.size()) return;
    result = Curvature::undecided;
    const double square = tangent() * tangent();
    const double modulus = list[index].modulus();
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

Eigencomponents approx_eigencomponents(const FrequencyBlocks& blocks, const RegularPart& regular) {
  Eigencomponents result;
  result.verdict.regular_part = regular;
  result.valence = blocks.valence;
  result.rings = blocks.rings;
  result.spectra = approx_spectra(blocks);
  const std::array<std::optional<double>*, kComponents.size()> values{
      &result.position, &result.cup, &result.tangent, &result.saddle};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const Component& component = kComponents[i]; component.exists_at(blocks.valence))
      *values[i] =
          labelled(component, result.spectra[static_cast<std::size_t>(component.frequency)]);
  // at n = 2 frequency 1 is its own conjugate: real shapes, and no pair that spans a plane
  if (blocks.valence == 2) result.tangent.reset();
  Judge(result).judge();
  return result;
}

}  // namespace limn
