#include "limn/report/data_table.h"

#include <cmath>

#include <fmt/core.h>

#include "limn/base/file.h"

namespace limn {
namespace {

bool ends_with(std::string_view path, std::string_view end) {
  return path.size() >= end.size() && path.substr(path.size() - end.size()) == end;
}

/// Quotes and backslashes do not occur in the names of columns.
std::string joined(const std::vector<std::string>& names, const char* quote) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + (quote + name) + quote;
  return text;
}

std::string joined(const std::vector<double>& row, const char* missing) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i)
    text += (i == 0 ? "" : ",") + (std::isfinite(row[i]) ? fmt::format("{}", row[i]) : missing);
  return text;
}

}  // namespace

std::string csv_text(const DataTable& table) {
  std::string text = joined(table.columns, "") + "\n";
  for (const auto& row : table.rows) text += joined(row, "") + "\n";
  return text;
}

std::string json_text(const DataTable& table) {
  std::string text = "{\"columns\":[" + joined(table.columns, "\"") + "],\"rows\":[";
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    text += (i == 0 ? "\n[" : ",\n[") + joined(table.rows[i], "null") + "]";
  return text + "\n]}\n";
}

bool is_table_path(std::string_view path) {
  return ends_with(path, ".csv") || ends_with(path, ".json");
}

Status write_table(const std::string& path, const DataTable& table) {
  if (!is_table_path(path)) return Error{"a table is written as .csv or .json", {}, path, 0, 0};
  return write_file(path, ends_with(path, ".csv") ? csv_text(table) : json_text(table));
}

}  // namespace limn
