#include "limn/fast/layout/kite_patches.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

/// The patches round one: beyond its sides x = 0, x = n, y = 0, y = n, and beyond two sides.
constexpr std::size_t kNeighbours = 8;
std::array<Index, kNeighbours> neighbours(const Mesh& mesh, Index h) {
  const Index left = mesh.next(h), below = mesh.prev(h), across = mesh.twin(h);
  const Index right = mesh.twin(below);
  return {left,   right,           below, mesh.next(across), mesh.next(left), mesh.rotate(right),
          across, mesh.next(right)};
}

class Frame {
 public:
  /// So many rows beyond each side.
  Frame(Index n, Index halo) {
    for (Index j = 0; j < halo; ++j)
      for (Index t = 0; t < n; ++t) {
        add(0, {-1 - j, t}, {t, j});
        add(1, {n + j, t}, {t, n - 1 - j});
        add(2, {t, -1 - j}, {j, t});
        add(3, {t, n + j}, {n - 1 - j, t});
      }
    for (Index k = 0; k < halo; ++k)
      for (Index j = 0; j < halo; ++j) {
        add(4, {-1 - j, -1 - k}, {j, k});
        add(5, {n + j, n + k}, {n - 1 - j, n - 1 - k});
        add(6, {-1 - j, n + k}, {j, n - 1 - k});
        add(7, {n + j, -1 - k}, {n - 1 - j, k});
      }
    for (std::size_t i = 0; i < kNeighbours; ++i)
      for (const Offset& at : points_[i]) steps_[i].push_back(at.b * n + at.a);
  }

  [[nodiscard]] std::vector<Offset> places() const {
    std::vector<Offset> all;
    for (const std::vector<Offset>& places : places_)
      all.insert(all.end(), places.begin(), places.end());
    return all;
  }

  /// In the same order; where there is no point, that of another one.
  void number(const KiteLayout& at, Index h, Index* out) const {
    const Kites& kites = at.kites();
    const std::array<Index, kNeighbours> round = neighbours(kites.control(), h);
    for (std::size_t i = 0; i < kNeighbours; ++i) {
      const Index first = at.point(round[i], 0, 0);
      if (kites.is_whole(round[i])) {
        for (const Index step : steps_[i]) *out++ = first + step;
      } else {
        for (const Offset& p : points_[i])
          *out++ = kites.has_point(round[i], p.a, p.b) ? at.point(round[i], p.a, p.b) : first;
      }
    }
  }

 private:
  /// A place, which is a point of a neighbour.
  void add(std::size_t neighbour, Offset place, Offset point) {
    places_[neighbour].push_back(place);
    points_[neighbour].push_back(point);
  }

  std::array<std::vector<Offset>, kNeighbours> places_, points_;
  std::array<std::vector<Index>, kNeighbours> steps_;  // from the neighbour's first point
};

}  // namespace

std::optional<PatchPlan> plan_kite_patches(const KiteLayout& old, const KiteLayout& made,
                                           std::vector<FinePoint> points,
                                           std::vector<Stencil> stencils) {
  const Index n = old.n();
  Index halo = 1;
  for (const Stencil& stencil : stencils)
    for (const Tap& tap : stencil)
      halo = std::max({halo, std::abs(tap.place.a), std::abs(tap.place.b)});
  if (halo > n) return std::nullopt;
  const std::vector<Index>& wholes = old.kites().wholes();
  const Frame frame(n, halo);
  PatchPlan plan;
  plan.shape.frame = frame.places();
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) plan.shape.inner.push_back({x, y});
  plan.shape.runs = {std::move(points)};
  plan.stencils = std::move(stencils);
  plan.patches = static_cast<Index>(wholes.size());
  const std::size_t each = plan.shape.frame.size();
  plan.frame = base::HugeArray<Index>(each * wholes.size());
  plan.runs = base::HugeArray<Index>(wholes.size());
  base::parallel_for(
      Index{0}, plan.patches,
      [&](Index first, Index last) {
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
          frame.number(old, wholes[i], plan.frame.data() + i * each);
          plan.runs[i] = made.point(wholes[i], 0, 0);
        }
      },
      std::max<std::ptrdiff_t>(1, kNumberGrain / static_cast<std::ptrdiff_t>(each)));
  return plan;
}

}  // namespace limn::fast
