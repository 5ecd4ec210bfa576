#pragma once
/// The rows of sharp control edges and vertices, level by level, with the numbers that a layout
/// gives their points. They come after all others of a step's plan and overwrite them: patches and
/// smooth rows are made as though nothing were sharp.
///
/// All parts of a control edge are as sharp as one another (so edges must fade uniformly). What is
/// sharp therefore stays on control edges and vertices, and as it fades, rows become fewer.

#include "limn/fast/sites/sharp_tables.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {

/// boundary_sides (reach.h), where sharp edges are boundaries, as long as they are sharp.
[[nodiscard]] BoundarySides sharp_sides(const Mesh& control, const Sharpness& sharpness);

/// What is left of the sharpness of edges and vertices after so many steps.
[[nodiscard]] Sharpness after_steps(Sharpness sharpness, int steps);

class SharpSteps {
 public:
  /// Of the steps from levels `first` … `last` - 1, counted from that of `control`, the mesh that
  /// is cut into grids; `sharpness` is that of `control`, which must outlive these; `groups` are
  /// group_vertices(control). Fails as SharpTables. Cost: a table for each kind of place, and for
  /// each level some 0.1 µs for each sharp edge and vertex.
  [[nodiscard]] static Result<SharpSteps> make(const Scheme& scheme, const GridCycle& cycle,
                                               const StencilTables& tables, const Mesh& control,
                                               const std::vector<ZoneGroup>& groups,
                                               const Sharpness& sharpness, int first, int last);

  /// The rows of the step from a level, in the layouts of that and the next.
  void add_rows(int level, const GridLayout& old_points, const GridLayout& new_points,
                std::vector<RowPlan>& plans) const;

 private:
  /// Control vertices with a table in common.
  struct Zones {
    ZoneTable table;
    ZoneGroup group;
  };
  /// Half-edges with rows in common along them and their twins.
  struct Strips {
    std::vector<SideRow> rows;
    std::vector<Index> sides;
  };
  struct Level {
    Sharpness sharpness;
    std::vector<Strips> strips;
    std::vector<Zones> zones;
  };
  struct SideRows {
    std::vector<Index> sources, targets;
  };
  class Maker;
  SharpSteps(const Reach& reach, const Mesh& control, int first)
      : reach_(reach), control_(&control), first_(first) {}

  /// A row's points along a half-edge, on its left.
  void add_side(const Level& of, const SideRow& row, Index h, const GridLayout& old_points,
                const GridLayout& new_points, SideRows& made) const;

  Reach reach_;
  const Mesh* control_;
  int first_;
  std::vector<Level> levels_;
};

}  // namespace limn::fast
