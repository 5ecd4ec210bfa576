#include "limn/fast/kernel/patch_step.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "limn/fast/kernel/lane_stencil.h"
#include "limn/fast/kernel/patch_worker.h"
#include "limn/mesh/unit_normal.h"

namespace limn::fast {
namespace {

template <class Real>
using Line = std::vector<LanePoint<Real>>;

/// Whether all places that new points take from are in the local grid; each takes from so many
/// stencils, from the one that it names on.
[[maybe_unused]] bool stays_in_grid(const PatchPlan& plan, const PatchProgram& program,
                                    std::size_t each) {
  for (const PatchBlock& block : program.blocks)
    for (const StencilPoints& points : block.points)
      for (std::size_t s = points.stencil; s < points.stencil + each; ++s)
        for (const Tap& tap : plan.stencils[s])
          for (const Index anchor : points.anchors) {
            const Index slot = anchor + program.slot_step(tap.place);
            if (slot < 0 || slot >= program.slots) return false;
          }
  return true;
}

/// Position and two tangents of the points of a block, and the normal from these.
template <class Real>
class LimitLines {
 public:
  explicit LimitLines(std::size_t points)
      : position_(points),
        first_(points),
        second_(points),
        normal_(points),
        squares_(points * kLanes<Real>),
        least_(points * kLanes<Real>) {}

  void make(const std::vector<LaneStencil<Real>>& stencils, const LanePoint<Real>* grid,
            const StencilPoints& points) {
    stencils[0].apply(grid, points, position_.data());
    stencils[1].apply(grid, points, first_.data());
    stencils[2].apply(grid, points, second_.data());
    find_normals(points.anchors.size());
  }
  [[nodiscard]] const LanePoint<Real>* positions() const { return position_.data(); }
  [[nodiscard]] const LanePoint<Real>* normals() const { return normal_.data(); }

 private:
  static constexpr auto kLaneCount = static_cast<std::size_t>(kLanes<Real>);

  static Vector<Real> square(const LanePoint<Real>& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

  /// first × second, as unit vectors. In several loops, so that the compiler takes several roots in
  /// one instruction.
  void find_normals(std::size_t count) {
    constexpr Real kError = Real(mesh::kTangentUnits) * std::numeric_limits<Real>::epsilon();
    for (std::size_t i = 0; i < count; ++i) {
      const LanePoint<Real>&a = first_[i], &b = second_[i];
      normal_[i] = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
      const Vector<Real> tangents = square(a) + square(b);
      store(&squares_[i * kLaneCount], square(normal_[i]));
      store(&least_[i * kLaneCount],
            (square(position_[i]) + tangents) * (kError * kError) * tangents);
    }
    bool sure = true;
    for (std::size_t i = 0; i < count * kLaneCount; ++i) sure &= is_sure(squares_[i], least_[i]);
    if (!sure) return find_normals_carefully(count);
    for (std::size_t i = 0; i < count * kLaneCount; ++i) squares_[i] = 1 / std::sqrt(squares_[i]);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector<Real> scale = load(&squares_[i * kLaneCount]);
      normal_[i] = {normal_[i].x * scale, normal_[i].y * scale, normal_[i].z * scale};
    }
  }

  static bool is_sure(Real square, Real least) {
    return (square > least) &
           (square > mesh::kSafeSquare<Real>)&(square < 1 / mesh::kSafeSquare<Real>);
  }

  /// One by one, where lengths may be lost in products, or be no more than rounding.
  void find_normals_carefully(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
        const std::size_t at = i * kLaneCount + lane;
        std::array<double, 3> normal = numbers(normal_[i], lane);
        if (is_sure(squares_[at], least_[at])) {
          for (double& number : normal)
            number = static_cast<Real>(number) * (1 / std::sqrt(squares_[at]));
        } else {
          const std::array<double, 3> position = numbers(position_[i], lane);
          const std::array<std::array<double, 3>, 2> tangents{numbers(first_[i], lane),
                                                              numbers(second_[i], lane)};
          double size = 0;
          for (const auto& numbers : {position, tangents[0], tangents[1]})
            for (const double number : numbers) size = std::max(size, std::abs(number));
          normal = mesh::unit_normal<Real>(tangents, size);
        }
        normal_[i].x[lane] = static_cast<Real>(normal[0]);
        normal_[i].y[lane] = static_cast<Real>(normal[1]);
        normal_[i].z[lane] = static_cast<Real>(normal[2]);
      }
  }

