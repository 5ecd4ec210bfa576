#include "support/triangle_rules.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;

double loop_beta(int n) {
  const double lambda = 3 / 8. + std::cos(2 * kPi / n) / 4;
  return (5 / 8. - lambda * lambda) / n;
}
double warren_beta(int n) { return n == 3 ? 3 / 16. : 3 / (8. * n); }
double optimal_beta(int n) {
  const double lambda = 1 / 3. + std::cos(2 * kPi / n) / 3;
  return (2 / 3. - lambda * lambda) / n;
}
double optimal_high_beta(int n) { return (2 / 3. - (1 / 3. + std::cos(3 * kPi / n) / 3)) / n; }
double optimal_low_beta(int n) { return 33 / 64. / n; }
double no_beta(int) { return 0; }

double zorin_weight(int n, int k) {
  if (n == 3) return k == 0 ? 5 / 12. : -1 / 12.;
  if (n == 4) return k == 0 ? 3 / 8. : k == 2 ? -1 / 8. : 0;
  return (1 / 4. + std::cos(2 * kPi * k / n) + std::cos(4 * kPi * k / n) / 2) / n;
}

/// As in the modified butterfly.
const TriangleRules::Ends kZorin{[](int n) { return n != 6; }, [](int) { return 3 / 4.; },
                                 zorin_weight};

/// [BGSK Fig. 1] Loop with other eigenvalues at valence 7: the cup's, and those of frequencies 1,
/// 2, 3.
TriangleRules at_seven(double cup, const std::array<double, 3>& eigenvalues) {
  const auto beta = [cup](int n) { return n == 7 ? (5 / 8. - cup) / 7 : loop_beta(n); };
  const auto spoke = [eigenvalues](int, int k) {
    double sum = 5 / 8.;
    for (int frequency = 1; frequency < 7; ++frequency)
      sum += eigenvalues[static_cast<std::size_t>(std::min(frequency, 7 - frequency) - 1)] *
             std::cos(2 * kPi * frequency * k / 7);
    return sum / 7;
  };
  return {beta,
          3 / 8.,
          1 / 8.,
          0,
          0,
          {},
          TriangleRules::Ends{[](int n) { return n == 7; }, [](int) { return 3 / 8.; }, spoke}};
}

/// [Barthe, Kobbelt 2004] a row for each valence: the vertex's own weight; on its edges that of the
/// vertex and a wing's. The far end has the rest; elsewhere all is Loop's.
struct TunedWeights {
  double vertex, end, wing;
};
using TunedTable = std::map<int, TunedWeights>;

TriangleRules tuned(const TunedTable& table) {
  const auto beta = [table](int n) {
    const auto row = table.find(n);
    return row == table.end() ? loop_beta(n) : (1 - row->second.vertex) / n;
  };
  const auto spoke = [table](int n, int k) {
    const TunedWeights& row = table.at(n);
    if (k == 0) return 1 - row.end - 2 * row.wing;
    return k == 1 || k == n - 1 ? row.wing : 0.;
  };
  return {beta,
          3 / 8.,
          1 / 8.,
          0,
          0,
          {},
          TriangleRules::Ends{[table](int n) { return table.count(n) > 0; },
                              [table](int n) { return table.at(n).end; }, spoke}};
}

TunedTable regularity_table() {
  return {{3, {.32517, .15658, .14427}},  {4, {.49954, .25029, .12524}},
          {5, {.59549, .34547, .11182}},  {7, {.63873, .38877, .14771}},
          {8, {.64643, .39644, .1768}},   {9, {.65127, .40132, .21092}},
          {10, {.67358, .42198, .20354}}, {11, {.68678, .43423, .20505}},
          {12, {.69908, .44579, .19828}}};
}

TunedTable continuity_table() {
  return {
      {3, {.32517, .15658, .14427}}, {4, {.50033, .26721, .12495}},  {5, {.59464, .33539, .11252}},
      {7, {.63903, .36909, .14673}}, {8, {.67821, .25579, .16074}},  {9, {.6866, .2521, .18939}},
      {10, {.69248, .24926, .2222}}, {11, {.69678, .24706, .25894}}, {12, {.70014, .2452, .29934}}};
}

