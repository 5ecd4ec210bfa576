#include "limn/limit/sector_spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/scheme/lattice_schemes.h"

namespace limn::limit {
namespace {

// moduli that are nearer to each other are equal; below the second it is not known, since rounding
// blurs eigenvalues that have a Jordan block
constexpr double kEqual = 1e-10, kUnknown = 1e-6;

/// Whether a is larger than b ≤ a.
Truth is_larger(double a, double b) {
  if (a - b <= kEqual) return Truth::no;
  return a - b > kUnknown ? Truth::yes : Truth::undecided;
}

/// That the split makes of such a star one of the same sectors.
Status check_takes(const Scheme& scheme, const mesh::Sectors& sectors) {
  const Split& split = *scheme.split;
  if (split.is_dual() || split.dilation.turns())
    return Error{fmt::format("the split {} keeps no faces round a vertex", split.name),
                 "give a valence"};
  const bool others = std::any_of(sectors.lattices.begin(), sectors.lattices.end(),
                                  [&](Lattice lattice) { return lattice != split.lattice; });
  if (!others || split.mixed) return Done{};
  return Error{fmt::format("scheme '{}' has {}s alone round a vertex, after a step at most",
                           scheme.name, scheme::lattice_name(split.lattice)),
               "schemes of the split quad-triangle have both kinds of faces"};
}

void judge_convergence(SectorSpectrum& spectrum) {
  const std::vector<std::complex<double>>& values = spectrum.eigenvalues;
  const double second = values.size() > 1 ? std::abs(values[1]) : 0;
  const bool leads = std::abs(values.front() - 1.0) < kUnknown;
  spectrum.convergent = leads ? is_larger(1, std::min(second, 1.0)) : Truth::no;
  if (spectrum.convergent != Truth::yes)
    spectrum.reasons.push_back(
        fmt::format("the subdominant eigenvalue has the modulus {:.6f}", second));
}

/// Given the eigenvalues beside 1.
void judge_pair(const std::vector<std::complex<double>>& values, SectorSpectrum& spectrum) {
  const auto say = [&](Truth truth, std::string reason) {
    spectrum.c1_necessary = truth;
    spectrum.reasons.push_back(std::move(reason));
  };
  if (values.size() < 2) return say(Truth::no, "there is no tangent pair");
  const double first = std::abs(values[0]), second = std::abs(values[1]);
  const double third = values.size() > 2 ? std::abs(values[2]) : 0;
  const Truth leads = is_larger(second, third);
  if (leads != Truth::yes)
    return say(leads, fmt::format("after 1 the moduli are {:.6f}, {:.6f}, {:.6f}: no two of them "
                                  "lead the others",
                                  first, second, third));
  if (std::abs(values[0].imag()) > kEqual || std::abs(values[1].imag()) > kEqual)
    return say(Truth::undecided, "the two that lead the others are not real");
  if (values[0].real() < 0 || values[1].real() < 0)
    return say(Truth::undecided, "of the two that lead the others one is negative");
  if (!leading_pair(spectrum.matrix, values))
    return say(Truth::undecided, "the two that lead the others have a Jordan block");
  spectrum.c1_necessary = Truth::yes;
  spectrum.tangent = {values[0].real(), values[1].real()};
}

}  // namespace

Result<SectorSpectrum> approx_sector_spectrum(const Scheme& scheme, const mesh::Sectors& sectors) {
  if (Status status = check_takes(scheme, sectors); !status) return status.error();
  Result<SectorMatrix> matrix = sector_matrix(scheme, sectors);
  if (!matrix) return matrix.error();
  SectorSpectrum spectrum{std::move(*matrix), {}, {}, Truth::undecided, Truth::undecided, {}};
  spectrum.eigenvalues = eigenvalues_of(spectrum.matrix);
  judge_convergence(spectrum);
  if (spectrum.convergent == Truth::yes)
    judge_pair({spectrum.eigenvalues.begin() + 1, spectrum.eigenvalues.end()}, spectrum);
  else
    spectrum.c1_necessary = spectrum.convergent;
  return spectrum;
}

}  // namespace limn::limit
