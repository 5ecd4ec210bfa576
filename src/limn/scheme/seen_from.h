#pragma once
/// Rules that are seen from a vertex: they make new points of edges or faces that it ends or is a
/// corner of, by its valence.

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// Whether the scheme has such rules, so that a vertex of another valence changes the stencils of
/// its edges or faces. A rule that every valence has (boundary.edge-end where boundary edges are
/// cut in three) counts only if its weights or guards use n.
[[nodiscard]] bool has_rules_seen_from(const Scheme& scheme);

}  // namespace limn::scheme
