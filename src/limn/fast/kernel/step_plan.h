#pragma once
/// One step from a level to the next as data, in which neither the split nor the scheme is seen any
/// more: patches, whose insides are regular, and rows for all points that are not.

#include <vector>

#include "limn/base/huge_array.h"
#include "limn/fast/kernel/stencil.h"

namespace limn::fast {

/// A new point of a patch: the sum of a stencil's taps, placed at the anchor.
struct FinePoint {
  std::size_t stencil = 0;
  Offset anchor;
};

/// What is done for each patch, the same for all: old points are read into a local grid, and new
/// ones are made there and written in runs.
struct PatchShape {
  std::vector<Offset> frame;  ///< places of old points that have a number each
  std::vector<Offset> inner;  ///< places of old points whose numbers follow one another
  std::vector<std::vector<FinePoint>> runs;  ///< new points whose numbers follow one another
};

struct PatchPlan {
  PatchShape shape;
  std::vector<Stencil> stencils;
  Index patches = 0;
  /// Patch p's inner points begin with number inner_begin + p · shape.inner.size().
  Index inner_begin = 0;
  /// patches × shape.frame: numbers of old points; where there is none, the number of any.
  base::HugeArray<Index> frame;
  /// patches × shape.runs: number of the first point, or kNone where another patch makes the run.
  base::HugeArray<Index> runs;
};

/// The same rows at many places.
struct RowPlan {
  RowTable table;
  /// Numbers of old (new) points: places × table.sources (table.targets()).
  base::HugeArray<Index> sources, targets;
  /// Whether two places may have a target in common: they are then made one after the other.
  bool overlap = false;

  [[nodiscard]] std::size_t places() const {
    const auto each = static_cast<std::size_t>(table.sources);
    if (each > 0) return sources.size() / each;
    return table.targets() > 0 ? targets.size() / static_cast<std::size_t>(table.targets()) : 0;
  }
  /// Of a place: as many as rows, or fewer in a limit plan.
  [[nodiscard]] std::size_t targets_each() const {
    return places() > 0 ? targets.size() / places() : 0;
  }
};

/// Patches first, then the rows of each plan in turn: what comes later overwrites.
struct StepPlan {
  PatchPlan patches;
  std::vector<RowPlan> rows;
};

/// A plan of the limit surface at the vertices of a level is of the same kind: its patches have
/// three stencils, for position and two tangents, of which all new points name the first; its rows
/// make as many sums for each target, one after the other: its position, and two or more vectors
/// whose crosses, each with the next, sum to the normal.

/// What a plan holds, in bytes.
[[nodiscard]] std::size_t bytes_of(const StepPlan& plan);

}  // namespace limn::fast
