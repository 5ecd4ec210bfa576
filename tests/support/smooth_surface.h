#pragma once
/// Parametrized surfaces with exact derivatives, and the integrals over them by quadrature: what
/// sampled meshes are measured against.

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>

namespace limn::test {

/// d[i][j]: the i-th derivative by u and j-th by v, for i + j ≤ 3.
struct Derivatives {
  std::array<std::array<Eigen::Vector3d, 4>, 4> d;
};

/// Per unit of u and v: area, ‖II‖² and ‖∇II‖² times it.
struct Densities {
  double area = 0, thin_plate = 0, variation = 0;
};

/// By first and second fundamental forms and Christoffel symbols, from the derivatives alone:
/// II_ij;k = S_ijk·N − Γ^m_ij II_mk − Γ^m_jk II_mi − Γ^m_ki II_mj.
inline Densities densities(const Derivatives& s) {
  const auto d1 = [&](int i) { return s.d[i == 0][i == 1]; };
  const auto d2 = [&](int i, int j) {
    const auto v = static_cast<std::size_t>(i + j);
    return s.d[2 - v][v];
  };
  const auto d3 = [&](int i, int j, int k) {
    const auto v = static_cast<std::size_t>(i + j + k);
    return s.d[3 - v][v];
  };
  const Eigen::Vector3d cross = d1(0).cross(d1(1));
  const Eigen::Vector3d normal = cross.normalized();
  Eigen::Matrix2d metric;
  Eigen::Matrix2d form;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      metric(i, j) = d1(i).dot(d1(j));
      form(i, j) = d2(i, j).dot(normal);
    }
  const Eigen::Matrix2d inverse = metric.inverse();
  const auto christoffel_form = [&](int i, int j, int k) {  // Γ^m_ij II_mk
    const Eigen::Vector2d low(d2(i, j).dot(d1(0)), d2(i, j).dot(d1(1)));
    return (inverse * low).dot(form.col(k));
  };
  std::array<Eigen::Matrix2d, 2> derivative;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        derivative[static_cast<std::size_t>(k)](i, j) =
            d3(i, j, k).dot(normal) - christoffel_form(i, j, k) - christoffel_form(j, k, i) -
            christoffel_form(k, i, j);
  double variation = 0;
  for (int k = 0; k < 2; ++k)
    for (int l = 0; l < 2; ++l)
      variation += inverse(k, l) * (inverse * derivative[static_cast<std::size_t>(k)] * inverse *
                                    derivative[static_cast<std::size_t>(l)])
                                       .trace();
  const double area = cross.norm();
  return {area, area * (inverse * form * inverse * form).trace(), area * variation};
}

/// Of surface(u, v) → Derivatives over a rectangle, by the midpoint rule.
template <class Surface>
Densities integrals(Surface surface, std::array<double, 2> u, std::array<double, 2> v, int steps) {
  Densities sum;
  const double du = (u[1] - u[0]) / steps;
  const double dv = (v[1] - v[0]) / steps;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const Densities at = densities(surface(u[0] + (i + .5) * du, v[0] + (j + .5) * dv));
      sum.area += at.area * du * dv;
      sum.thin_plate += at.thin_plate * du * dv;
      sum.variation += at.variation * du * dv;
    }
  return sum;
}

/// (a (R + r cos v) cos u, b (R + r cos v) sin u, c r sin v): a torus, or for R = 0 an ellipsoid.
struct Tube {
  double large = 2, small = 1;
  Eigen::Vector3d scale{1, 1, 1};

  [[nodiscard]] Eigen::Vector3d at(double u, double v) const { return (*this)(u, v).d[0][0]; }
  [[nodiscard]] Derivatives operator()(double u, double v) const {
    // each derivative of a cosine is a quarter turn of its phase
    constexpr double kQuarter = std::numbers::pi / 2;
    Derivatives s;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; i + j < 4; ++j) {
        const double du = u + static_cast<double>(i) * kQuarter;
        const double dv = v + static_cast<double>(j) * kQuarter;
        const double width = (j == 0 ? large : 0) + small * std::cos(dv);
        s.d[i][j] = Eigen::Vector3d(width * std::cos(du), width * std::sin(du),
                                    i == 0 ? small * std::sin(dv) : 0)
                        .cwiseProduct(scale);
      }
    return s;
  }
};

}  // namespace limn::test
