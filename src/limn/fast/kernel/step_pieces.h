#pragma once
/// A step made in pieces, each in memory of its own: the level that it makes need never be there as
/// a whole.

#include <vector>

#include "limn/fast/kernel/patch_step.h"
#include "limn/fast/kernel/piece_finder.h"
#include "limn/fast/kernel/row_step.h"

namespace limn::fast {

/// What one piece makes, extent after extent.
struct StepPiece {
  std::vector<Extent> extents;    ///< ascending
  std::vector<double> positions;  ///< x, y, z of each vertex; then padding
  std::vector<double> normals;    ///< likewise, of a limit plan

  [[nodiscard]] Index vertex_count() const;
};

/// Every new vertex is made in one piece, by the same sums as by `make_patches` and `make_rows`, to
/// the same bits. A piece is some consecutive patches and the rows that overwrite some of their
/// points, or rows alone. Where the patches that follow one another make vertices that do, as those
/// of the grids do, a piece has two or three extents.
class StepPieces {
 public:
  /// Of a plan that makes `vertices`; a piece has about so many of them, but at least those of a
  /// patch. Plan and program must outlive it. Cost: O(patches · runs + targets of rows).
  StepPieces(const StepPlan& plan, const PatchProgram& program, Index vertices,
             Index piece_vertices = 16384);

  [[nodiscard]] Index count() const { return static_cast<Index>(begin_.size()) - 1; }

  /// Makes a piece from the old points (three numbers each, and one of padding). From several
  /// threads at once, into different ones.
  void make(Index piece, const double* in, StepPiece& out) const;
  /// Of a limit plan (step_plan.h): positions and normals.
  void make_limit(Index piece, const double* in, StepPiece& out) const;

  /// The pieces of the step before that make what a piece reads, ascending; with `own_vertices`,
  /// also those that make the points of its own vertices' numbers (of a limit plan).
  [[nodiscard]] std::vector<Index> sources(Index piece, const StepPieces& before,
                                           bool own_vertices) const;
  /// How many a piece makes.
  [[nodiscard]] Index vertices_of(Index piece) const;

  /// What it holds, in bytes.
  [[nodiscard]] std::size_t bytes() const;

 private:
  /// A place of rows that has targets in a piece.
  struct Touch {
    Index plan = 0, place = 0;
  };

  void cut_patches(Index piece_vertices);
  void cut_the_rest(Index vertices, Index piece_vertices);
  void find_touches();
  [[nodiscard]] std::vector<Index> run_sizes() const;
  /// The patches of a piece, the runs' beginnings being places in its memory.
  [[nodiscard]] PatchRange patches_of(Index piece, const StepPiece& out,
                                      std::vector<Index>& runs) const;
  /// use(plan, places) for the rows of a piece, with targets that are places in its memory.
  template <class Use>
  void for_rows(Index piece, const StepPiece& out, const Use& use) const;
  void lay_out(Index piece, StepPiece& out) const;

  const StepPlan* plan_;
  PatchStep<double> patches_;
  std::vector<RowStep<double>> rows_;
  Index patches_each_ = 1;    // patches of a piece
  Index patch_pieces_ = 0;    // the first pieces, which have patches
  std::vector<Index> begin_;  // of each piece: its first extent
  std::vector<Extent> extents_;
  PieceFinder finder_;
  std::vector<std::size_t> touch_begin_;  // of each piece: its first touch
  std::vector<Touch> touches_;
};

}  // namespace limn::fast
