#include <algorithm>

#include <fmt/core.h>

#include "limn/report/certificate_report.h"

namespace limn::report {
namespace {

using certify::Answer;
using certify::ValenceClaim;

/// Text in LaTeX's text mode.
std::string latex_text(std::string text) {
  constexpr std::pair<const char*, const char*> kSquare{"²", " squared"};
  for (std::size_t at = 0; (at = text.find(kSquare.first)) != std::string::npos;)
    text.replace(at, std::string(kSquare.first).size(), kSquare.second);
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\textbackslash{}";
    else if (c == '~' || c == '^')
      result += std::string("\\") + c + "{}";
    else if (c == '_' || c == '&' || c == '%' || c == '$' || c == '#' || c == '{' || c == '}')
      result += std::string("\\") + c;
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result;
}

constexpr const char* kStatement = R"(
\paragraph{Claim.} At the valences marked ``proved'' the limit surfaces of almost all control nets are
regular $C^1$ surfaces at the extraordinary vertex; at those marked ``refuted'' they are not.

\paragraph{Theorem (Reif 1995; Peters, Reif 1998).} Let the scheme be $C^1$ on the regular lattice. Let the
subdivision matrix have the simple eigenvalue $1$, and let the next in modulus be a real $\lambda > 0$, exactly
double, without Jordan blocks, all others being smaller. If the characteristic map, whose control
net is the pair of eigenvectors of $\lambda$, has a Jacobian of one sign and winds once round the centre, then the
limit surfaces of almost all control nets are regular and $C^1$ at the vertex.
)";

constexpr const char* kProof = R"(
\paragraph{Spectrum.} The matrix splits into real blocks $B_\omega$, $\omega = 0, \dots, \lfloor n/2 \rfloor$. In ball
arithmetic Krawczyk's test encloses $\lambda$ in the block of its frequency and shows that it is simple there. With
$1$ and $\lambda$ deflated, $\|(B_\omega/\lambda)^{2^{k_\omega}}\|_\infty < 1$ for all $\omega$; the largest $k_\omega$ is in the
table. A pair of conjugate frequencies makes $\lambda$ exactly double and semisimple.

\paragraph{Characteristic map.} On every part of the cells of half a sector of a ring both partial derivatives of
both coordinates are enclosed, so that the Jacobian's sign is known, and so is the half-plane in which the image
lies. The number of parts is in the table.
)";

std::string row(const ValenceClaim& claim) {
  if (claim.c1 == Answer::undecided) return fmt::format("{} & undecided & & & & ", claim.valence);
  std::size_t parts = claim.fold ? 2 : 0;
  for (const certify::CellClaim& cell : claim.ring) parts += cell.parts.size();
  return fmt::format("{} & {} & {} & {:.15g} & {} & {}", claim.valence, to_string(claim.c1),
                     claim.frequency, claim.eigenvalue,
                     *std::max_element(claim.squarings.begin(), claim.squarings.end()), parts);
}

}  // namespace

std::string certificate_latex(const certify::Certificate& certificate) {
  std::string text = fmt::format("\\section*{{{}: $C^1$ at extraordinary vertices}}\n{}",
                                 latex_text(certificate.scheme), kStatement);
  text += fmt::format("\n\\paragraph{{Lattice.}} $C^1$: {}. {}.\n",
                      to_string(certificate.regular.c1), latex_text(certificate.regular.reason));
  text += kProof;
  text +=
      "\n\\begin{center}\n\\begin{tabular}{rlrlrr}\n$n$ & $C^1$ & frequency & $\\lambda$ & "
      "$\\max k_\\omega$ & parts";
  for (const ValenceClaim& claim : certificate.valences)
    // A strut keeps the first row off the rule.
    text += (&claim == &certificate.valences.front() ? " \\\\\n\\hline\n\\rule{0pt}{2.6ex}"
                                                     : " \\\\\n") +
            row(claim);
  text += "\n\\end{tabular}\n\\end{center}\n";
  for (const ValenceClaim& claim : certificate.valences)
    if (claim.c1 != Answer::proved)
      text += fmt::format("\n$n = {}$: {}.\n", claim.valence, latex_text(claim.reason));
  return text;
}

}  // namespace limn::report
