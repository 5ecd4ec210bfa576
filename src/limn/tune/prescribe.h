#pragma once
/// Prescribed spectra [BGSK §2.1, Fig. 1]: choose the eigenvalue of each rotational frequency at
/// one valence; the inverse DFT gives the weights of the first ring.

#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/scheme.h"

namespace limn::tune {

struct Prescription {
  int valence = 0;
  std::string cup;  ///< subdominant eigenvalue of frequency 0, an expression
  /// Of the frequencies 1 (tangent), 2 (saddle), … ⌊n/2⌋.
  std::vector<std::string> eigenvalues;
};

struct Prescribed {
  std::string text;  ///< the scheme file
  /// What other eigenvalues of the same frequency lead, as "the cup is 0.125, not 1/16: …": the
  /// weights reach the first ring alone. These are no facts of the file.
  Warnings unmet;
};

/// A scheme file that extends `base` (named `base_name` there) by rules for that valence: for the
/// vertex, and for an edge that ends there, whose weight of the vertex stays the one that `base`
/// has for regular edges. Checked by reading it as the file `path`, after which the scheme is
/// called; letters, digits, - and _. Fails where the edges of `base` look beyond the first ring of
/// triangles (its eigenvalues then do not follow from these weights), at the regular valence 6, for
/// a wrong number of eigenvalues, and where one is no expression in n alone.
[[nodiscard]] Result<Prescribed> prescribed_scheme(const Scheme& base, const std::string& base_name,
                                                   const std::string& path,
                                                   const Prescription& prescription);

}  // namespace limn::tune
