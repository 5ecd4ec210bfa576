#pragma once
/// What a scheme is on meshes of one kind of faces.

#include <string>
#include <string_view>
#include <vector>

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// "triangle" or "quad".
[[nodiscard]] std::string_view lattice_name(Lattice lattice);

/// The scheme itself; where its meshes have both kinds of faces (Split::mixed), what it is on
/// triangles alone, with the split triangle-dyadic, and on quads alone, with quad-dyadic: schemes
/// of the same stages, in which q, the number of quads at a vertex, is a let, 0 or n. Facts go to
/// their lattice. Cost: that of copying the scheme.
[[nodiscard]] std::vector<Scheme> lattice_schemes(const Scheme& scheme);

/// What a report calls one of them: "NAME on triangles"; NAME where the scheme has one lattice.
[[nodiscard]] std::string label_on_lattice(const std::string& name, const Scheme& scheme);

/// That there is one lattice, for what has no meaning where both kinds of faces meet: the error
/// says so.
[[nodiscard]] Status check_one_lattice(const Scheme& scheme);

}  // namespace limn::scheme
