#pragma once
/// Private to the page of [KS]: the numbers that its claims are held against.

#include <optional>
#include <string>
#include <vector>

#include "limn/regular/smoothness/regularity.h"
#include "limn/report/fairness_report.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/study/c1_answers.h"
#include "limn/tune/solve.h"
#include "papers/kawaharada_parts.h"

namespace limn::ks {

inline constexpr int kFirstValence = 3, kLastValence = 12;

/// What limn knows of a scheme of the paper.
struct Evidence {
  Member member;
  Regularity regularity;
  std::vector<Eigencomponents> valences;  ///< kFirstValence … kLastValence
  std::vector<certify::Answer> proofs;    ///< of C1, likewise

  [[nodiscard]] const Eigencomponents& at(int n) const {
    return valences[static_cast<std::size_t>(n - kFirstValence)];
  }
};
[[nodiscard]] Result<Evidence> evidence_of(const Member& member);

/// "[1.407, 1.415]"
[[nodiscard]] std::string bracket_text(const HolderBracket& bracket);

/// "3, 5 … 12" of the valences at which `holds` is true; "none".
[[nodiscard]] std::string valences_text(const Evidence& evidence,
                                        bool (*holds)(const Eigencomponents&));
[[nodiscard]] bool fails_c1(const Eigencomponents& found);
[[nodiscard]] bool unbounds_curvature(const Eigencomponents& found);

/// The range of a name in which C¹ is not ruled out, at these valences.
[[nodiscard]] Result<std::vector<ValenceRange>> c1_ranges(const std::string& scheme,
                                                          const std::string& name, int first,
                                                          int last);

/// All evidence, in the order of the paper; tables of it are put on the page.
struct Findings {
  Evidence loop, high, low, butterfly, eighth, sixteenths, quarter, optimal, optimal_high,
      optimal_low;
  std::vector<ValenceRange> a_of_high, b_of_type;  ///< of laplacian-loop and loop-type, from 3 on
  std::vector<ValenceRange> a_of_low;              ///< of laplacian-loop-low's á, from 3 on
  std::vector<double> tangents;                    ///< Loop's μ1 from 3 on, as many
  std::vector<ValenceRange> b_of_butterfly;        ///< of laplacian-butterfly, at 6 alone
  /// Of the members on the torus, the cube and the raised vertex.
  std::vector<study::FairnessRecord> torus, cube, raised;
  /// Of the optimal scheme and its low pass, from one raised vertex of valence k over a mesh that
  /// is regular elsewhere.
  std::vector<std::pair<int, std::vector<study::FairnessRecord>>> by_valence;
};
[[nodiscard]] Result<Findings> find_all(PaperPage& page, Studio& studio);

/// Whether the first is the fairer of two that `records` holds, energy by energy: counts of those
/// in which it is, and in which the other is; energies that grow without bound in both decide
/// nothing. "b = 1/8 against butterfly: thin plate 1 against 2, …".
struct FairnessTally {
  int smaller = 0, larger = 0;
  std::string words;

  /// Of the claim that the first is fairer.
  [[nodiscard]] Judgement fairer() const;
  /// Of the claim that the first brings no gain.
  [[nodiscard]] Judgement no_gain() const;
};
[[nodiscard]] FairnessTally fairness_tally(const std::vector<study::FairnessRecord>& records,
                                           const Member& fairer, const Member& other);

/// The claims of §3, §4 and §5.
[[nodiscard]] Result<std::vector<PaperFinding>> loop_claims(const Findings& found, Studio& studio);
[[nodiscard]] std::vector<PaperFinding> butterfly_claims(const Findings& found, const Members& m);
[[nodiscard]] std::vector<PaperFinding> misprints();
[[nodiscard]] Result<std::vector<PaperFinding>> optimal_claims(const Findings& found,
                                                               const Members& m);

}  // namespace limn::ks
