#pragma once
/// What a mesh carries, refined: the choices, and what a scheme can take.

#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/attributes/texture_rule.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// What becomes of attributes.
struct AttributeRules {
  bool linear = false;  ///< numbers of vertices: on each face by itself, not by the scheme's rules
  TextureRule texture = TextureRule::corners_plus1;  ///< what of texture coordinates stays in place
};

/// Whether a scheme can refine these texture coordinates. Where they have seams, its split must
/// keep old edges, and unless the rule is `all` it must have rules for boundaries; the error names
/// what is missing and a way out.
[[nodiscard]] Status check_takes_texture(const Scheme& scheme, const Mesh& mesh,
                                         const TextureCoordinates& texture, TextureRule rule);

}  // namespace limn
