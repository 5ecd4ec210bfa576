#include "limn/report/compare/compare_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace limn::report {
namespace {

constexpr double kTie = 1e-9;  // relative
constexpr const char* kMark = " *";
constexpr std::size_t kGap = 2;

/// More is better.
Between goodness(const Between& value, Better better) {
  return better == Better::more ? value : Between{-value.high, -value.low};
}

/// More than by rounding.
bool greater(double a, double b, double rounding) {
  if (std::isinf(a) || std::isinf(b)) return a > b;
  return a - b > rounding && !(a - b <= kTie * std::max(std::abs(a), std::abs(b)));
}

/// Letters that take a place of their own, in UTF-8.
std::size_t places(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(places(text), width), ' ');
}

void keep_differences(std::vector<TableSection>& sections) {
  for (TableSection& section : sections)
    std::erase_if(section.rows, [](const TableRow& row) { return !differs(row); });
}

/// The texts of the cells, marked.
std::vector<std::string> marked(const TableRow& row) {
  const std::vector<bool> best = best_cells(row);
  std::vector<std::string> texts;
  texts.reserve(row.cells.size());
  for (std::size_t i = 0; i < row.cells.size(); ++i)
    texts.push_back(row.cells[i].text + (best[i] ? kMark : ""));
  return texts;
}

/// Of the names of rows first, then of the columns.
std::vector<std::size_t> widths(const std::vector<std::string>& columns,
                                const std::vector<TableSection>& sections) {
  std::vector<std::size_t> widths = {0};
  for (const std::string& column : columns) widths.push_back(places(column));
  for (const TableSection& section : sections)
    for (const TableRow& row : section.rows) {
      widths[0] = std::max(widths[0], places(row.name) + kGap);
      const std::vector<std::string> texts = marked(row);
      for (std::size_t i = 0; i < columns.size(); ++i)
        widths[i + 1] = std::max(widths[i + 1], places(texts[i]));
    }
  return widths;
}

std::string line(const std::string& name, const std::vector<std::string>& texts,
                 const std::vector<std::size_t>& widths) {
  std::string line = padded(name, widths[0]);
  for (std::size_t i = 0; i < texts.size(); ++i)
    line += std::string(kGap, ' ') + padded(texts[i], widths[i + 1]);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

}  // namespace

std::vector<bool> best_cells(const TableRow& row) {
  std::vector<bool> best(row.cells.size(), false);
  if (row.better == Better::none) return best;
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    if (!row.cells[i].value) continue;
    const Between mine = goodness(*row.cells[i].value, row.better);
    bool beaten = false, beats = false;
    for (const TableCell& cell : row.cells) {
      if (&cell == &row.cells[i] || !cell.value) continue;
      const Between other = goodness(*cell.value, row.better);
      const double rounding = row.cells[i].rounding + cell.rounding;
      beaten = beaten || greater(other.high, mine.low, rounding);
      beats = beats || greater(mine.low, other.high, rounding);
    }
    best[i] = beats && !beaten;
  }
  return best;
}

bool differs(const TableRow& row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [&](const TableCell& cell) { return cell.text != row.cells[0].text; });
}

std::string table_text(const std::vector<std::string>& columns,
                       const std::vector<TableSection>& sections, bool differences) {
  std::vector<TableSection> shown = sections;
  if (differences) keep_differences(shown);
  const std::vector<std::size_t> all = widths(columns, shown);
  std::string text = line("", columns, all);
  for (const TableSection& section : shown) {
    if (section.rows.empty()) continue;
    if (!section.title.empty()) text += "\n" + section.title + "\n";
    const std::string indent(section.title.empty() ? 0 : kGap, ' ');
    for (const TableRow& row : section.rows) text += line(indent + row.name, marked(row), all);
  }
  return text;
}

}  // namespace limn::report
