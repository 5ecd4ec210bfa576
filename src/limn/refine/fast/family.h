#pragma once
/// What a split has of its own: numbers for the vertices of each level, and how a level is made of
/// the one before.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "limn/refine/fast/step_plan.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// Limit position and two tangents at a vertex, as sums over the vertices of a star or fan.
struct LimitSums {
  Index rings = 1;
  std::array<std::vector<double>, 3> weights;  ///< numbered as in mesh/lattice.h
};
/// Of a vertex of so many faces, in a fan where `open`.
using LimitSumsOf = std::function<Result<LimitSums>(bool open, Index faces)>;

class Family {
 public:
  virtual ~Family() = default;

  struct Size {
    Index vertices = 0, faces = 0, corners = 0;
  };

  /// How many of the first steps are left to the plain engine: the fewest after which vertices that
  /// are not regular lie far enough apart, or all of them.
  [[nodiscard]] virtual int plain_steps() const = 0;
  /// Below, plain_steps() ≤ level ≤ the levels that the family was made for.
  [[nodiscard]] virtual Size size(int level) const = 0;
  /// From `level` to the next.
  [[nodiscard]] virtual StepPlan plan(int level) const = 0;
  /// The limit surface at the vertices of `level` (see step_plan.h). Nothing where the sums look
  /// farther than one ring, so that near irregular vertices they would not do, or the family
  /// cannot.
  [[nodiscard]] virtual Result<std::optional<StepPlan>> limit_plan(
      int /*level*/, const LimitSumsOf& /*of*/) const {
    return std::optional<StepPlan>();
  }
  /// The plain engine's vertex at each number of level plain_steps(), given what the plain steps
  /// made; empty where the numbers are the same.
  [[nodiscard]] virtual std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const = 0;
  /// The corners of the faces of a level, face by face.
  virtual void write_faces(int level, std::span<Index> corners) const = 0;
  /// How many corners each face has, where that is one number; or 0: then `write_face_begin` gives
  /// where each face begins (size().faces + 1 numbers).
  [[nodiscard]] virtual Index corners_per_face() const = 0;
  virtual void write_face_begin(int /*level*/, std::span<Index> /*begin*/) const {}
};

}  // namespace limn::fast
