#include "limn/fairness/energy.h"

#include <array>
#include <cmath>

#include <fmt/core.h>
#include <Eigen/Geometry>

#include "limn/base/parallel.h"
#include "limn/fairness/second_form.h"

namespace limn {
namespace {

using Eigen::Vector3d;

struct Corner {
  Vector3d position;
  Eigen::Matrix3d tensor;
};

/// The squared length of the covariant derivative over a triangle: of the linear interpolant of the
/// tensors, within the triangle's plane. `normal` is twice the area long.
double squared_derivative(const std::array<Corner, 3>& corners, const Vector3d& normal) {
  const double doubled_area = normal.norm();
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = (corners[1].position - corners[0].position).normalized();
  plane.col(1) = normal.cross(plane.col(0)) / doubled_area;
  std::array<Eigen::Matrix2d, 2> derivative{Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero()};
  for (std::size_t i = 0; i < 3; ++i) {
    // the gradient of the function that is 1 at this corner and 0 at the others
    const Vector3d opposite = corners[(i + 2) % 3].position - corners[(i + 1) % 3].position;
    const Eigen::Vector2d gradient =
        plane.transpose() * normal.cross(opposite) / (doubled_area * doubled_area);
    const Eigen::Matrix2d form = plane.transpose() * corners[i].tensor * plane;
    derivative[0] += gradient[0] * form;
    derivative[1] += gradient[1] * form;
  }
  return derivative[0].squaredNorm() + derivative[1].squaredNorm();
}

/// Adds a triangle; `known` is whether the corners' tensors are.
void add_triangle(const std::array<Corner, 3>& corners, bool known, SurfaceEnergies& sum) {
  const Vector3d normal =
      (corners[1].position - corners[0].position).cross(corners[2].position - corners[0].position);
  const double area = normal.norm() / 2;
  if (!(area > 0)) return;
  sum.area += area;
  if (!known) return;
  double squares = 0;
  for (const Corner& corner : corners) squares += corner.tensor.squaredNorm();
  sum.thin_plate += area * squares / 3;
  const double variation = area * squared_derivative(corners, normal);
  // of a needle whose area is no more than rounding
  if (std::isfinite(variation)) sum.curvature_variation += variation;
}

class FaceSum {
 public:
  FaceSum(const Mesh& mesh, const std::vector<Point3>& positions,
          const std::vector<SecondForm>& forms)
      : mesh_(mesh), positions_(positions), forms_(forms) {}

  void add(Index f, SurfaceEnergies& sum) const {
    const Index begin = mesh_.face_begin(f);
    const Index end = mesh_.face_begin(f + 1);
    bool known = true;
    Corner mean{Vector3d::Zero(), Eigen::Matrix3d::Zero()};
    for (Index h = begin; h < end; ++h) {
      const Corner one = corner(h);
      mean.position += one.position / (end - begin);
      mean.tensor += one.tensor / (end - begin);
      known = known && forms_[static_cast<std::size_t>(mesh_.origin(h))].known;
    }
    if (!known) ++sum.left_out;
    if (end - begin == 3)
      add_triangle({corner(begin), corner(begin + 1), corner(begin + 2)}, known, sum);
    else
      for (Index h = begin; h < end; ++h)
        add_triangle({mean, corner(h), corner(mesh_.next(h))}, known, sum);
  }

 private:
  [[nodiscard]] Corner corner(Index h) const {
    const auto v = static_cast<std::size_t>(mesh_.origin(h));
    return {{positions_[v].x, positions_[v].y, positions_[v].z}, forms_[v].tensor};
  }

  const Mesh& mesh_;
  const std::vector<Point3>& positions_;
  const std::vector<SecondForm>& forms_;
};

Status check_finite(const std::vector<Point3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Point3& p = positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return Error{fmt::format("the position of vertex {} is not finite", v), {}, {}, 0, 0};
  }
  return Done{};
}

}  // namespace

Result<SurfaceEnergies> approx_energies(const Mesh& mesh, const std::vector<Point3>& positions) {
  if (Status status = check_finite(positions); !status) return status.error();
  const std::vector<SecondForm> forms = approx_second_forms(mesh, positions);
  const FaceSum faces(mesh, positions, forms);
  constexpr std::ptrdiff_t kGrain = 512;
  // one slot a chunk, so that the sums hang on no thread
  std::vector<SurfaceEnergies> sums(static_cast<std::size_t>(mesh.face_count() / kGrain + 1));
  parallel_for(
      Index{0}, mesh.face_count(),
      [&](Index first, Index last) {
        SurfaceEnergies& sum = sums[static_cast<std::size_t>(first / kGrain)];
        for (Index f = first; f < last; ++f) faces.add(f, sum);
      },
      kGrain);
  SurfaceEnergies total;
  for (const SurfaceEnergies& sum : sums) {
    total.area += sum.area;
    total.thin_plate += sum.thin_plate;
    total.curvature_variation += sum.curvature_variation;
    total.left_out += sum.left_out;
  }
  return total;
}

}  // namespace limn
