#pragma once
/// A rule as it is drawn: where its weights lie round the new vertex, on a flat neighbourhood.

#include <array>
#include <string>
#include <vector>

#include "limn/scheme/scheme.h"

namespace limn::study {

/// One case of a rule, at one valence at which it applies. Places are in the plane, y upwards,
/// edges at the middle of length 1.
struct RulePicture {
  using Place = std::array<double, 2>;
  /// A weight, of an old vertex or of the new vertex of a face.
  struct Spot {
    Place at{};
    std::string weight;  ///< a fraction, or where it is none a decimal of four digits
    bool of_face = false;
  };

  RuleKind kind = RuleKind::vertex;
  std::string when;                       ///< the case's guard; empty: it has none
  int valence = 0;                        ///< n; 0: the rule has none
  std::vector<Place> vertices;            ///< of the faces shown
  std::vector<std::array<int, 2>> edges;  ///< between vertices
  std::vector<Spot> weights;              ///< none of them 0; those on one vertex are added
  Place made{};                           ///< the new vertex
};

/// Of every case of every rule, in the order of the kinds; a case is shown at the regular valence
/// if it applies there, else at the first of 5, 3, 7, 4, 6, … 24. One that applies at none is left
/// out. Fails where weights have no value there.
[[nodiscard]] Result<std::vector<RulePicture>> rule_pictures(const Scheme& scheme);

}  // namespace limn::study
