#include "limn/tune/branches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "limn/tune/margin.h"

namespace limn::tune {
namespace {

/// Rounding splits a defective pair by so much at most, into the complex.
constexpr double kSplitPair = 1e-6;

/// Real eigenvalues of the sought component's block. The 1 of position is not in question where
/// another label of frequency 0 is sought.
std::vector<Eigenvalue> candidates(const Component& sought, const BlockSpectrum& spectrum) {
  std::vector<Eigenvalue> list;
  for (const Eigenvalue& one : spectrum.eigenvalues)
    if (std::abs(one.value.imag()) <= kSplitPair) list.push_back(one);
  if (sought.frequency == 0 && sought.index > 0 && !list.empty())
    list.erase(std::min_element(list.begin(), list.end(), [](const auto& a, const auto& b) {
      return std::abs(a.value - 1.0) < std::abs(b.value - 1.0);
    }));
  std::sort(list.begin(), list.end(), [](const Eigenvalue& a, const Eigenvalue& b) {
    return std::tuple(a.ring, -a.value.real()) < std::tuple(b.ring, -b.value.real());
  });
  return list;
}

}  // namespace

Result<BranchSample> sample_branches(const Requirement& requirement, FreedScheme& scheme,
                                     const FrequencyBlocks& blocks, double x, Near near) {
  std::map<int, BlockSpectrum> spectra;  // of the frequencies in question
  ComponentValues values;
  for (const std::size_t i : requirement.used) {
    const Component& component = kComponents[i];
    if (!component.exists_at(blocks.valence)) continue;
    const auto [at, fresh] = spectra.try_emplace(component.frequency);
    if (fresh) at->second = approx_spectrum(blocks, component.frequency, near);
    values[i] = labelled(component, at->second);
  }
  const int n = blocks.valence;
  BranchSample sample{x, true, {}, std::nullopt};
  if (const Result<double> own = difference(requirement, scheme, n, x, values))
    sample.labelled = *own;
  const std::optional<std::size_t> sought = sought_component(requirement);
  std::vector<Eigenvalue> list{Eigenvalue{1.0, 0, 0, 1, 1}};  // an equation without components
  if (sought && kComponents[*sought].exists_at(n))
    list = candidates(kComponents[*sought], spectra.at(kComponents[*sought].frequency));
  else if (sought)
    list.front().value = 0;  // `difference` will say what is missing
  for (const Eigenvalue& one : list) {
    if (sought && kComponents[*sought].exists_at(n)) values[*sought] = one.value.real();
    const Result<double> value = difference(requirement, scheme, n, x, values);
    if (!value) return value.error();
    sample.branches.push_back({one, *value});
  }
  return sample;
}

bool same_rings(const BranchSample& a, const BranchSample& b) {
  return a.defined && b.defined &&
         std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                    [](const Branch& one, const Branch& other) {
                      return one.eigenvalue.ring == other.eigenvalue.ring;
                    });
}

}  // namespace limn::tune
