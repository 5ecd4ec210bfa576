#pragma once
/// Numbers in named columns, as files that other programs read.

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "limn/base/error.h"

namespace limn::report {

struct DataTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< each as long as columns
};

/// A header and a line a row; the shortest text that reads back the same; what is not finite is
/// empty.
[[nodiscard]] std::string csv_text(const DataTable& table);

/// {"columns": […], "rows": [[…], …]}; what is not finite is null.
[[nodiscard]] std::string json_text(const DataTable& table);

/// A number or text.
using Cell = std::variant<double, std::string>;

/// A column with a short name and what it holds, in what unit: {"fx", "frequency along x [cycles
/// per control edge]"}.
struct DescribedColumn {
  std::string name, meaning;
};

/// A table that is of use without the page that it belongs to.
struct DescribedTable {
  std::vector<DescribedColumn> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as columns

  /// A column of its own in front, with one value in all rows.
  void put_first(DescribedColumn column, const Cell& value);
};

/// The columns of `table` of these names, in this order. Every name is one of the table's.
[[nodiscard]] DescribedTable described(const DataTable& table,
                                       const std::vector<DescribedColumn>& columns);

/// One header line of cells "name: meaning", then a line a row; cells with commas, quotes or line
/// breaks are quoted as RFC 4180 says.
[[nodiscard]] std::string csv_text(const DescribedTable& table);

/// {"columns": [names], "meanings": [texts], "rows": [[…], …]}.
[[nodiscard]] std::string json_text(const DescribedTable& table);

/// Writes a .csv or .json file, whole or not at all. Fails on other extensions and where the file
/// cannot be written.
[[nodiscard]] Status write_table(const std::string& path, const DataTable& table);
[[nodiscard]] bool is_table_path(std::string_view path);

}  // namespace limn::report
