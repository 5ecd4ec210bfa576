#include "limn/certify/blocks/real_blocks.h"

#include <cmath>

#include "limn/number/exact.h"

namespace limn::certify {
namespace {

int modulo(int a, int m) { return ((a % m) + m) % m; }

/// All weights of regular rules that are not 0.
spectrum::RegularNames names_of(const Scheme& scheme) {
  return [&scheme](const spectrum::NamedWeight& name) {
    const Result<number::Exact> value =
        scope_of<number::Exact>(scheme, name, std::nullopt, 0)(name.weight->value);
    return !value || !value->is_zero();
  };
}

}  // namespace

std::size_t RealBasis::orbit(int ring, int place) const {
  const std::size_t first = first_orbit[static_cast<std::size_t>(ring - 1)];
  const RealOrbit& one = orbits[first];
  return first + static_cast<std::size_t>(modulo(place - one.place, one.size));
}

RealBasis real_basis(const spectrum::SectorPattern& pattern) {
  RealBasis basis;
  basis.has_center = pattern.has_center;
  basis.rings = pattern.rings;
  for (const Orbit& orbit : pattern.orbits) basis.orbits.push_back({orbit.ring, 0, 0, 0, 0, false});
  for (std::size_t first = 0; first < basis.orbits.size();) {
    basis.first_orbit.push_back(first);
    std::size_t end = first;
    while (end < basis.orbits.size() && basis.orbits[end].ring == basis.orbits[first].ring) ++end;
    const int size = static_cast<int>(end - first);
    for (std::size_t i = first; i < end; ++i) {
      basis.orbits[i].size = size;
      basis.orbits[i].place = static_cast<int>(std::lround(pattern.orbits[i].angle * size));
    }
    first = end;
  }
  for (std::size_t i = 0; i < basis.orbits.size(); ++i) {
    RealOrbit& orbit = basis.orbits[i];
    const std::size_t image = basis.orbit(orbit.ring, -orbit.place);
    orbit.reflected = image < i;
    orbit.real = orbit.reflected ? image : i;
    orbit.imaginary = orbit.reflected ? i : image;
  }
  return basis;
}

std::vector<int> constant_vector(const RealBasis& basis) {
  const std::size_t shift = basis.has_center ? 1 : 0;
  std::vector<int> result(basis.orbits.size() + shift, 1);
  for (const RealOrbit& orbit : basis.orbits)
    if (orbit.imaginary != orbit.real) result[orbit.imaginary + shift] = 0;
  return result;
}

Result<spectrum::SectorPattern> exact_pattern(const Scheme& scheme, int n) {
  const Result<spectrum::CenterCases> cases = spectrum::center_cases(scheme, n);
  if (!cases) return cases.error();
  const Result<int> rings = spectrum::control_rings(scheme, *cases, names_of(scheme));
  if (!rings) return rings.error();
  return spectrum::sector_pattern(scheme, *cases, *rings, names_of(scheme));
}

Result<spectrum::SectorPattern> exact_pattern(const Scheme& scheme, int n, int rings) {
  const Result<spectrum::CenterCases> cases = spectrum::center_cases(scheme, n);
  if (!cases) return cases.error();
  return spectrum::sector_pattern(scheme, *cases, rings, names_of(scheme));
}

}  // namespace limn::certify
