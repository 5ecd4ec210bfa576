#pragma once
/// Eigenvalues at a vertex with given faces as text and JSON: `limn eigen --faces`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/limit/sector_spectrum.h"

namespace limn::report {

/// {"scheme", "faces": corners of each face, "rings", "matrix": rows, "eigenvalues": [{"value":
/// [re, im], "modulus"}], "tangent": the two that lead all others but 1, or null, "verdict":
/// {"convergent", "c1_necessary", "reasons"}}. The verdict as in SectorSpectrum: what a C1 surface
/// needs of the eigenvalues, and that does not suffice.
[[nodiscard]] nlohmann::ordered_json faces_json(const std::string& name,
                                                const limit::SectorSpectrum& spectrum);

/// The same without the matrix.
[[nodiscard]] std::string faces_text(const std::string& name,
                                     const limit::SectorSpectrum& spectrum);

}  // namespace limn::report
