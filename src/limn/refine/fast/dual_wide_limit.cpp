#include "limn/refine/fast/dual_wide_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "limn/mesh/lattice.h"
#include "limn/refine/fast/dual_frame.h"
#include "limn/refine/fast/dual_zone.h"
#include "limn/refine/fast/limit_zones.h"

namespace limn::fast {
namespace {

constexpr Index kRegular = 4;       // sides of a regular centre
constexpr Index kLargestStar = 24;  // rings

using Form = LinearForm<double>;

/// The sums of a regular vertex at (0, 0) of the plane.
struct RegularSums {
  std::vector<Offset> places;
  std::array<std::vector<double>, 3> weights;  // by place
  Index halo = 1;                              // rows that the places are away

  void add(Offset place, std::size_t row, double weight) {
    auto at = std::find(places.begin(), places.end(), place);
    if (at == places.end()) {
      at = places.insert(at, place);
      for (std::vector<double>& each : weights) each.push_back(0);
      halo = std::max({halo, std::abs(place.a), std::abs(place.b)});
    }
    weights[row][static_cast<std::size_t>(at - places.begin())] = weight;
  }
};

/// Without what the last digits of eigenvectors leave where nothing is.
Form without_noise(const Form& form) {
  double largest = 0;
  for (const auto& [vertex, weight] : form.terms) largest = std::max(largest, std::abs(weight));
  Form kept;
  for (const auto& term : form.terms)
    if (std::abs(term.second) > std::ldexp(largest, -42)) kept.terms.push_back(term);
  return kept;
}

/// Sums at some points of sector 0 of a face star that do not see its rim; nothing if they do.
struct StarSums {
  Index sides;
  std::vector<SectorPoint> points;
  std::vector<LimitForms> forms;
};

class StarReader {
 public:
  StarReader(LimitReader& reader, int level) : reader_(reader), level_(level) {}

  /// Rings 1 … rings of the sector. Reads larger and larger stars, from `margin` rings more on.
  Result<std::optional<StarSums>> read(Index sides, Index rings, Index margin) {
    StarSums sums{sides, {}, {}};
    std::vector<Index> vertices;
    for (Index y = 0; y < rings; ++y)
      for (Index x = 0; x < rings; ++x) {
        sums.points.push_back({0, x, y});
        vertices.push_back(dual_vertex(sides, sums.points.back()));
      }
    for (Index size = rings + margin; size <= kLargestStar; size += margin) {
      const auto forms = reader_.read(face_star(sides, size), level_, true, vertices);
      if (!forms) return forms.error();
      sums.forms.clear();
      for (const std::optional<LimitForms>& form : *forms) {
        if (!form) return std::optional<StarSums>();
        sums.forms.push_back(*form);
        for (Form& sum : sums.forms.back()) sum = without_noise(sum);
      }
      if (!sees_ring(sums, size)) return std::optional<StarSums>(std::move(sums));
    }
    return std::optional<StarSums>();
  }

 private:
  static bool sees_ring(const StarSums& sums, Index ring) {
    const Index inside = face_star_size(sums.sides, ring - 1);
    for (const LimitForms& forms : sums.forms)
      for (const Form& form : forms)
        if (!form.terms.empty() && form.terms.back().first >= inside) return true;
    return false;
  }

  LimitReader& reader_;
  int level_;
};

/// Whether two pairs of tangents span the same plane with the same orientation: (s, t) = A (u, v)
/// with det A > 0. By vertices.
bool same_tangents(const std::array<std::vector<double>, 2>& tangents,
                   const std::array<std::vector<double>, 2>& other) {
  constexpr double kTolerance = 1e-10;
  const auto dot = [](const std::vector<double>& p, const std::vector<double>& q) {
    return std::inner_product(p.begin(), p.end(), q.begin(), 0.0);
  };
  const auto& [u, v] = other;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  if (det <= kTolerance * uu * vv) return false;
  std::array<std::array<double, 2>, 2> map{};
  for (std::size_t row = 0; row < 2; ++row) {
    const std::vector<double>& t = tangents[row];
    const double tu = dot(t, u), tv = dot(t, v);
    map[row] = {(tu * vv - tv * uv) / det, (tv * uu - tu * uv) / det};
    const double scale = std::sqrt(dot(t, t));
    for (std::size_t i = 0; i < t.size(); ++i)
      if (std::abs(t[i] - map[row][0] * u[i] - map[row][1] * v[i]) > kTolerance * scale)
        return false;
  }
  return map[0][0] * map[1][1] - map[0][1] * map[1][0] > 0;
}

/// Whether a point of a star has the regular sums, though its centre has other sides.
bool is_regular(const RegularSums& regular, Index sides, const SectorPoint& point,
                const LimitForms& forms) {
  constexpr double kTolerance = 1e-10;
  std::map<Index, std::size_t> slots;
  for (const Form& form : forms)
    for (const auto& [vertex, weight] : form.terms) slots.emplace(vertex, 0);
  std::vector<Index> vertices;
  for (const Offset place : regular.places) {
    const auto at = dual_from_plane(sides, {point.x + place.a, point.y + place.b});
    if (!at) return false;
    vertices.push_back(dual_vertex(sides, *at));
    slots.emplace(vertices.back(), 0);
  }
  std::size_t count = 0;
  for (auto& [vertex, slot] : slots) slot = count++;
  std::array<std::vector<double>, 3> found, expected;
  for (std::size_t row = 0; row < 3; ++row) {
    found[row].assign(count, 0);
    expected[row].assign(count, 0);
    for (const auto& [vertex, weight] : forms[row].terms) found[row][slots.at(vertex)] = weight;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      expected[row][slots.at(vertices[i])] = regular.weights[row][i];
  }
  for (std::size_t i = 0; i < count; ++i)
    if (std::abs(found[0][i] - expected[0][i]) > kTolerance) return false;
  return same_tangents({found[1], found[2]}, {expected[1], expected[2]});
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
    plan_isolated();
    return Found(std::move(plan_));
  }

