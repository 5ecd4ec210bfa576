#pragma once
/// Sums for the limit surface, read on a star or fan of √3 grids, and compared.

#include "limn/fast/limit/limit_sums.h"
#include "limn/fast/sites/sqrt3_site.h"

namespace limn::fast {

/// In a fan: rows along the side that is its first spoke, or the last one.
enum class SideRow { none, first, last };

/// A star or fan at one of the two kinds of levels: the one that `step` leads from.
class LimitSite {
 public:
  static constexpr Index kEdge = 3;  ///< a grid edge, in thirds
  static constexpr Index kRim = 2;   ///< edges from the rim that sums must not come to

  /// Of so many rings of edges.
  LimitSite(const Split& split, Sqrt3Step step, Index sectors, bool open, Index rings)
      : step_(step),
        sectors_(sectors),
        open_(open),
        rings_(rings),
        site_(split, sectors, open, rings_) {}

  [[nodiscard]] const Sqrt3Site& places() const { return site_; }
  /// How many thirds a vertex lies from the middle one.
  [[nodiscard]] Index ring(Index vertex) const {
    return site_.place(vertex).x + site_.place(vertex).y;
  }

  /// Nothing where a point has no sums, or they come near the rim. Fails as `reader`.
  [[nodiscard]] Result<std::optional<std::vector<LimitForms>>> read(
      LimitReader& reader, const std::vector<SectorPoint>& points) const;

  /// In thirds from the point (sqrt3_site.h); on at most six sectors, three of a fan.
  [[nodiscard]] LimitStencils on_plane_from(const LimitForms& forms, Offset point) const;

  /// The sums at a point as its patch or side row finds them; nothing where these look past a
  /// sector that is next to the point's.
  [[nodiscard]] std::optional<LimitForms> shifted(const LimitStencils& sums,
                                                  const SectorPoint& point,
                                                  SideRow row = SideRow::none) const;

 private:
  [[nodiscard]] std::optional<SectorPoint> beyond(SectorPoint place, SideRow row) const;

  Sqrt3Step step_;
  Index sectors_;
  bool open_;
  Index rings_;
  Sqrt3Site site_;
};

}  // namespace limn::fast
