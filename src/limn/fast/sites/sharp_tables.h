#pragma once
/// What sharpness (mesh/sharpness/sharpness.h) changes in a step from one grid to the next: near
/// sharp control edges and vertices, new points have other stencils. Like all that is special at a
/// place, these are read by refining sites with the plain engine, here with sharp spokes
/// (refine/crease_step.h): nothing here knows a rule, or how sharpness is blended.
///
/// A crease is a boundary that is seen from either side. So new points need tables where they would
/// at a boundary (reach.h), and only those are kept whose stencils differ from the smooth ones.
/// Sharpness matters to a step only by whether it stays, and if not, by how much of it is left:
/// most places share a table with many, at this level and at others.

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "limn/fast/sites/stencil_tables.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::fast {

/// What a step makes of a sharpness: the sharpness, where it ends with the step; else
/// kInfinitelySharp, or 0. Where all that ends at a place is kWholeStep, it is as though it stayed.
[[nodiscard]] inline double in_one_step(double sharpness) {
  return after_step(sharpness) > 0 ? kInfinitelySharp : sharpness;
}
inline constexpr double kWholeStep = 1;

/// A control vertex with what is sharp there, as in_one_step has it.
struct SharpPattern {
  bool open = false;           ///< on the boundary
  double own = 0;              ///< of the vertex
  std::vector<double> spokes;  ///< of the first edge of each of its faces; a boundary edge has 0
  // not <=>, which emscripten's library lacks for vectors
  friend bool operator<(const SharpPattern& a, const SharpPattern& b) {
    return std::tie(a.open, a.own, a.spokes) < std::tie(b.open, b.own, b.spokes);
  }
};

/// The zone of a face at a vertex, by whether the edges at its sides there are sharp, or on the
/// boundary.
[[nodiscard]] inline const Zone& zone_between(const Reach& reach, bool first, bool second) {
  return first && second ? reach.corner_zone : reach.fan_zone;
}

/// Tables of what is sharp, read as they are asked for. Of cycles of one step with whole points.
class SharpTables {
 public:
  /// `tables` are those of the step (read_stencils), for boundary sides that include sharp ones;
  /// all must outlive these.
  SharpTables(const Scheme& scheme, const GridCycle& cycle, const StencilTables& tables);

  /// New points round a vertex whose stencils differ from the smooth ones: maybe none. Fails as the
  /// rules' tables do. Cost: some 0.1 ms the first time.
  [[nodiscard]] Result<const ZoneTable*> zone(const SharpPattern& pattern);

  /// The same along an edge of sharpness in_one_step, on its left. Rows of y = 0 see both sides.
  [[nodiscard]] Result<const std::vector<SideRow>*> strip(double sharpness);

 private:
  using Form = refine::LinearForm<double>;
  struct Forms {
    std::vector<SectorPoint> points;
    std::vector<Form> forms;
  };
  /// On which zones, and points so many steps farther out, see as far as they look.
  [[nodiscard]] Site site(Index sectors, bool open, Index more) const;
  [[nodiscard]] std::vector<SectorPoint> points_round(const SharpPattern& pattern) const;
  /// Of those points whose stencils differ from the smooth ones.
  [[nodiscard]] Result<Forms> read(const Site& site, const SharpPattern& pattern,
                                   const std::vector<SectorPoint>& points);

  const Scheme& scheme_;
  const GridCycle& cycle_;
  const StencilTables& tables_;
  refine::RuleTables<double> rules_;
  std::map<std::pair<Index, bool>, Site> sites_;
  std::map<SharpPattern, ZoneTable> zones_;
  std::map<double, std::vector<SideRow>> strips_;
};

}  // namespace limn::fast
