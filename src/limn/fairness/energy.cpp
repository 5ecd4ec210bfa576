#include "limn/fairness/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <Eigen/Geometry>

#include "limn/base/parallel.h"
#include "limn/fairness/rounding.h"
#include "limn/fairness/second_form.h"
#include "limn/mesh/unit_normal.h"

namespace limn {
namespace {

using Eigen::Vector3d;

struct Corner {
  Vector3d position;
  Eigen::Matrix3d tensor;
  double gain = 0;
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

/// What a unit of error in the positions makes of the variation's square root over a triangle.
double variation_gain(const std::array<Corner, 3>& corners, double doubled_area) {
  double longest = 0, gain = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, (corners[i].position - corners[(i + 1) % 3].position).norm());
    gain = std::max(gain, corners[i].gain);
  }
  return gain * longest / doubled_area;  // the steepest gradient of an interpolant
}

/// Adds a triangle; `known` is whether the corners' tensors are. Noise is what one unit of error in
/// each position makes alone, to be multiplied by that error's square (area: by the error).
void add_triangle(const std::array<Corner, 3>& corners, bool known, SurfaceEnergies& sum) {
  const Vector3d first = corners[1].position - corners[0].position;
  const Vector3d second = corners[2].position - corners[0].position;
  const Vector3d normal = first.cross(second);
  const double area = normal.norm() / 2;
  sum.rounding.area += first.norm() + second.norm();
  if (!(area > 0)) return;
  sum.area += area;
  if (!known) return;
  double squares = 0, gains = 0;
  for (const Corner& corner : corners) {
    squares += corner.tensor.squaredNorm();
    gains += corner.gain * corner.gain;
  }
  sum.thin_plate += area * squares / 3;
  sum.rounding.thin_plate += area * gains / 3;
  const double variation = area * squared_derivative(corners, normal);
  const double gain = variation_gain(corners, 2 * area);
  const double noise = area * gain * gain;
  // not of a needle whose area is no more than rounding
  if (!std::isfinite(variation) || !std::isfinite(noise)) return;
  sum.curvature_variation += variation;
  sum.rounding.curvature_variation += noise;
}

class FaceSum {
 public:
  FaceSum(const Mesh& mesh, const std::vector<Point3>& positions,
          const std::vector<fairness::SecondForm>& forms)
      : mesh_(mesh), positions_(positions), forms_(forms) {}

  void add(Index f, SurfaceEnergies& sum) const {
    const Index begin = mesh_.face_begin(f);
    const Index end = mesh_.face_begin(f + 1);
    bool known = true;
    Corner mean{Vector3d::Zero(), Eigen::Matrix3d::Zero(), 0};
    for (Index h = begin; h < end; ++h) {
      const Corner one = corner(h);
      mean.position += one.position / (end - begin);
      mean.tensor += one.tensor / (end - begin);
      mean.gain = std::max(mean.gain, one.gain);
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
    return {{positions_[v].x, positions_[v].y, positions_[v].z}, forms_[v].tensor, forms_[v].gain};
  }

  const Mesh& mesh_;
  const std::vector<Point3>& positions_;
  const std::vector<fairness::SecondForm>& forms_;
};

Status check_finite(const std::vector<Point3>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Point3& p = positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return Error{fmt::format("the position of vertex {} is not finite", v)};
  }
  return Done{};
}

void add(SurfaceEnergies& total, const SurfaceEnergies& sum) {
  total.area += sum.area;
  total.thin_plate += sum.thin_plate;
  total.curvature_variation += sum.curvature_variation;
  total.left_out += sum.left_out;
  total.rounding.area += sum.rounding.area;
  total.rounding.thin_plate += sum.rounding.thin_plate;
  total.rounding.curvature_variation += sum.rounding.curvature_variation;
}

/// Noise of unit errors becomes what errors of these positions may change.
void set_rounding(double size, SurfaceEnergies& energies) {
  const double error = fairness::kPositionUnits * std::numeric_limits<double>::epsilon() * size;
  SurfaceEnergies::Rounding& rounding = energies.rounding;
  rounding.area *= error;
  rounding.thin_plate =
      fairness::rounding_of_squares(energies.thin_plate, error * error * rounding.thin_plate);
  rounding.curvature_variation = fairness::rounding_of_squares(
      energies.curvature_variation, error * error * rounding.curvature_variation);
}

/// Of positions whose products are neither lost nor too large.
SurfaceEnergies energies_of(const Mesh& mesh, const std::vector<Point3>& positions) {
  const std::vector<fairness::SecondForm> forms = fairness::approx_second_forms(mesh, positions);
  const FaceSum faces(mesh, positions, forms);
  constexpr std::ptrdiff_t kGrain = 512;
  // one slot a chunk, so that the sums depend on no thread
  std::vector<SurfaceEnergies> sums(static_cast<std::size_t>(mesh.face_count() / kGrain + 1));
  base::parallel_for(
      Index{0}, mesh.face_count(),
      [&](Index first, Index last) {
        SurfaceEnergies& sum = sums[static_cast<std::size_t>(first / kGrain)];
        for (Index f = first; f < last; ++f) faces.add(f, sum);
      },
      kGrain);
  SurfaceEnergies total;
  for (const SurfaceEnergies& sum : sums) add(total, sum);
  return total;
}

}  // namespace

double fairness::rounding_of_squares(double sum, double noise) {
  return 2 * std::sqrt(sum) * std::sqrt(noise) + noise;
}

Result<SurfaceEnergies> approx_energies(const Mesh& mesh, const std::vector<Point3>& positions) {
  if (Status status = check_finite(positions); !status) return status.error();
  const int exponent = mesh::largest_exponent(numbers_of(positions));
  if (exponent == mesh::kNoExponent) return energies_of(mesh, positions);
  const double size = std::ldexp(1.0, exponent);
  constexpr int kSafe = 64;  // squares of squares of such numbers are far from the ends
  if (std::abs(exponent) <= kSafe) {
    SurfaceEnergies energies = energies_of(mesh, positions);
    set_rounding(size, energies);
    return energies;
  }
  SurfaceEnergies energies = energies_of(mesh, mesh::scaled(positions, -exponent));
  set_rounding(1, energies);
  energies.area = std::ldexp(energies.area, 2 * exponent);
  energies.rounding.area = std::ldexp(energies.rounding.area, 2 * exponent);
  energies.curvature_variation = std::ldexp(energies.curvature_variation, -2 * exponent);
  energies.rounding.curvature_variation =
      std::ldexp(energies.rounding.curvature_variation, -2 * exponent);
  return energies;
}

}  // namespace limn
