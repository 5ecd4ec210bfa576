#include "limn/report/eigen/eigen_table.h"

#include <cmath>
#include <limits>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/files/file.h"
#include "limn/base/printable.h"

namespace limn::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kComplex = " is complex";  // the end of such a column's name
constexpr const char* kOther = "largest other";

/// A labelled eigenvalue or the largest other one.
struct Entry {
  double value = kNone;  ///< real, or the modulus of a complex one
  double complex = 0;    ///< 1 where it is
};

Entry entry(const Eigenvalue& eigenvalue) {
  const bool real = std::abs(eigenvalue.value.imag()) <= kEqualBelow;
  return {real ? eigenvalue.value.real() : eigenvalue.modulus(), real ? 0.0 : 1.0};
}

Entry labelled_entry(const Component& component, const Eigencomponents& found) {
  if (!component.exists_at(found.valence)) return {};
  const auto& eigenvalues =
      found.spectra[static_cast<std::size_t>(component.frequency)].eigenvalues;
  return component.index < eigenvalues.size() ? entry(eigenvalues[component.index]) : Entry{};
}

/// Blocks are sorted by modulus, so the first without a label is the largest of its block.
Entry largest_other(const Eigencomponents& found) {
  Entry largest{0, 0};
  for (const BlockSpectrum& spectrum : found.spectra) {
    std::size_t labels = 0;
    for (const Component& component : kComponents)
      if (component.frequency == spectrum.frequency && component.exists_at(found.valence)) ++labels;
    if (labels >= spectrum.eigenvalues.size()) continue;
    const Eigenvalue& first = spectrum.eigenvalues[labels];
    if (first.modulus() > largest.value) largest = {first.modulus(), entry(first).complex};
  }
  return largest;
}

/// The column that says whether that of this name is complex; none where it has no such column.
std::optional<std::size_t> complex_column(const DataTable& table, const std::string& name) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i] == name + kComplex) return i;
  return std::nullopt;
}

std::string latex_cell(const std::vector<double>& row, std::size_t column,
                       std::optional<std::size_t> complex) {
  if (column == 0) return fmt::format("{}", row[0]);
  if (!std::isfinite(row[column])) return "--";
  const bool bars = complex && row[*complex] != 0;
  return fmt::format("${}{:.6f}{}$", bars ? "|" : "", row[column], bars ? "|" : "");
}

std::string meaning(const std::string& column) {
  if (column == "valence") return "edges of the vertex, of dual schemes corners of the face";
  if (column == "tangent squared") return "the tangent's modulus squared";
  if (column == kOther) return "largest modulus that is none of position, tangent, cup, saddle";
  if (column.ends_with(kComplex)) return "1 where it is, and its modulus is given; else 0";
  return "eigenvalue of this shape; none where the valence has no such shape";
}

bool ends_with_tex(const std::string& path) { return path.ends_with(".tex"); }

}  // namespace

DataTable eigenvalue_table(const std::vector<Eigencomponents>& valences) {
  DataTable table{{"valence", "tangent", "tangent squared", "cup", "saddle", kOther}, {}};
  for (const char* name : {"tangent", "cup", "saddle", kOther})
    table.columns.push_back(std::string(name) + kComplex);
  for (const Eigencomponents& found : valences) {
    std::array<Entry, kComponents.size()> at;  // in the order of kComponents
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = labelled_entry(kComponents[i], found);
    const Entry cup = at[1], tangent = at[2], saddle = at[3];
    const Entry other = largest_other(found);
    table.rows.push_back({static_cast<double>(found.valence), tangent.value,
                          tangent.value * tangent.value, cup.value, saddle.value, other.value,
                          tangent.complex, cup.complex, saddle.complex, other.complex});
  }
  return table;
}

DescribedTable described_eigenvalues(const DataTable& table, const std::string& scheme) {
  std::vector<DescribedColumn> columns;
  for (const std::string& name : table.columns) columns.push_back({name, meaning(name)});
  DescribedTable result = described(table, columns);
  result.put_first({"scheme", "its name"}, scheme);
  return result;
}

std::vector<int> complex_valences(const DataTable& table) {
  std::vector<int> valences;
  for (const std::vector<double>& row : table.rows)
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].ends_with(kComplex) && row[i] != 0) {
        valences.push_back(static_cast<int>(row[0]));
        break;
      }
  return valences;
}

bool has_complex(const DataTable& table) { return !complex_valences(table).empty(); }

std::string eigenvalue_latex(const std::string& scheme, const DataTable& table) {
  std::vector<std::string> heads{"$n$"};
  std::vector<std::string> lines;
  for (std::size_t i = 1; i < table.columns.size(); ++i)
    if (!table.columns[i].ends_with(kComplex))
      heads.push_back(table.columns[i] == "tangent squared" ? "tangent$^2$" : table.columns[i]);
  lines.push_back(fmt::format("  {}", fmt::join(heads, " & ")));
  for (const std::vector<double>& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < heads.size(); ++i)
      cells.push_back(latex_cell(row, i, complex_column(table, table.columns[i])));
    lines.push_back(fmt::format("  {}", fmt::join(cells, " & ")));
  }
  lines[1] = "  \\hline\n" + lines[1];
  return fmt::format(
      "\\begin{{tabular}}{{{}}}\n{}\n\\end{{tabular}}\n\nEigenvalues of {} over the valence "
      "$n$.{}\n",
      std::string(heads.size(), 'r'), fmt::join(lines, " \\\\\n"), base::latex_text(scheme),
      has_complex(table) ? " Between bars: moduli of complex eigenvalues." : "");
}

bool is_eigenvalue_path(const std::string& path) {
  return ends_with_tex(path) || is_table_path(path);
}

Status write_eigenvalues(const std::string& path, const std::string& scheme,
                         const DataTable& table) {
  if (ends_with_tex(path)) return base::write_file(path, eigenvalue_latex(scheme, table));
  return write_table(path, table);
}

}  // namespace limn::report
