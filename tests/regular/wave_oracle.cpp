#include "regular/wave_oracle.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include "limn/regular/regular_mask.h"
#include "support/shipped.h"

namespace limn::test {

Place plane(Lattice lattice, Place c) {
  if (lattice == Lattice::quad) return c;
  return {c[0] - c[1] / 2, c[1] * kSqrt3 / 2};
}

Complex wave(Frequency g, Place x) {
  return std::polar(1., 2 * std::numbers::pi * (g[0] * x[0] + g[1] * x[1]));
}

Frequency frequency_along(Lattice lattice, double a, double b) {
  if (lattice == Lattice::quad) return {a, b};
  return {a, (b + a / 2) * 2 / kSqrt3};
}

std::vector<Frequency> some_frequencies(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Frequency> all;
  const auto draw = [&] { return (random() % 100001 / 100000. - 0.5) * 1.3; };
  for (int i = 0; i < count; ++i) {
    const double x = draw();
    all.push_back({x, draw()});
  }
  return all;
}

const Mask& shipped_mask(const std::string& scheme) {
  static std::map<std::string, Mask> known;
  const auto found = known.find(scheme);
  if (found != known.end()) return found->second;
  return known.emplace(scheme, regular_mask(shipped(scheme)).value()).first->second;
}

ArtifactAnalysis analysis_of(const Mask& mask) {
  Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(mask);
  EXPECT_TRUE(analysis.ok()) << analysis.error().text();
  return std::move(analysis).value();
}

const ArtifactAnalysis& shipped_analysis(const std::string& scheme) {
  static std::map<std::string, ArtifactAnalysis> known;
  const auto found = known.find(scheme);
  if (found != known.end()) return found->second;
  return known.emplace(scheme, analysis_of(shipped_mask(scheme))).first->second;
}

std::vector<Mask> random_masks(unsigned seed) {
  // each turns and stretches its lattice: √3 and √7 go with triangles, √2 and √5 with squares
  const std::map<Lattice, std::vector<LatticeMatrix>> dilations = {
      {Lattice::triangle,
       {{{{{2, 0}, {0, 2}}}}, {{{{3, 0}, {0, 3}}}}, {{{{2, -1}, {1, 1}}}}, {{{{3, -1}, {1, 2}}}}}},
      {Lattice::quad,
       {{{{{-2, 0}, {0, 2}}}},
        {{{{0, 3}, {3, 0}}}},
        {{{{1, 1}, {1, -1}}}},
        {{{{1, -2}, {2, 1}}}}}}};
  std::vector<Mask> masks;
  for (const auto& [lattice, all] : dilations)
    for (const LatticeMatrix& dilation : all)
      masks.push_back(random_mask(lattice, dilation, seed++));
  return masks;
}

std::vector<std::pair<std::string, Mask>> many_masks() {
  std::vector<std::pair<std::string, Mask>> masks = {{"ternary", ternary_box_spline()},
                                                     {"quincunx", quincunx()}};
  for (const std::string& name : lattice_names()) masks.emplace_back(name, shipped_mask(name));
  const std::vector<std::pair<std::string, std::vector<std::string>>> others = {
      {"box-spline-quad", {"i=2", "j=2", "p=1", "q=1"}},
      {"box-spline-quad", {"i=3", "j=1", "p=0", "q=1"}},
      {"box-spline-triangle", {"i=3", "j=1", "k3=1"}},
      {"box-spline-triangle", {"i=4", "j=2", "k3=4"}},
      {"laplacian-butterfly", {"b=3/16"}},
      {"butterfly", {"w=1/20"}},
      {"laplacian-loop", {"a=-1/9"}}};
  for (const auto& [name, parameters] : others) {
    Scheme scheme = shipped(name);
    const Status set = set_parameters(scheme, parameters);
    EXPECT_TRUE(set.ok()) << set.error().text();
    masks.emplace_back(name + ", " + parameters[0], regular_mask(scheme).value());
  }
  for (const Mask& mask : random_masks(5)) masks.emplace_back("random", mask);
  return masks;
}

bool is_dual(const Mask& mask) {
  const auto& [offset, value] = *mask.coefficients.begin();
  return offset[0] % 2 != 0 || offset[1] % 2 != 0;
}

bool divides(const LatticeMatrix& m, LatticeVector k, LatticeVector& quotient) {
  const auto& [top, bottom] = m.rows;
  const int det = top[0] * bottom[1] - top[1] * bottom[0];
  const int x = bottom[1] * k[0] - top[1] * k[1], y = top[0] * k[1] - bottom[0] * k[0];
  quotient = {x / det, y / det};
  return x % det == 0 && y % det == 0;
}

std::vector<LatticeVector> class_members(const LatticeMatrix& dilation) {
  std::vector<LatticeVector> members;
  const int growth = std::abs(dilation.rows[0][0] * dilation.rows[1][1] -
                              dilation.rows[0][1] * dilation.rows[1][0]);
  for (int y = 0; y < growth; ++y) {
    for (int x = 0; x < growth; ++x) {
      bool is_new = true;
      LatticeVector ignored{};
      for (const LatticeVector& m : members)
        is_new = is_new && !divides(dilation, {x - m[0], y - m[1]}, ignored);
      if (is_new) members.push_back({x, y});
    }
  }
  EXPECT_EQ(static_cast<int>(members.size()), growth);
  return members;
}

Complex refined_wave(const Mask& mask, Frequency f, LatticeVector doubled) {
  Complex sum = 0;
  for (const auto& [offset, value] : mask.coefficients) {
    LatticeVector j{};
    const LatticeVector twice{doubled[0] - offset[0], doubled[1] - offset[1]};
    if (divides(mask.dilation, {twice[0] / 2, twice[1] / 2}, j))
      sum += to_double(value) * wave(f, plane(mask.lattice, {1. * j[0], 1. * j[1]}));
  }
  return sum;
}

Place refined_place(const Mask& mask, LatticeVector doubled) {
  const auto& [top, bottom] = mask.dilation.rows;
  const double twice_det = 2. * (top[0] * bottom[1] - top[1] * bottom[0]);
  return plane(mask.lattice, {(bottom[1] * doubled[0] - top[1] * doubled[1]) / twice_det,
                              (top[0] * doubled[1] - bottom[0] * doubled[0]) / twice_det});
}

std::vector<double> fitted_amplitudes(const Mask& mask, Frequency f,
                                      const std::vector<Frequency>& waves, int shift) {
  const std::vector<LatticeVector> members = class_members(mask.dilation);
  const auto size = static_cast<Eigen::Index>(members.size());
  EXPECT_EQ(waves.size(), members.size());
  Eigen::MatrixXcd matrix(size, size);
  Eigen::VectorXcd values(size);
  const int odd = is_dual(mask) ? 1 : 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const LatticeVector member = members[static_cast<std::size_t>(i)];
    const LatticeVector away = {shift * static_cast<int>(i), 2 * shift - static_cast<int>(i)};
    const auto& [top, bottom] = mask.dilation.rows;
    const LatticeVector doubled = {
        2 * (member[0] + top[0] * away[0] + top[1] * away[1]) + odd,
        2 * (member[1] + bottom[0] * away[0] + bottom[1] * away[1]) + odd};
    const Place x = refined_place(mask, doubled);
    for (Eigen::Index c = 0; c < size; ++c)
      matrix(i, c) = wave(waves[static_cast<std::size_t>(c)], x);
    values(i) = refined_wave(mask, f, doubled);
  }
  const Eigen::VectorXcd solved = matrix.fullPivLu().solve(values);
  std::vector<double> amplitudes;
  for (const Complex& amplitude : solved) {
    EXPECT_NEAR(amplitude.imag(), 0, 1e-12);
    amplitudes.push_back(amplitude.real());
  }
  return amplitudes;
}

