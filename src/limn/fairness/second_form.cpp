#include "limn/fairness/second_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/base/parallel.h"
#include "limn/mesh/unit_normal.h"

namespace limn::fairness {
namespace {

using Eigen::Matrix;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// a quadratic surface through the vertex: two slopes, three second derivatives
constexpr int kUnknowns = 5;
// of the least pivot to the largest; a ring that is a square of neighbours has 0, a good one 0.1
constexpr double kWorstPivots = 1e-3;
constexpr double kWorstWidths = 1e-3;  // a ring that is all but a line

Vector3d vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// visit(h) for every half-edge out of v.
template <class Visit>
void visit_spokes(const Mesh& mesh, Index v, Visit visit) {
  const Index first = mesh.halfedge_of_vertex(v);
  for (Index h = first; h != kNone;) {
    visit(h);
    h = mesh.rotate(h);
    if (h == first) break;
  }
}

/// Appends the other corners of v's faces.
void append_ring(const Mesh& mesh, Index v, std::vector<Index>& ring) {
  visit_spokes(mesh, v, [&](Index h) {
    // the last corner of a face is the first of the next, if there is one
    const Index end = mesh.rotate(h) == kNone ? h : mesh.prev(h);
    for (Index corner = mesh.next(h); corner != end; corner = mesh.next(corner))
      ring.push_back(mesh.origin(corner));
  });
}

/// Adds the rings of the ring, each vertex once and none of them v.
void widen(const Mesh& mesh, Index v, std::vector<Index>& ring) {
  const std::vector<Index> inner = ring;
  for (const Index w : inner) append_ring(mesh, w, ring);
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  ring.erase(std::remove(ring.begin(), ring.end(), v), ring.end());
}

/// Along the sum of the faces' normals, weighted by what each face turns about v. Zero where that
/// is no more than rounding.
Vector3d normal_at(const Mesh& mesh, const std::vector<Point3>& positions, Index v,
                   std::vector<std::array<double, 3>>& chain) {
  chain.clear();
  double size = 0;
  const Point3 from = positions[static_cast<std::size_t>(v)];
  const auto add = [&](Index w) {
    const Point3 to = positions[static_cast<std::size_t>(w)], spoke = to - from;
    chain.push_back({spoke.x, spoke.y, spoke.z});
    size = std::max({size, std::abs(to.x), std::abs(to.y), std::abs(to.z)});
  };
  const Index first = mesh.halfedge_of_vertex(v);
  Index last = first;
  visit_spokes(mesh, v, [&](Index h) {
    add(mesh.target(h));
    last = h;
  });
  add(mesh.origin(mesh.prev(last)));  // the first again, or the other end of the boundary
  const std::array<double, 3> normal = mesh::unit_normal<double>(chain, size);
  return {normal[0], normal[1], normal[2]};
}

/// The tensor of a graph over the plane at the origin, from its slopes and second derivatives
/// there; the last of the orthonormal axes is the normal of the plane.
SecondForm form_of_graph(const Eigen::Matrix3d& axes, const Vector2d& slopes,
                         const Matrix2d& second) {
  const Matrix<double, 3, 2> tangents = axes.leftCols<2>() + axes.col(2) * slopes.transpose();
  const Vector3d normal = axes.col(2) - axes.leftCols<2>() * slopes;
  const double length = normal.norm();
  const Matrix<double, 3, 2> dual = tangents * (tangents.transpose() * tangents).inverse();
  return {dual * (second / length) * dual.transpose(), normal / length, true, 0};
}

class Fit {
 public:
  Fit(const Mesh& mesh, const std::vector<Point3>& positions)
      : mesh_(mesh), positions_(positions) {}

  SecondForm at(Index v) {
    if (mesh_.is_isolated(v)) return {};
    const Vector3d normal = normal_at(mesh_, positions_, v, chain_);
    if (normal.isZero(0)) return {};
    axes_.col(2) = normal;
    axes_.col(0) = axes_.col(2).unitOrthogonal();
    axes_.col(1) = axes_.col(2).cross(axes_.col(0));
    ring_.clear();
    append_ring(mesh_, v, ring_);
    SecondForm form = of_ring(v);
    if (form.known) return form;
    widen(mesh_, v, ring_);
    return of_ring(v);
  }

 private:
  [[nodiscard]] Vector3d offset(Index v, Index w) const {
    return axes_.transpose() * vector_of(positions_[static_cast<std::size_t>(w)] -
                                         positions_[static_cast<std::size_t>(v)]);
  }

  /// The root of the ring's covariance in the tangent plane: in its inverse's coordinates the ring
  /// is as wide as it is long, so that stretched meshes are fitted as well as others.
  [[nodiscard]] Matrix2d width_of_ring(Index v) const {
    Matrix2d covariance = Matrix2d::Zero();
    for (const Index w : ring_) {
      const Vector2d p = offset(v, w).head<2>();
      covariance += p * p.transpose() / static_cast<double>(ring_.size());
    }
    return covariance.llt().matrixL();
  }

  [[nodiscard]] SecondForm of_ring(Index v) const {
    if (ring_.size() < kUnknowns) return {};
    const Matrix2d width = width_of_ring(v);
    if (!(width.diagonal().minCoeff() > kWorstWidths * width.diagonal().maxCoeff())) return {};
    const auto narrow = width.triangularView<Eigen::Lower>();
    Matrix<double, kUnknowns, kUnknowns> normal_matrix;
    normal_matrix.setZero();
    Matrix<double, kUnknowns, 1> right;
    right.setZero();
    for (const Index w : ring_) {
      const Vector3d p = offset(v, w);
      const Vector2d q = narrow.solve(p.head<2>());
      Matrix<double, kUnknowns, 1> row;
      row << q.x(), q.y(), q.x() * q.x() / 2, q.x() * q.y(), q.y() * q.y() / 2;
      normal_matrix += row * row.transpose();
      right += p.z() * row;
    }
    const Eigen::LDLT<Matrix<double, kUnknowns, kUnknowns>> solver(normal_matrix);
    const auto pivots = solver.vectorD();
    if (!(pivots.minCoeff() > kWorstPivots * pivots.maxCoeff())) return {};
    const Matrix<double, kUnknowns, 1> c = solver.solve(right);
    if (!c.allFinite()) return {};
    const Matrix2d back = width.inverse();
    Matrix2d second;
    second << c[2], c[3], c[3], c[4];
    SecondForm form =
        form_of_graph(axes_, back.transpose() * c.head<2>(), back.transpose() * second * back);
    // in the fit's coordinates the ring is about 1 wide
    form.gain = back.squaredNorm();
    return form;
  }

  const Mesh& mesh_;
  const std::vector<Point3>& positions_;
  Eigen::Matrix3d axes_;
  std::vector<Index> ring_;
  std::vector<std::array<double, 3>> chain_;
};

}  // namespace

std::vector<SecondForm> approx_second_forms(const Mesh& mesh,
                                            const std::vector<Point3>& positions) {
  std::vector<SecondForm> forms(positions.size());
  constexpr std::ptrdiff_t kGrain = 512;
  base::parallel_for(
      Index{0}, mesh.vertex_count(),
      [&](Index first, Index last) {
        Fit fit(mesh, positions);
        for (Index v = first; v < last; ++v) forms[static_cast<std::size_t>(v)] = fit.at(v);
      },
      kGrain);
  return forms;
}

}  // namespace limn::fairness
