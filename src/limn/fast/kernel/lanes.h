#pragma once
/// The arithmetic of the fast engine: one instruction works on as many patches at once as fit into
/// 16 bytes, which every x86-64 has (and AVX2's 32 are no faster here: reading and writing points
/// is what takes the time). A *lane* is a patch; points of the lanes lie side by side, so that no
/// row's length or start matters. With LIMN_ONE_LANE defined there is one, for other processors.

#include <array>
#include <cstddef>
#include <cstring>

#include "limn/mesh/polygons.h"

namespace limn::fast {

#ifdef LIMN_ONE_LANE
template <class Real>
inline constexpr int kLanes = 1;
#else
template <class Real>
inline constexpr int kLanes = 16 / static_cast<int>(sizeof(Real));
#endif

template <class Real>
struct VectorOf {
  // `using` takes no dependent attribute
  typedef Real Type __attribute__((vector_size(sizeof(Real) * kLanes<Real>)));
};
template <class Real>
using Vector = typename VectorOf<Real>::Type;

/// A point of each lane.
template <class Real>
struct LanePoint {
  Vector<Real> x, y, z;
};

/// A number of each lane: where it reads, writes, …
template <class Real, class T>
using PerLane = std::array<T, static_cast<std::size_t>(kLanes<Real>)>;

/// Four numbers, or a point and the number after it: arrays are padded by one number for that.
template <class Real>
inline Vector<Real> load(const Real* from) {
  Vector<Real> v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <class Real>
inline void store(Real* to, Vector<Real> v) {
  std::memcpy(to, &v, sizeof v);
}

#ifdef LIMN_ONE_LANE

template <class Real>
inline void gather(const PerLane<Real, const Real*>& from, LanePoint<Real>& to) {
  to.x[0] = from[0][0];
  to.y[0] = from[0][1];
  to.z[0] = from[0][2];
}
template <bool spill, class Real>
inline void scatter(const LanePoint<Real>& from, const PerLane<Real, Real*>& to) {
  to[0][0] = from.x[0];
  to[0][1] = from.y[0];
  to[0][2] = from.z[0];
}

#else

/// Reads a point of each lane.
[[gnu::always_inline]] inline void gather(const PerLane<float, const float*>& from,
                                          LanePoint<float>& to) {
  const Vector<float> p0 = load(from[0]), p1 = load(from[1]);
  const Vector<float> p2 = load(from[2]), p3 = load(from[3]);
  const Vector<float> xy01 = __builtin_shufflevector(p0, p1, 0, 4, 1, 5);
  const Vector<float> xy23 = __builtin_shufflevector(p2, p3, 0, 4, 1, 5);
  const Vector<float> z01 = __builtin_shufflevector(p0, p1, 2, 6, 3, 7);
  const Vector<float> z23 = __builtin_shufflevector(p2, p3, 2, 6, 3, 7);
  to.x = __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5);
  to.y = __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7);
  to.z = __builtin_shufflevector(z01, z23, 0, 1, 4, 5);
}
[[gnu::always_inline]] inline void gather(const PerLane<double, const double*>& from,
                                          LanePoint<double>& to) {
  const Vector<double> p0 = load(from[0]), p1 = load(from[1]);
  to.x = __builtin_shufflevector(p0, p1, 0, 2);
  to.y = __builtin_shufflevector(p0, p1, 1, 3);
  to.z = Vector<double>{from[0][2], from[1][2]};
}

/// Writes a point of each lane. `spill`: the number after each may be overwritten.
template <bool spill>
[[gnu::always_inline]] inline void scatter(const LanePoint<float>& from,
                                           const PerLane<float, float*>& to) {
  const Vector<float> xy01 = __builtin_shufflevector(from.x, from.y, 0, 4, 1, 5);
  const Vector<float> xy23 = __builtin_shufflevector(from.x, from.y, 2, 6, 3, 7);
  if constexpr (spill) {
    store(to[0], __builtin_shufflevector(xy01, from.z, 0, 1, 4, 4));
    store(to[1], __builtin_shufflevector(xy01, from.z, 2, 3, 5, 5));
    store(to[2], __builtin_shufflevector(xy23, from.z, 0, 1, 6, 6));
    store(to[3], __builtin_shufflevector(xy23, from.z, 2, 3, 7, 7));
  } else {
    for (int lane = 0; lane < kLanes<float>; ++lane) {
      to[lane][0] = from.x[lane];
      to[lane][1] = from.y[lane];
      to[lane][2] = from.z[lane];
    }
  }
}
template <bool spill>
[[gnu::always_inline]] inline void scatter(const LanePoint<double>& from,
                                           const PerLane<double, double*>& to) {
  store(to[0], __builtin_shufflevector(from.x, from.y, 0, 2));
  store(to[1], __builtin_shufflevector(from.x, from.y, 1, 3));
  to[0][2] = from.z[0];
  to[1][2] = from.z[1];
}

#endif

}  // namespace limn::fast
