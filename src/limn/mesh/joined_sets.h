#pragma once
/// Sets of things that are joined pair by pair; each thing has a parity relative to its set's root,
/// which says whether it faces the other way. (union-find, with path compression)

#include <numeric>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// Things are numbers from 0. Cost of each call: next to O(1), amortised.
class JoinedSets {
 public:
  explicit JoinedSets(Index count)
      : parent_(static_cast<std::size_t>(count)), parity_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  Index root(Index i) {
    Index top = i;
    char parity = 0;
    for (; parent_[top] != top; top = parent_[top]) parity ^= parity_[top];
    while (parent_[i] != top) {  // the whole way points at the root from now on
      const Index above = parent_[i];
      const char rest = parity ^ parity_[i];
      parent_[i] = top;
      parity_[i] = parity;
      parity = rest;
      if (above == top) break;
      i = above;
    }
    return top;
  }
  /// Relative to the root; precondition: `root(i)` was called after the last `join`.
  [[nodiscard]] bool parity(Index i) const { return parity_[i] != 0; }

  /// False where the two are in one set already, with another parity between them.
  bool join(Index i, Index k, bool parity) {
    const Index a = root(i), b = root(k);
    const char between = static_cast<char>(parity_[i] ^ parity_[k] ^ (parity ? 1 : 0));
    if (a == b) return between == 0;
    parent_[b] = a;
    parity_[b] = between;
    return true;
  }

 private:
  std::vector<Index> parent_;
  std::vector<char> parity_;
};

}  // namespace limn::mesh
