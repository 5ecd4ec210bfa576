#include "limn/report/figure/figure.h"

#include <algorithm>

#include "limn/report/figure/axes.h"

namespace limn {
namespace {

constexpr double kPageMargin = 6;
constexpr double kColumnGap = 16, kRowGap = 14;
constexpr double kCaptionGap = 5, kCaptionLine = 10.5;
constexpr double kFigureTitleSize = 9.5, kFigureTitleHeight = 18;
constexpr TextStyle kCaption = {.size = kLabelSize, .vertical = VerticalAlign::top};

/// (a) … (z), (27) …
std::string letter(std::size_t index) {
  return index < 26 ? std::string("(") + static_cast<char>('a' + index) + ")"
                    : "(" + std::to_string(index + 1) + ")";
}

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> result;
  std::string word;
  int depth = 0;
  for (const char c : text) {
    if (c == '{') ++depth;
    if (c == '}' && depth > 0) --depth;
    if (c == ' ' && depth == 0) {
      if (!word.empty()) result.push_back(word);
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) result.push_back(word);
  return result;
}

}  // namespace

std::vector<std::string> broken_lines(const std::string& text, double width,
                                      const TextStyle& style) {
  std::vector<std::string> lines;
  for (const std::string& word : words(text)) {
    if (!lines.empty() && text_width(lines.back() + " " + word, style) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

Figure& Figure::title(std::string text) {
  title_ = std::move(text);
  return *this;
}

Figure& Figure::add_entry(Entry entry) {
  entries_.push_back(std::move(entry));
  return *this;
}

double Figure::column_width() const {
  const int columns = std::max(columns_, 1);
  return std::max((width_ - 2 * kPageMargin - kColumnGap * (columns - 1)) / columns, 1.0);
}

std::vector<std::string> Figure::caption_lines(std::size_t index) const {
  std::string text = entries_[index].caption;
  if (entries_.size() > 1) text = "*{" + letter(index) + "} " + text;
  return broken_lines(text, column_width(), kCaption);
}

Canvas Figure::canvas() const {
  const double width = column_width();
  const auto columns = static_cast<std::size_t>(std::max(columns_, 1));
  const double title_height = title_.empty() ? 0 : kFigureTitleHeight;
  // First the rows' heights, as the page must be known before anything is drawn on it.
  struct Row {
    double panels = 0;
    std::size_t caption_lines = 0;
  };
  std::vector<Row> rows((entries_.size() + columns - 1) / columns);
  double height = 2 * kPageMargin + title_height;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Row& row = rows[i / columns];
    row.panels = std::max(row.panels, entries_[i].height(width));
    row.caption_lines = std::max(row.caption_lines, caption_lines(i).size());
  }
  const auto row_height = [](const Row& row) {
    const auto lines = static_cast<double>(row.caption_lines);
    return row.panels + (lines > 0 ? kCaptionGap + kCaptionLine * lines : 0);
  };
  for (const Row& row : rows) height += row_height(row) + (&row == &rows.back() ? 0 : kRowGap);

  Canvas canvas(width_, height);
  canvas.text({width_ / 2, kPageMargin}, title_,
              {.size = kFigureTitleSize,
               .align = Align::centre,
               .vertical = VerticalAlign::top,
               .bold = true});
  double top = kPageMargin + title_height;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Row& row = rows[i / columns];
    const double x = kPageMargin + static_cast<double>(i % columns) * (width + kColumnGap);
    entries_[i].draw(canvas, {x, top, width, row.panels});
    double y = top + row.panels + kCaptionGap;
    for (const std::string& line : caption_lines(i)) {
      canvas.text({x, y}, line, kCaption);
      y += kCaptionLine;
    }
    if (i % columns + 1 == columns) top += row_height(row) + kRowGap;
  }
  return canvas;
}

Status Figure::write(const std::string& path) const {
  // The name first: drawing may take a while.
  if (const Result<FigureFormat> format = figure_format(path); !format) return format.error();
  return canvas().write(path);
}

}  // namespace limn
