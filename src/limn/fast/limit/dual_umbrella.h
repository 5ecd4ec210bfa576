#pragma once
/// The faces round a vertex by themselves, and sums over them.

#include <map>
#include <optional>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/fast/families/family.h"

namespace limn::fast {

/// The faces round a vertex: how many corners each has, counterclockwise; at the boundary (`open`)
/// from the first one.
struct Umbrella {
  bool open = false;
  std::vector<Index> degrees;
  friend bool operator==(const Umbrella&, const Umbrella&) = default;
  // no <=>: em++'s vectors have none
  friend bool operator<(const Umbrella& a, const Umbrella& b) {
    return a.open != b.open ? b.open : a.degrees < b.degrees;
  }

  /// Vertices: the middle one, then those of the faces counterclockwise, from the first face's
  /// first edge on.
  [[nodiscard]] Index vertex_count() const;
};

/// The limit surface at its middle: three rows over its vertices. Nothing as LimitReader::read.
[[nodiscard]] Result<std::optional<RowTable>> read_umbrella(LimitReader& reader, int level,
                                                            const Umbrella& umbrella);

/// Rows for isolated vertices, which stay and have no tangents.
void add_isolated_limits(const std::vector<Index>& vertices, std::vector<RowPlan>& rows);

/// Rows for some vertices, named as the caller likes: umbrella_of(vertex) and number(vertex, out),
/// which writes the numbers of its umbrella's vertices, of which the first is the target. Returns
/// false where one has no rows.
template <class Vertex, class UmbrellaOf, class Number>
[[nodiscard]] Result<bool> add_umbrellas(const std::vector<Vertex>& vertices, int level,
                                         LimitReader& reader, UmbrellaOf umbrella_of, Number number,
                                         std::vector<RowPlan>& rows) {
  constexpr std::ptrdiff_t kVertexGrain = 1024;
  std::map<Umbrella, std::vector<Vertex>> groups;
  for (const Vertex& vertex : vertices) groups[umbrella_of(vertex)].push_back(vertex);
  for (const auto& [umbrella, members] : groups) {
    const std::vector<Vertex>& group = members;  // em++ captures no part of a binding
    Result<std::optional<RowTable>> table = read_umbrella(reader, level, umbrella);
    if (!table) return table.error();
    if (!*table) return false;
    const auto each = static_cast<std::size_t>(umbrella.vertex_count());
    RowPlan plan{std::move(**table), HugeArray<Index>(group.size() * each),
                 HugeArray<Index>(group.size()), false};
    parallel_for(
        std::size_t{0}, group.size(),
        [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            Index* sources = plan.sources.data() + i * each;
            number(group[i], sources);
            plan.targets[i] = *sources;
          }
        },
        kVertexGrain);
    rows.push_back(std::move(plan));
  }
  return true;
}

}  // namespace limn::fast
