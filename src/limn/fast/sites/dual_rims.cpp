#include "limn/fast/sites/dual_rims.h"

#include <algorithm>
#include <cassert>
#include <set>

#include <fmt/core.h>

#include "limn/fast/layout/dual_walk.h"
#include "limn/fast/sites/dependence.h"
#include "limn/refine/refine_values.h"

namespace limn::fast {
namespace {

using Form = LinearForm<double>;

Births corner_births(const Mesh& mesh) {
  Births births;
  births.from_corners = mesh.halfedge_count();
  return births;
}

Mesh build(Polygons polygons, Index vertices) {
  polygons.positions.resize(static_cast<std::size_t>(vertices));
  Result<Mesh> mesh = Mesh::build(polygons);
  assert(mesh.ok());
  return *std::move(mesh);
}

void add_quad(Polygons& polygons, std::array<Index, 4> corners) {
  polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
  polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
}

/// A face that touches the boundary so, and regular surroundings: a quad at each side and vertex.
Mesh mesh_of(const RimPattern& pattern) {
  const auto n = static_cast<Index>(pattern.size());
  Polygons polygons;
  for (Index i = 0; i < n; ++i) polygons.corners.push_back(i);
  polygons.face_begin.push_back(n);
  // the vertices beyond side i lie at n + 2i (next to vertex i) and n + 2i + 1
  Index vertices = n;
  std::vector<Index> beyond(pattern.size(), kNone);
  for (Index i = 0; i < n; ++i) {
    if ((pattern[static_cast<std::size_t>(i)] & 1) == 0) continue;
    beyond[static_cast<std::size_t>(i)] = vertices;
    add_quad(polygons, {(i + 1) % n, i, vertices, vertices + 1});
    vertices += 2;
  }
  for (Index i = 0; i < n; ++i) {
    if ((pattern[static_cast<std::size_t>(i)] & 2) == 0) continue;
    const Index before = beyond[static_cast<std::size_t>((i + n - 1) % n)];
    add_quad(polygons, {i, before + 1, vertices++, beyond[static_cast<std::size_t>(i)]});
  }
  return build(std::move(polygons), vertices);
}

RimPattern pattern_of(const DualCorners& corners, Index f) {
  const Mesh& mesh = corners.control();
  RimPattern pattern;
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
    pattern.push_back((corners.has_y_arm(h) ? 1 : 0) + (corners.is_whole(h) ? 2 : 0));
  return pattern;
}

bool touches_boundary(const RimPattern& pattern) {
  return std::any_of(pattern.begin(), pattern.end(), [](Index side) { return (side & 2) == 0; });
}

/// Turns the pattern to the least of its turns; returns which side comes first.
Index turn_to_least(RimPattern& pattern) {
  RimPattern least = pattern, turned = pattern;
  Index first = 0;
  for (Index i = 1; i < std::ssize(pattern); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (turned < least) {
      least = turned;
      first = i;
    }
  }
  pattern = std::move(least);
  return first;
}

class RimReader {
 public:
  RimReader(const Scheme& scheme, Index reach)
      : scheme_(scheme), rules_(scheme, Boundary::left_out) {
    rims_.reach = reach;
  }

  Result<DualRims> read(const Mesh& control) {
    const Index deep = 2 * rims_.reach;
    if (Status status = read_strip(2 * deep + 2, deep, rims_.strip); !status) return status.error();
    if (Status status = read_strip(2, 2, rims_.narrow); !status) return status.error();
    const DualCorners corners(control);
    for (Index f = 0; f < control.face_count(); ++f) {
      RimPattern pattern = pattern_of(corners, f);
      if (!touches_boundary(pattern)) continue;
      turn_to_least(pattern);
      if (rims_.zones.contains(pattern)) continue;
      if (Status status = read_zone(pattern); !status) return status.error();
    }
    return std::move(rims_);
  }

