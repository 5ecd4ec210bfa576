#include "limn/fast/layout/dual_frame.h"

#include <algorithm>
#include <cassert>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

constexpr Index kNumberGrain = 16384;  // numbers that one call of a parallel loop makes

PatchShape make_shape(Index n, Index halo) {
  PatchShape shape;
  for (Index j = 0; j < halo; ++j) {
    for (Index y = 0; y < n; ++y) shape.frame.push_back({-1 - j, y});
    for (Index y = 0; y < n; ++y) shape.frame.push_back({n + j, y});
    for (Index x = 0; x < n; ++x) shape.frame.push_back({x, -1 - j});
    for (Index x = 0; x < n; ++x) shape.frame.push_back({x, n + j});
  }
  for (Index k = 0; k < halo; ++k)
    for (Index j = 0; j < halo; ++j)
      shape.frame.insert(shape.frame.end(),
                         {{-1 - j, -1 - k}, {n + j, n + k}, {-1 - j, n + k}, {n + j, -1 - k}});
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) shape.inner.push_back({x, y});
  return shape;
}

/// The frame's points as make_shape has them: those beyond x = 0, x = n, y = 0, y = n …
void write_frame(const DualLayout& at, Index h, Index halo, Index* out) {
  const DualCorners& corners = at.corners();
  const Mesh& mesh = corners.control();
  const Index n = at.n(), twin = mesh.twin(h), below = mesh.prev(h);
  const Index left = mesh.next(h), right = mesh.twin(below), above = mesh.next(twin);
  for (Index j = 0; j < halo; ++j, out += static_cast<std::ptrdiff_t>(4) * n) {
    // a rim has no more than its arm
    at.row(left, corners.is_whole(left) ? j : 0, out);
    at.row(right, n - 1 - j, out + n);
    at.column(below, corners.is_whole(below) ? j : 0, out + std::ptrdiff_t{2} * n);
    at.column(above, n - 1 - j, out + std::ptrdiff_t{3} * n);
  }
  // … and beyond two sides: of use where there are four patches, else just any numbers
  const Index face = mesh.next(left), vertex = mesh.rotate(right);
  const Index far = mesh.next(right);
  for (Index k = 0; k < halo; ++k)
    for (Index j = 0; j < halo; ++j) {
      *out++ = corners.is_whole(face) ? at.point(face, j, k) : at.point(face, 0, 0);
      *out++ = at.point(vertex, n - 1 - j, n - 1 - k);
      *out++ = at.point(twin, corners.is_whole(twin) ? j : 0, n - 1 - k);
      *out++ = at.point(far, n - 1 - j, corners.is_whole(far) ? k : 0);
    }
}

}  // namespace

PatchPlan frame_dual_patches(const DualLayout& old, const DualLayout& fresh, Index halo) {
  assert(halo <= old.n());
  const std::vector<Index>& wholes = old.corners().wholes();
  PatchPlan plan;
  plan.shape = make_shape(old.n(), halo);
  plan.patches = static_cast<Index>(wholes.size());
  const std::size_t frame = plan.shape.frame.size();
  plan.frame = HugeArray<Index>(frame * wholes.size());
  plan.runs = HugeArray<Index>(wholes.size());
  parallel_for(
      Index{0}, plan.patches,
      [&](Index first, Index last) {
        for (Index p = first; p < last; ++p) {
          const auto i = static_cast<std::size_t>(p);
          write_frame(old, wholes[i], halo, plan.frame.data() + i * frame);
          plan.runs[i] = fresh.point(wholes[i], 0, 0);
        }
      },
      std::max<std::ptrdiff_t>(1, kNumberGrain / static_cast<std::ptrdiff_t>(frame)));
  return plan;
}

PatchPlan plan_dual_limit_patches(const DualLayout& at, Index halo, std::vector<Stencil> stencils) {
  PatchPlan plan = frame_dual_patches(at, at, halo);
  std::vector<FinePoint>& run = plan.shape.runs.emplace_back();
  run.reserve(plan.shape.inner.size());
  for (const Offset place : plan.shape.inner) run.push_back({0, place});
  plan.stencils = std::move(stencils);
  return plan;
}

}  // namespace limn::fast
