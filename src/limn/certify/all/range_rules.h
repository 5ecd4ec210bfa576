#pragma once
/// A scheme's frequency blocks for all valences n ≥ N at once: as functions of t = 1/n and of the
/// turn of a sector.

#include <map>
#include <vector>

#include "limn/certify/all/power_ball.h"
#include "limn/certify/blocks/real_blocks.h"
#include "limn/number/symbolic.h"

namespace limn::certify {

/// The centre's rules as they hold for every n ≥ from. Made without balls but where guards are
/// decided; the blocks take t from the ValenceRange that holds when they are asked for.
class RangeRules {
 public:
  /// Fails, with the reason, where guards do not choose the same case for all n ≥ from, where the
  /// weights of a rule do not sum to 1 for all of them or that cannot be shown, and where weights
  /// depend on their place k in a way that has no closed Fourier sum. The scheme must outlive it.
  [[nodiscard]] static Result<RangeRules> make(const Scheme& scheme, int from);

  [[nodiscard]] int from() const { return from_; }
  [[nodiscard]] const spectrum::SectorPattern& pattern() const { return pattern_; }
  [[nodiscard]] const RealBasis& basis() const { return basis_; }
  /// Blocks of frequencies above it, up to n/2, depend on n by the phases alone, if
  /// `is_steady()`.
  [[nodiscard]] int last_special() const { return last_special_; }
  /// Whether no weight of the centre's rules that depends on n is in blocks without the centre,
  /// special frequencies left aside.
  [[nodiscard]] bool is_steady() const { return steady_; }

  /// Whether the weights in blocks without the centre are the same at all frequencies.
  [[nodiscard]] bool has_same_weights() const { return same_weights_; }

  /// Weights at one frequency. Fails where a weight cannot be enclosed over the range.
  [[nodiscard]] Result<NamedValues<PowerBall>> values(int frequency) const;
  /// The block of frequency > 0 with the phases given.
  [[nodiscard]] number::BallMatrix block(const NamedValues<PowerBall>& values,
                                         const Phase<number::Ball>& phase) const;
  /// That of frequency 0, the centre first where there is one.
  [[nodiscard]] number::DenseMatrix<PowerBall> constant_block(
      const NamedValues<PowerBall>& values) const;

 private:
  /// Fourier sums of a repeated role: w(k) = Σ harmonics[m] cos(2πmk/n), the same of k + 1/2, and
  /// more at some k.
  struct Repeated {
    std::map<int, number::Symbolic> harmonics, half_harmonics;
    std::vector<std::pair<int, number::Symbolic>> apart;  ///< k, negative from the end
  };

  Status choose_cases();
  Status find_sums();
  void find_dependence();
  [[nodiscard]] Result<PowerBall> plain(const spectrum::NamedWeight& name) const;

  const Scheme* scheme_ = nullptr;
  int from_ = 0;
  spectrum::SectorPattern pattern_;
  RealBasis basis_;
  std::map<std::size_t, Repeated> repeated_;  // by name
  int last_special_ = 0;
  bool steady_ = true, same_weights_ = true;
};

}  // namespace limn::certify
