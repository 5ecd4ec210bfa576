#include "limn/spectrum/sector_pattern.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>

#include <fmt/core.h>

#include "limn/mesh/lattice.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/refine_values.h"
#include "limn/refine/star_step.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/spectrum/sector_names.h"

namespace limn::spectrum {
namespace {

constexpr int kMostRings = 7;   // that control the surface, and one more
constexpr int kSeenBeyond = 4;  // rings of the star's margin

Error not_invariant(const Scheme& scheme, int rings) {
  return {fmt::format("{} rings are not invariant under scheme '{}'", rings, scheme.name),
          "take more rings"};
}

/// A vertex of a star as sector and orbit (kCenter: the centre).
struct OrbitPosition {
  int orbit, sector;
};

class OrbitPositions {
 public:
  OrbitPositions(const Split& split, int rings) : center_(!split.is_dual()) {
    for (int ring = 1; ring <= rings; ++ring) {
      first_orbit_.push_back(static_cast<int>(orbits_.size()));
      const int size = (refine::split_star_size(split, kSectors, ring) -
                        refine::split_star_size(split, kSectors, ring - 1)) /
                       kSectors;
      const double middle = center_ ? 0 : ring - 1;  // dual: the corner's diagonal
      for (int k = 0; k < size; ++k) orbits_.push_back({ring, (k - middle) / size});
    }
  }
  [[nodiscard]] const std::vector<Orbit>& orbits() const { return orbits_; }

  /// Of vertex v < star_size, numbered as in mesh/lattice.h.
  [[nodiscard]] OrbitPosition of(Index v) const {
    int left = static_cast<int>(v) - (center_ ? 1 : 0);
    if (left < 0) return {kCenter, 0};
    for (std::size_t r = 0;; ++r) {
      const int next =
          r + 1 < first_orbit_.size() ? first_orbit_[r + 1] : static_cast<int>(orbits_.size());
      const int size = next - first_orbit_[r];
      if (left < kSectors * size) return {first_orbit_[r] + left % size, left / size};
      left -= kSectors * size;
    }
  }

 private:
  bool center_;
  std::vector<Orbit> orbits_;
  std::vector<int> first_orbit_;  // of each ring
};

Result<refine::Row<refine::WeightForm>> constant_row(const Scheme& scheme, RuleKind kind, int n) {
  Result<refine::Row<double>> numbers = refine::tabulate_row<double>(scheme, kind, n);
  if (!numbers) return numbers.error();
  refine::Row<refine::WeightForm> row;
  row.program = numbers->program;
  row.weights.assign(numbers->weights.begin(), numbers->weights.end());
  return row;
}

/// The terms of one row from its linear form.
class RowTerms {
 public:
  RowTerms(const Namer& namer, const OrbitPositions& places, int row, double row_angle)
      : namer_(namer), places_(places), row_(row), row_angle_(row_angle) {}

  /// False where what was found has no such pattern.
  [[nodiscard]] bool add(Index vertex, const refine::WeightForm& form) {
    const OrbitPosition place = places_.of(vertex);
    const int sector = place.sector > kSectors / 2 ? place.sector - kSectors : place.sector;
    for (const auto& [indices, coefficient] : form.terms()) {
      if (coefficient == 0) continue;
      if (namer_.sectors_name() >= 0) {
        add_of_stages(place.orbit, sector, indices, coefficient);
        continue;
      }
      Key key{place.orbit, {}, -1, coefficient};
      int k = -1;
      for (const int index : indices) {
        const Namer::Position& position = namer_.positions[static_cast<std::size_t>(index)];
        if (position.k < 0) {
          key.names.push_back(position.name);
          continue;
        }
        if (key.repeated >= 0) return false;
        key.repeated = position.name;
        k = position.k;
      }
      found_[key].push_back({sector, k});
    }
    return true;
  }

