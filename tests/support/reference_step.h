#pragma once
/// One refinement step of the shipped schemes, written a second time from the literature and by
/// scheme name: its weights are typed in from the papers, and nothing of scheme/ or refine/ is
/// used. Only the half-edges and the births (mesh/) are shared with the library.

#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/split/split.h"

namespace limn::test {

/// Whether there is a reference for a scheme of this name.
[[nodiscard]] bool has_reference(const std::string& scheme);

/// Values at the vertices of the refined mesh; a scheme that has smooth triangles has two
/// references, "NAME" and "NAME, smooth triangles". `parameter` is the value of the scheme's own
/// parameter (w, b or a), where it has one; without it, what the papers take. Schemes that are
/// given by a mask alone have a reference on regular tori only; a modified-butterfly kind has none
/// round an interior vertex of valence 2.
[[nodiscard]] std::vector<double> reference_step(const std::string& scheme,
                                                 std::optional<double> parameter, const Mesh& mesh,
                                                 const Births& births,
                                                 const std::vector<double>& old);

}  // namespace limn::test
