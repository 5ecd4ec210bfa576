#pragma once
/// What limn knows of one scheme, each part worked out when it is first asked for, and kept:
/// several quantities of a study share it.

#include <map>
#include <optional>
#include <vector>

#include "limn/certify/certify.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/scheme.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/frequency_blocks.h"

namespace limn::search {

/// How hard a study looks at one scheme. Everything is bounded by work, never by time, so that a
/// scheme has the same numbers in every run.
struct Effort {
  int regularity = 2000;  ///< RegularityOptions::budget
  /// RegularityOptions::tolerance: width of the Hölder bracket below which little more is sought.
  /// Above 0.138 no invariant polytope in exact numbers is tried, which for the long fractions of a
  /// search may take minutes; at the leading product itself a bracket of 1e-8 is tried all the
  /// same.
  double tolerance = 0.14;
  int certificate_parts = 20'000;  ///< CertifyOptions::most_parts
};

/// Not for two threads at once. Each part costs what the function costs that makes it.
class SchemeReading {
 public:
  /// `valences` are those that quantities "over valences" run over, ascending, from 3 on.
  /// `proofs`: how the certificate is searched for.
  SchemeReading(Scheme scheme, std::vector<int> valences, const Effort& effort,
                certify::CertifyOptions proofs);
  SchemeReading(const SchemeReading&) = delete;
  SchemeReading& operator=(const SchemeReading&) = delete;

  [[nodiscard]] const Scheme& scheme() const { return scheme_; }
  [[nodiscard]] const std::vector<int>& valences() const { return valences_; }

  /// regular_mask.
  [[nodiscard]] const Result<Mask>& mask();
  /// Of that mask. Fails where the limit or its energy does not exist, too.
  [[nodiscard]] const Result<ArtifactAnalysis>& artifacts();
  /// enclose_regularity of that mask.
  [[nodiscard]] const Result<Regularity>& regularity();
  /// find_regular_part.
  [[nodiscard]] const RegularPart& regular_part();
  /// approx_eigencomponents at a valence from 3 on, without what the lattice lets curvature be.
  [[nodiscard]] const Result<Eigencomponents>& components(int n);
  /// certify at all of `valences`; what cannot be evaluated is undecided there.
  [[nodiscard]] const Result<certify::Certificate>& certificate();

 private:
  Scheme scheme_;
  std::vector<int> valences_;
  Effort effort_;
  certify::CertifyOptions proofs_;
  std::optional<Result<Mask>> mask_;
  std::optional<Result<ArtifactAnalysis>> artifacts_;
  std::optional<Result<Regularity>> regularity_;
  std::optional<RegularPart> regular_part_;
  FrequencyAnalysis frequencies_;
  std::map<int, Result<Eigencomponents>> components_;
  std::optional<Result<certify::Certificate>> certificate_;
};

}  // namespace limn::search