/// [KS §3.1] a times (1, -1/n, …) added; their own a(n) where no other is given.
TriangleRules high_pass(std::optional<double> a) {
  const auto beta = [a](int n) {
    const double theirs = n * loop_beta(n) - 1 / 4. + std::cos(3 * kPi / n) / 4;
    return loop_beta(n) - a.value_or(theirs) / n;
  };
  return {beta, 3 / 8., 1 / 8., 0, 0, {}, {}};
}

/// [KS §3.2] blended with (1/2, 1/(2n), …).
TriangleRules low_pass(double a) {
  const auto beta = [a](int n) { return (1 - a) * loop_beta(n) + a / (2 * n); };
  return {beta, 3 / 8., 1 / 8., 0, 0, {}, {}};
}

/// [KS §5.1] edge weights b and 1/2 - b; the cup's eigenvalue is the tangent's square.
TriangleRules loop_type(double b) {
  const double c = 1 / 2. - b;
  const auto beta = [b, c](int n) {
    const double tangent = b + 2 * c * std::cos(2 * kPi / n);
    return (b + 2 * c - tangent * tangent) / n;
  };
  return {beta, b, c, 0, 0, {}, {}};
}

TriangleRules butterfly(double w, bool zorin) {
  return {no_beta, 1 / 2., 2 * w, -w, 0, w, zorin ? std::optional(kZorin) : std::nullopt};
}

/// [KS §4] the butterfly blended with the mean of the ends' stencils (1/2 and six of 1/12).
TriangleRules low_pass_butterfly(double b) {
  return {no_beta,
          (1 - b) / 2 + b * (1 / 4. + 1 / 24.),
          (1 - b) / 8 + b * (1 / 12.),
          (1 - b) / -16 + b * (1 / 24.),
          b * (1 / 24.),
          1 / 16.,
          kZorin};
}

}  // namespace

std::optional<TriangleRules> triangle_rules(const std::string& scheme, std::optional<double> x) {
  static const std::map<std::string, TriangleRules> kWithoutParameter{
      {"loop", {loop_beta, 3 / 8., 1 / 8., 0, 0, {}, {}}},
      {"box-spline-triangle", {loop_beta, 3 / 8., 1 / 8., 0, 0, {}, {}}},
      {"loop-warren", {warren_beta, 3 / 8., 1 / 8., 0, 0, {}, {}}},
      {"loop-piecewise-smooth", {warren_beta, 3 / 8., 1 / 8., 0, 0, {}, {}}},
      {"optimal", {optimal_beta, 1 / 3., 1 / 6., 0, 0, {}, {}}},
      {"optimal-high", {optimal_high_beta, 1 / 3., 1 / 6., 0, 0, {}, {}}},
      {"optimal-low", {optimal_low_beta, 1 / 3., 1 / 6., 0, 0, {}, {}}},
      {"loop-7-bounded", at_seven(1 / 4., {1 / 2., 1 / 4., 1 / 8.})},
      {"loop-7-shrinking", at_seven(1 / 4., {1 / 4., 1 / 2., 1 / 8.})},
      {"loop-7-flat", at_seven(1 / 4., {1 / 2., 1 / 8., 1 / 4.})},
      {"loop-tuned-regularity", tuned(regularity_table())},
      {"loop-tuned-continuity", tuned(continuity_table())},
      {"interpolating-loop", {no_beta, 33 / 64., 6 / 64., -3 / 64., -1 / 64., 1 / 16., kZorin}},
  };
  if (const auto found = kWithoutParameter.find(scheme); found != kWithoutParameter.end())
    return found->second;
  if (scheme == "laplacian-loop") return high_pass(x);
  if (scheme == "laplacian-loop-low") return low_pass(x.value_or(1));
  if (scheme == "loop-type") return loop_type(x.value_or(3 / 8.));
  if (scheme == "butterfly") return butterfly(x.value_or(1 / 16.), false);
  if (scheme == "butterfly-modified") return butterfly(x.value_or(1 / 16.), true);
  if (scheme == "laplacian-butterfly") return low_pass_butterfly(x.value_or(1 / 8.));
  return std::nullopt;
}

}  // namespace limn::test
