#pragma once
/// A page to draw on: filled and stroked paths, text, images, clipping, in points (1/72 inch) from
/// the top left corner, y downward. A canvas only remembers what was drawn; `write` makes the file.
///
///     Canvas canvas(200, 100);
///     canvas.fill(Path::rectangle({10, 10, 80, 40}), {0.9, 0.9, 0.2});
///     canvas.text({100, 50}, "f_{x}, degree α", {.size = 8, .align = Align::centre});
///     Status written = canvas.write("page.pdf");
///
/// The same drawing gives the same bytes, in every process, locale and on every day, given the
/// same versions of cairo and of the font, DejaVu Sans.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "limn/base/error.h"

namespace limn::figure {

/// A place on the page, or a vector between two.
using PagePoint = std::array<double, 2>;

/// A rectangle on the page; (x, y) is its top left corner.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
};

/// sRGB and opacity, each in [0, 1].
struct Colour {
  double red = 0, green = 0, blue = 0, alpha = 1;
  friend bool operator==(const Colour&, const Colour&) = default;
};

[[nodiscard]] inline Colour grey(double lightness) { return {lightness, lightness, lightness}; }

/// How a path is stroked: ends and joins are round. `dash`: lengths of dashes and gaps in turn, in
/// points; empty: solid.
struct Stroke {
  double width = 0.5;
  std::vector<double> dash = {};
};

enum class Align { left, centre, right };
enum class VerticalAlign { baseline, top, middle, bottom };  ///< middle: of a capital letter

struct TextStyle {
  double size = 8;  ///< points
  Align align = Align::left;
  VerticalAlign vertical = VerticalAlign::baseline;
  double angle = 0;  ///< degrees counterclockwise about the given point
  bool bold = false;
  bool italic = false;
  Colour colour = {};
};

/// Polygons and polylines.
class Path {
 public:
  enum class Verb : std::uint8_t { move, line, close };

  /// Begins a new polyline; `line_to` without one begins it too.
  Path& move_to(PagePoint to);
  Path& line_to(PagePoint to);
  /// Joins the end of the polyline to its beginning.
  Path& close();

  /// Adds a whole polyline; nothing for fewer than two points.
  Path& polyline(const std::vector<PagePoint>& points, bool closed = false);

  [[nodiscard]] static Path segment(PagePoint from, PagePoint to);
  [[nodiscard]] static Path rectangle(const Box& box);
  /// A polygon that no eye tells from a circle, for radii of a few points.
  [[nodiscard]] static Path disk(PagePoint centre, double radius);

  [[nodiscard]] bool empty() const { return verbs_.empty(); }
  [[nodiscard]] const std::vector<Verb>& verbs() const { return verbs_; }
  /// One for each move and line, in order.
  [[nodiscard]] const std::vector<PagePoint>& points() const { return points_; }

 private:
  std::vector<Verb> verbs_;
  std::vector<PagePoint> points_;
};

/// A picture of pixels.
struct Image {
  int width = 0, height = 0;  ///< each in [1, 32767]
  /// Red, green, blue (sRGB) and opacity of each pixel, rows from the top; 4 · width · height
  /// values. Colours are as they are, not multiplied by the opacity.
  std::vector<std::uint8_t> rgba = {};
};

/// The image of a .png file, of at most 2^26 pixels. Errors name the file.
[[nodiscard]] Result<Image> read_png(const std::string& path);

/// What a canvas remembers.
struct FillOp {
  Path path;
  Colour colour;
};
struct StrokeOp {
  Path path;
  Colour colour;
  Stroke stroke;
};
struct TextOp {
  PagePoint at;
  std::string text;
  TextStyle style;
};
struct ImageOp {
  Image image;
  Box box;
};
struct ClipOp {
  Path path;
};
struct UnclipOp {};
using DrawingOp = std::variant<FillOp, StrokeOp, TextOp, ImageOp, ClipOp, UnclipOp>;

/// The kinds of figure file, by extension: .pdf (fonts embedded), .svg (letters as outlines) and
/// .png (144 pixels per inch, on white).
enum class FigureFormat { pdf, svg, png };

/// Pixels a point of a .png.
inline constexpr double kPngDensity = 2;

/// Points; the most that a side of a page has, which is PDF's own limit.
inline constexpr double kLargestPage = 14400;

/// By the extension of `path`, in lower or upper case; an error names the supported ones.
[[nodiscard]] Result<FigureFormat> figure_format(std::string_view path);

/// Whether this limn was built with cairo. If not, `Canvas::render` and `write` are errors.
[[nodiscard]] bool figures_available();

class Canvas {
 public:
  /// A page of this size in points, each in (0, kLargestPage]. `density`: pixels a point of the
  /// file that will be made of it, if it is to be one of pixels.
  Canvas(double width, double height, double density = 0)
      : width_(width), height_(height), density_(density) {}

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }
  /// 0: not known, or none. An image whose pixels are those of the file is not resampled.
  [[nodiscard]] double density() const { return density_; }
  [[nodiscard]] const std::vector<DrawingOp>& ops() const { return ops_; }

  /// Fills by the nonzero winding rule. Coordinates of paths and texts are finite.
  void fill(Path path, Colour colour);
  void stroke(Path path, Colour colour, Stroke stroke = {});
  /// Text in the markup of rich_text.h: f_{x}, 10^{−3}, *{bold}, /{italic}.
  void text(PagePoint at, std::string text, const TextStyle& style = {});
  /// The image stretched over the box; nothing if the image or the box has no area. Vector formats
  /// hold the pixels as they are.
  void image(Image image, const Box& box);

  /// What follows is drawn within `path` (and within the clips before it), until `end_clip`.
  void begin_clip(Path path);
  void end_clip();

  /// The file's bytes. Errors: no cairo in this limn; a page that cairo cannot make.
  [[nodiscard]] Result<std::string> render(FigureFormat format) const;

  /// Writes the file whole or not at all; its kind is `figure_format(path)`.
  [[nodiscard]] Status write(const std::string& path) const;
  [[nodiscard]] Status write(const std::string& path, FigureFormat format) const;

 private:
  double width_, height_, density_;
  std::vector<DrawingOp> ops_;
};

/// Width in points of the text set in one line; without cairo an estimate.
[[nodiscard]] double text_width(std::string_view text, const TextStyle& style);

}  // namespace limn::figure
