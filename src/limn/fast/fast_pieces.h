#pragma once
/// A refined mesh that is made in pieces by the quick engine (fast_refiner.h): only the level
/// before the last is in memory, so that the mesh may be larger than that.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "limn/fast/fast_refiner.h"
#include "limn/fast/kernel/step_pieces.h"
#include "limn/refine/refine_estimate.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// Some consecutive faces.
struct FacePiece {
  Index first = 0, count = 0;
  std::vector<Index> corners;  ///< their vertices, face by face
  std::vector<Index> begin;    ///< where each face's begin, and the last one's end; uniform: empty
};

/// The vertices and faces of `fast_refine` and `approx_fast_limit_mesh`, in the same order, with
/// the same bits.
class FastPieces {
 public:
  /// What is wanted of the limit surface (with either, each level is one that is a step finer than
  /// said above); and how large pieces are.
  struct Wanted {
    bool limit = false;    ///< positions are limit points
    bool normals = false;  ///< StepPiece::normals
    /// Vertices of a piece, or half as many as faces, but at least those of a patch: what stays in
    /// the caches of a processor.
    Index most = 8192;
    /// A level of so many bytes is kept as a whole, although parts of it would do: parts that are
    /// made again for each group of pieces take time. 0: never.
    double whole_bytes = 64e6;
  };

  /// Makes all levels that must be in memory as a whole. Precondition:
  /// has_fast_layout(scheme); `scheme` must outlive the pieces. Nothing where the plain
  /// engine would make all steps or positions are near the end of a double's range (range.h), which
  /// is found out at once, or there is no quick limit (approx_fast_limit). Fails as these do; of
  /// memory, only what `estimate` tells must be there.
  [[nodiscard]] static Result<std::optional<FastPieces>> make(const Scheme& scheme, Mesh control,
                                                              std::span<const double> positions,
                                                              int levels, const Wanted& wanted);
  [[nodiscard]] static Result<std::optional<FastPieces>> make(const Scheme& scheme, Mesh control,
                                                              std::span<const double> positions,
                                                              int levels) {
    return make(scheme, std::move(control), positions, levels, Wanted());
  }

  /// What making the pieces takes at most, each being dropped once it is written, by counting.
  [[nodiscard]] static refine::RefineEstimate estimate(const Split& split, const Mesh& control,
                                                       int levels, const Wanted& wanted);

  FastPieces(FastPieces&&) noexcept;
  FastPieces& operator=(FastPieces&&) noexcept;
  ~FastPieces();

  [[nodiscard]] Index vertex_count() const;      ///< of the whole mesh
  [[nodiscard]] Index face_count() const;        ///< of the whole mesh
  [[nodiscard]] Index corner_count() const;      ///< of all faces together
  [[nodiscard]] Index corners_per_face() const;  ///< or 0 where faces differ

  /// Pieces first … last - 1.
  struct Range {
    Index first = 0, last = 0;
  };
  /// Each vertex is in one piece, each piece in one group.
  [[nodiscard]] Index groups() const;
  /// Makes what the pieces of a group are made of, in parallel, and drops what those of another
  /// were. Groups may come in any order.
  Range enter(Index group);
  /// Makes a piece of the group that was entered last. From several threads at once, into different
  /// ones; memory in it is used again.
  void make_vertices(Index piece, fast::StepPiece& out) const;

  /// Pieces of faces, which follow one another; a single one where faces differ.
  [[nodiscard]] Index face_pieces() const;
  /// As make_vertices.
  void make_faces(Index piece, FacePiece& out) const;

 private:
  struct State;
  explicit FastPieces(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace limn::fast