  [[nodiscard]] bool append_to(std::vector<SectorTerm>& terms) const {
    if (!append_stages(terms)) return false;
    for (const auto& [key, positions] : found_) {
      SectorTerm term{row_, key.column, 0, key.coefficient, key.names, key.repeated, 0, false};
      const double from = row_ == kCenter ? 0 : row_angle_;
      const double to = key.column == kCenter
                            ? from
                            : places_.orbits()[static_cast<std::size_t>(key.column)].angle;
      if (key.repeated >= 0 && row_ == kCenter && positions.size() == kSectors * kSectors) {
        // by way of the faces' new vertices, from each of the sectors
        term.every_sector = true;
        terms.push_back(term);
      } else if (key.repeated >= 0) {
        const std::optional<Lines> lines = line_up(positions);
        if (!lines) return false;
        term.slope = lines->slope;
        for (const int sector : lines->first) {
          term.angle = key.column == kCenter ? 0 : sector + to - from;
          terms.push_back(term);
        }
      } else if (row_ == kCenter && key.column != kCenter) {
        // rotation leaves the centre, so all sectors come alike
        if (positions.size() % kSectors != 0) return false;
        term.every_sector = true;
        const std::size_t per_sector_count = positions.size() / kSectors;
        term.coefficient *= static_cast<double>(per_sector_count);
        terms.push_back(term);
      } else if (row_ == kCenter && per_sector(key.names)) {
        term.every_sector = true;
        term.coefficient /= kSectors;  // what came from the sectors' faces was added up
        terms.push_back(term);
      } else {
        for (const auto& [sector, k] : positions) {
          if (std::abs(sector) >= kSectors / 2) return false;
          term.angle = key.column == kCenter ? 0 : sector + to - from;
          terms.push_back(term);
        }
      }
    }
    return true;
  }

 private:
  struct Key {
    int column;
    std::vector<int> names;
    int repeated;
    double coefficient;
    friend bool operator<(const Key& a, const Key& b) {
      return std::tie(a.column, a.names, a.repeated, a.coefficient) <
             std::tie(b.column, b.names, b.repeated, b.coefficient);
    }
  };
  struct Position {
    int sector, k;
  };

  /// Names of stages that come per sector are each of a sum over the sectors. All but the last of
  /// these sums are of the centre's value, the same in each; so is the last where the term weighs
  /// the centre. They have counted this star's sectors, in place of n.
  void add_of_stages(int column, int sector, const refine::WeightForm::Names& indices,
                     double coefficient) {
    std::vector<int> names;
    names.reserve(indices.size());
    for (const int index : indices)
      names.push_back(namer_.positions[static_cast<std::size_t>(index)].name);
    auto sums = std::count_if(names.begin(), names.end(), [&](int name) {
      return namer_.names[static_cast<std::size_t>(name)].per_sector;
    });
    const bool every_sector = sums > 0 && column != kCenter;
    if (every_sector) --sums;
    for (; sums > 0; --sums) {
      coefficient /= kSectors;
      names.push_back(namer_.sectors_name());
    }
    std::sort(names.begin(), names.end());
    of_stages_[{column, every_sector, every_sector ? 0 : sector, names}] +=
        every_sector ? coefficient / kSectors : coefficient;
  }

  [[nodiscard]] bool append_stages(std::vector<SectorTerm>& terms) const {
    const auto angle_of = [&](int orbit) {
      return places_.orbits()[static_cast<std::size_t>(orbit)].angle;
    };
    for (const auto& [key, coefficient] : of_stages_) {
      const auto& [column, every_sector, sector, names] = key;
      if (std::abs(sector) >= kSectors / 2) return false;
      SectorTerm term{row_, column, 0, coefficient, names, -1, 0, every_sector};
      if (!every_sector && column != kCenter)
        term.angle = sector + angle_of(column) - (row_ == kCenter ? 0 : row_angle_);
      terms.push_back(term);
    }
    return true;
  }

