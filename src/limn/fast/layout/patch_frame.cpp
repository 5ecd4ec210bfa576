#include "limn/fast/layout/patch_frame.h"

#include <algorithm>
#include <array>

#include "limn/base/parallel.h"

namespace limn::fast {

PatchTopology::PatchTopology(const Mesh& control, Index sides)
    : sides_(sides), data_(static_cast<std::size_t>(control.face_count() * size(sides))) {
  parallel_for_each(control.face_count(), [&](Index f) {
    Index* out = data_.data() + f * size(sides);
    const Index first = f * sides;
    for (Index h = first; h < first + sides; ++h) *out++ = control.origin(h);
    for (Index h = first; h < first + sides; ++h) *out++ = edge_code(control, h);
    for (Index h = first; h < first + sides; ++h, out += 2 * sides - 1) {
      const Index twin = control.twin(h);
      out[0] = twin == kNone ? kNone : control.face(twin);
      if (twin == kNone) continue;
      out[1] = twin - sides * out[0];
      Index g = control.next(twin);
      for (Index k = 1; k < sides; ++k, g = control.next(g)) {
        if (k > 1) out[k] = control.origin(g);
        out[sides + k - 1] = edge_code(control, g);
      }
    }
  });
}

/// Where the series of one face begin, for one level.
class PatchFrame::Series {
 public:
  explicit Series(const GridLayout& layout) : layout_(layout), sides_(layout.sides()) {
    step_.fill(1);
  }

  /// Corners from number `corner` on, and sides from number `side` on.
  void set(Index f, const Index* corners, Index corner, const EdgeCode* codes, Index side) {
    std::copy(corners, corners + sides_ - corner, origin_.begin() + corner);
    for (Index k = side; k < sides_; ++k) {
      const EdgeCode code = codes[k - side];
      origin_[at(sides_ + k)] = layout_.point_along(code, 0);
      step_[at(sides_ + k)] = 2 * (code & 1) - 1;
    }
    origin_[at(2 * sides_)] = layout_.face_begin(f);
    origin_[at(2 * sides_ + 1)] = layout_.centre_begin(f);
  }

  Index* write(const std::vector<Entry>& entries, Index* out) const {
    for (const Entry& entry : entries)
      *out++ = origin_[at(entry.series)] + step_[at(entry.series)] * entry.at;
    return out;
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  const GridLayout& layout_;
  Index sides_;
  std::array<Index, 10> origin_{}, step_{};
};

PatchFrame::Entry PatchFrame::entry(Index k, Index x, Index y) const {
  const GridLayout::Spot spot = layout_.spot(k, x, y);
  const Index sides = layout_.sides();
  switch (spot.on) {
    case GridLayout::Spot::corner: return {spot.side, 0};
    case GridLayout::Spot::edge: return {sides + spot.side, spot.at};
    case GridLayout::Spot::inner: return {2 * sides, spot.at};
    case GridLayout::Spot::centre: break;
  }
  return {2 * sides + 1, spot.at};
}

PatchFrame::PatchFrame(const GridLayout& layout, Index halo) : layout_(layout) {
  const Lattice lattice = layout.lattice();
  const Index side = layout.side(), unit = layout.unit(), sides = layout.sides();
  const auto add_own = [&](Offset p) {
    places_.push_back(p);
    own_.push_back(entry(0, p.a, p.b));
  };
  for (Index k = 0; k < sides; ++k) add_own(in_patch(lattice, side, k, {0, 0}));
  for (Index k = 0; k < sides; ++k)
    for (Index t = unit; t < side; t += unit) add_own(in_patch(lattice, side, k, {t, 0}));
  if (layout.has_centres())
    for (const Offset p : inner_places(lattice, layout.n())) add_own({unit * p.a, unit * p.b});
  beyond_.resize(static_cast<std::size_t>(sides));
  for (Index k = 0; k < sides; ++k)
    for (Index r = 1; r <= halo; ++r)
      for (Index x = 0; x <= (lattice == Lattice::triangle ? side - r : side); ++x) {
        if (!layout.has_point(x, r)) continue;  // in the neighbour's frame
        places_.push_back(in_patch(lattice, side, k, {side - x, -r}));
        beyond_[static_cast<std::size_t>(k)].push_back(entry(k, x, r));
      }
}

void PatchFrame::number(Index f, const PatchTopology::Face& face, Index* out) const {
  const GridLayout layout = layout_;  // here, as the numbers that are written might be its own
  Series series(layout);
  series.set(f, face.corners(), 0, face.codes(), 0);
  out = series.write(own_, out);
  for (Index k = 0; k < layout.sides(); ++k) {
    const PatchTopology::Face::Neighbour across = face.across(k);
    if (across.face == kNone) {
      out = std::fill_n(out, beyond_.front().size(), face.corners()[0]);
      continue;
    }
    series.set(across.face, across.corners, 2, across.codes, 1);
    out = series.write(beyond_[static_cast<std::size_t>(across.side)], out);
  }
}

}  // namespace limn::fast
