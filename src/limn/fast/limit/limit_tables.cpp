#include "limn/fast/limit/limit_tables.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

using Form = LinearForm<double>;
using Place = std::function<Index(Offset)>;  ///< the vertex of a mesh there, or kNone

constexpr Index kMargin = 4;      // rings round what is read, so that the rim is not felt
constexpr Index kMostRings = 24;  // of a star or fan

/// A vertex's sums as those of another one like it; nothing where the mesh has not all places.
std::optional<LimitSums> moved(const LimitStencils& stencils, const Place& vertex) {
  LimitSums forms(stencils.size());
  for (std::size_t i = 0; i < forms.size(); ++i) {
    std::map<Index, double> terms;  // around few sectors a place may be met from both sides
    for (const Tap& tap : stencils[i]) {
      const Index v = vertex(tap.place);
      if (v == kNone) return std::nullopt;
      terms[v] += tap.weight;
    }
    forms[i].terms.assign(terms.begin(), terms.end());
  }
  return forms;
}

/// A star or fan of so many rings.
struct Disc {
  StarShape shape;
  Index rings = 1;

  [[nodiscard]] Index size(Index ring) const {  // vertices of rings 0 … ring
    if (ring == 0) return 1;
    return shape.open ? fan_size(shape.lattice, shape.sectors, ring)
                      : star_size(shape.lattice, shape.sectors, ring);
  }
  [[nodiscard]] Mesh mesh() const {
    return shape.open ? fan(shape.lattice, shape.sectors, rings)
                      : star(shape.lattice, shape.sectors, rings);
  }
  [[nodiscard]] Index ring(Index v) const {
    const SectorPoint point = sector_point(shape, v);
    return ring_of(shape.lattice, point.x, point.y);
  }

  /// The vertex at a place in the coordinates of a sector, in it or in one of the two beside it;
  /// kNone where there is none.
  [[nodiscard]] Index vertex(Index sector, Offset place) const {
    const auto [a, b] = place;
    const Index sum = shape.lattice == Lattice::triangle ? a + b : std::max(a, b);
    if (sum < 0) return kNone;
    const Index side = shape.lattice == Lattice::triangle ? sum : a < 0 ? b : a;
    if (a < 0) return vertex(SectorPoint{sector + 1, side, -a});
    if (b < 0) return vertex(SectorPoint{sector - 1, -b, side});
    return vertex(SectorPoint{sector, a, b});
  }

 private:
  [[nodiscard]] Index vertex(SectorPoint point) const {
    if (ring_of(shape.lattice, point.x, point.y) > rings) return kNone;
    if (point.sector < 0 || point.sector >= shape.sectors) {
      if (shape.open) return kNone;
      point.sector = (point.sector + shape.sectors) % shape.sectors;
    }
    return vertex_at(shape, point);
  }
};

/// The sums at a vertex of the disc that makes the plane, or half of it.
LimitStencils to_stencils(const LimitSums& forms, const Disc& disc, Index v) {
  const Lattice lattice = disc.shape.lattice;
  const Offset at = on_plane(lattice, sector_point(disc.shape, v));
  LimitStencils stencils;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    std::vector<Offset> places;
    std::vector<double> weights;
    for (const auto& [vertex, weight] : forms[i].terms) {
      const Offset place = on_plane(lattice, sector_point(disc.shape, vertex));
      places.push_back({place.a - at.a, place.b - at.b});
      weights.push_back(weight);
    }
    stencils[i] = rounded_stencil(places, std::move(weights));
  }
  return stencils;
}

/// How far a place lies beyond the sides of any patch that holds the origin.
Index rows_beyond(Lattice lattice, Offset place) {
  const auto [a, b] = place;
  return std::max({-a, -b, lattice == Lattice::triangle ? a + b : std::max(a, b)});
}

class TableReader {
 public:
  TableReader(LimitReader& reader, Lattice lattice, int level)
      : reader_(reader), lattice_(lattice), level_(level) {}

  /// Whether there are tables.
  Result<bool> read(const std::vector<ZoneGroup>& groups) {
    const bool open = std::any_of(groups.begin(), groups.end(),
                                  [](const auto& group) { return group.kind.open; });
    const Result<Index> inner = reader_.regular_rings(false);
    if (!inner) return inner.error();
    inner_ = *inner;
    if (open) {
      const Result<Index> outer = reader_.regular_rings(true);
      if (!outer) return outer.error();
      outer_ = *outer;
    }
    Result<bool> found = read_interior();
    if (found && *found && open) found = read_strips();
    for (const ZoneGroup& group : groups)
      if (found && *found)
        found = group.kind.open ? read_fan(group.kind.faces) : read_star(group.kind.faces);
    return found;
  }

  [[nodiscard]] LimitTables tables() && {
    find_grid();
    return std::move(tables_);
  }

