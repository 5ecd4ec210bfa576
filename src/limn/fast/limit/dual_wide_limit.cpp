#include "limn/fast/limit/dual_wide_limit.h"

#include <algorithm>
#include <map>
#include <set>

#include "limn/fast/families/dual_zone.h"
#include "limn/fast/layout/dual_frame.h"
#include "limn/fast/limit/dual_umbrella.h"
#include "limn/fast/limit/limit_sums.h"
#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

constexpr Index kRegular = 4;       // sides of a regular centre
constexpr Index kFirstRings = 4;    // that are read at once
constexpr Index kLargestStar = 24;  // rings

using Form = LinearForm<double>;

/// Sums at points of sector 0 of a face star.
struct StarSums {
  Index sides = 0;
  std::vector<SectorPoint> points;
  std::vector<LimitSums> sums;  ///< by point
};

class StarReader {
 public:
  StarReader(LimitReader& reader, int level) : reader_(reader), level_(level) {}

  /// Rings 1 … rings of the sector, in larger and larger stars, from `margin` rings more on, until
  /// the sums do not see the rim. Nothing if they always do, or where there are no such sums.
  Result<std::optional<StarSums>> read(Index sides, Index rings, Index margin) {
    StarSums star{sides, {}, {}};
    std::vector<Index> vertices;
    for (Index y = 0; y < rings; ++y)
      for (Index x = 0; x < rings; ++x) {
        star.points.push_back({0, x, y});
        vertices.push_back(dual_vertex(sides, star.points.back()));
      }
    for (Index size = rings + margin; size <= kLargestStar; size += margin) {
      const auto forms = reader_.read(face_star(sides, size), level_, true, vertices);
      if (!forms) return forms.error();
      star.sums.clear();
      for (const std::optional<LimitForms>& form : *forms) {
        if (!form) return std::optional<StarSums>();
        star.sums.emplace_back(form->begin(), form->end());
        for (Form& sum : star.sums.back()) drop_rounding(sum);
      }
      if (!sees_ring(star, size)) return std::optional<StarSums>(std::move(star));
    }
    return std::optional<StarSums>();
  }

 private:
  static bool sees_ring(const StarSums& star, Index ring) {
    const Index inside = face_star_size(star.sides, ring - 1);
    for (const LimitSums& sums : star.sums)
      for (const Form& form : sums)
        if (!form.terms.empty() && form.terms.back().first >= inside) return true;
    return false;
  }

  LimitReader& reader_;
  int level_;
};

/// The stencils of the first point of a regular star, whose place is (0, 0).
LimitStencils regular_stencils(const StarSums& star) {
  LimitStencils stencils;
  for (std::size_t row = 0; row < stencils.size(); ++row) {
    std::vector<Offset> places;
    std::vector<double> weights;
    for (const auto& [vertex, weight] : star.sums.front()[row].terms) {
      places.push_back(dual_on_plane(dual_point(kRegular, vertex)));
      weights.push_back(weight);
    }
    stencils[row] = rounded_stencil(places, std::move(weights));
  }
  return stencils;
}

/// Whether a point of a star, whatever its sides, has the regular sums.
bool has_regular_sums(const LimitStencils& regular, Index sides, const SectorPoint& point,
                      const LimitSums& sums) {
  LimitSums expected;
  for (const Stencil& stencil : regular) {
    Form& sum = expected.emplace_back();
    for (const auto& [place, weight] : stencil) {
      const auto at = dual_from_plane(sides, {point.x + place.a, point.y + place.b});
      if (!at) return false;
      sum.terms.emplace_back(dual_vertex(sides, *at), weight);
    }
    std::sort(sum.terms.begin(), sum.terms.end());
  }
  return same_limit(expected, sums);
}

class WidePlanner {
 public:
  using Found = std::optional<StepPlan>;

  WidePlanner(const DualLayout& at, int level, LimitReader& reader)
      : at_(at), corners_(at.corners()), mesh_(corners_.control()), stars_(reader, level) {}

