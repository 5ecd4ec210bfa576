#pragma once
/// Proofs that surfaces are C1 at extraordinary vertices, and certificates of them.
///
/// Search and check share what encloses (valence_balls, ring_cells, contraction, …); the check
/// decides nothing by itself and looks for nothing: every number of a certificate is compared or
/// used, and nothing but the scheme's text in it is believed.

#include <functional>

#include "limn/base/budget.h"
#include "limn/certify/certificate/certificate.h"

namespace limn::certify {

struct CertifyOptions {
  int bits = 128;  ///< of the ball arithmetic; doubled once where a spectrum stays undecided
  /// Work of one valence: cells of the characteristic map, and products of the regular lattice.
  int most_parts = 200'000;
  int most_products = 200'000;
  /// Also a proof for every valence from 3 on: the valences that it does not cover are then added
  /// to those asked for.
  bool all = false;
  /// Valences at which the scheme cannot be evaluated, as without a rule there, are undecided
  /// instead of a failure.
  bool leave_out = false;
  /// Also what can be proved of curvature, where C1 is: for long fractions most of the cost.
  bool curvature = true;
  TimeBudget time;                                   ///< when it ends, what is left is undecided
  std::function<void(const std::string&)> progress;  ///< called with what is done next, if given
  /// Claims of a certificate of the same scheme that was checked, taken over unseen where C1 is
  /// decided and, if it is asked for, curvature.
  std::vector<ValenceClaim> known;
};

/// At each of these valences, from 3 on, ascending. Fails where the scheme has no rule at one of
/// them, and where it was not read from a text. Deterministic as long as the time does not end.
/// Cost: of the order of 10 milliseconds a valence; some seconds where interpolating schemes have
/// small ones.
[[nodiscard]] Result<Certificate> certify(const Scheme& scheme, const std::vector<int>& valences,
                                          const CertifyOptions& options = {});

/// "name=expression" of the parameters that were set after the scheme was read.
[[nodiscard]] std::vector<std::string> set_parameters_of(const Scheme& scheme);

/// Reads the scheme from the certificate's text and repeats what is claimed of it. Fails with the
/// first claim that is not shown.
[[nodiscard]] Status check_certificate(
    const Certificate& certificate, const std::function<void(const std::string&)>& progress = {});

}  // namespace limn::certify
