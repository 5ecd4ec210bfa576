#include "limn/fast/plain/weight_lists.h"

#include <algorithm>
#include <cstring>

namespace limn::fast {
namespace {

constexpr std::size_t kFewestSlots = 256;

/// Terms do not wait for each other. The upper bits are the better ones.
std::uint64_t hash_of(std::span<const double> weights, Index olds) {
  std::uint64_t factor = 0x9e3779b97f4a7c15U, sum = static_cast<std::uint64_t>(olds) * factor;
  for (const double weight : weights) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &weight, sizeof bits);
    factor += 0xd1342543de82ef96U;  // even, so that factors stay odd
    sum += (bits ^ (bits >> 29U)) * factor;
  }
  return (sum ^ (sum >> 32U)) * 0x9e3779b97f4a7c15U;
}

std::size_t slot_of(std::uint64_t hash, std::size_t slots) { return (hash >> 32U) & (slots - 1); }

}  // namespace

Index WeightLists::number_of(std::span<const double> weights, Index olds) {
  if (2 * lists_.size() >= slots_.size()) grow();
  const std::uint64_t hash = hash_of(weights, olds);
  std::size_t at = slot_of(hash, slots_.size());
  for (; slots_[at] != kNone; at = (at + 1) & (slots_.size() - 1)) {
    const Index list = slots_[at];
    const bool same =
        hashes_[list] == hash && lists_[list].olds == olds &&
        lists_[list].size() == weights.size() &&
        std::memcmp(weights_of(list).data(), weights.data(), weights.size_bytes()) == 0;
    if (same) return list;
  }
  const auto list = static_cast<Index>(lists_.size());
  slots_[at] = list;
  hashes_.push_back(hash);
  lists_.push_back({weights_.size(), olds, static_cast<Index>(weights.size()) - olds});
  weights_.insert(weights_.end(), weights.begin(), weights.end());
  return list;
}

void WeightLists::grow() {
  slots_.assign(std::max(kFewestSlots, 2 * slots_.size()), kNone);
  for (std::size_t list = 0; list < hashes_.size(); ++list) {
    std::size_t at = slot_of(hashes_[list], slots_.size());
    while (slots_[at] != kNone) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = static_cast<Index>(list);
  }
}

}  // namespace limn::fast
