#pragma once
/// What a split has of its own: numbers for the vertices of each level, and how a level is made of
/// the one before.

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "limn/fast/kernel/step_plan.h"
#include "limn/refine/linear_form.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// The limit surface at a vertex of a mesh, as sums over the mesh's vertices: position and two
/// tangents, whose cross product points outward.
using LimitForms = std::array<LinearForm<double>, 3>;

/// The same at a vertex whose normal is not that of two sums.
struct LimitChain {
  /// Position, and vectors t₀, t₁, … such that Σ tᵢ × tᵢ₊₁ points outward.
  std::vector<LinearForm<double>> forms;
  /// As many rings, but for the outermost, must be regular so that these are the sums.
  Index rings = 1;
};

/// Finds the limit surface at vertices of a level: what this floor cannot know.
class LimitReader {
 public:
  virtual ~LimitReader() = default;
  /// How many rings round a regular vertex, interior or (`open`) on the boundary, must be regular
  /// but for the outermost, so that its sums are those of any such vertex.
  [[nodiscard]] virtual Result<Index> regular_rings(bool open) = 0;
  /// At these vertices of a small mesh, which stands for part of a level made by `steps_made`
  /// steps. Its boundary is refined as the scheme has it, or (`closed`) stands for nothing: then
  /// vertices are far from it. Nothing at vertices whose normal is not that of two sums. An
  /// isolated vertex stays, its tangents are zero.
  [[nodiscard]] virtual Result<std::vector<std::optional<LimitForms>>> read(
      const Mesh& mesh, int steps_made, bool closed, const std::vector<Index>& vertices) = 0;
  /// The same at one vertex, not isolated, where `read` finds nothing.
  [[nodiscard]] virtual Result<LimitChain> read_chain(const Mesh& mesh, int steps_made, bool closed,
                                                      Index vertex) = 0;
};

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
  /// too far for that level, or a normal is not that of sums the family can take.
  [[nodiscard]] virtual Result<std::optional<StepPlan>> limit_plan(int /*level*/,
                                                                   LimitReader& /*reader*/) const {
    return std::optional<StepPlan>();
  }
  /// The plain engine's vertex at each number of level plain_steps(), given what the plain steps
  /// made; empty where the numbers are the same.
  [[nodiscard]] virtual std::vector<Index> plain_order(
      const std::vector<SplitResult>& steps) const = 0;
  /// The corners of the faces of a level, face by face.
  virtual void write_faces(int level, std::span<Index> corners) const = 0;
  /// Into how many blocks of equally many faces these fall, so that each can be written alone.
  [[nodiscard]] virtual Index face_blocks(int /*level*/) const { return 1; }
  /// The corners of the faces of blocks first … last - 1, of face_blocks() > 1. Not in parallel.
  virtual void write_face_blocks(int /*level*/, Index /*first*/, Index /*last*/,
                                 Index* /*corners*/) const {}
  /// How many corners each face has, where that is one number; or 0: then `write_face_begin` gives
  /// where each face begins (size().faces + 1 numbers).
  [[nodiscard]] virtual Index corners_per_face() const = 0;
  virtual void write_face_begin(int /*level*/, std::span<Index> /*begin*/) const {}
};

}  // namespace limn::fast