 private:
  using Forms = std::vector<LimitSums>;

  /// Whether a vertex's sums are found on its own ring, whatever follows.
  [[nodiscard]] bool near() const { return inner_ <= 1 && outer_ <= 1; }
  [[nodiscard]] Index widest() const { return std::max(inner_, outer_); }

  /// At vertices of a disc, which gets as many rings as it takes until none takes from the rim.
  Result<std::optional<Forms>> read(Disc& disc, const std::vector<Index>& vertices) {
    using Found = std::optional<Forms>;
    for (; disc.rings <= kMostRings; disc.rings += 2) {
      auto read = reader_.read(disc.mesh(), level_, !disc.shape.open, vertices);
      if (!read) return read.error();
      Forms all;
      bool inside = true;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        LimitSums& sums = all.emplace_back();
        if (std::optional<LimitForms>& forms = (*read)[i]) {
          sums.assign(forms->begin(), forms->end());
        } else if (vertices[i] == 0) {
          Result<LimitSums> chain = read_chain(disc);
          if (!chain) return chain.error();
          sums = std::move(*chain);
        } else {
          return Found();
        }
        for (Form& form : sums) {
          drop_rounding(form);
          inside =
              inside && (form.terms.empty() || form.terms.back().first < disc.size(disc.rings - 1));
        }
      }
      if (inside) return Found(std::move(all));
    }
    return Found();
  }

  /// Of a disc's centre; its rings are kept.
  Result<LimitSums> read_chain(const Disc& disc) {
    Result<LimitChain> chain = reader_.read_chain(disc.mesh(), level_, !disc.shape.open, 0);
    if (!chain) return chain.error();
    chain_rings_ = std::max(chain_rings_, chain->rings);
    return std::move(chain->forms);
  }

  Result<bool> read_interior() {
    Disc disc{{lattice_, plane_sectors(lattice_), false}, inner_ + 1};
    const Result<std::optional<Forms>> forms = read(disc, {0});
    if (!forms) return forms.error();
    if (!*forms || (*forms)->front().size() != 3) return false;
    tables_.interior = to_stencils((*forms)->front(), disc, 0);
    for (const Stencil& stencil : tables_.interior)
      for (const Tap& tap : stencil)
        tables_.halo = std::max(tables_.halo, rows_beyond(lattice_, tap.place));
    return true;
  }

  Result<bool> read_strips() {
    Disc disc{{lattice_, half_plane_sectors(lattice_), true}, widest() + 1};
    std::vector<Index> vertices;  // from row inner_ on, a vertex does not see the boundary
    for (Index y = 0; y < std::max(Index{1}, inner_); ++y)
      vertices.push_back(vertex_at(disc.shape, {0, 0, y}));
    if (!near()) disc.rings += inner_ + kMargin;
    const Result<std::optional<Forms>> forms = read(disc, vertices);
    if (!forms) return forms.error();
    if (!*forms || (*forms)->front().size() != 3) return false;
    std::map<Offset, Index> vertex;
    for (Index v = 0; v < disc.size(disc.rings); ++v)
      vertex[on_plane(lattice_, sector_point(disc.shape, v))] = v;
    Index rows = 1;
    for (Index y = 0; y < std::ssize(vertices); ++y) {
      const LimitSums& found = (**forms)[static_cast<std::size_t>(y)];
      const auto expected = moved(tables_.interior, [&](Offset place) {
        const auto at = vertex.find({place.a, place.b + y});
        return at == vertex.end() ? kNone : at->second;
      });
      if (!expected || !same_limit(*expected, found)) rows = y + 1;
      tables_.strips.push_back(to_stencils(found, disc, vertices[static_cast<std::size_t>(y)]));
    }
    tables_.strips.resize(static_cast<std::size_t>(rows));
    return true;
  }

  /// What is expected at a vertex of a disc, if that has nothing to say; nothing where patches and
  /// strips do not look.
  [[nodiscard]] std::optional<LimitSums> expected(const Disc& disc, Index v) const {
    const auto [sector, x, y] = sector_point(disc.shape, v);
    const auto rows = static_cast<Index>(tables_.strips.size());
    const bool first = disc.shape.open && sector == 0 && y < rows;
    const bool last = disc.shape.open && sector == disc.shape.sectors - 1 && x < rows;
    if (first && last) return std::nullopt;  // two strips would make it
    const LimitStencils& stencils = first  ? tables_.strips[static_cast<std::size_t>(y)]
                                    : last ? tables_.strips[static_cast<std::size_t>(x)]
                                           : tables_.interior;
    return moved(stencils, [&, sector = sector, x = x, y = y](Offset tap) {
      // the last spoke is the end of a side, which runs towards the centre
      if (last) tap = {tap.b, mirrored(lattice_, 0, tap.a, tap.b)};
      return disc.vertex(sector, {x + tap.a, y + tap.b});
    });
  }

  Result<bool> read_star(Index sectors) {
    if (sectors == 0) {  // it stays, without tangents
      tables_.stars[0].tables = {{0, {SectorPoint{}}, {SectorPoint{}}, isolated_limit_rows()}};
      return true;
    }
    // from ring inner_ on, a vertex does not see the centre
    return read_zone({lattice_, sectors, false}, inner_ - 1, tables_.stars[sectors]);
  }

  Result<bool> read_fan(Index sectors) {
    const StarShape shape{lattice_, sectors, true};
    if (near()) return read_zone(shape, 0, tables_.fans[sectors]);
    const Index rows = std::ssize(tables_.strips);  // at a corner two strips meet
    for (Index seen = std::max(widest() + 1, 2 * rows); seen <= kMostRings / 2; seen += 2) {
      LimitZone& zone = tables_.fans[sectors];
      Result<bool> found = read_zone(shape, seen, zone);
      // along a side the centre may be felt for some rings more
      if (!found || !*found || zone.radius < seen) return found;
    }
    return false;
  }

  /// Reads rings 0 … `seen`, and keeps those that are not as expected, those before them, and those
  /// that strips leave out.
  Result<bool> read_zone(const StarShape& shape, Index seen, LimitZone& zone) {
    if (!near() && shape.sectors > kLargestLimitZone) return false;
    Disc disc{shape, widest() + 1 + (near() ? 0 : seen + kMargin)};
    std::vector<Index> vertices(static_cast<std::size_t>(disc.size(seen)));
    std::iota(vertices.begin(), vertices.end(), 0);
    Result<std::optional<Forms>> forms = read(disc, vertices);
    if (!forms) return forms.error();
    if (!*forms) return false;
    zone.radius = shape.open ? static_cast<Index>(tables_.strips.size()) - 1 : 0;
    for (const Index v : vertices) {
      if (disc.ring(v) <= zone.radius) continue;
      const auto same = expected(disc, v);
      if (!same || !same_limit(*same, (**forms)[static_cast<std::size_t>(v)]))
        zone.radius = disc.ring(v);
    }
    vertices.resize(static_cast<std::size_t>(disc.size(zone.radius)));
    zone.tables.clear();
    add_tables(shape, vertices, **forms, zone);
    if (near() || !shape.open || shape.sectors > 1) return true;
    // where the only face at a corner gives the normal, it has to be of the level itself
    const Result<LimitSums> chain = read_chain(disc);
    if (!chain) return chain.error();
    return true;
  }

  /// The centre may have other rows than the rest.
  static void add_tables(const StarShape& shape, const std::vector<Index>& vertices,
                         const Forms& forms, LimitZone& zone) {
    const std::size_t first = forms.front().size() == 3 ? vertices.size() : 1;
    for (const auto& [begin, end] : {std::pair{std::size_t{0}, first}, {first, vertices.size()}})
      if (begin < end)
        zone.tables.push_back(limit_table(shape, {vertices.begin() + begin, vertices.begin() + end},
                                          std::span(forms).subspan(begin, end - begin)));
  }

  void find_grid() {
    Index radius = 0, far = 0;
    for (const auto* zones : {&tables_.stars, &tables_.fans})
      for (const auto& [sectors, zone] : *zones) {
        radius = std::max(radius, zone.radius);
        for (const ZoneTable& table : zone.tables)
          for (const SectorPoint& p : table.sources)
            far = std::max(far, ring_of(lattice_, p.x, p.y));
      }
    for (Index y = 0; y < std::ssize(tables_.strips); ++y)
      for (const Stencil& stencil : tables_.strips[static_cast<std::size_t>(y)])
        for (const Tap& tap : stencil) far = std::max(far, y + tap.place.b);
    // what takes from the next control vertex may be one of its own rules
    Index least = std::max({tables_.halo, chain_rings_, near() ? far : far + 1});
    if (radius > 0) least = std::max(least, 2 * radius + 1);
    while (tables_.smallest_grid < least) tables_.smallest_grid *= 2;
  }

  LimitReader& reader_;
  Lattice lattice_;
  int level_;
  Index inner_ = 1, outer_ = 1;  // regular_rings
  Index chain_rings_ = 1;        // the most of a LimitChain
  LimitTables tables_;
};

}  // namespace

Result<std::optional<LimitTables>> read_limit_tables(LimitReader& reader, Lattice lattice,
                                                     int level,
                                                     const std::vector<ZoneGroup>& groups) {
  using Found = std::optional<LimitTables>;
  TableReader tables(reader, lattice, level);
  const Result<bool> found = tables.read(groups);
  if (!found) return found.error();
  return *found ? Found(std::move(tables).tables()) : Found();
}

}  // namespace limn::fast
