#include "limn/mesh/polygon/triangulate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "limn/mesh/mesh_limits.h"

namespace limn {
namespace {

double largest(Point3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

std::array<double, 3> numbers(Point3 p) { return {p.x, p.y, p.z}; }

/// Twice the vector area, whose direction is that of the best-fitting plane [Newell]; relative to
/// the first point, so that a small polygon far from the origin keeps its digits.
Point3 vector_area(const std::vector<Point3>& points) {
  Point3 sum;
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
    sum = sum + cross(points[k] - points[0], points[k + 1] - points[0]);
  return sum;
}

}  // namespace

bool mesh::FaceCutter::project(Index face) {
  scaled_.clear();
  double size = 0;
  const Index first = polygons_.face_begin[face], last = polygons_.face_begin[face + 1];
  for (Index c = first; c < last; ++c) {
    scaled_.push_back(polygons_.positions[polygons_.corners[c]]);
    size = std::max(size, largest(scaled_.back()));
  }
  if (!(size > 0) || !std::isfinite(size)) return false;
  // By a power of two: no coordinate is rounded, no product overflows.
  const int exponent = std::ilogb(size);
  double width = 0;
  for (Point3& p : scaled_) {
    p = {std::scalbn(p.x, -exponent), std::scalbn(p.y, -exponent), std::scalbn(p.z, -exponent)};
    width = std::max(width, largest(p - scaled_[0]));
  }
  const Point3 area = vector_area(scaled_);
  const double length = std::sqrt(dot(area, area));
  if (!(length > 1e-14 * width * width)) return false;  // rounding, if anything
  const Point3 normal = (1 / length) * area;
  double height = 0;
  for (const Point3& p : scaled_) height = std::max(height, std::abs(dot(normal, p - scaled_[0])));
  plane_.clear();
  const std::array<double, 3> n = numbers(normal);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  if (height <= 1e-9 * width) {
    // Seen along an axis a plane polygon is the same but for an affine map, and not rounded.
    const std::size_t x = (axis + (n[axis] > 0 ? 1 : 2)) % 3,
                      y = (axis + (n[axis] > 0 ? 2 : 1)) % 3;
    for (const Point3& p : scaled_) plane_.push_back({numbers(p)[x], numbers(p)[y]});
    return true;
  }
  std::array<double, 3> other{};
  other[(axis + 1) % 3] = 1;
  Point3 u = cross({other[0], other[1], other[2]}, normal);
  u = (1 / std::sqrt(dot(u, u))) * u;
  const Point3 v = cross(normal, u);
  for (const Point3& p : scaled_) {
    const Point3 d = p - scaled_[0];
    plane_.push_back({dot(u, d), dot(v, d)});
  }
  return true;
}

bool mesh::FaceCutter::fan_is_positive(Index apex) const {
  constexpr double least_sine = 1e-9;
  const auto point = [&](std::size_t k) {
    return plane_[(static_cast<std::size_t>(apex) + k) % plane_.size()];
  };
  const mesh::Point2 a = point(0);
  for (std::size_t k = 1; k + 1 < plane_.size(); ++k) {
    const mesh::Point2 b = point(k), c = point(k + 1);
    const double far = std::hypot(b.x - a.x, b.y - a.y) * std::hypot(c.x - b.x, c.y - b.y);
    if (!(mesh::approx_turn(a, b, c) > least_sine * far)) return false;
  }
  return true;
}

void mesh::FaceCutter::fan(Index degree, Index apex) {
  for (Index k = 1; k + 1 < degree; ++k)
    triangles_.push_back({apex, (apex + k) % degree, (apex + k + 1) % degree});
}

const std::vector<std::array<Index, 3>>& mesh::FaceCutter::cut(Index face, bool& gave_up,
                                                               Index apex) {
  triangles_.clear();
  gave_up = false;
  const Index degree = polygons_.degree(face);
  const Index* const corners = polygons_.corners.data() + polygons_.face_begin[face];
  const bool sound = std::all_of(corners, corners + std::max<Index>(degree, 0),
                                 [&](Index v) { return v >= 0 && v < polygons_.vertex_count(); });
  const bool has_choice = degree > 3 && sound;
  const bool has_plane = has_choice && project(face);
  if (!has_plane || fan_is_positive(apex)) {
    fan(degree, has_plane ? apex : 0);
    gave_up = has_choice && !has_plane;
  } else if (apex != 0 && fan_is_positive(0)) {
    fan(degree, 0);
  } else {
    gave_up = !clipper_.cut(plane_, triangles_);
  }
  return triangles_;
}

namespace {

/// The corners at vertices of two faces that share both edges there; the offsets fit the corners.
class SharedCorners {
 public:
  explicit SharedCorners(const Polygons& polygons)
      : polygons_(polygons), at_(polygons.positions.size()), shared_(polygons.corners.size()) {
    for (Index f = 0; f < polygons.face_count(); ++f)
      for (Index k = 0; k < polygons.degree(f); ++k) note(f, k);
    for (const Corners& at : at_)
      if (at.count == 2 && share_edges(at))
        for (std::size_t i = 0; i < 2; ++i)
          shared_[index(polygons.face_begin[at.face[i]] + at.corner[i])] = true;
  }

