#pragma once
/// Eigenvalues of frequency blocks in exact numbers. All of it gives up, with nothing, where an
/// ExactBudget that is open ends.

#include <optional>
#include <string>
#include <vector>

#include "limn/certify/blocks/valence_balls.h"

namespace limn::certify {

/// Exact::approx is within a few roundings of its magnitude.
[[nodiscard]] number::Ball enclosed(const number::Exact& value);

/// to += a·b; false where exact arithmetic gives up.
[[nodiscard]] bool add_product(number::Exact& to, const number::Exact& a, const number::Exact& b);

/// λ as an exact number: a row of its own in the block, or a rational of small denominator. That
/// it is an eigenvalue is for null_space to show.
[[nodiscard]] std::optional<number::Exact> exact_leader(
    const number::DenseMatrix<number::Exact>& block, const EnclosedPair& leader);

/// A basis of the null space of a - value·I. Cost: rows³ operations.
[[nodiscard]] std::optional<std::vector<std::vector<number::Exact>>> null_space(
    number::DenseMatrix<number::Exact> a, const number::Exact& value);

/// "1/6 exactly, with 2 eigenvectors in the blocks of frequencies 0, 1" where the blocks, the 1 of
/// frequency 0 left aside, have together more than one eigenvector of a rational eigenvalue near
/// `value`; else empty.
[[nodiscard]] std::string exact_tie(const Scheme& scheme, const ValenceBalls& balls, double value);

}  // namespace limn::certify
