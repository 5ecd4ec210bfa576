#pragma once
/// A stencil applied to all points of a class, in all lanes (lanes.h). Terms of one weight are
/// added before they are weighed: by symmetry most come in such groups.

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "limn/fast/kernel/lanes.h"
#include "limn/fast/kernel/patch_program.h"

namespace limn::fast {

inline constexpr std::size_t kLargestGroup = 6;

/// Terms that have one weight.
template <class Real>
struct EqualTerms {
  std::array<Index, kLargestGroup> slots{};  ///< relative to the anchor's
  std::size_t size = 0;
  Real weight = 0;
};

namespace detail {

// not left to the compiler, which thinks of the size of all of these together
template <class Real, std::size_t size>
[[gnu::always_inline]] inline void add_equal(const LanePoint<Real>* anchor,
                                             const std::array<std::ptrdiff_t, size>& slots,
                                             Vector<Real> weight, LanePoint<Real>& sum) {
  LanePoint<Real> equal = anchor[slots[0]];
  for (std::size_t t = 1; t < size; ++t) {
    equal.x += anchor[slots[t]].x;
    equal.y += anchor[slots[t]].y;
    equal.z += anchor[slots[t]].z;
  }
  sum.x += weight * equal.x;
  sum.y += weight * equal.y;
  sum.z += weight * equal.z;
}

/// Adds two groups (of the second, there may be none) for the points of a class to what is in the
/// line, or where they are the `first`, to nothing.
template <class Real, std::size_t size, std::size_t size2, bool first>
void add_groups(const LanePoint<Real>* grid, const StencilPoints& points,
                const EqualTerms<Real>* groups, LanePoint<Real>* line) {
  std::array<std::ptrdiff_t, size> slots;
  std::copy_n(groups[0].slots.begin(), size, slots.begin());
  std::array<std::ptrdiff_t, size2> slots2;
  const Vector<Real> weight = Vector<Real>{} + groups[0].weight;
  Vector<Real> weight2{};
  if constexpr (size2 > 0) {
    std::copy_n(groups[1].slots.begin(), size2, slots2.begin());
    weight2 += groups[1].weight;
  }
  const Index* anchors = points.anchors.data();
  const Index* places = points.places.data();
  const std::size_t count = points.anchors.size();
  for (std::size_t i = 0; i < count; ++i) {
    const LanePoint<Real>* anchor = grid + anchors[i];
    LanePoint<Real>& to = line[places[i]];
    LanePoint<Real> sum{};
    if constexpr (!first) sum = to;
    add_equal(anchor, slots, weight, sum);
    if constexpr (size2 > 0) add_equal(anchor, slots2, weight2, sum);
    to = sum;
  }
}

template <class Real>
using Adder = void (*)(const LanePoint<Real>*, const StencilPoints&, const EqualTerms<Real>*,
                       LanePoint<Real>*);
inline constexpr std::size_t kSecondSizes = kLargestGroup + 1;
template <class Real, bool first, std::size_t... i>
constexpr std::array<Adder<Real>, sizeof...(i)> make_adders(std::index_sequence<i...>) {
  return {add_groups<Real, i / kSecondSizes + 1, i % kSecondSizes, first>...};
}
template <class Real, bool first>
inline constexpr auto kAdders =
    make_adders<Real, first>(std::make_index_sequence<kLargestGroup * kSecondSizes>());

}  // namespace detail

template <class Real>
class LaneStencil {
 public:
  LaneStencil() = default;

  /// Over the slots of the program's local grid; groups come in the order of their first terms.
  LaneStencil(const Stencil& stencil, const PatchProgram& program) {
    for (const Tap& tap : stencil) {
      const Real weight = static_cast<Real>(tap.weight);
      auto group = std::find_if(groups_.begin(), groups_.end(), [&](const auto& known) {
        return known.weight == weight && known.size < kLargestGroup;
      });
      if (group == groups_.end()) {
        group = groups_.emplace(group);
        group->weight = weight;
      }
      group->slots[group->size++] = program.slot_step(tap.place);
    }
    if (groups_.size() % 2 == 1) groups_.emplace_back();
    for (std::size_t g = 0; g < groups_.size(); g += 2) {
      const std::size_t i = (groups_[g].size - 1) * detail::kSecondSizes + groups_[g + 1].size;
      adders_.push_back(g == 0 ? detail::kAdders<Real, true>[i] : detail::kAdders<Real, false>[i]);
    }
  }

  /// The points of a class, from the grid into their places in the line.
  void apply(const LanePoint<Real>* grid, const StencilPoints& points,
             LanePoint<Real>* line) const {
    for (std::size_t a = 0; a < adders_.size(); ++a)
      adders_[a](grid, points, &groups_[2 * a], line);
  }

 private:
  std::vector<EqualTerms<Real>> groups_;     // an even number, the last may be empty
  std::vector<detail::Adder<Real>> adders_;  // one for two groups
};

}  // namespace limn::fast
