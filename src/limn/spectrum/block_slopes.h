#pragma once
/// Frequency blocks with their derivatives by names that a scheme's weights depend on, and what
/// follows for eigenvalues.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "limn/number/jet.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn::spectrum {

/// Blocks and how they change.
struct BlockSlopes {
  FrequencyBlocks blocks;  ///< those asked for; the others have no rows
  /// By ω, then by variable: the derivatives of that block, exact but for rounding.
  std::vector<std::vector<Eigen::MatrixXcd>> slopes;
};

struct SectorPattern;  // sector_pattern.h

/// Such blocks of one scheme at any number of valences and values of its variables.
class SlopeAnalysis {
 public:
  /// `variables`: names of lets or parameters, whose definitions give way to values. The scheme
  /// must outlive the analysis.
  SlopeAnalysis(const Scheme& scheme, std::vector<std::string> variables);
  ~SlopeAnalysis();
  SlopeAnalysis(SlopeAnalysis&& other) noexcept;

  /// At valence n, of these frequencies (ascending, of 0 … ⌊n/2⌋), where variable j is values[j].
  /// Weights are evaluated in jets; the blocks are the polynomials in them that the star's
  /// refinement gives, those of regular rules too. Fails as FrequencyAnalysis::blocks. Not for two
  /// threads at once. Cost: a refined star for each new set of rule cases at the centre; else a few
  /// times that of FrequencyAnalysis::blocks.
  [[nodiscard]] Result<BlockSlopes> blocks(int n, const std::vector<double>& values,
                                           const std::vector<int>& frequencies);

 private:
  Result<const SectorPattern*> pattern_at(int n, const std::vector<double>& values);

  const Scheme* scheme_;
  std::vector<std::string> variables_;
  std::map<std::vector<const RuleCase*>, std::unique_ptr<SectorPattern>> patterns_;
};

/// A real eigenvalue as a jet: its derivative is left · (derivative of the block) · right
/// [BGSK §3]. Fails where it is not simple: it may then have no derivative.
[[nodiscard]] Result<number::Jet> eigenvalue_jet(const BlockSlopes& slopes,
                                                 const Eigenvalue& eigenvalue);

}  // namespace limn::spectrum
