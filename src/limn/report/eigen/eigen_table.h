#pragma once
/// Eigenvalues over valences as a table: `limn eigen --table`, and what its chart draws.

#include <string>
#include <vector>

#include "limn/report/data_table.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn::report {

/// A row for each valence: "valence", "tangent", "tangent squared", "cup", "saddle", "largest
/// other" (the largest modulus that is none of the labels and not that of the position, 1), and for
/// each of tangent, cup, saddle and largest other "… is complex", 1 or 0. A complex eigenvalue
/// stands as its modulus. What the valence does not have is not a number.
[[nodiscard]] DataTable eigenvalue_table(const std::vector<Eigencomponents>& valences);

/// The same with what each column means, and the scheme's name in front.
[[nodiscard]] DescribedTable described_eigenvalues(const DataTable& table,
                                                   const std::string& scheme);

/// The valences at which some eigenvalue of the table is complex.
[[nodiscard]] std::vector<int> complex_valences(const DataTable& table);

/// The table as a tabular of LaTeX, to six digits; moduli of complex eigenvalues between bars, and
/// a note below that names the scheme and says so.
[[nodiscard]] std::string eigenvalue_latex(const std::string& scheme, const DataTable& table);

/// Whether some eigenvalue of the table is complex.
[[nodiscard]] bool has_complex(const DataTable& table);

/// What `write_eigenvalues` writes by: .csv, .json or .tex.
[[nodiscard]] bool is_eigenvalue_path(const std::string& path);

/// Writes the table, whole or not at all. Fails on other extensions and where the file cannot be
/// written.
[[nodiscard]] Status write_eigenvalues(const std::string& path, const std::string& scheme,
                                       const DataTable& table);

}  // namespace limn::report
