#include "limn/regular/artifacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/regular/limit_values.h"

namespace limn {
namespace {

constexpr int kDirections = 180;
constexpr int kDirectionSteps = 256;
constexpr double kDegree = std::numbers::pi / 180;

/// For each whole degree the first direction that a symmetry of the mask carries it to: waves along
/// both have the same artifacts.
std::vector<std::size_t> first_alike(const Mask& mask) {
  std::vector<std::size_t> list(kDirections, kDirections);
  for (const LatticeMatrix& s : regular::symmetries(mask)) {
    const LatticeVector image = s.apply({1, 0});
    const std::array<double, 2> x =
        cartesian(mask.lattice, {static_cast<double>(image[0]), static_cast<double>(image[1])});
    const int turn = static_cast<int>(std::lround(std::atan2(x[1], x[0]) / kDegree));
    const int sense = s.determinant() > 0 ? 1 : -1;
    for (int degrees = 0; degrees < kDirections; ++degrees) {
      const int to = ((turn + sense * degrees) % kDirections + kDirections) % kDirections;
      std::size_t& first = list[static_cast<std::size_t>(degrees)];
      first = std::min(first, static_cast<std::size_t>(to));
    }
  }
  return list;
}

class Search {
 public:
  Search(const ArtifactAnalysis& analysis, double tolerance, ArtifactMeasure measure)
      : analysis_(analysis), tolerance_(tolerance), measure_(measure) {}

  [[nodiscard]] DirectionalDensity along(double degrees) const {
    const double angle = degrees * kDegree;
    const double far = nyquist_distance(analysis_.mask().lattice, degrees);
    DirectionalDensity result{degrees, far, 1 / far, false};
    for (int step = 1; step <= kDirectionSteps; ++step) {
      const double length = far * step / kDirectionSteps;
      if (!exceeded(angle, length)) continue;
      double inside = far * (step - 1) / kDirectionSteps;
      double outside = length;
      while (outside - inside > 1e-13) {
        const double middle = (inside + outside) / 2;
        (exceeded(angle, middle) ? outside : inside) = middle;
      }
      return {degrees, inside, 1 / inside, true};
    }
    return result;
  }

  /// The extreme direction near one of the sampled: `sign` 1 looks for the largest |f|.
  [[nodiscard]] DirectionalDensity refined(const DirectionalDensity& sampled, double sign) const {
    DirectionalDensity best = sampled;
    for (double step = 0.5; step > 1e-4; step /= 2)
      for (const double degrees : {best.direction - step, best.direction + step}) {
        const DirectionalDensity candidate = along(degrees);
        if (sign * candidate.frequency > sign * best.frequency + 1e-12) best = candidate;
      }
    best.direction = std::fmod(best.direction + 360, 180);
    return best;
  }

 private:
  [[nodiscard]] bool exceeded(double angle, double length) const {
    const Frequency f{length * std::cos(angle), length * std::sin(angle)};
    const double percent = measure_ == ArtifactMeasure::total_energy
                               ? analysis_.energy_percent(f)
                               : analysis_.in_limit(f).percent_of_signal();
    return !(percent <= tolerance_);
  }

  const ArtifactAnalysis& analysis_;
  double tolerance_;
  ArtifactMeasure measure_;
};

}  // namespace

Result<SamplingDensity> sampling_density(const ArtifactAnalysis& analysis, double tolerance,
                                         ArtifactMeasure measure) {
  if (!(tolerance >= kLeastTolerance && tolerance <= 100))
    return Error{fmt::format("a tolerance of {} percent", tolerance),
                 fmt::format("it is a percentage from {} to 100", kLeastTolerance)};
  const Status& status =
      measure == ArtifactMeasure::total_energy ? analysis.energy_status() : analysis.limit_status();
  if (!status) return status.error();
  const Search search(analysis, tolerance, measure);
  SamplingDensity result;
  result.tolerance = tolerance;
  result.directions.resize(kDirections);
  const std::vector<std::size_t> same_as = first_alike(analysis.mask());
  base::parallel_for(
      std::size_t{0}, result.directions.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          if (same_as[i] == i) result.directions[i] = search.along(static_cast<double>(i));
      },
      1);
  for (std::size_t i = 0; i < result.directions.size(); ++i) {
    result.directions[i] = result.directions[same_as[i]];
    result.directions[i].direction = static_cast<double>(i);
  }
  for (int degrees = 0; degrees < kDirections; ++degrees) {
    const DirectionalDensity& density = result.directions[static_cast<std::size_t>(degrees)];
    if (degrees == 0 || density.frequency < result.worst.frequency - 1e-12) result.worst = density;
    if (degrees == 0 || density.frequency > result.best.frequency + 1e-12) result.best = density;
  }
  result.worst = search.refined(result.worst, -1);
  result.best = search.refined(result.best, 1);
  return result;
}

}  // namespace limn