  [[nodiscard]] bool per_sector(const std::vector<int>& names) const {
    return std::any_of(names.begin(), names.end(), [&](int name) {
      return namer_.names[static_cast<std::size_t>(name)].per_sector;
    });
  }

  /// Positions k = 0 … of a repeated role lie `slope` sectors on from each other. Where two new
  /// points weighed by the row have the role (faces side by side), there are two such lines.
  struct Lines {
    int slope = 0;
    std::vector<int> first;  ///< sector of each line's k = 0
  };
  static std::optional<Lines> line_up(const std::vector<Position>& positions) {
    std::array<std::vector<int>, kSectors> sectors;  // by k
    for (const Position& position : positions)
      sectors[static_cast<std::size_t>(position.k)].push_back(position.sector);
    for (const int slope : {1, -1, 0}) {
      std::vector<int> first;
      bool lines = true;
      for (int k = 0; k < kSectors && lines; ++k) {
        std::vector<int> turned;
        for (const int sector : sectors[static_cast<std::size_t>(k)])
          turned.push_back(((sector - slope * k) % kSectors + kSectors) % kSectors);
        std::sort(turned.begin(), turned.end());
        if (k == 0) first = turned;
        lines = turned == first;
      }
      if (lines && !first.empty()) return Lines{slope, sectors.front()};
    }
    return std::nullopt;
  }

