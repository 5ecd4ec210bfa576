#include "limn/spectrum/connected_parts.h"

#include <algorithm>

namespace limn::spectrum {

ConnectedParts connected_parts(const BoolMatrix& entries) {
  const Eigen::Index size = entries.rows();
  ConnectedParts result{{}, std::vector<std::size_t>(static_cast<std::size_t>(size)), entries};
  BoolMatrix& reaches = result.reaches;
  for (Eigen::Index i = 0; i < size; ++i) reaches(i, i) = true;
  for (Eigen::Index via = 0; via < size; ++via)
    for (Eigen::Index j = 0; j < size; ++j)
      if (j != via && reaches(via, j)) reaches.col(j) = reaches.col(j) || reaches.col(via);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto together = [&](const std::vector<Eigen::Index>& part) {
      return reaches(i, part.front()) && reaches(part.front(), i);
    };
    auto part = std::find_if(result.parts.begin(), result.parts.end(), together);
    if (part == result.parts.end()) part = result.parts.emplace(part);
    part->push_back(i);
    result.part_of[static_cast<std::size_t>(i)] =
        static_cast<std::size_t>(part - result.parts.begin());
  }
  return result;
}

std::vector<Eigen::Index> rows_between(const ConnectedParts& connected,
                                       const std::vector<Eigen::Index>& ends) {
  const BoolMatrix& reaches = connected.reaches;
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < reaches.rows(); ++i)
    if (std::any_of(ends.begin(), ends.end(), [&](Eigen::Index end) { return reaches(i, end); }) &&
        std::any_of(ends.begin(), ends.end(), [&](Eigen::Index end) { return reaches(end, i); }))
      rows.push_back(i);
  return rows;
}

}  // namespace limn::spectrum
