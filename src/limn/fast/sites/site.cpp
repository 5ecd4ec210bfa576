#include "limn/fast/sites/site.h"

#include <algorithm>
#include <cassert>

#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

/// A place in the coordinates of a sector, in the one of it and the two beside it that holds it.
SectorPoint in_sector(Lattice lattice, Index sector, Offset place) {
  const auto [a, b] = place;
  const bool triangle = lattice == Lattice::triangle;
  if (b < 0) return {sector - 1, -b, triangle ? a + b : a};
  if (a < 0) return {sector + 1, triangle ? a + b : b, -a};
  return {sector, a, b};
}

/// The weighted sum of places that belong together, in whatever sectors near one another they are.
class PlaceSum {
 public:
  /// `home`: the sector in whose coordinates the sum is taken. Of two sectors the other one is on
  /// both sides: `before` says that it is met over the spoke at which `home` begins.
  PlaceSum(const StarShape& shape, Index home, bool before)
      : shape_(shape), home_(home), before_(before) {}

  void add(Index weight, const SectorPoint& p) {
    const Offset place = at_home(p);
    sum_ = {sum_.a + weight * place.a, sum_.b + weight * place.b};
  }

  /// A part of the sum, in the sector in which it lies.
  [[nodiscard]] SectorPoint part(Index divisor) const {
    assert(sum_.a % divisor == 0 && sum_.b % divisor == 0);
    return in_sector(shape_.lattice, home_, {sum_.a / divisor, sum_.b / divisor});
  }

 private:
  [[nodiscard]] Offset at_home(const SectorPoint& p) const {
    if (p.x == 0 && p.y == 0) return {0, 0};
    const bool triangle = shape_.lattice == Lattice::triangle;
    Index turn = p.sector - home_;
    if (!shape_.open && (turn > 1 || turn < -1))
      turn += turn > 0 ? -shape_.sectors : shape_.sectors;
    // a spoke of the other sector ends this one
    if (!shape_.open && shape_.sectors == 2 && turn != 0) turn = before_ && p.y > 0 ? -1 : 1;
    assert(-1 <= turn && turn <= 1);
    if (turn == 0) return {p.x, p.y};
    if (turn > 0) return {-p.y, triangle ? p.x + p.y : p.x};
    return {triangle ? p.x + p.y : p.y, -p.x};
  }

  const StarShape& shape_;
  Index home_;
  bool before_;
  Offset sum_;
};

/// The old vertices that a birth lies between, with weights.
using Parents = std::vector<std::pair<Index, Index>>;

/// `dual`: a corner's point lies half the way to the middle of its quad; else at thirds.
Parents parents(const Mesh& mesh, const Birth& birth, bool dual) {
  const Index h = birth.halfedge;
  switch (birth.kind) {
    case Birth::vertex: return {{1, mesh.origin(h)}};
    case Birth::edge: return {{1, mesh.origin(h)}, {1, mesh.target(h)}};
    case Birth::edge_end:
      return {{birth.at_target ? 1 : 2, mesh.origin(h)}, {birth.at_target ? 2 : 1, mesh.target(h)}};
    case Birth::corner:
      if (!dual)  // all corners: two opposite ones may lie on spokes of different sectors
        return {{4, mesh.origin(h)},
                {2, mesh.target(h)},
                {2, mesh.origin(mesh.prev(h))},
                {1, mesh.target(mesh.next(h))}};
      return {{3, mesh.origin(h)}, {1, mesh.target(mesh.next(h))}};
    default: break;
  }
  Parents corners;
  const Index f = mesh.face(h);
  for (Index k = mesh.face_begin(f); k < mesh.face_begin(f + 1); ++k)
    corners.emplace_back(1, mesh.origin(k));
  return corners;
}

/// A face star without the points that a pattern has not.
Mesh receding_star(const StarShape& shape, Index rings, const RimPattern& pattern) {
  const Mesh whole = mesh::face_star(shape.sectors, rings);
  const auto there = [&](Index v) { return has_point(pattern, sector_point(shape, v)); };
  std::vector<Index> number;
  Polygons polygons;
  for (Index v = 0; v < whole.vertex_count(); ++v) {
    number.push_back(polygons.vertex_count());
    if (there(v)) polygons.positions.emplace_back();
  }
  for (Index f = 0; f < whole.face_count(); ++f) {
    std::vector<Index> corners;
    for (Index h = whole.face_begin(f); h < whole.face_begin(f + 1); ++h)
      if (there(whole.origin(h)))
        corners.push_back(number[static_cast<std::size_t>(whole.origin(h))]);
    if (std::ssize(corners) < whole.degree(f)) continue;
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  Result<Mesh> mesh = Mesh::build(polygons);
  assert(mesh.ok());
  return *std::move(mesh);
}

}  // namespace

bool has_point(const RimPattern& pattern, const SectorPoint& point) {
  if (pattern.empty() || (point.x == 0 && point.y == 0)) return true;
  const auto sector = static_cast<std::size_t>(point.sector);
  if ((pattern[sector] & 2) != 0) return true;
  const std::size_t before = (sector == 0 ? pattern.size() : sector) - 1;
  return (point.y == 0 && (pattern[before] & 1) != 0) ||
         (point.x == 0 && (pattern[sector] & 1) != 0);
}

