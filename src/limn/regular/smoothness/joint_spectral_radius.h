#pragma once
/// The joint spectral radius ρ of rational matrices: the growth of the largest of all products of n
/// of them, lim max ‖A_{i1} … A_{in}‖^{1/n} [Jungers2009]. Common invariant subspaces are split off
/// first; then ρ lies between the spectral radius of a product (proved by an exact determinant) and
/// a norm, that of a polytope (proved in doubles rounded outwards).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"
#include "limn/regular/smoothness/regularity.h"

namespace limn::regular {

struct JointSpectralRadiusOptions {
  int budget = 7000;        ///< vertices of one polytope
  double tolerance = 3e-3;  ///< upper/lower - 1 below which little more is sought
  /// Called with what is done next, if given.
  std::function<void(const std::string&)> progress = {};
  /// If given, nothing is asked but whether ρ is below this: `upper` is brought below it or left
  /// coarse, and left coarse at once where `lower` comes near it.
  std::optional<double> target = {};
  /// Asks for the end of the search: what was reached is given, all of it proved.
  Stop stop = {};
};

/// Precondition: at least one matrix, all square and of one size ≥ 1. Deterministic.
[[nodiscard]] JointSpectralRadius enclose_joint_spectral_radius(
    const std::vector<RationalMatrix>& matrices, const JointSpectralRadiusOptions& options = {});

}  // namespace limn::regular
