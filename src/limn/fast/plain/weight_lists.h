#pragma once
/// Lists of weights, each kept once.

#include <cstdint>
#include <span>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::fast {

class WeightLists {
 public:
  /// Weights of old vertices first, then of new vertices of faces.
  struct List {
    std::size_t begin = 0;  ///< among all weights
    Index olds = 0, faces = 0;
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(olds + faces); }
  };

  /// The number of the list of these weights, the first `olds` of which are of old vertices; a new
  /// one the first time. Lists are the same where their bits are. Cost O(weights).
  Index number_of(std::span<const double> weights, Index olds);

  [[nodiscard]] const std::vector<List>& lists() const { return lists_; }
  [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
  [[nodiscard]] std::span<const double> weights_of(Index list) const {
    return {weights_.data() + lists_[list].begin, lists_[list].size()};
  }
  [[nodiscard]] std::size_t bytes() const {
    return weights_.size() * sizeof(double) + slots_.size() * sizeof(Index) +
           lists_.size() * (sizeof(List) + sizeof(std::uint64_t));
  }

 private:
  void grow();

  std::vector<double> weights_;
  std::vector<List> lists_;
  std::vector<std::uint64_t> hashes_;  // of each list
  std::vector<Index> slots_;           // a list or kNone; at most half are taken
};

}  // namespace limn::fast