  Result<Found> plan() {
    const Result<bool> regular = plan_patches();
    if (!regular) return regular.error();
    if (!*regular) return Found();
    std::set<Index> all_sides;
    for (Index f = 0; f < mesh_.face_count(); ++f) all_sides.insert(mesh_.degree(f));
    for (const Index v : corners_.inner_vertices()) all_sides.insert(mesh_.valence(v));
    all_sides.erase(kRegular);
    for (const Index sides : all_sides) {
      const Result<bool> done = plan_zone(sides);
      if (!done) return done.error();
      if (!*done) return Found();
    }
    add_isolated_limits(at_.isolated(), plan_.rows);
    return Found(std::move(plan_));
  }

 private:
  Result<bool> plan_patches() {
    const Result<std::optional<StarSums>> star = stars_.read(kRegular, 1, kFirstRings);
    if (!star) return star.error();
    if (!*star) return false;
    regular_ = regular_stencils(**star);
    for (const Stencil& stencil : regular_)
      for (const Tap& tap : stencil)
        halo_ = std::max({halo_, std::abs(tap.place.a), std::abs(tap.place.b)});
    if (halo_ > at_.n()) return false;
    plan_.patches = plan_dual_limit_patches(at_, halo_, {regular_.begin(), regular_.end()});
    return true;
  }

  /// Reads some rings, of which those that have the regular sums are dropped.
  Result<bool> plan_zone(Index sides) {
    const Index most = at_.n() / 2 + 1;  // one too many: between two centres lie n points
    for (Index rings = std::min(kFirstRings, most);; rings = std::min(2 * rings, most)) {
      const Result<std::optional<StarSums>> star = stars_.read(sides, rings, halo_ + 1);
      if (!star) return star.error();
      if (!*star) return false;
      Index differ = 0;
      for (std::size_t i = 0; i < (*star)->points.size(); ++i)
        if (!has_regular_sums(regular_, sides, (*star)->points[i], (*star)->sums[i]))
          differ = std::max(differ, dual_ring((*star)->points[i]));
      if (differ < rings) return add_zone(**star, differ);
      if (rings == most) return false;
    }
  }

  /// So many rings of the sector, turned to all sectors. Returns false where they take from beyond
  /// the next centres.
  bool add_zone(const StarSums& star, Index rings) {
    if (rings == 0) return true;
    DualZone zone;
    std::vector<Form> forms;
    for (Index s = 0; s < star.sides; ++s)
      for (std::size_t i = 0; i < star.points.size(); ++i) {
        const SectorPoint& point = star.points[i];
        if (dual_ring(point) > rings) continue;
        zone.targets.push_back({s, point.x, point.y});
        for (const Form& form : star.sums[i]) {
          Form& turned = forms.emplace_back();
          for (const auto& [vertex, weight] : form.terms) {
            SectorPoint place = dual_point(star.sides, vertex);
            if (dual_ring(place) > at_.n()) return false;
            place.sector = (place.sector + s) % star.sides;
            turned.terms.emplace_back(dual_vertex(star.sides, place), weight);
          }
        }
      }
    fill_zone(zone, forms, [&](Index v) { return dual_point(star.sides, v); });
    std::vector<Index> faces;
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (mesh_.degree(f) == star.sides) faces.push_back(mesh_.face_begin(f));
    plan_.rows.push_back(plan_dual_zones(zone, star.sides, faces,
                                         vertices_of_sides(corners_, star.sides), at_, at_, false));
    return true;
  }

  const DualLayout& at_;
  const DualCorners& corners_;
  const Mesh& mesh_;
  StarReader stars_;
  LimitStencils regular_;
  Index halo_ = 1;
  StepPlan plan_;
};

}  // namespace

Result<std::optional<StepPlan>> plan_wide_dual_limit(const DualLayout& at, int level,
                                                     LimitReader& reader) {
  return WidePlanner(at, level, reader).plan();
}

}  // namespace limn::fast
