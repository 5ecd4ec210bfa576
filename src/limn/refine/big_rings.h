#pragma once
/// The sums of a step round what has very many neighbours. Each of the n edges of a vertex may
/// weigh all n neighbours, and each of the n corners of a face all its corners: n² products one by
/// one. But the weights depend on how far round from the edge (corner) a neighbour is, so that all
/// n sums are one circular correlation of n values with one row of weights: n log n.

#include <optional>
#include <vector>

#include "limn/mesh/polygons.h"
#include "limn/refine/rule_tables.h"

namespace limn::refine {

/// From this many neighbours on, the sums are correlated; below, one by one is as quick and rounds
/// less.
inline constexpr Index kBigRing = 512;

/// sums[m] = Σ_k weights[k] · values[(m + k) mod n], by Fourier transforms. Precondition: as many
/// values as weights. Rounding: for each coordinate, the root mean square over m of the error is
/// within about 10 · 2^-53 · log2(4n) · Σ|weights| times the root mean square of the coordinate.
/// Cost O(n log n), on this thread.
[[nodiscard]] std::vector<Point3> correlate(const std::vector<double>& weights,
                                            const std::vector<Point3>& values);

/// Something with n anchors round it, in turn: the edges out of a vertex, or the corners of a face.
class BigRing {
 public:
  /// `row` is that of the rule `kind` at n; h names the first anchor. Cost O(n).
  BigRing(const Mesh& mesh, RuleKind kind, Index h, const Row<double>& row);

  [[nodiscard]] const std::vector<Index>& anchors() const { return anchors_; }
  /// What the row weighs but by going round.
  [[nodiscard]] const Row<double>& singles() const { return singles_; }
  /// Whether the row goes round what its anchors stand round.
  [[nodiscard]] bool turns() const { return !turns_.empty(); }

  /// For each anchor, the part of its sum that comes of going round; value_of(Source) → Point3.
  template <class ValueOf>
  [[nodiscard]] std::vector<Point3> sums(const ValueOf& value_of) const {
    std::vector<Point3> sums(anchors_.size());
    std::vector<Point3> values(anchors_.size());
    for (const Turn& turn : turns_) {
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = value_of(turn.sources[k]);
      const std::vector<Point3> parts = correlate(turn.weights, values);
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const Point3& part = parts[turn.starts[i]];
        sums[i] = {sums[i].x + part.x, sums[i].y + part.y, sums[i].z + part.z};
      }
    }
    return sums;
  }

 private:
  /// A repeated step: its sources as seen from the first anchor, and where in these each anchor's
  /// own begin.
  struct Turn {
    std::vector<double> weights;
    std::vector<Source> sources;
    std::vector<std::size_t> starts;
  };
  /// Nothing where the anchors do not go round the same.
  [[nodiscard]] static std::optional<Turn> turn(const Mesh& mesh, RuleKind kind, const Step& step,
                                                const std::vector<Index>& anchors);

  std::vector<Index> anchors_;
  Row<double> singles_;
  std::vector<Turn> turns_;
};

}  // namespace limn::refine
