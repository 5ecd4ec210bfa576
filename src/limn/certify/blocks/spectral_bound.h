#pragma once
/// Eigenvalues of matrices of balls: enclosed, or bounded, for every matrix that the balls hold.

#include <complex>
#include <optional>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/ball.h"

namespace limn::certify {

/// An eigenvalue and its eigenvector, which is 1 at `pivot`.
struct EnclosedPair {
  number::Ball value;
  std::vector<number::Ball> vector;
  std::size_t pivot = 0;
};

/// An eigenvalue and its eigenvector in double precision, the largest entry 1.
struct ApproxPair {
  double value = 0;
  std::vector<double> vector;
};
/// Of the midpoints: the eigenvalue of largest modulus, where its imaginary part is at most so
/// large; nothing also where a midpoint is not finite or there is none.
[[nodiscard]] std::optional<ApproxPair> approx_leader(const number::BallMatrix& a,
                                                      double most_imaginary = 0);
/// Of the midpoints: the real part of the eigenvalue nearest to `value`. Precondition: not empty.
[[nodiscard]] ApproxPair approx_nearest(const number::BallMatrix& a, double value);
/// The eigenvalues of the midpoints.
[[nodiscard]] std::vector<std::complex<double>> approx_eigenvalues(const number::BallMatrix& a);

/// The one eigenvalue near `value` that has an eigenvector near `vector`, which is scaled so that
/// its largest entry is 1. It is real and simple, in every matrix that `a` holds, by Krawczyk's
/// test [Rump 2010, §10]. Fails where the test does: no such eigenvalue, one of several that are
/// close, or balls too wide. Cost: size³, some times.
[[nodiscard]] Result<EnclosedPair> enclose_eigenpair(const number::BallMatrix& a, double value,
                                                     const std::vector<double>& vector);

/// A matrix whose eigenvalues are those of `a` but for one, pair.value, counted once
/// [Wielandt's deflation: Wilkinson 1965, §9.22]. One row and column smaller.
[[nodiscard]] number::BallMatrix deflated(const number::BallMatrix& a, const EnclosedPair& pair);

/// Shows that all eigenvalues of `a` are less than `bound` > 0 in modulus: the least k ≤
/// most_squarings for which (a/bound)^(2^k) has an ∞-norm below 1. Nothing where none has. Cost:
/// size³ a squaring.
[[nodiscard]] std::optional<int> squarings_below(const number::BallMatrix& a,
                                                 const number::Ball& bound, int most_squarings);

}  // namespace limn::certify
