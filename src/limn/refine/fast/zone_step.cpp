#include "limn/refine/fast/zone_step.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <iterator>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

constexpr Index kVertexGrain = 1024;
constexpr Index kSideGrain = 64;

/// Four numbers at once: a point and what comes after it.
template <class Real>
struct Quad {
  typedef Real Type __attribute__((vector_size(4 * sizeof(Real))));
};

/// A vertex that no face uses keeps its place.
const ZoneTable& identity_table() {
  static const ZoneTable table{0, {SectorPoint{}}, {SectorPoint{}}, {0, 1}, {{0, 1.0}}};
  return table;
}

/// The numbers of the points round each of a group's vertices.
std::vector<Index> number_points(const ZoneGroup& group, const std::vector<Index>& sectors,
                                 const TriangleLayout& layout,
                                 const std::vector<SectorPoint>& points) {
  std::vector<Index> numbers(group.vertices.size() * points.size());
  parallel_for(
      Index{0}, static_cast<Index>(group.vertices.size()),
      [&](Index first, Index last) {
        Index* number = numbers.data() + first * std::ssize(points);
        for (Index i = first; i < last; ++i) {
          const Index* out = sectors.data() + static_cast<std::ptrdiff_t>(i) * group.table->sectors;
          for (const SectorPoint& p : points)
            *number++ = p.x + p.y == 0 ? group.vertices[static_cast<std::size_t>(i)]
                                       : layout.point(out[p.sector], p.x, p.y);
        }
      },
      kVertexGrain);
  return numbers;
}

/// Sums the rows of one table.
template <class Real>
class ZoneWorker {
 public:
  using Four = typename Quad<Real>::Type;

  ZoneWorker(const ZoneTable& table, const std::vector<Real>& weights)
      : table_(table), weights_(weights), points_(table.sources.size()) {}

  void run(const Index* sources, const Index* targets, const Real* in, Real* out) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      std::memcpy(&points_[i], in + 3 * static_cast<std::ptrdiff_t>(sources[i]), sizeof(Four));
    for (std::size_t row = 0; row < table_.targets.size(); ++row) {
      Four sum{};
      for (int t = table_.row_begin[row]; t < table_.row_begin[row + 1]; ++t)
        sum += weights_[t] * points_[table_.terms[t].source];
      Real* to = out + 3 * static_cast<std::ptrdiff_t>(targets[row]);
      for (int i = 0; i < 3; ++i) to[i] = sum[i];
    }
  }

 private:
  const ZoneTable& table_;
  const std::vector<Real>& weights_;
  std::vector<Four> points_;
};

/// A boundary side's points.
template <class Real>
class StripWorker {
 public:
  StripWorker(const StencilTables& tables, const TriangleLayout& coarse, const TriangleLayout& fine,
              const Real* in, Real* out)
      : tables_(tables), coarse_(coarse), fine_(fine), in_(in), out_(out) {}

  void run(Index h) const {
    const Mesh& mesh = fine_.control();
    const Index left = zone_of(mesh.origin(h)), right = zone_of(mesh.target(h));
    const Index n = fine_.n();
    for (Index y = 0; y <= tables_.reach.strip_depth; ++y)
      for (Index x = std::max(left - y, 0) + 1; x + y < n && n - x > right; ++x) sum(h, x, y);
  }

 private:
  [[nodiscard]] Index zone_of(Index v) const {
    const bool corner = fine_.control().valence(v) == 2;  // one face
    return corner ? tables_.reach.corner_zone : tables_.reach.fan_zone;
  }

  void sum(Index h, Index x, Index y) const {
    std::array<Real, 3> value{};
    for (const auto& [place, weight] : tables_.strips[static_cast<std::size_t>(2 * y + (x & 1))]) {
      const Index source = coarse_.point_beyond(h, x / 2 + place.a, y / 2 + place.b);
      assert(source != kNone);
      const Real* from = in_ + 3 * static_cast<std::ptrdiff_t>(source);
      for (int i = 0; i < 3; ++i) value[i] += static_cast<Real>(weight) * from[i];
    }
    Real* to = out_ + 3 * static_cast<std::ptrdiff_t>(fine_.point(h, x, y));
    for (int i = 0; i < 3; ++i) to[i] = value[i];
  }

