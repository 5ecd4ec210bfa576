#include "limn/fast/sites/rim_tables.h"

namespace limn::fast {
namespace {

constexpr Index kMargin = 3;  // points between what is read and the end of a site

/// Quads round a vertex, of which two are beyond a straight side, and of which none is inside.
const RimPattern kWideSide{3, 3, 0, 1}, kNarrowSide{0, 1, 0, 1};

/// What is to be read at points of a site: as many forms for each, one after the other; or none.
using RimForms = std::vector<refine::LinearForm<double>>;

template <class Read>
class RimMaker {
 public:
  RimMaker(const Split& split, const GridCycle& cycle, Index near, Index edge, Index first,
           Read read)
      : split_(split), cycle_(cycle), edge_(edge), first_(first), read_(read) {
    rims_.near = near;
  }

  Result<std::optional<RimTables>> make(const std::set<RimPattern>& patterns) {
    for (const auto& [pattern, rows, wide] : {std::tuple(&kWideSide, &rims_.wide, true),
                                              std::tuple(&kNarrowSide, &rims_.narrow, false)}) {
      const Result<bool> found = read_side(*pattern, wide ? rims_.near : 2, *rows);
      if (!found) return found.error();
      if (!*found) return std::optional<RimTables>();
    }
    for (const RimPattern& pattern : patterns) {
      const Result<bool> found = read_zone(pattern);
      if (!found) return found.error();
      if (!*found) return std::optional<RimTables>();
    }
    return std::optional<RimTables>(std::move(rims_));
  }

 private:
  [[nodiscard]] Site site(const RimPattern& pattern) const {
    return {split_,
            cycle_,
            {Lattice::quad, static_cast<Index>(pattern.size()), false},
            rims_.near + kMargin,
            pattern};
  }
  [[nodiscard]] SectorPoint place(const SectorPoint& p) const {
    return {p.sector, edge_ * p.x + first_, edge_ * p.y + first_};
  }

  Result<bool> read_side(const RimPattern& pattern, Index depths, std::vector<SideRow>& rows) {
    const Site site = this->site(pattern);
    for (Index depth = 0; depth < depths; ++depth)
      for (Index along = 0; edge_ * along < cycle_.edge(); ++along) {
        const SectorPoint point =
            place(depth == 0 ? SectorPoint{3, 0, along} : SectorPoint{0, along, depth - 1});
        const Result<RimForms> forms = read_(site, {point});
        if (!forms) return forms.error();
        if (forms->empty()) return false;
        rows.push_back(side_row(*forms, site, 0, point, cycle_.edge()));
      }
    return true;
  }

  Result<bool> read_zone(const RimPattern& pattern) {
    const Site site = this->site(pattern);
    std::vector<SectorPoint> points;
    for (Index s = 0; s < std::ssize(pattern); ++s)
      for (Index y = 0; y < rims_.near; ++y)
        for (Index x = 0; x < rims_.near; ++x)
          if (has_point(pattern, {s, x, y})) points.push_back(place({s, x, y}));
    const Result<RimForms> forms = read_(site, points);
    if (!forms) return forms.error();
    if (forms->empty()) return false;
    rims_.zones.emplace(pattern, zone_table(*forms, site, 0, std::move(points)));
    return true;
  }

  const Split& split_;
  const GridCycle& cycle_;
  Index edge_, first_;
  Read read_;
  RimTables rims_;
};

}  // namespace

Result<RimTables> read_rims(const Scheme& scheme, const GridCycle& cycle,
                            const std::set<RimPattern>& patterns, const Reach& reach) {
  refine::RuleTables<double> rules(scheme, refine::Boundary::left_out);
  const auto read = [&](const Site& site, const std::vector<SectorPoint>& points) {
    return read_new_points(scheme, rules, site, 0, points);
  };
  auto made = RimMaker(*scheme.split, cycle, reach.rim, cycle.new_edge(), 1, read).make(patterns);
  if (!made) return made.error();
  return *std::move(*made);
}

Result<std::optional<RimTables>> read_limit_rims(const Split& split, const GridCycle& cycle,
                                                 const std::set<RimPattern>& patterns,
                                                 int steps_made, LimitReader& reader) {
  const Result<Index> rings = reader.regular_rings(false);
  if (!rings) return rings.error();
  if (*rings > 1) return std::optional<RimTables>();
  const auto read = [&](const Site& site,
                        const std::vector<SectorPoint>& points) -> Result<RimForms> {
    std::vector<Index> vertices;
    vertices.reserve(points.size());
    for (const SectorPoint& point : points) vertices.push_back(site.old_vertex(0, point));
    const auto found = reader.read(site.mesh(0), steps_made, false, vertices);
    if (!found) return found.error();
    RimForms all;
    for (const std::optional<LimitForms>& forms : *found) {
      if (!forms) return RimForms();
      all.insert(all.end(), forms->begin(), forms->end());
    }
    return all;
  };
  const LatticeStep step(cycle, 0);
  return RimMaker(split, cycle, 1, step.edge, step.first(), read).make(patterns);
}

}  // namespace limn::fast
