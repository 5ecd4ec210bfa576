#pragma once
/// A table with a column for each thing compared and a row for each property, the best of each row
/// marked.

#include <optional>
#include <string>
#include <vector>

namespace limn::report {

/// Whether more or less of a property is better; nothing is better in a row of facts.
enum class Better { none, less, more };

/// A number, or what it is known to lie between. An end may be infinite.
struct Between {
  double low = 0, high = 0;
};

struct TableCell {
  std::string text;
  std::optional<Between> value = {};  ///< what is compared; nothing where it is not known
  double rounding = 0;  ///< cells that differ by no more than both of theirs are equal
};

struct TableRow {
  std::string name;
  Better better = Better::none;
  std::vector<TableCell> cells = {};  ///< as many as the table has columns
};

struct TableSection {
  std::string title = {};  ///< empty: rows without a heading
  std::vector<TableRow> rows = {};
};

/// Which cells of a row are best: as good as every other known one, and better than some. Numbers
/// that differ by less than 1e-9 of their size, or than their rounding, are equal; of overlapping
/// brackets none is better. All false where nothing is better.
[[nodiscard]] std::vector<bool> best_cells(const TableRow& row);

/// Whether the row's texts differ.
[[nodiscard]] bool differs(const TableRow& row);

/// Aligned lines; " *" stands after what is best. Sections follow after an empty line; those
/// without rows are left out. `differences`: only rows that differ.
[[nodiscard]] std::string table_text(const std::vector<std::string>& columns,
                                     const std::vector<TableSection>& sections, bool differences);

}  // namespace limn::report
