#include "support/ternary_reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/old_values.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Schemes that cut triangles' edges in three. The weights of a stencil on the lattice are given
/// by how far the old vertices lie off, going round from the edge.
struct TernaryRules {
  double vertex;                                       ///< share of the neighbours' mean
  double near, far, wing, outer, far_outer, straight;  ///< a third's
  double self;                                         ///< a third's, near a special vertex
  std::function<double(int n, int k)> spoke;           ///< and that of its neighbours
  double corner, beyond, straight_on;                  ///< a face's
  std::array<double, 2> boundary_vertex;               ///< itself, either neighbour
  std::array<double, 4> boundary_third;                ///< beyond, near, far, beyond that
};

class TernaryReference : OldValues {
 public:
  TernaryReference(const Mesh& mesh, const Births& births, const std::vector<double>& old)
      : OldValues(mesh, old), births_(births) {}

  std::vector<double> make(const TernaryRules& rules) {
    for (Index v = 0; v < births_.from_vertices; ++v) {
      if (mesh_.is_isolated(v))
        push(at(v));
      else if (mesh_.is_boundary_vertex(v))
        push(rules.boundary_vertex[0] * at(v) + rules.boundary_vertex[1] * boundary_neighbours(v));
      else
        push((1 - rules.vertex) * at(v) + rules.vertex * neighbours(v) / mesh_.valence(v));
    }
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.halfedge_of_edge(e);
      push(ternary_third(rules, h, false));
      push(ternary_third(rules, h, true));
    }
    for (Index f = 0; f < mesh_.face_count(); ++f) push(ternary_face(rules, f));
    return std::move(fresh_);
  }

 private:
  [[nodiscard]] double ternary_third(const TernaryRules& rules, Index h, bool at_target) const {
    const Index v = mesh_.origin(h), w = mesh_.target(h);
    if (mesh_.twin(h) == kNone) {
      const auto& [beyond_near, near, far, beyond_far] = rules.boundary_third;
      return near * at(at_target ? w : v) + far * at(at_target ? v : w) +
             beyond_near * at(beyond(h, at_target)) + beyond_far * at(beyond(h, !at_target));
    }
    if (at_target) h = mesh_.twin(h);  // out of the near end
    const Index end = mesh_.origin(h);
    const int n = mesh_.valence(end);
    if (!mesh_.is_boundary_vertex(end) && n != 6) {
      double sum = rules.self * at(end);
      Index spoke = h;
      for (int k = 0; k < n; ++k, spoke = mesh_.rotate(spoke))
        sum += rules.spoke(n, k) * at(mesh_.target(spoke));
      return sum;
    }
    const Index t = mesh_.twin(h);
    double sum = rules.near * at(end) + rules.far * at(mesh_.target(h)) +
                 rules.wing * (at(apex(h)) + at(apex(t))) +
                 rules.outer * (across(mesh_.prev(h)) + across(mesh_.next(t))) +
                 rules.far_outer * (across(mesh_.next(h)) + across(mesh_.prev(t)));
    return sum + rules.straight * (straight_on_left(t) + straight_on_right(t)) / 2;
  }

  [[nodiscard]] double ternary_face(const TernaryRules& rules, Index f) const {
    double sum = 0;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      sum += rules.corner * at(mesh_.origin(h)) + rules.beyond * across(h);
      // straight on from the origin of h over its target, and the other way
      sum += rules.straight_on * (straight_on_left(h) + straight_back(h));
    }
    return sum;
  }

  /// Over the origin of h, three faces on from h's face.
  [[nodiscard]] double straight_back(Index h) const {
    Index side = mesh_.prev(h);  // into the origin
    for (int i = 0; i < 2; ++i) {
      if (mesh_.twin(side) == kNone) return 2 * at(mesh_.origin(h)) - at(mesh_.target(h));
      side = mesh_.prev(mesh_.twin(side));
    }
    return at(mesh_.origin(side));
  }

  void push(double value) { fresh_.push_back(value); }

  const Births& births_;
  std::vector<double> fresh_;
};

/// A ring's weights from the eigenvalues of its frequencies 0, 1, 2, … (and back from n - 1), by
/// the Fourier sum over all n of them.
double ring_weight(const std::vector<double>& eigenvalues, int n, int k) {
  double sum = 0;
  for (int frequency = 0; frequency < n; ++frequency) {
    const auto folded = static_cast<std::size_t>(std::min(frequency, n - frequency));
    if (folded < eigenvalues.size())
      sum += eigenvalues[folded] * std::cos(2 * kPi * frequency * k / n);
  }
  return sum / n;
}

std::optional<TernaryRules> ternary_rules(const std::string& scheme,
                                          std::optional<double> parameter) {
  if (scheme == "loop-ternary") {
    // frequency 3 has 1/54, and comes with no other below valence 6
    const auto spoke = [](int n, int k) {
      return n < 6 ? ring_weight({5 / 9., 1 / 3., 1 / 9.}, n, k)
                   : ring_weight({5 / 9., 1 / 3., 1 / 9., 1 / 54.}, n, k);
    };
    return TernaryRules{4 / 9.,
                        36 / 81.,
                        20 / 81.,
                        10 / 81.,
                        2 / 81.,
                        0,
                        1 / 81.,
                        4 / 9.,
                        spoke,
                        24 / 81.,
                        3 / 81.,
                        0,
                        {19 / 27., 4 / 27.},
                        {1 / 27., 16 / 27., 10 / 27., 0}};
  }
  if (scheme != "butterfly-ternary") return std::nullopt;
  // the curve scheme: weights of the points before, at, after and one more after
  const double mu = parameter.value_or(1 / 11.);
  const std::array<double, 4> a{-1 / 18. - mu / 6, 13 / 18. + mu / 2, 7 / 18. - mu / 2,
                                -1 / 18. + mu / 6};
  const auto spoke = [](int n, int k) { return ring_weight({1 / 9., 1 / 3., 1 / 9.}, n, k); };
  return TernaryRules{
      0,      a[1] + a[3], a[2] + a[0],       -(a[0] + a[3]), a[0],     a[3],     0,
      8 / 9., spoke,       (a[1] - a[3]) / 2, a[0] - a[3],    a[3] / 2, {1., 0.}, a};
}

}  // namespace

bool has_ternary_reference(const std::string& scheme) {
  return ternary_rules(scheme, {}).has_value();
}

std::vector<double> ternary_reference_step(const std::string& scheme,
                                           std::optional<double> parameter, const Mesh& mesh,
                                           const Births& births, const std::vector<double>& old) {
  return TernaryReference(mesh, births, old).make(*ternary_rules(scheme, parameter));
}

}  // namespace limn::test
