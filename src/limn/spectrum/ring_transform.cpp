#include "limn/spectrum/ring_transform.h"

#include <bit>
#include <cassert>
#include <cstdint>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace limn::spectrum {
namespace {

using Spectrum = std::vector<std::complex<double>>;

Spectrum one_by_one(const std::vector<double>& values) {
  const std::size_t n = values.size();
  Spectrum roots, sums;
  for (std::size_t k = 0; k < n; ++k)
    roots.push_back(
        std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n)));
  for (std::size_t omega = 0; omega <= n / 2; ++omega) {
    std::complex<double> sum = 0;
    std::size_t at = 0;
    for (const double value : values) {
      sum += value * roots[at];
      at += omega;
      if (at >= n) at -= n;
    }
    sums.push_back(sum);
  }
  return sums;
}

/// 2ωk = ω² + k² − (ω−k)² makes the sums a convolution with the chirp e^{−πij²/n}, of any length
/// that has room, so of a power of two.
Spectrum by_chirp(const std::vector<double>& values) {
  const std::size_t n = values.size();
  const std::size_t size = std::bit_ceil(2 * n);
  const auto chirp = [&](std::uint64_t j) {  // e^{πij²/n}; j² modulo 2n is exact
    const std::uint64_t square = j * j % (2 * n);
    return std::polar(1.0, std::numbers::pi * static_cast<double>(square) / static_cast<double>(n));
  };
  Spectrum weighted(size), kernel(size), chirps(n);
  for (std::size_t j = 0; j < n; ++j) {
    chirps[j] = chirp(j);
    weighted[j] = values[j] * chirps[j];
    kernel[j] = std::conj(chirps[j]);
    if (j > 0) kernel[size - j] = kernel[j];
  }
  Eigen::FFT<double> fft;
  Spectrum a, b;
  fft.fwd(a, weighted);
  fft.fwd(b, kernel);
  for (std::size_t i = 0; i < size; ++i) a[i] *= b[i];
  fft.inv(weighted, a);
  Spectrum sums;
  sums.reserve(n / 2 + 1);
  for (std::size_t omega = 0; omega <= n / 2; ++omega)
    sums.push_back(chirps[omega] * weighted[omega]);
  return sums;
}

}  // namespace

std::vector<std::complex<double>> ring_transform(const std::vector<double>& values) {
  assert(!values.empty());
  return values.size() < kQuickTransform ? one_by_one(values) : by_chirp(values);
}

}  // namespace limn::spectrum
