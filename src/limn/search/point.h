#pragma once
/// A point of a study and what is found there. What was evaluated is exactly what can be written as
/// a scheme file: coordinates are fractions.

#include <optional>
#include <string>
#include <vector>

#include "limn/base/rational.h"
#include "limn/base/truth.h"
#include "limn/search/study.h"

namespace limn::search {

/// Places in the unit cube, one for each coordinate, from 0 to 1.
using UnitPoint = std::vector<Rational>;

/// Coordinates that a search makes up are multiples of this part of their range, so that fractions
/// stay short.
inline constexpr int kUnitBits = 20;

/// The multiple of 2^-kUnitBits nearest to u, within [0, 1]. Precondition: u is not a NaN.
[[nodiscard]] Rational snapped(double u);

/// Values of the coordinates.
using Point = std::vector<Rational>;

/// low + u (high - low), exactly.
[[nodiscard]] Point point_at(const Study& study, const UnitPoint& unit);
/// "1/4 3/64": what two points share only if they are one.
[[nodiscard]] std::string point_key(const Point& point);

/// A scheme file that extends `extends` (a shipped name or a path, as the file is to say it) and
/// has the numbers of the point. `notes` says more, or nothing.
[[nodiscard]] std::string point_text(const Study& study, const Point& point,
                                     const std::string& extends, const std::string& notes = {});

/// What is known of a point. Two evaluations of a point give the same, to the last bit, but for the
/// seconds.
struct Outcome {
  bool feasible = false;  ///< everything that is demanded holds, and every objective has a value
  std::string reason;     ///< why not, the first reason
  /// How far from feasible: 0 where it is; less for fewer and smaller misses.
  double violation = 0;
  std::vector<std::optional<double>> objectives;  ///< nothing: not known, or not looked for
  std::vector<std::optional<Truth>> demands;      ///< nothing: not looked for
  double seconds = 0;                             ///< that it took
};

/// Evaluates one point; pure, from several threads at once, and opens no file. Demands come first,
/// the cheap ones before the proofs; a point that fails one has no objectives. Never fails: where
/// there is no scheme, or no number, the outcome says why.
[[nodiscard]] Outcome evaluate_point(const Study& study, const Point& point);
/// The same of any scheme, as of those that are drawn beside; it has objectives also where it fails
/// a demand.
[[nodiscard]] Outcome evaluate_scheme(const Study& study, const Scheme& scheme);

/// What a search minimises, one number for each objective: the objective, with its sign changed
/// where it is to be large; the same large number, growing with the violation, in all of them where
/// the point is not feasible.
[[nodiscard]] std::vector<double> fitness(const Study& study, const Outcome& outcome);

}  // namespace limn::search
