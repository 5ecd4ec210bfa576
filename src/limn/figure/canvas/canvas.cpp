#include "limn/figure/canvas/canvas.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "limn/base/files/file.h"
#include "limn/figure/canvas/cairo_backend.h"

namespace limn::figure {

Path& Path::move_to(PagePoint to) {
  verbs_.push_back(Verb::move);
  points_.push_back(to);
  return *this;
}

Path& Path::line_to(PagePoint to) {
  if (verbs_.empty() || verbs_.back() == Verb::close) return move_to(to);
  verbs_.push_back(Verb::line);
  points_.push_back(to);
  return *this;
}

Path& Path::close() {
  if (!verbs_.empty() && verbs_.back() != Verb::close) verbs_.push_back(Verb::close);
  return *this;
}

Path& Path::polyline(const std::vector<PagePoint>& points, bool closed) {
  if (points.size() < 2) return *this;
  move_to(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) line_to(points[i]);
  if (closed) close();
  return *this;
}

Path Path::segment(PagePoint from, PagePoint to) {
  Path path;
  path.move_to(from).line_to(to);
  return path;
}

Path Path::rectangle(const Box& box) {
  Path path;
  path.move_to({box.x, box.y}).line_to({box.right(), box.y});
  path.line_to({box.right(), box.bottom()}).line_to({box.x, box.bottom()}).close();
  return path;
}

Path Path::disk(PagePoint centre, double radius) {
  constexpr int corners = 24;
  Path path;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    path.line_to({centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)});
  }
  return path.close();
}

Result<FigureFormat> figure_format(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == path.npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  std::string extension(dot == name.npos ? std::string_view() : name.substr(dot));
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".pdf") return FigureFormat::pdf;
  if (extension == ".svg") return FigureFormat::svg;
  if (extension == ".png") return FigureFormat::png;
  Error error;
  error.message = extension.empty() ? "a figure file needs an extension"
                                    : "figures are not written as " + extension;
  error.hint = "give the file one of the extensions .pdf, .svg, .png";
  error.file = path;
  return error;
}

void Canvas::fill(Path path, Colour colour) {
  if (!path.empty()) ops_.emplace_back(FillOp{std::move(path), colour});
}

void Canvas::stroke(Path path, Colour colour, Stroke stroke) {
  if (!path.empty()) ops_.emplace_back(StrokeOp{std::move(path), colour, std::move(stroke)});
}

void Canvas::text(PagePoint at, std::string text, const TextStyle& style) {
  if (!text.empty()) ops_.emplace_back(TextOp{at, std::move(text), style});
}

void Canvas::image(Image image, const Box& box) {
  if (image.width < 1 || image.height < 1 || !(box.width > 0) || !(box.height > 0)) return;
  assert(image.width <= 32767 && image.height <= 32767);
  assert(image.rgba.size() == 4 * std::size_t(image.width) * std::size_t(image.height));
  ops_.emplace_back(ImageOp{std::move(image), box});
}

void Canvas::begin_clip(Path path) { ops_.emplace_back(ClipOp{std::move(path)}); }

void Canvas::end_clip() { ops_.emplace_back(UnclipOp{}); }

Result<std::string> Canvas::render(FigureFormat format) const {
  return cairo_render(*this, format);
}

Status Canvas::write(const std::string& path) const {
  const Result<FigureFormat> format = figure_format(path);
  if (!format) return format.error();
  return write(path, *format);
}

Status Canvas::write(const std::string& path, FigureFormat format) const {
  const Result<std::string> bytes = render(format);
  if (!bytes) {
    Error error = bytes.error();
    error.file = path;
    return error;
  }
  return base::write_file(path, *bytes);
}

bool figures_available() { return cairo_available(); }

Result<Image> read_png(const std::string& path) {
  const Result<std::string> bytes = base::read_file(path);
  if (!bytes) return bytes.error();
  Result<Image> image = cairo_decode_png(*bytes);
  if (image) return image;
  Error error = image.error();
  error.file = path;
  return error;
}

double text_width(std::string_view text, const TextStyle& style) {
  return cairo_text_width(text, style);
}

}  // namespace limn::figure
