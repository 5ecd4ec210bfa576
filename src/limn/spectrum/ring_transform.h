#pragma once
/// The discrete Fourier transform of what stands round a vertex, of any number of values.

#include <complex>
#include <vector>

namespace limn::spectrum {

/// sums[ω] = Σ_k values[k] e^{2πiωk/n} for ω = 0 … ⌊n/2⌋, n = values.size() ≥ 1; the sum of n-ω is
/// the conjugate of ω's. For small n one by one, and from kQuickTransform on by Bluestein's
/// transform [Bluestein 1970], so that n may be any number, a prime too. Rounding: within about
/// 10 · 2^-53 · log2(4n) times the root of n Σ values². Cost O(n log n).
[[nodiscard]] std::vector<std::complex<double>> ring_transform(const std::vector<double>& values);

/// Below, n² products are as quick, and round less.
inline constexpr std::size_t kQuickTransform = 512;

}  // namespace limn::spectrum