 private:
  Result<std::vector<Form>> forms(const Mesh& mesh, const std::vector<Index>& born) {
    const Births births = corner_births(mesh);
    if (Status status = rules_.prepare(mesh, births); !status) return status.error();
    return refine_values_at(scheme_, mesh, births, rules_, unit_forms<double>(mesh.vertex_count()),
                            born);
  }

  /// Of a grid so many points wide, whose side is its last row.
  Status read_strip(Index width, Index depths, std::vector<Stencil>& strip) {
    const Index middle = 2 * rims_.reach + 2, length = 2 * middle + 1;
    Polygons polygons;
    for (Index v = 0; v + 1 < width; ++v)
      for (Index t = 0; t + 1 < length; ++t) {
        const Index corner = v * length + t;
        add_quad(polygons, {corner, corner + 1, corner + length + 1, corner + length});
      }
    const Mesh mesh = build(std::move(polygons), width * length);
    std::vector<Index> born;
    for (Index depth = 0; depth < depths; ++depth)
      for (const Index t : {0, 1}) {
        const Index row = width - 1 + anchor_row(depth);
        // the face towards the point, in which the anchor is one of the four corners
        const bool low = depth % 2 == 0, left = t == 0;
        const Index face = (low ? row - 1 : row) * (length - 1) + (left ? middle - 1 : middle);
        born.push_back(4 * face + (low ? (left ? 2 : 3) : (left ? 1 : 0)));
      }
    const Result<std::vector<Form>> read = forms(mesh, born);
    if (!read) return read.error();
    for (std::size_t i = 0; i < read->size(); ++i) {
      const Index row = width - 1 + anchor_row(static_cast<Index>(i) / 2);
      Stencil& stencil = strip.emplace_back();
      for (const auto& [vertex, weight] : (*read)[i].terms)
        if (weight != 0)
          stencil.push_back({{vertex % length - middle, vertex / length - row}, weight});
      std::sort(stencil.begin(), stencil.end(),
                [](const Tap& p, const Tap& q) { return p.place < q.place; });
    }
    return Done{};
  }

  static Index anchor_row(Index depth) { return -((depth + 1) / 2); }

  Status read_zone(const RimPattern& pattern) {
    const Mesh local = mesh_of(pattern);
    const DualCorners corners(local);
    Index n = 1;
    Mesh coarse_mesh = scheme_.split->apply(local, 0).mesh;
    for (; n < 2 * rims_.reach; n *= 2) coarse_mesh = scheme_.split->apply(coarse_mesh, 0).mesh;
    const Mesh fine_mesh = scheme_.split->apply(coarse_mesh, 0).mesh;
    const DualLayout coarse(corners, n), fine(corners, 2 * n);
    const std::vector<Index> old = dual_order(coarse, coarse_mesh);
    const std::vector<Index> fresh = dual_order(fine, fine_mesh);
    std::map<Index, SectorPoint> places;  // of the old vertices in the face's patches
    DualZone zone;
    std::vector<Index> born;
    for (Index s = 0; s < std::ssize(pattern); ++s) {
      each_point(corners, s, n, [&](Index x, Index y) {
        places[old[static_cast<std::size_t>(coarse.point(s, x, y))]] = {s, x, y};
      });
      each_point(corners, s, 2 * rims_.reach, [&](Index x, Index y) {
        zone.targets.push_back({s, x, y});
        born.push_back(fresh[static_cast<std::size_t>(fine.point(s, x, y))]);
      });
    }
    for (const Index h : born)
      for (const Index v :
           dependence(scheme_, coarse_mesh, corner_births(coarse_mesh), {Birth::corner, h}))
        if (!places.contains(v))
          return Error{fmt::format("the rules of scheme '{}' look too far", scheme_.name)};
    const Result<std::vector<Form>> read = forms(coarse_mesh, born);
    if (!read) return read.error();
    fill_zone(zone, *read, [&](Index v) { return places.at(v); });
    rims_.zones.emplace(pattern, std::move(zone));
    return Done{};
  }

