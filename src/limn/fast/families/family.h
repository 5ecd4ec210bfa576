#pragma once
/// What a split has of its own: numbers for the vertices of each level, and how a level is made of
/// the one before.

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "limn/fast/kernel/step_plan.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/mesh/split/split.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

class LimitReader;  // limit/limit_forms.h

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
  /// What of a level is still sharp, by its numbers: as tags_of (mesh/sharpness/sharpness.h) has
  /// it.
  [[nodiscard]] virtual SharpnessTags sharp_tags(int /*level*/) const { return {}; }
};

/// Whether there is a family for schemes of this split.
[[nodiscard]] bool has_family(const Split& split);

/// Why no family takes a mesh with this sharpness, though the scheme can (check_takes_sharpness,
/// refine/crease_step.h); nothing where one does. The one place that knows.
[[nodiscard]] std::optional<std::string> why_no_family(const Scheme& scheme, const Mesh& control,
                                                       const Sharpness& sharpness);

/// Preconditions: has_family(*scheme.split), `control` is what the split takes, and there is no
/// reason why_no_family. The first two must outlive the family. Of a sharpness, holes are not
/// looked at.
[[nodiscard]] std::unique_ptr<Family> make_family(const Scheme& scheme, const Mesh& control,
                                                  int levels, const Sharpness& sharpness);

}  // namespace limn::fast
