#pragma once
/// The weights of dyadic schemes on triangles, typed a second time, from their papers.

#include <functional>
#include <optional>
#include <string>

namespace limn::test {

/// Dyadic schemes on triangles: a vertex takes 1 - n·beta of itself and beta of each neighbour.
struct TriangleRules {
  std::function<double(int n)> beta;
  double end, wing, outer, opposite;
  std::optional<double> tension;  ///< boundary curve: four-point of this tension, or cubic B-spline
  /// Edges with a special end: its weight, and that of its neighbours counted from the edge.
  struct Ends {
    std::function<bool(int n)> special;
    std::function<double(int n)> self;
    std::function<double(int n, int k)> spoke;
  };
  std::optional<Ends> ends;
};

/// Those of a shipped scheme with its parameter, or the default of that; nothing where it is no
/// dyadic scheme on triangles.
std::optional<TriangleRules> triangle_rules(const std::string& scheme, std::optional<double> x);

}  // namespace limn::test