std::vector<double> all(const Components& components) {
  std::vector<double> values = {components.signal};
  values.insert(values.end(), components.artifacts.begin(), components.artifacts.end());
  return values;
}

std::vector<Frequency> all_frequencies(const ArtifactAnalysis& analysis, Frequency f) {
  std::vector<Frequency> waves = {f};
  for (const Frequency& g : analysis.artifact_frequencies(f)) waves.push_back(g);
  return waves;
}

double distance(const std::vector<double>& a, const std::vector<double>& b, bool up_to_sign) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = up_to_sign ? std::abs(a[i]) - std::abs(b[i]) : a[i] - b[i];
    largest = std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                     : std::max(largest, std::abs(difference));
  }
  return largest;
}

Mask ternary_box_spline() {
  Laurent product = {{{0, 0}, Rational(1, 81)}};  // 9 / 3^6
  for (const LatticeVector d : {LatticeVector{1, 0}, {0, 1}, {1, 1}}) {
    for (int twice = 0; twice < 2; ++twice) {
      Laurent longer;
      for (const auto& [k, value] : product)
        for (int i = -1; i <= 1; ++i) longer[{k[0] + 2 * i * d[0], k[1] + 2 * i * d[1]}] += value;
      product = longer;
    }
  }
  return {Lattice::triangle, {{{{3, 0}, {0, 3}}}}, product};
}

Mask quincunx() {
  Mask mask{Lattice::quad, {{{{1, 1}, {1, -1}}}}, {{{0, 0}, Rational(1)}}};
  for (const Exponents k : {Exponents{2, 0}, {-2, 0}, {0, 2}, {0, -2}})
    mask.coefficients[k] = Rational(1, 4);
  return mask;
}

Mask random_mask(Lattice lattice, const LatticeMatrix& dilation, unsigned seed) {
  std::mt19937 random(seed);
  Laurent weights;
  for (int x = 0; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      const Rational w(1 + static_cast<int>(random() % 19), 7);
      weights[{2 * x, 2 * y}] = weights[{-2 * x, -2 * y}] = w;
    }
  }
  // divide each class, and so its mirror image, by its sum
  Mask mask{lattice, dilation, {}};
  for (const LatticeVector& member : class_members(dilation)) {
    Laurent of_class;
    Rational sum = 0;
    for (const auto& [k, value] : weights) {
      LatticeVector ignored{};
      if (!divides(dilation, {k[0] / 2 - member[0], k[1] / 2 - member[1]}, ignored)) continue;
      of_class[k] = value;
      sum += value;
    }
    for (const auto& [k, value] : of_class) mask.coefficients[k] = value / sum;
  }
  return mask;
}

}  // namespace limn::test
