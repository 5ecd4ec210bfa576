#include "limn/figure/figure.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/figure/chart/axes.h"

namespace limn::figure {
namespace {

constexpr double kPageMargin = 6;
constexpr double kColumnGap = 16, kRowGap = 14;
constexpr double kCaptionGap = 5, kCaptionLine = 10.5;
constexpr double kFigureTitleSize = 9.5, kFigureTitleHeight = 18;
constexpr TextStyle kCaption = {.size = kLabelSize, .vertical = VerticalAlign::top};

double title_room(const std::string& title) { return title.empty() ? 0 : kFigureTitleHeight; }

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

std::size_t Figure::column_count() const { return static_cast<std::size_t>(std::max(columns_, 1)); }

double Figure::column_width() const {
  const auto columns = static_cast<double>(column_count());
  return std::max((width_ - 2 * kPageMargin - kColumnGap * (columns - 1)) / columns, 1.0);
}

std::vector<std::string> Figure::caption_lines(std::size_t index) const {
  std::string text = entries_[index].caption;
  if (entries_.size() > 1) text = "*{" + letter(index) + "} " + text;
  return broken_lines(text, column_width(), kCaption);
}

struct Figure::Row {
  double panels = 0;              ///< height of the tallest panel
  std::size_t caption_lines = 0;  ///< of the longest caption

  [[nodiscard]] double height() const {
    if (caption_lines == 0) return panels;
    return panels + kCaptionGap + kCaptionLine * static_cast<double>(caption_lines);
  }
};

std::vector<Figure::Row> Figure::rows() const {
  const std::size_t columns = column_count();
  std::vector<Row> rows((entries_.size() + columns - 1) / columns);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Row& row = rows[i / columns];
    row.panels = std::max(row.panels, entries_[i].height(column_width()));
    row.caption_lines = std::max(row.caption_lines, caption_lines(i).size());
  }
  return rows;
}

void Figure::draw_entry(Canvas& canvas, std::size_t index, const Row& row, double x,
                        double top) const {
  entries_[index].draw(canvas, {x, top, column_width(), row.panels});
  double y = top + row.panels + kCaptionGap;
  for (const std::string& line : caption_lines(index)) {
    canvas.text({x, y}, line, kCaption);
    y += kCaptionLine;
  }
}

double Figure::height_of(const std::vector<Row>& rows) const {
  double height = 2 * kPageMargin + title_room(title_);
  for (const Row& row : rows) height += row.height() + (&row == &rows.back() ? 0 : kRowGap);
  return height;
}

Status Figure::check() const {
  const double height = height_of(rows());
  if (width_ > 0 && width_ <= kLargestPage && height > 0 && height <= kLargestPage) return Done{};
  Error error;
  error.message = fmt::format(
      "the figure is too large: {} panel{} on a page of {:.0f} × {:.0f} points, of which each side "
      "may have {:.0f}",
      entries_.size(), entries_.size() == 1 ? "" : "s", width_, height, kLargestPage);
  error.hint = "make several figures of fewer panels";
  return error;
}

Canvas Figure::canvas(double density) const {
  const std::vector<Row> all = rows();
  Canvas canvas(width_, height_of(all), density);
  canvas.text({width_ / 2, kPageMargin}, title_,
              {.size = kFigureTitleSize,
               .align = Align::centre,
               .vertical = VerticalAlign::top,
               .bold = true});
  const std::size_t columns = column_count();
  double top = kPageMargin + title_room(title_);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto column = static_cast<double>(i % columns);
    const Row& row = all[i / columns];
    draw_entry(canvas, i, row, kPageMargin + column * (column_width() + kColumnGap), top);
    if (i % columns + 1 == columns) top += row.height() + kRowGap;
  }
  return canvas;
}

Status Figure::write(const std::string& path) const {
  // The name first: drawing may take a while.
  const Result<FigureFormat> format = figure_format(path);
  if (!format) return format.error();
  return write(path, *format);
}

Status Figure::write(const std::string& path, FigureFormat format) const {
  if (Status status = check(); !status) return status;
  return canvas(format == FigureFormat::png ? kPngDensity : 0).write(path, format);
}

}  // namespace limn::figure