  const Namer& namer_;
  const OrbitPositions& places_;
  int row_;
  double row_angle_;
  std::map<Key, std::vector<Position>> found_;
  /// Coefficients by column, whether in every sector, sector and names.
  std::map<std::tuple<int, bool, int, std::vector<int>>, double> of_stages_;
};

/// A star refined once, in forms whose coefficients are polynomials in the centre's weights.
struct StarForms {
  refine::StarStep step;
  Namer namer;
  std::vector<refine::LinearForm<refine::WeightForm>> forms;  // of step.images
};

Result<StarForms> refined_star(const Scheme& scheme, const CenterCases& cases, int rings,
                               const RegularNames& named) {
  const Split& split = *scheme.split;
  const std::vector<RuleKind> kinds = center_rules(split);
  StarForms star{refine::star_step(split, kSectors, rings), {}, {}};
  refine::RuleTables<refine::WeightForm> tables(
      scheme, refine::Boundary::left_out,
      [&](RuleKind kind, int n, std::optional<int>) -> Result<refine::Row<refine::WeightForm>> {
        if (scheme.stages)
          return n == kSectors ? star.namer.stage_row(*scheme.stages, *cases.front(), kind)
                               : constant_row(scheme, kind, n);
        const auto at = std::find(kinds.begin(), kinds.end(), kind);
        if (n != kSectors || at == kinds.end())
          return named ? star.namer.regular_row(scheme, kind, n, named)
                       : constant_row(scheme, kind, n);
        return star.namer.row(cases[static_cast<std::size_t>(at - kinds.begin())], kind,
                              split.lattice);
      });
  const refine::StarStep& step = star.step;
  if (Status status = tables.prepare(step.coarse, step.fine.births); !status) return status.error();
  star.forms = refine::refine_values_at(
      scheme, step.coarse, step.fine.births, tables,
      refine::unit_forms<refine::WeightForm>(step.coarse.vertex_count()), step.images);
  return star;
}

}  // namespace

std::vector<RuleKind> center_rules(const Split& split) {
  if (split.is_dual())
    return split.births.corners ? std::vector{RuleKind::corner} : std::vector<RuleKind>{};
  std::vector<RuleKind> kinds{RuleKind::vertex};
  if (split.births.edges) kinds.push_back(RuleKind::edge_end);
  if (split.births.faces) kinds.push_back(RuleKind::face_end);
  return kinds;
}

Result<CenterCases> center_cases(const Scheme& scheme, int n) {
  if (Status status = scheme::check_one_lattice(scheme); !status) return status.error();
  CenterCases cases;
  const std::vector<RuleKind> kinds =
      scheme.stages ? std::vector{RuleKind::vertex} : center_rules(*scheme.split);
  for (const RuleKind kind : kinds) {
    const Result<const RuleCase*> found = scheme::applicable_case(scheme, kind, n);
    if (!found) return found.error();
    if (*found == nullptr && !stands_in_for(kind, *scheme.split))
      return scheme::missing_rule(scheme, kind, n);
    cases.push_back(*found);
  }
  return cases;
}

Result<int> control_rings(const Scheme& scheme, const CenterCases& cases,
                          const RegularNames& named) {
  const Result<StarForms> star = refined_star(scheme, cases, kMostRings, named);
  if (!star) return star.error();
  const OrbitPositions places(*scheme.split, kMostRings + kSeenBeyond);
  const auto ring = [&](int orbit) {
    return orbit == kCenter ? 0 : places.orbits()[static_cast<std::size_t>(orbit)].ring;
  };
  std::map<int, std::set<int>> sees;  // the orbits that an orbit of the refined star depends on
  std::set<int> controls;
  for (Index v = 0; v < star->step.size; ++v) {
    const int orbit = places.of(v).orbit;
    controls.insert(orbit);
    for (const auto& [vertex, form] : star->forms[static_cast<std::size_t>(v)].terms)
      sees[orbit].insert(places.of(vertex).orbit);
  }
  // What controls the faces round the centre at every level: the orbits that others depend on, of
  // as many steps as one likes. Dependence grows more slowly than distance, so these are few.
  for (std::size_t count = 0; count != controls.size();) {
    count = controls.size();
    std::set<int> further;
    for (const int orbit : controls)
      for (const int seen : sees[orbit])
        if (ring(seen) <= kMostRings) further.insert(seen);
    controls = std::move(further);
  }
  int rings = 1;
  for (const int orbit : controls) rings = std::max(rings, ring(orbit));
  const auto is_invariant = [&](int count) {
    return std::all_of(sees.begin(), sees.end(), [&](const auto& one) {
      return ring(one.first) > count || std::all_of(one.second.begin(), one.second.end(),
                                                    [&](int seen) { return ring(seen) <= count; });
    });
  };
  while (rings < kMostRings && !is_invariant(rings)) ++rings;
  if (rings < kMostRings) return rings;
  return Error{
      fmt::format("scheme '{}' reaches farther than {} rings", scheme.name, kMostRings - 1),
      {},
      scheme.file,
      0,
      0};
}

Result<SectorPattern> sector_pattern(const Scheme& scheme, const CenterCases& cases, int rings,
                                     const RegularNames& named) {
  const Split& split = *scheme.split;
  if (rings < refine::least_star_rings(split)) return not_invariant(scheme, rings);
  const Result<StarForms> star = refined_star(scheme, cases, rings, named);
  if (!star) return star.error();
  const OrbitPositions places(split, rings);
  const double turn = split.dilation.turns() ? 0.5 : 0;
  SectorPattern pattern{rings, places.orbits(), !split.is_dual(), star->namer.names, {}};
  for (Index v = 0; v < star->step.size; ++v) {
    const OrbitPosition place = places.of(v);
    if (place.sector != 0) continue;
    const double angle = place.orbit == kCenter
                             ? 0
                             : places.orbits()[static_cast<std::size_t>(place.orbit)].angle + turn;
    RowTerms terms(star->namer, places, place.orbit, angle);
    for (const auto& [vertex, form] : star->forms[static_cast<std::size_t>(v)].terms)
      if (vertex >= star->step.size || !terms.add(vertex, form))
        return not_invariant(scheme, rings);
    if (!terms.append_to(pattern.terms)) return not_invariant(scheme, rings);
  }
  return pattern;
}

}  // namespace limn::spectrum
