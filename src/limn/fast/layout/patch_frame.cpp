#include "limn/fast/layout/patch_frame.h"

#include <algorithm>
#include <cstring>

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
      out[0] = kNone;
      if (twin == kNone) continue;
      out[0] = control.face(twin);
      Index k = twin - sides * out[0];
      out[1] = k;
      for (Index i = 1; i < sides; ++i) {
        k = k + 1 == sides ? 0 : k + 1;
        const Index g = sides * out[0] + k;
        if (i > 1) out[i] = control.origin(g);
        out[sides + i - 1] = edge_code(control, g);
      }
    }
  });
}

void PatchFrame::Entries::add(Entry entry) {
  if (parts.empty() || parts.back().series != entry.series) {
    parts.push_back({entry.series, count, 0});
    if (std::find(series.begin(), series.end(), entry.series) == series.end())
      series.push_back(entry.series);
  }
  ++parts.back().count;
  at.resize(static_cast<std::size_t>(count) + 4);
  at[static_cast<std::size_t>(count++)] = entry.at;
}

/// The series of one face, for one level.
class PatchFrame::Series {
 public:
  explicit Series(const GridLayout& layout) : layout_(layout), sides_(layout.sides()) {}

  /// Sets what the entries use, from the face's corners and codes, given from some number on, and
  /// writes their numbers, and unless these are the `last` some more, that are to be overwritten;
  /// returns past the entries.
  Index* write(const Entries& entries, Index f, const Index* corners, const EdgeCode* codes,
               bool last, Index* out) {
    for (const Index i : entries.series) set(i, f, corners, codes);
    const Index* at = entries.at.data();
    const Part* part = entries.parts.data();
    const Part* const end = part + entries.parts.size();
    for (; part != (last ? end - 1 : end); ++part) {
      const Four origin = Four{} + origin_[part->series], sign = Four{} + sign_[part->series];
      for (Index i = 0; i < part->count; i += 4) {
        Four numbers;
        std::memcpy(&numbers, at + part->begin + i, sizeof numbers);
        numbers = origin + ((numbers ^ sign) - sign);
        std::memcpy(out + i, &numbers, sizeof numbers);
      }
      out += part->count;
    }
    for (; part != end; ++part)
      for (Index i = 0; i < part->count; ++i) {
        const Index sign = sign_[part->series];
        *out++ = origin_[part->series] + ((at[part->begin + i] ^ sign) - sign);
      }
    return out;
  }

 private:
  typedef Index Four __attribute__((vector_size(16)));

  void set(Index i, Index f, const Index* corners, const EdgeCode* codes) {
    sign_[i] = 0;
    if (i < sides_) {
      origin_[i] = corners[i];
    } else if (i < 2 * sides_) {
      const EdgeCode code = codes[i - sides_];
      origin_[i] = layout_.point_along(code, 0);
      sign_[i] = (code & 1) - 1;
    } else {
      origin_[i] = i == 2 * sides_ ? layout_.face_begin(f) : layout_.centre_begin(f);
    }
  }

  const GridLayout layout_;
  const Index sides_;
  Index origin_[10], sign_[10];  // a sign: 0, or -1 where numbers descend
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
    own_.add(entry(0, p.a, p.b));
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
        beyond_[static_cast<std::size_t>(k)].add(entry(k, x, r));
      }
}

void PatchFrame::number(Index f, const PatchTopology::Face& face, Index* out) const {
  Series series(layout_);
  const auto halo = static_cast<std::size_t>(beyond_.front().count);
  out = series.write(own_, f, face.corners(), face.codes(), halo == 0, out);
  for (Index k = 0; k < layout_.sides() && halo > 0; ++k) {
    const PatchTopology::Face::Neighbour across = face.across(k);
    if (across.face == kNone)
      out = std::fill_n(out, halo, face.corners()[0]);
    else  // its corners are given from number 2 on, the codes from 1 on
      out = series.write(beyond_[static_cast<std::size_t>(across.side)], across.face,
                         across.corners - 2, across.codes - 1, k + 1 == layout_.sides(), out);
  }
}

}  // namespace limn::fast