  const StencilTables& tables_;
  const TriangleLayout& coarse_;
  const TriangleLayout& fine_;
  const Real* in_;
  Real* out_;
};

}  // namespace

std::vector<ZoneGroup> group_vertices(const StencilTables& tables, const Mesh& control) {
  std::map<const ZoneTable*, std::vector<Index>> members;
  for (Index v = 0; v < control.vertex_count(); ++v) {
    const bool open = control.is_boundary_vertex(v);
    const ZoneTable& table = control.is_isolated(v) ? identity_table()
                             : open                 ? tables.fans.at(control.valence(v) - 1)
                                                    : tables.stars.at(control.valence(v));
    members[&table].push_back(v);
  }
  std::vector<ZoneGroup> groups;
  groups.reserve(members.size());
  for (auto& [table, vertices] : members) groups.push_back({table, std::move(vertices)});
  // not in the order of addresses, which differs from run to run
  std::sort(groups.begin(), groups.end(), [](const ZoneGroup& a, const ZoneGroup& b) {
    return a.vertices.front() < b.vertices.front();
  });
  return groups;
}

std::vector<Index> sectors_of(const ZoneGroup& group, const Mesh& control) {
  const Index sectors = group.table->sectors;
  std::vector<Index> list(group.vertices.size() * static_cast<std::size_t>(sectors));
  parallel_for(
      Index{0}, static_cast<Index>(group.vertices.size()),
      [&](Index first, Index last) {
        Index* out = list.data() + static_cast<std::ptrdiff_t>(first) * sectors;
        for (Index i = first; i < last; ++i) {
          Index h = control.halfedge_of_vertex(group.vertices[static_cast<std::size_t>(i)]);
          for (Index s = 0; s < sectors; ++s, h = control.rotate(h)) *out++ = h;
        }
      },
      kVertexGrain);
  return list;
}

ZoneNumbers number_zones(const ZoneGroup& group, const std::vector<Index>& sectors,
                         const TriangleLayout& coarse, const TriangleLayout& fine) {
  return {number_points(group, sectors, coarse, group.table->sources),
          number_points(group, sectors, fine, group.table->targets)};
}

template <class Real>
void refine_zones(const std::vector<ZoneGroup>& groups, const std::vector<ZoneNumbers>& numbers,
                  bool overlap, const Real* in, Real* out) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const ZoneTable& table = *groups[g].table;
    std::vector<Real> weights;
    weights.reserve(table.terms.size());
    for (const ZoneTable::Term& term : table.terms)
      weights.push_back(static_cast<Real>(term.weight));
    const Index* sources = numbers[g].sources.data();
    const Index* targets = numbers[g].targets.data();
    const auto count = static_cast<Index>(groups[g].vertices.size());
    parallel_for(
        Index{0}, count,
        [&](Index first, Index last) {
          ZoneWorker<Real> worker(table, weights);
          for (std::ptrdiff_t i = first; i < last; ++i)
            worker.run(sources + i * std::ssize(table.sources),
                       targets + i * std::ssize(table.targets), in, out);
        },
        overlap ? count : kVertexGrain);
  }
}

template <class Real>
void refine_strips(const StencilTables& tables, const std::vector<Index>& sides,
                   const TriangleLayout& coarse, const TriangleLayout& fine, const Real* in,
                   Real* out) {
  const StripWorker<Real> worker(tables, coarse, fine, in, out);
  parallel_for(
      Index{0}, static_cast<Index>(sides.size()),
      [&](Index first, Index last) {
        for (Index i = first; i < last; ++i) worker.run(sides[i]);
      },
      kSideGrain);
}

template void refine_zones<float>(const std::vector<ZoneGroup>&, const std::vector<ZoneNumbers>&,
                                  bool, const float*, float*);
template void refine_zones<double>(const std::vector<ZoneGroup>&, const std::vector<ZoneNumbers>&,
                                   bool, const double*, double*);
template void refine_strips<float>(const StencilTables&, const std::vector<Index>&,
                                   const TriangleLayout&, const TriangleLayout&, const float*,
                                   float*);
template void refine_strips<double>(const StencilTables&, const std::vector<Index>&,
                                    const TriangleLayout&, const TriangleLayout&, const double*,
                                    double*);

}  // namespace limn::fast
