#include "limn/report/data_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/files/file.h"

namespace limn::report {
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

/// As RFC 4180 has it.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string csv_cell(const Cell& cell) {
  if (const std::string* text = std::get_if<std::string>(&cell)) return csv_cell(*text);
  const double value = std::get<double>(cell);
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string json_cell(const Cell& cell) {
  if (const std::string* text = std::get_if<std::string>(&cell))
    return nlohmann::json(*text).dump();
  const double value = std::get<double>(cell);
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

/// text_of(item) of each, with commas between them.
template <class Items, class TextOf>
std::string listed(const Items& items, const TextOf& text_of) {
  std::string text;
  bool first = true;
  for (const auto& item : items) {
    if (!first) text += ',';
    text += text_of(item);
    first = false;
  }
  return text;
}

}  // namespace

void DescribedTable::put_first(DescribedColumn column, const Cell& value) {
  columns.insert(columns.begin(), std::move(column));
  for (auto& row : rows) row.insert(row.begin(), value);
}

DescribedTable described(const DataTable& table, const std::vector<DescribedColumn>& columns) {
  DescribedTable result{columns, {}};
  std::vector<std::size_t> places;
  for (const DescribedColumn& column : columns)
    places.push_back(static_cast<std::size_t>(
        std::find(table.columns.begin(), table.columns.end(), column.name) -
        table.columns.begin()));
  result.rows.reserve(table.rows.size());
  for (const std::vector<double>& row : table.rows) {
    std::vector<Cell>& added = result.rows.emplace_back();
    for (const std::size_t place : places) added.emplace_back(row[place]);
  }
  return result;
}

std::string csv_text(const DescribedTable& table) {
  std::string text = listed(table.columns,
                            [](const DescribedColumn& column) {
                              return csv_cell(column.name + ": " + column.meaning);
                            }) +
                     "\n";
  for (const auto& row : table.rows)
    text += listed(row, [](const Cell& cell) { return csv_cell(cell); }) + "\n";
  return text;
}

std::string json_text(const DescribedTable& table) {
  const auto texts = [&](std::string DescribedColumn::*which) {
    return listed(table.columns, [&](const DescribedColumn& column) {
      return nlohmann::json(column.*which).dump();
    });
  };
  std::string text = "{\"columns\":[" + texts(&DescribedColumn::name) + "],\n\"meanings\":[" +
                     texts(&DescribedColumn::meaning) + "],\n\"rows\":[";
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    text += (i == 0 ? "\n[" : ",\n[") + listed(table.rows[i], json_cell) + "]";
  return text + "\n]}\n";
}

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
  return base::write_file(path, ends_with(path, ".csv") ? csv_text(table) : json_text(table));
}

}  // namespace limn::report
