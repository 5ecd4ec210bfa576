#pragma once
/// Whether the rules of a scheme look no farther round a vertex than proofs understand.
///
/// Far from an extraordinary vertex the mask stands for the rules only if a walk that passes near
/// the vertex ends where it would on the lattice. One that turns half way round a vertex which is
/// not its anchor's, or goes round it along its neighbours, ends elsewhere when the valence is
/// another. Blocks are made from a star of 13 sectors, in which a longer turn round the anchor
/// cannot be told from one the other way round.

#include <optional>
#include <string>

#include "limn/scheme/scheme.h"

namespace limn::certify {

/// What is wrong with a walk of the interior rules; nothing where all are short enough: at most 6
/// sectors round the anchor, less than half a regular turn round any other vertex (dual: face),
/// and no more than 3 steps from vertex to vertex (dual: face to face).
[[nodiscard]] std::optional<std::string> walk_beyond_bounds(const Scheme& scheme);

}  // namespace limn::certify
