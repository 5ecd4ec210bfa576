#pragma once
/// Rows for the points of kites (kites.h) that patches cannot make: round the centres of faces and
/// the inner vertices that have not four sides, and at the boundary.

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/kites.h"
#include "limn/fast/sites/rim_tables.h"

namespace limn::fast {

/// Places where kites meet, that are alike: faces, or inner vertices, with so many sides.
struct KiteCentres {
  Index sides = 0;
  bool vertices = false;
  std::vector<Index> sectors;  ///< half-edges, whose patches are the sectors of each in turn
};

struct KiteGroups {
  /// Off the boundary, with other than four sides.
  std::vector<KiteCentres> centres;
  /// Faces at the boundary, from the first side of the pattern on.
  std::map<RimPattern, KiteCentres> rims;
  /// How many sides there are, 4 in any case.
  std::set<Index> sides{4};
};
[[nodiscard]] KiteGroups group_kites(const Kites& kites);

/// A level, and how far apart its points lie in the places of tables.
struct KiteLevel {
  const KiteLayout& layout;
  Index edge = 1;
};

/// A table's rows at each centre, from points of one level to points of another.
[[nodiscard]] RowPlan centre_rows(const ZoneTable& table, const KiteCentres& centres,
                                  const KiteLevel& old, const KiteLevel& made, bool overlap);

/// All rows at the boundary.
void add_rim_rows(const RimTables& rims, const KiteGroups& groups, const KiteLevel& old,
                  const KiteLevel& made, std::vector<RowPlan>& plans);

}  // namespace limn::fast
