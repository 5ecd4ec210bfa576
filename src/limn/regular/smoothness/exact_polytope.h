#pragma once
/// A joint spectral radius, exactly, by a polytope in exact numbers.
///
/// Let P be the convex hull of finitely many vectors ±v, spanning, and let every image A_i v lie in
/// level · P. Then P is the unit ball of a norm in which no A_i is greater than the level, so that
/// products of n of the A_i have at most that norm to the n: the joint spectral radius is at most
/// the level, and products are bounded by a constant times level^n, without a power of n. Where a
/// product of L factors has an eigenvalue of the modulus level^L the radius is the level
/// [GuglielmiProtasov2013; GuglielmiProtasov2016].
///
/// The level and all coordinates are rational. Of an image it is proved that it lies in P
///   - where it is ± a vertex, by comparing coordinates;
///   - well within P, by a combination Σ c_j v_j in double precision with Σ|c_j| < 1 and a bound,
///     rounded outwards, of the norm of what it misses: all that is strictly inside has one;
///   - on the faces of P, by the combination solved exactly for the vertices that the linear
///     program takes.
/// A level with an error of 10⁻⁹ would pass for the right one nowhere in this: an image that lies
/// outside by any amount has no such combination.

#include <functional>
#include <optional>
#include <vector>

#include "limn/base/budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

/// Whether the hull of the vertices and their negatives is spanning and every matrix maps it into
/// `level` times itself: true is proved, false says nothing. Precondition: level > 0, vectors of
/// the matrices' size. Cost: a linear program for each matrix and vertex.
[[nodiscard]] bool certify_invariant_polytope(const std::vector<RationalMatrix>& matrices,
                                              const Rational& level,
                                              const std::vector<FieldVector<Rational>>& vertices,
                                              const Stop& stop = {});

struct ExactPolytopeLimits {
  int most_vertices = 2000;
  Stop stop;
  std::function<void(int vertices)> progress;  ///< called now and then, if given
};

/// Grows such a polytope: the images of `start` under products of matrices/level until each new one
/// lies within, which `certify_invariant_polytope` then holds true. Nothing where that does not
/// happen within the limits: where the radius is above the level, or at the level where `start`
/// lacks an eigenvector of a product that has it, it never does. Deterministic.
[[nodiscard]] std::optional<std::vector<FieldVector<Rational>>> find_invariant_polytope(
    const std::vector<RationalMatrix>& matrices, const Rational& level,
    const std::vector<FieldVector<Rational>>& start, const ExactPolytopeLimits& limits = {});

}  // namespace limn::regular