 private:
  Result<bool> plan_patches() {
    const Result<std::optional<StarSums>> star = stars_.read(kRegular, 1, 4);
    if (!star) return star.error();
    if (!*star) return false;
    for (std::size_t row = 0; row < 3; ++row)
      for (const auto& [vertex, weight] : (*star)->forms.front()[row].terms)
        regular_.add(dual_on_plane(dual_point(kRegular, vertex)), row, weight);
    if (regular_.halo > at_.n()) return false;
    std::vector<Stencil> stencils;
    stencils.reserve(3);
    for (const std::vector<double>& weights : regular_.weights)
      stencils.push_back(rounded_stencil(regular_.places, weights));
    plan_.patches = plan_dual_limit_patches(at_, regular_.halo, std::move(stencils));
    return true;
  }

  /// Reads some rings, of which those that have the regular sums are dropped.
  Result<bool> plan_zone(Index sides) {
    const Index largest = at_.n() / 2;  // between two centres lie n points
    for (Index rings = std::min<Index>(4, largest + 1); rings <= largest + 1;
         rings = std::min(2 * rings, largest + 1)) {
      const Result<std::optional<StarSums>> sums = stars_.read(sides, rings, regular_.halo + 1);
      if (!sums) return sums.error();
      if (!*sums) return false;
      Index differ = 0;
      for (std::size_t i = 0; i < (*sums)->points.size(); ++i)
        if (!is_regular(regular_, sides, (*sums)->points[i], (*sums)->forms[i]))
          differ = std::max(differ, dual_ring((*sums)->points[i]));
      if (differ < rings) return add_zone(**sums, differ);
      if (rings > largest) return false;
    }
    return false;
  }

  /// The sector's points and sums, turned to all sectors.
  bool add_zone(const StarSums& sums, Index rings) {
    if (rings == 0) return true;
    DualZone zone;
    std::vector<Form> forms;
    std::map<Index, SectorPoint> places;
    for (Index s = 0; s < sums.sides; ++s)
      for (std::size_t i = 0; i < sums.points.size(); ++i) {
        if (dual_ring(sums.points[i]) > rings) continue;
        zone.targets.push_back({s, sums.points[i].x, sums.points[i].y});
        for (const Form& form : sums.forms[i]) {
          Form& turned = forms.emplace_back();
          for (const auto& [vertex, weight] : form.terms) {
            SectorPoint place = dual_point(sums.sides, vertex);
            if (dual_ring(place) > at_.n()) return false;
            place.sector = (place.sector + s) % sums.sides;
            const Index v = dual_vertex(sums.sides, place);
            places[v] = place;
            turned.terms.emplace_back(v, weight);
          }
        }
      }
    fill_zone(zone, forms, [&](Index v) { return places.at(v); });
    std::vector<Index> faces;
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (mesh_.degree(f) == sums.sides) faces.push_back(mesh_.face_begin(f));
    plan_.rows.push_back(plan_dual_zones(zone, sums.sides, faces,
                                         vertices_of_sides(corners_, sums.sides), at_, at_, false));
    return true;
  }

  void plan_isolated() {
    std::vector<Index> isolated(corners_.isolated().size());
    std::iota(isolated.begin(), isolated.end(), at_.isolated_begin());
    add_isolated_limits(isolated, plan_.rows);
  }

  const DualLayout& at_;
  const DualCorners& corners_;
  const Mesh& mesh_;
  StarReader stars_;
  RegularSums regular_;
  StepPlan plan_;
};

}  // namespace

Result<std::optional<StepPlan>> plan_wide_dual_limit(const DualLayout& at, int level,
                                                     LimitReader& reader) {
  return WidePlanner(at, level, reader).plan();
}

}  // namespace limn::fast
