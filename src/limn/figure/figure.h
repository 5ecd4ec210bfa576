#pragma once
/// A figure: panels in rows, with captions, on one page.
///
///     Figure figure(3);
///     figure.add(MapPanel{.grid = grid, .values = trace, .title = "trace"}, "The trace.");
///     figure.add(ChartPanel{.series = {{"limn", n, seconds}}, .log_y = true}, "Time over *{n}.");
///     figure.add(height_field(grid, z));
///     Status written = figure.write("fairness.pdf");

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/chart/chart_panel.h"
#include "limn/figure/chart/map_panel.h"
#include "limn/figure/chart/net_panel.h"
#include "limn/figure/chart/overlay_panel.h"
#include "limn/figure/chart/surface_panel.h"
#include "limn/figure/space/reflection_line_panel.h"
#include "limn/figure/space/shaded_panel.h"

namespace limn::figure {

/// What can stand in a figure: anything with these two members.
template <class T>
concept FigurePanel = requires(const T& panel, Canvas& canvas, const Box& box) {
  { panel.height(1.0) } -> std::convertible_to<double>;
  panel.draw(canvas, box);
};

class Figure {
 public:
  /// `columns` ≥ 1 panels to a row. `width` of the page in points: 482 is 17 cm, the text width of
  /// a journal's page; a column of one is about 240.
  explicit Figure(int columns, double width = 482) : columns_(columns), width_(width) {}

  /// A line in bold over all panels.
  Figure& title(std::string text);

  /// Puts a panel into the next place, rows from the left. A figure of several panels letters them
  /// (a), (b), … The caption is broken into lines; text is in the markup of rich_text.h.
  template <FigurePanel Panel>
  Figure& add(Panel panel, std::string caption = {}) {
    return add_entry({[panel](double width) { return panel.height(width); },
                      [panel](Canvas& canvas, const Box& box) { panel.draw(canvas, box); },
                      std::move(caption)});
  }

  /// The drawn page; its height follows from the panels. `density` as of a `Canvas`.
  [[nodiscard]] Canvas canvas(double density = 0) const;

  /// An error, before anything is drawn, if the page is larger than a page can be.
  [[nodiscard]] Status check() const;

  /// Writes a .pdf, .svg or .png; errors as those of `check` and of `Canvas::write`.
  [[nodiscard]] Status write(const std::string& path) const;
  /// The same in a given format, whatever the path is called.
  [[nodiscard]] Status write(const std::string& path, FigureFormat format) const;

 private:
  struct Entry {
    std::function<double(double)> height;
    std::function<void(Canvas&, const Box&)> draw;
    std::string caption;
  };
  struct Row;
  Figure& add_entry(Entry entry);
  [[nodiscard]] std::vector<Row> rows() const;
  [[nodiscard]] double height_of(const std::vector<Row>& rows) const;
  void draw_entry(Canvas& canvas, std::size_t index, const Row& row, double x, double top) const;
  [[nodiscard]] std::size_t column_count() const;
  [[nodiscard]] double column_width() const;
  [[nodiscard]] std::vector<std::string> caption_lines(std::size_t index) const;

  int columns_;
  double width_;
  std::string title_;
  std::vector<Entry> entries_;
};

/// The text in lines of at most `width` points, broken at spaces outside the braces of markup; a
/// word that is wider has a line of its own.
[[nodiscard]] std::vector<std::string> broken_lines(const std::string& text, double width,
                                                    const TextStyle& style);

}  // namespace limn::figure
