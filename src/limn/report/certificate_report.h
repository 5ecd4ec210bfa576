#pragma once
/// Certificates for people.

#include <string>

#include "limn/certify/certificate/certificate.h"

namespace limn::report {

/// What is proved: the regular lattice, and a line for each valence.
[[nodiscard]] std::string certificate_text(const certify::Certificate& certificate);

/// A proof to print, in LaTeX without a preamble: the theorem, what it rests on, and a table of the
/// numbers. It needs amsmath.
[[nodiscard]] std::string certificate_latex(const certify::Certificate& certificate);

}  // namespace limn::report
