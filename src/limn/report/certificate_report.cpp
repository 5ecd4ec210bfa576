#include "limn/report/certificate_report.h"

#include <fmt/core.h>

#include "limn/base/printable.h"

namespace limn::report {

std::string certificate_text(const certify::Certificate& certificate) {
  std::string text = base::printable(certificate.scheme) + "\n";
  text += fmt::format("C1 on the regular lattice: {} ({})\n\n", to_string(certificate.regular.c1),
                      certificate.regular.reason);
  text += fmt::format("{:>7}  {:<9}  {:<9}  {}\n", "valence", "C1", "curvature", "because");
  for (const certify::ValenceClaim& claim : certificate.valences) {
    text += fmt::format("{:>7}  {:<9}  {:<9}  {}\n", claim.valence, to_string(claim.c1),
                        to_string(claim.curvature.answer), claim.reason);
    if (claim.c1 == certify::Answer::proved)
      text += fmt::format("{:>29}  {}\n", "", claim.curvature.reason);
  }
  if (!certificate.all) return text;
  const certify::AllClaim& all = *certificate.all;
  if (all.c1 != certify::Answer::proved)
    return text + fmt::format("\nall valences: undecided ({})\n", all.reason);
  std::string except;
  for (const certify::AllClaim::Exception& one : all.exceptions)
    except += fmt::format("{}{} ({})", except.empty() ? " except " : ", ", one.valence,
                          to_string(one.c1));
  return text +
         fmt::format("\nC1 is proved for every n ≥ {}{}: {}\n", all.from, except, all.reason);
}

}  // namespace limn::report
