#pragma once
/// What is known of the shipped schemes independently of their files, as one question: the first
/// thing about this scheme that is not so. Silent for every shipped scheme (facts_test.cpp), and
/// for no scheme with a changed weight (mutation_test.cpp).

#include <optional>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn::test {

/// All of the following, the quickest first.
[[nodiscard]] std::optional<std::string> first_failed_check(const Scheme& scheme);

/// One step of refinement against reference_step on a deck of meshes: stars of valence 3 … 12,
/// faces of as many corners, extraordinary neighbours, boundaries, random closed and open meshes
/// (tori alone for schemes given by a mask).
[[nodiscard]] std::optional<std::string> failed_reference(const Scheme& scheme);

/// The stated mask against the one that the rules make, exactly.
[[nodiscard]] std::optional<std::string> failed_mask(const Scheme& scheme);

/// Every fact at each of its valences, against brute-force frequency blocks: tangent, cup and
/// saddle are eigenvalues of frequencies 1, 0 and 2, the largest on the smallest neighbourhood, and
/// the tangent is frequency 1's largest on a larger one, too.
[[nodiscard]] std::optional<std::string> failed_facts(const Scheme& scheme);

}  // namespace limn::test