  /// The points x, y < size of a patch that are there.
  template <class Body>
  static void each_point(const DualCorners& corners, Index h, Index size, Body body) {
    for (Index y = 0; y < size; ++y)
      for (Index x = 0; x < size; ++x)
        if (corners.has_point(h, x, y)) body(x, y);
  }

  const Scheme& scheme_;
  RuleTables<double> rules_;
  DualRims rims_;
};

/// `lines`: half-edges whose origins, and maybe targets, lie on the boundary.
void add_strips(const std::vector<Stencil>& strip, const std::vector<Index>& lines, Index from,
                const DualLayout& coarse, const DualLayout& fine, std::vector<RowPlan>& rows) {
  const Index to = 2 * fine.n() - from;
  for (Index i = 0; i < std::ssize(strip) && !lines.empty(); ++i) {
    const Stencil& stencil = strip[static_cast<std::size_t>(i)];
    const Index depth = i / 2;
    std::vector<Index> sources, targets;
    for (const Index h : lines)
      for (Index t = from + (from + i) % 2; t < to; t += 2) {
        for (const Tap& tap : stencil)
          sources.push_back(
              coarse.line_point(h, t / 2 + tap.place.a, tap.place.b - (depth + 1) / 2));
        targets.push_back(fine.line_point(h, t, -depth));
      }
    rows.push_back({to_rows(stencil), HugeArray<Index>(sources), HugeArray<Index>(targets), false});
  }
}

}  // namespace

Result<DualRims> read_dual_rims(const Scheme& scheme, const Mesh& control, Index reach) {
  return RimReader(scheme, reach).read(control);
}

void add_dual_lines(const std::vector<Stencil>& strip, const std::vector<Stencil>& narrow,
                    Index from, const DualLayout& coarse, const DualLayout& fine,
                    std::vector<RowPlan>& rows) {
  const DualCorners& corners = coarse.corners();
  const Mesh& mesh = corners.control();
  std::vector<Index> wide_lines, narrow_lines;
  for (const Index h : corners.y_arms()) {
    if (corners.is_whole(mesh.next(h)))
      wide_lines.push_back(h);
    else if (h < mesh.twin(h))
      narrow_lines.push_back(h);
  }
  add_strips(strip, wide_lines, from, coarse, fine, rows);
  add_strips(narrow, narrow_lines, from, coarse, fine, rows);
}

void add_dual_rims(const DualRims& rims, const DualLayout& coarse, const DualLayout& fine,
                   std::vector<RowPlan>& rows) {
  assert(coarse.n() >= 2 * rims.reach);
  add_dual_lines(rims.strip, rims.narrow, 2 * rims.reach, coarse, fine, rows);
  const DualCorners& corners = coarse.corners();
  const Mesh& mesh = corners.control();
  struct Places {
    std::vector<Index> sources, targets;
  };
  std::map<RimPattern, Places> groups;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    RimPattern pattern = pattern_of(corners, f);
    if (!touches_boundary(pattern)) continue;
    const Index first = turn_to_least(pattern), degree = mesh.degree(f);
    std::vector<Index> sectors(pattern.size());
    for (Index s = 0; s < degree; ++s)
      sectors[static_cast<std::size_t>(s)] = mesh.face_begin(f) + (first + s) % degree;
    const DualZone& zone = rims.zones.at(pattern);
    auto& [sources, targets] = groups[pattern];
    sources.resize(sources.size() + zone.sources.size());
    targets.resize(targets.size() + zone.targets.size());
    number_zone(coarse, sectors, false, zone.sources,
                sources.data() + sources.size() - zone.sources.size());
    number_zone(fine, sectors, false, zone.targets,
                targets.data() + targets.size() - zone.targets.size());
  }
  for (const auto& [pattern, places] : groups)
    rows.push_back({rims.zones.at(pattern).table, HugeArray<Index>(places.sources),
                    HugeArray<Index>(places.targets), false});
}

}  // namespace limn::fast
