#pragma once
/// Numbers in named columns, as files that other programs read.

#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"

namespace limn {

struct DataTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< each as long as columns
};

/// A header and a line a row; the shortest text that reads back the same; what is not finite is
/// empty.
[[nodiscard]] std::string csv_text(const DataTable& table);

/// {"columns": […], "rows": [[…], …]}; what is not finite is null.
[[nodiscard]] std::string json_text(const DataTable& table);

/// Writes a .csv or .json file, whole or not at all. Fails on other extensions and where the file
/// cannot be written.
[[nodiscard]] Status write_table(const std::string& path, const DataTable& table);
[[nodiscard]] bool is_table_path(std::string_view path);

}  // namespace limn