  static std::array<double, 3> numbers(const LanePoint<Real>& p, std::size_t lane) {
    return {p.x[lane], p.y[lane], p.z[lane]};
  }

  Line<Real> position_, first_, second_, normal_;
  std::vector<Real> squares_;  // of the normals' lengths, then the inverse lengths
  std::vector<Real> least_;    // of the squares that rounding may make
};

}  // namespace

template <class Real>
struct PatchStep<Real>::Stencils {
  std::vector<LaneStencil<Real>> list;
};

template <class Real>
PatchStep<Real>::PatchStep(const PatchPlan& plan, const PatchProgram& program)
    : plan_(&plan), program_(&program), stencils_(std::make_unique<Stencils>()) {
  stencils_->list.reserve(plan.stencils.size());
  for (const Stencil& stencil : plan.stencils) stencils_->list.emplace_back(stencil, program);
}

template <class Real>
PatchStep<Real>::PatchStep(PatchStep&&) noexcept = default;
template <class Real>
PatchStep<Real>::~PatchStep() = default;

template <class Real>
void PatchStep<Real>::make(const PatchRange& range, const Real* in, Real* out) const {
  assert(stays_in_grid(*plan_, *program_, 1));
  Line<Real> line(static_cast<std::size_t>(program_->line));
  for_batches(*plan_, *program_, range, in, [&](PatchWorker<Real>& worker) {
    for (const PatchBlock& block : program_->blocks) {
      for (const StencilPoints& points : block.points)
        stencils_->list[points.stencil].apply(worker.grid(), points, line.data());
      worker.put(block, line.data(), out);
    }
  });
}

template <class Real>
void PatchStep<Real>::make_limit(const PatchRange& range, const Real* in, Real* positions,
                                 Real* normals) const {
  assert(stays_in_grid(*plan_, *program_, 3));
  LimitLines<Real> sums(static_cast<std::size_t>(program_->line));
  for_batches(*plan_, *program_, range, in, [&](PatchWorker<Real>& worker) {
    for (const PatchBlock& block : program_->blocks) {
      sums.make(stencils_->list, worker.grid(), block.points.front());
      worker.put(block, sums.positions(), positions);
      worker.put(block, sums.normals(), normals);
    }
  });
}

template class PatchStep<float>;
template class PatchStep<double>;

namespace {

/// work(range) for all patches, in parallel.
template <class Real, class Work>
void for_ranges(const PatchPlan& plan, const PatchProgram& program, const Work& work) {
  if (program.blocks.empty()) return;
  base::parallel_for(
      Index{0}, plan.patches,
      [&](Index first, Index last) {
        const std::size_t runs = static_cast<std::size_t>(first) * plan.shape.runs.size();
        work({first, last, plan.runs.data() + runs});
      },
      patch_grain<Real>(plan));
}

}  // namespace

template <class Real>
void make_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in, Real* out) {
  const PatchStep<Real> step(plan, program);
  for_ranges<Real>(plan, program, [&](const PatchRange& range) { step.make(range, in, out); });
}

template <class Real>
void make_limit_patches(const PatchPlan& plan, const PatchProgram& program, const Real* in,
                        Real* positions, Real* normals) {
  const PatchStep<Real> step(plan, program);
  for_ranges<Real>(plan, program, [&](const PatchRange& range) {
    step.make_limit(range, in, positions, normals);
  });
}

template void make_patches<float>(const PatchPlan&, const PatchProgram&, const float*, float*);
template void make_patches<double>(const PatchPlan&, const PatchProgram&, const double*, double*);
template void make_limit_patches<float>(const PatchPlan&, const PatchProgram&, const float*, float*,
                                        float*);
template void make_limit_patches<double>(const PatchPlan&, const PatchProgram&, const double*,
                                         double*, double*);

}  // namespace limn::fast
