#pragma once
/// How far a requirement is from holding, and what it is asked of.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "limn/base/error.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/tune/freed_scheme.h"

namespace limn::tune {

/// Values of kComponents, in that order; nothing where there is no such (real) eigenvalue.
using ComponentValues = std::array<std::optional<double>, kComponents.size()>;

/// The component whose eigenvalue an equation asks for: the one that is a side by itself, or else
/// the first one used; nothing where none is used.
[[nodiscard]] std::optional<std::size_t> sought_component(const Requirement& requirement);

/// left - right, in double. Fails where a component is used that has no value.
[[nodiscard]] Result<double> difference(const Requirement& requirement, FreedScheme& scheme, int n,
                                        double x, const ComponentValues& values);

/// How far a requirement that has a range is from failing: it holds where the margin is positive
/// (at_least, bounded_curvature: above -kEqualBelow). Continuous in the eigenvalues, also across
/// the margin 0; that of a verdict is in moduli of eigenvalues [BGSK §2.3], and -1 where frequency
/// 1 is not led by a positive eigenvalue. Of bounded_curvature it presupposes that the regular
/// lattice allows it (allowed_by_lattice). Fails where left or right has no value.
[[nodiscard]] Result<double> margin(const Requirement& requirement, FreedScheme& scheme, double x,
                                    const Eigencomponents& found);

/// Whether the regular lattice allows it where the freed name is x: yes of all but
/// bounded_curvature, which needs a regular part whose curvature is bounded.
[[nodiscard]] RegularPart allowed_by_lattice(const Requirement& requirement, FreedScheme& scheme,
                                             int n, double x);

/// Why nothing is said of the regular lattice at a value that is no simple fraction.
[[nodiscard]] std::string known_in_digits_only(const std::string& name);

/// Whether a margin of 0 will do.
[[nodiscard]] bool is_closed(Relation relation);

/// The labelled eigenvalues, in the order of kComponents.
[[nodiscard]] ComponentValues component_values(const Eigencomponents& found);

}  // namespace limn::tune
