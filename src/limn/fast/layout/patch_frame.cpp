#include "limn/fast/layout/patch_frame.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "limn/base/parallel.h"

namespace limn::fast {

PatchTopology::PatchTopology(const Mesh& control, Index sides)
    : sides_(sides), data_(static_cast<std::size_t>(control.face_count() * size(sides))) {
  if (sides == 3)
    fill<3>(control);
  else
    fill<4>(control);
}

template <int kSides>
void PatchTopology::fill(const Mesh& control) {
  base::parallel_for_each(control.face_count(), [&](Index f) {
    Index* out = data_.data() + f * size(kSides);
    const Index first = f * kSides;
    for (int k = 0; k < kSides; ++k) *out++ = control.origin(first + k);
    for (int k = 0; k < kSides; ++k) *out++ = edge_code(control, first + k);
    for (int k = 0; k < kSides; ++k, out += 2 * kSides - 1) {
      const Index twin = control.twin(first + k);
      out[0] = kNone;
      if (twin == kNone) continue;
      const Index across = static_cast<Index>(static_cast<unsigned>(twin) / kSides);
      Index side = twin - kSides * across;
      out[0] = across;
      out[1] = side;
      for (int i = 1; i < kSides; ++i) {
        side = side + 1 == kSides ? 0 : side + 1;
        const Index g = kSides * across + side;
        if (i > 1) out[i] = control.origin(g);
        out[kSides + i - 1] = edge_code(control, g);
      }
    }
  });
}

namespace {

typedef Index Four __attribute__((vector_size(16)));

/// out[i] = origin + at[i], or (`sign` = -1) origin - at[i], for i < count, and some more before
/// `end` that are to be overwritten. Returns past the last.
Index* write(Index origin, Index sign, const Index* at, Index count, const Index* end, Index* out) {
  Index i = 0;
  for (; i < count && out + i + 4 <= end; i += 4) {
    Four numbers;
    std::memcpy(&numbers, at + i, sizeof numbers);
    numbers = origin + ((numbers ^ sign) - sign);
    std::memcpy(out + i, &numbers, sizeof numbers);
  }
  for (; i < count; ++i) out[i] = origin + ((at[i] ^ sign) - sign);
  return out + count;
}

constexpr std::size_t kVector = 4;  // what vectors may read past the end

}  // namespace

PatchFrame::PatchFrame(const GridLayout& layout, Index halo) : layout_(layout) {
  const Lattice lattice = layout.lattice();
  const Index side = layout.side(), unit = layout.unit(), sides = layout.sides();
  for (Index k = 0; k < sides; ++k) places_.push_back(in_patch(lattice, side, k, {0, 0}));
  for (Index k = 0; k < sides; ++k)
    for (Index t = unit; t < side; t += unit) places_.push_back(in_patch(lattice, side, k, {t, 0}));
  if (layout.has_centres())
    for (const Offset p : inner_places(lattice, layout.n()))
      places_.push_back({unit * p.a, unit * p.b});
  steps_.resize(static_cast<std::size_t>(std::max(layout.n(), layout.face_size())) + kVector);
  std::iota(steps_.begin(), steps_.end(), 1);
  inside_.resize(static_cast<std::size_t>(sides));
  for (Index k = 0; k < sides; ++k) add_beyond(k, halo);
}

/// What lies beyond side k, in the order of writing, and its numbers where k is the side's number
/// in the neighbour.
void PatchFrame::add_beyond(Index k, Index halo) {
  using Spot = GridLayout::Spot;
  const Lattice lattice = layout_.lattice();
  const Index side = layout_.side();
  Inside& inside = inside_[static_cast<std::size_t>(k)];
  std::vector<Offset> points, centres;
  loose_.clear();  // they are the same for all k
  for (Index r = 1; r <= halo; ++r)
    for (Index x = 0; x <= (lattice == Lattice::triangle ? side - r : side); ++x) {
      if (!layout_.has_point(x, r)) continue;  // in the neighbour's frame
      const Spot spot = layout_.spot(k, x, r);
      const Offset place = in_patch(lattice, side, k, {side - x, -r});
      if (spot.on == Spot::inner) {
        points.push_back(place);
        inside.points.push_back(spot.at);
      } else if (spot.on == Spot::centre) {
        centres.push_back(place);
        inside.centres.push_back(spot.at);
      } else {
        places_.push_back(place);
        loose_.push_back(
            {spot.on == Spot::corner ? spot.side : layout_.sides() + spot.side, spot.at});
      }
    }
  places_.insert(places_.end(), points.begin(), points.end());
  places_.insert(places_.end(), centres.begin(), centres.end());
  points_ = static_cast<Index>(points.size());
  centres_ = static_cast<Index>(centres.size());
  inside.points.resize(points.size() + kVector);
  inside.centres.resize(centres.size() + kVector);
}

template <int kSides>
void PatchFrame::number(Index f, const PatchTopology::Face& face, Index* out) const {
  const GridLayout layout = layout_;  // here, as the numbers that are written might be its own
  const Index n = layout.n();
  const Index* const end = out + places_.size();
  const auto sign_of = [](EdgeCode code) { return (code & 1) - 1; };
  for (int i = 0; i < kSides; ++i) *out++ = face.corners()[i];
  for (int i = 0; i < kSides && n > 1; ++i) {
    const EdgeCode code = face.codes()[i];
    out = write(layout.point_along(code, 0), sign_of(code), steps_.data(), n - 1, end, out);
  }
  if (layout.has_centres())
    out = write(layout.face_begin(f) - 1, 0, steps_.data(), layout.face_size(), end, out);
  Index origin[2 * kSides] = {}, sign[2 * kSides] = {};
  const Index points = points_, centres = centres_;
  const auto beyond = std::ssize(loose_) + points + centres;
  for (int k = 0; k < kSides && beyond > 0; ++k) {
    const PatchTopology::Face::Neighbour across = face.across(k);
    if (across.face == kNone) {
      out = std::fill_n(out, beyond, face.corners()[0]);
      continue;
    }
    // its corners are given from number 2 on, the codes from 1 on
    for (int i = 2; i < kSides; ++i) origin[i] = across.corners[i - 2];
    for (int i = 1; i < kSides && n > 1; ++i) {
      const EdgeCode code = across.codes[i - 1];
      origin[kSides + i] = layout.point_along(code, 0);
      sign[kSides + i] = sign_of(code);
    }
    for (const Loose& p : loose_)
      *out++ = origin[p.series] + ((p.at ^ sign[p.series]) - sign[p.series]);
    const Inside& inside = inside_[static_cast<std::size_t>(across.side)];
    if (points > 0)
      out = write(layout.face_begin(across.face), 0, inside.points.data(), points, end, out);
    if (centres > 0)
      out = write(layout.centre_begin(across.face), 0, inside.centres.data(), centres, end, out);
  }
}

void PatchFrame::number(Index f, const PatchTopology::Face& face, Index* out) const {
  if (layout_.sides() == 3)
    number<3>(f, face, out);
  else
    number<4>(f, face, out);
}

}  // namespace limn::fast
