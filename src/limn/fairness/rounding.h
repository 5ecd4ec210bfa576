#pragma once
/// What rounding of positions may make of sums of squares.

namespace limn::fairness {

/// Units of rounding, of the largest coordinate, that limit points may be wrong by.
inline constexpr double kPositionUnits = 8;

/// What an error may change a sum of squares by, at most, where the squares of the errors alone sum
/// to `noise`: |(x + e)² − x²| summed, by Cauchy and Schwarz.
[[nodiscard]] double rounding_of_squares(double sum, double noise);

}  // namespace limn::fairness
