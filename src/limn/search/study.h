#pragma once
/// A study: a scheme with free numbers, what is asked of it, and how it is searched for. One TOML
/// file; docs/studies.md explains it to users.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/scheme/scheme.h"
#include "limn/search/quantity.h"
#include "limn/search/scheme_reading.h"
#include "limn/tune/freed_scheme.h"

namespace limn::search {

/// One number that the search moves, low < high.
struct Coordinate {
  std::string name;             ///< the parameter or let
  std::optional<int> valence;   ///< where it has this number; nothing: everywhere
  Rational low, high;           ///< both as the file says, or the nearest doubles
  int steps = 0;                ///< of a grid: so many values, both ends among them; at least 2
  std::optional<Rational> own;  ///< the scheme's own value, if it lies between the ends

  /// "b", "beta@5"
  [[nodiscard]] std::string label() const;
};

/// What is to be made small or large.
struct Objective {
  Quantity value;
  bool maximise = false;
};

/// What must hold.
struct Demand {
  std::string text;  ///< as it was written, with bounds
  /// Asked at each of the study's valences: a verdict, an inequality, an equation (to 1e-8).
  std::optional<Requirement> at_vertices;
  bool certified = false;         ///< proved in ball arithmetic, on the lattice and at each valence
  std::optional<Quantity> value;  ///< or: bounds of a quantity
  std::optional<double> at_least, at_most;  ///< of `value`
};

enum class MethodKind {
  grid,    ///< every combination of the coordinates' steps
  random,  ///< evenly distributed, independent points
  sobol,   ///< a low-discrepancy sequence
  local,   ///< from some points downhill (NLopt's Sbplx)
  global,  ///< CMA-ES by generations, one objective (pagmo)
  pareto   ///< NSGA-II by generations, several objectives (pagmo)
};
/// "grid", …
[[nodiscard]] std::string_view to_string(MethodKind kind);

struct MethodChoice {
  MethodKind kind = MethodKind::sobol;
  std::uint64_t seed = 1;
  long long points =
      1000;        ///< the search ends with the generation that reaches so many; of a grid all
  int batch = 32;  ///< points of a generation, which may be evaluated at once
};

/// A scheme to draw beside what is found.
struct Landmark {
  std::string label;
  Scheme scheme;
};

struct Study {
  std::string title;
  std::string file;           ///< path, as it was given
  std::string text;           ///< of the file
  std::string folder;         ///< of the file; "" the current one
  std::string scheme_name;    ///< as the file has it: what a scheme file beside it may extend
  Scheme scheme;              ///< with the fixed parameters set
  std::vector<int> valences;  ///< ascending
  std::vector<Coordinate> coordinates;
  std::vector<Objective> objectives;  ///< at least one
  std::vector<Demand> demands;
  MethodChoice method;
  Effort effort;
  std::vector<Landmark> landmarks;

  /// All that the results depend on but the number of points, which may be raised later: two
  /// studies with the same identity share their points.
  [[nodiscard]] std::string identity() const;
  /// The files beside it that it was read from, by paths as they were opened, sorted: schemes,
  /// meshes. With them it can be read on another machine.
  [[nodiscard]] std::vector<std::string> files() const;
  /// How hard proofs are searched for, and whether of curvature: only where that is demanded, as it
  /// may cost far more than all else.
  [[nodiscard]] certify::CertifyOptions certify_options() const;
};

/// Reads a study. All faults at once, with line, column and remedy. `path`: for messages; schemes
/// and meshes are looked for from its folder.
[[nodiscard]] Result<Study> parse_study(std::string_view text, const std::string& path);
[[nodiscard]] Result<Study> read_study(const std::string& path);

}  // namespace limn::search