Site::Site(const Split& split, const GridCycle& cycle, const StarShape& shape, Index rings,
           const RimPattern& pattern)
    : shape_(shape), extent_(cycle.edge() * rings), first_(LatticeStep(cycle, 0).first()) {
  const Index slots = shape.sectors * (extent_ + 1) * (extent_ + 1), edge = cycle.edge();
  shape_.offset = cycle.offset;
  Step first;
  first.mesh = shape_.offset ? receding_star(shape_, rings, pattern)
               : shape.open  ? mesh::fan(shape.lattice, shape.sectors, rings)
                             : mesh::star(shape.lattice, shape.sectors, rings);
  controls_.assign(at(slots), kNone);
  for (Index v = 0; std::ssize(first.places) < first.mesh.vertex_count(); ++v) {
    const SectorPoint point = sector_point(shape_, v);
    if (!has_point(pattern, point)) continue;
    controls_[slot({point.sector, edge * point.x + first_, edge * point.y + first_})] =
        static_cast<Index>(first.places.size());
    first.places.push_back({point.sector, edge * point.x + first_, edge * point.y + first_});
  }
  steps_.push_back(std::move(first));
  for (int i = 0; i < cycle.steps; ++i) {
    Step& step = steps_.back();
    SplitResult made;
    if (cycle.steps == 1)  // nobody looks at the mesh that the last step makes
      made.births = first_births(split, step.mesh);
    else
      made = split.apply(step.mesh, i);
    step.births = std::move(made.births);
    step.vertices.assign(at(slots), kNone);
    place_new(step);
    if (i + 1 < cycle.steps) steps_.push_back({std::move(made.mesh), {}, step.made, {}, {}});
  }
}

void Site::place_new(Step& step) const {
  const Births& births = step.births;
  const Index count =
      births.from_vertices + births.from_edges + births.from_faces + births.from_corners;
  step.made.reserve(at(count));
  for (Index v = 0; v < count; ++v) {
    const Birth birth = birth_of(step.mesh, births, v);
    const Parents from = parents(step.mesh, birth, shape_.offset);
    if (shape_.offset && step.mesh.face(birth.halfedge) == 0) {
      // the middle of the face is the middle of the site
      const SectorPoint& p = step.places[at(from.front().second)];
      step.made.push_back({p.sector, p.x / 2, p.y / 2});
    } else {
      step.made.push_back(between(from, step.places));
    }
    step.vertices[slot(step.made.back())] = v;
  }
}

SectorPoint Site::between(const std::vector<std::pair<Index, Index>>& parents,
                          const std::vector<SectorPoint>& places) const {
  // one that is within a sector says in which all of them are
  Index home = kNone, divisor = 0;
  for (const auto& [weight, old] : parents) {
    const SectorPoint& p = places[at(old)];
    const bool within = p.x > 0 && p.y > 0;
    if (within || (home == kNone && p.x + p.y > 0)) home = p.sector;
    divisor += weight;
  }
  if (home == kNone) home = 0;
  const bool before = std::any_of(parents.begin(), parents.end(), [&](const auto& parent) {
    const SectorPoint& p = places[at(parent.second)];
    return p.sector == home && p.x > 0 && p.y == 0;
  });
  PlaceSum sum(shape_, home, before);
  for (const auto& [weight, old] : parents) sum.add(weight, places[at(old)]);
  return normal(sum.part(divisor));
}

std::optional<SectorPoint> Site::beside(Index sector, Offset place) const {
  const SectorPoint point = in_sector(shape_.lattice, sector, place);
  if (point.x < 0 || point.y < 0 || ring(point) > extent_) return std::nullopt;
  if (shape_.open && (point.sector < 0 || point.sector >= shape_.sectors)) return std::nullopt;
  return normal(point);
}

/// The same place in the sector that owns it: a spoke belongs to the sector that begins there.
SectorPoint Site::normal(SectorPoint place) const {
  if (place.x == 0 && place.y == 0) return {};
  if (place.x == 0 && !(shape_.open && place.sector == shape_.sectors - 1))
    place = {place.sector + 1, place.y, 0};
  if (!shape_.open) place.sector = (place.sector + shape_.sectors) % shape_.sectors;
  return place;
}

std::size_t Site::slot(const SectorPoint& place) const {
  const SectorPoint p = normal(place);
  assert(p.sector >= 0 && p.sector < shape_.sectors && p.x >= 0 && p.y >= 0);
  assert(p.x <= extent_ && p.y <= extent_);
  return at((p.sector * (extent_ + 1) + p.x) * (extent_ + 1) + p.y);
}

Index Site::new_vertex(int step, const SectorPoint& place) const {
  const Index v = steps_[at(step)].vertices[slot(place)];
  assert(v != kNone);
  return v;
}

Index Site::old_vertex(int step, const SectorPoint& place) const {
  const Index v = step == 0 ? controls_[slot(place)] : steps_[at(step) - 1].vertices[slot(place)];
  assert(v != kNone);
  return v;
}

}  // namespace limn::fast
