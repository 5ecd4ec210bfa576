#include "limn/fast/kernel/piece_groups.h"

#include "limn/base/parallel.h"

namespace limn::fast {

std::vector<PieceGroup> group_pieces(const StepPieces& pieces, const StepPieces& before, Index most,
                                     bool own_vertices) {
  std::vector<std::vector<Index>> sources(static_cast<std::size_t>(pieces.count()));
  base::parallel_for(
      Index{0}, pieces.count(),
      [&](Index first, Index last) {
        for (Index piece = first; piece < last; ++piece)
          sources[static_cast<std::size_t>(piece)] = pieces.sources(piece, before, own_vertices);
      },
      8);
  std::vector<PieceGroup> groups;
  std::vector<std::size_t> taken_by(static_cast<std::size_t>(before.count()), 0);
  std::vector<Index> more;
  Index size = 0;
  for (Index piece = 0; piece < pieces.count(); ++piece) {
    const auto find_more = [&] {
      more.clear();
      Index found = 0;
      for (const Index source : sources[static_cast<std::size_t>(piece)]) {
        if (taken_by[static_cast<std::size_t>(source)] == groups.size()) continue;
        more.push_back(source);
        found += before.vertices_of(source);
      }
      return found;
    };
    Index added = groups.empty() ? 0 : find_more();
    if (groups.empty() || added > most - size) {  // a group of its own
      groups.push_back({piece, piece, {}});
      size = 0;
      added = find_more();
    }
    PieceGroup& group = groups.back();
    group.last = piece + 1;
    size += added;
    for (const Index source : more) {
      taken_by[static_cast<std::size_t>(source)] = groups.size();
      group.sources.push_back(source);
    }
    sources[static_cast<std::size_t>(piece)] = {};
  }
  return groups;
}

}  // namespace limn::fast