  /// The first such corner of the face whose neighbours are none; 0 where there is none.
  [[nodiscard]] Index apex(Index face) const {
    const Index degree = polygons_.degree(face), begin = polygons_.face_begin[face];
    const auto shared = [&](Index k) { return shared_[index(begin + k % degree)]; };
    for (Index k = 0; k < degree; ++k)
      if (shared(k) && !shared(k + 1) && !shared(k + degree - 1)) return k;
    return 0;
  }

 private:
  struct Corners {
    int count = 0;
    std::array<Index, 2> face{}, corner{};
  };
  static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
  void note(Index face, Index k) {
    const Index v = vertex(face, k);
    if (v < 0 || v >= polygons_.vertex_count()) return;
    Corners& at = at_[index(v)];
    if (at.count < 2) {
      at.face[index(at.count)] = face;
      at.corner[index(at.count)] = k;
    }
    at.count = std::min(at.count + 1, 3);
  }
  [[nodiscard]] Index vertex(Index face, Index k) const {
    return polygons_.corners[polygons_.face_begin[face] + k % polygons_.degree(face)];
  }
  [[nodiscard]] bool share_edges(const Corners& at) const {
    const auto next = [&](std::size_t i) { return vertex(at.face[i], at.corner[i] + 1); };
    const auto last = [&](std::size_t i) {
      return vertex(at.face[i], at.corner[i] + polygons_.degree(at.face[i]) - 1);
    };
    return at.face[0] != at.face[1] && next(0) == last(1) && last(0) == next(1);
  }

  const Polygons& polygons_;
  std::vector<Corners> at_;
  std::vector<bool> shared_;
};

}  // namespace

Result<mesh::Triangulation> mesh::triangulate(const Polygons& polygons) {
  std::int64_t triangles = 0, corners = 0, before = 0;
  bool ordered = !polygons.face_begin.empty() && polygons.face_begin.front() == 0;
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const std::int64_t last = polygons.face_begin[f + 1], degree = last - before;
    ordered = ordered && degree >= 0;
    triangles += std::max<std::int64_t>(degree - 2, 1);
    corners += degree <= 3 ? degree : 3 * (degree - 2);
    before = last;
  }
  if (const std::optional<Error> fault =
          mesh::too_many(polygons.positions.size(), static_cast<std::size_t>(triangles),
                         static_cast<std::size_t>(std::max<std::int64_t>(corners, 0))))
    return *fault;
  if (!ordered || static_cast<std::size_t>(before) != polygons.corners.size())
    return Error{"the face offsets do not run from 0 to the number of corners",
                 "face_begin holds one offset more than there are faces"};

  mesh::Triangulation result;
  result.polygons.positions = polygons.positions;
  result.polygons.corners.reserve(static_cast<std::size_t>(corners));
  const auto close_face = [&result](Index face) {
    result.polygons.face_begin.push_back(static_cast<Index>(result.polygons.corners.size()));
    result.face_of.push_back(face);
  };
  mesh::FaceCutter cutter(polygons);
  const SharedCorners shared(polygons);
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const Index* const face = polygons.corners.data() + polygons.face_begin[f];
    if (polygons.degree(f) < 3) {
      for (Index c = polygons.face_begin[f]; c < polygons.face_begin[f + 1]; ++c) {
        result.polygons.corners.push_back(polygons.corners[c]);
        result.corner_of.push_back(c);
      }
      close_face(f);
      continue;
    }
    bool gave_up = false;
    for (const auto& triangle : cutter.cut(f, gave_up, shared.apex(f))) {
      for (const Index corner : triangle) {
        result.polygons.corners.push_back(face[corner]);
        result.corner_of.push_back(polygons.face_begin[f] + corner);
      }
      close_face(f);
    }
    if (gave_up) result.gave_up.push_back(f);
  }
  return result;
}

Warnings mesh::warnings_of(const mesh::Triangulation& cut, const MeshSource& source) {
  if (cut.gave_up.empty()) return {};
  const std::size_t count = cut.gave_up.size();
  const Index first = source.file_face(cut.gave_up.front());
  Error warning;
  warning.file = source.file;
  if (static_cast<std::size_t>(first) < source.face_lines.size())
    warning.line = source.face_lines[static_cast<std::size_t>(first)];
  const std::string number = std::to_string(std::int64_t{first} + source.first);
  warning.message =
      (count == 1
           ? "face " + number + " crosses itself or has no area: its triangles overlap or are"
           : std::to_string(count) + " faces cross themselves or have no area (the first is " +
                 number + "): their triangles overlap or are") +
      " degenerate";
  warning.hint = "faces count from " + std::to_string(source.first) +
                 (source.file.empty() ? " here" : ", as in the file");
  return {std::move(warning)};
}

MeshSource mesh::source_of(const mesh::Triangulation& cut, const MeshSource& source) {
  MeshSource result = source;
  result.file_faces.clear();
  for (const Index face : cut.face_of) result.file_faces.push_back(source.file_face(face));
  return result;
}

Polygons triangulated(const Polygons& polygons) {
  Result<mesh::Triangulation> cut = mesh::triangulate(polygons);
  if (!cut) throw std::length_error("triangulated: " + cut.error().message);
  return std::move(cut->polygons);
}

}  // namespace limn
