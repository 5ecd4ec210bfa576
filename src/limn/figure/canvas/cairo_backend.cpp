#include "limn/figure/canvas/cairo_backend.h"

#include "limn/figure/canvas/rich_text.h"

#if LIMN_HAS_CAIRO
#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#endif

namespace limn::figure {

#if LIMN_HAS_CAIRO
namespace {

constexpr const char* kFont = "DejaVu Sans";
constexpr double kCapHeight = 0.73, kAscent = 0.76, kDescent = 0.236;  // of it, per size

struct Release {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Context = std::unique_ptr<cairo_t, Release>;
using Surface = std::unique_ptr<cairo_surface_t, Release>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// Letters of the same shape and width on every surface.
void use_unhinted_fonts(cairo_t* context) {
  const std::unique_ptr<cairo_font_options_t, Release> options(cairo_font_options_create());
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context, options.get());
}

void select_font(cairo_t* context, const TextRun& run, const TextStyle& style) {
  cairo_select_font_face(
      context, kFont,
      run.italic || style.italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
      run.bold || style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, run.scale * style.size);
}

double width_of(cairo_t* context, const std::vector<TextRun>& runs, const TextStyle& style) {
  double width = 0;
  for (const TextRun& run : runs) {
    select_font(context, run, style);
    cairo_text_extents_t extents;
    cairo_text_extents(context, run.text.c_str(), &extents);
    width += extents.x_advance;
  }
  return width;
}

void set_colour(cairo_t* context, const Colour& colour) {
  cairo_set_source_rgba(context, colour.red, colour.green, colour.blue, colour.alpha);
}

void set_path(cairo_t* context, const Path& path) {
  cairo_new_path(context);
  std::size_t next = 0;
  for (const Path::Verb verb : path.verbs()) {
    if (verb == Path::Verb::close) {
      cairo_close_path(context);
      continue;
    }
    const PagePoint& to = path.points()[next++];
    if (verb == Path::Verb::move) cairo_move_to(context, to[0], to[1]);
    if (verb == Path::Verb::line) cairo_line_to(context, to[0], to[1]);
  }
}

void draw(cairo_t* context, const FillOp& op) {
  set_path(context, op.path);
  set_colour(context, op.colour);
  cairo_fill(context);
}

void draw(cairo_t* context, const StrokeOp& op) {
  set_path(context, op.path);
  set_colour(context, op.colour);
  cairo_set_line_width(context, op.stroke.width);
  cairo_set_dash(context, op.stroke.dash.data(), static_cast<int>(op.stroke.dash.size()), 0);
  cairo_stroke(context);
}

void draw(cairo_t* context, const TextOp& op) {
  const std::vector<TextRun> runs = parse_rich_text(op.text);
  const TextStyle& style = op.style;
  double x = 0, y = 0;
  if (style.align != Align::left)
    x = -width_of(context, runs, style) * (style.align == Align::centre ? 0.5 : 1);
  if (style.vertical == VerticalAlign::top) y = kAscent * style.size;
  if (style.vertical == VerticalAlign::middle) y = kCapHeight / 2 * style.size;
  if (style.vertical == VerticalAlign::bottom) y = -kDescent * style.size;
  cairo_save(context);
  cairo_translate(context, op.at[0], op.at[1]);
  if (style.angle != 0) cairo_rotate(context, -style.angle * std::numbers::pi / 180);
  set_colour(context, style.colour);
  for (const TextRun& run : runs) {
    select_font(context, run, style);
    cairo_text_extents_t extents;
    cairo_text_extents(context, run.text.c_str(), &extents);
    cairo_move_to(context, x, y - run.rise * style.size);
    cairo_show_text(context, run.text.c_str());
    x += extents.x_advance;
  }
  cairo_restore(context);
}

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

/// In cairo's order, a word a pixel, and multiplied by the opacity. Opaque images need no mask.
Surface surface_of(const Image& image) {
  Surface surface(cairo_image_surface_create(
      opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image.width, image.height));
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  if (data == nullptr) return surface;
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t* const pixel = &image.rgba[4 * (y * width + x)];
      const std::uint32_t alpha = pixel[3];
      const auto part = [&](int channel) { return (pixel[channel] * alpha + 127) / 255; };
      const std::uint32_t word = alpha << 24 | part(0) << 16 | part(1) << 8 | part(2);
      std::memcpy(data + y * stride + 4 * x, &word, sizeof word);
    }
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void draw(cairo_t* context, const ImageOp& op) {
  const Surface pixels = surface_of(op.image);
  cairo_save(context);
  cairo_translate(context, op.box.x, op.box.y);
  cairo_scale(context, op.box.width / op.image.width, op.box.height / op.image.height);
  cairo_set_source_surface(context, pixels.get(), 0, 0);
  cairo_paint(context);
  cairo_restore(context);
}

void draw(cairo_t* context, const ClipOp& op) {
  cairo_save(context);
  set_path(context, op.path);
  cairo_clip(context);
}

void draw(cairo_t* context, const UnclipOp&) { cairo_restore(context); }

Surface make_surface(const Canvas& canvas, FigureFormat format, std::string& bytes) {
  const double width = canvas.width(), height = canvas.height();
  if (format == FigureFormat::png) {
    const auto pixels = [](double points) {
      return static_cast<int>(std::ceil(points * kPngDensity));
    };
    Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
    cairo_surface_set_device_scale(surface.get(), kPngDensity, kPngDensity);
    return surface;
  }
  if (format == FigureFormat::svg) {
    Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
    cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
    return surface;
  }
  Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, width, height));
  // Without it, the time of day. Readers show the date, so it is a plainly artificial one.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                 "2000-01-01T00:00:00Z");
  return surface;
}

/// The end of the id "surface7" or "image7" that begins there, and where its number begins.
std::optional<std::array<std::size_t, 2>> surface_id_at(const std::string& svg, std::size_t at) {
  for (const std::string_view word : {"surface", "image"}) {
    if (svg.compare(at, word.size(), word) != 0) continue;
    const std::size_t digits = at + word.size();
    const std::size_t end = std::min(svg.find_first_not_of("0123456789", digits), svg.size());
    if (end > digits) return std::array{digits, end};
  }
  return std::nullopt;
}

/// cairo numbers its surfaces through the life of the process and writes the numbers into the
/// SVG's ids; here they are counted anew from 1. An id follows a quote or a #, which never stand
/// before a word in the data of an image, and letters are outlines.
std::string renumber_surfaces(const std::string& svg) {
  std::map<std::string, int, std::less<>> numbers;
  std::string result;
  result.reserve(svg.size());
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t mark = svg.find_first_of("\"#", at);
    if (mark == svg.npos) return result.append(svg, at);
    result.append(svg, at, mark + 1 - at);
    at = mark + 1;
    if (const auto id = surface_id_at(svg, at)) {
      const auto [digits, end] = *id;
      const auto next = static_cast<int>(numbers.size()) + 1;
      result.append(svg, at, digits - at);
      result +=
          std::to_string(numbers.try_emplace(svg.substr(digits, end - digits), next).first->second);
      at = end;
    }
  }
  return result;
}

Error render_error(const char* reason) {
  Error error;
  error.message = std::string("cannot draw the figure: ") + reason;
  return error;
}

/// Gives cairo the bytes of a file.
cairo_status_t take(void* rest, unsigned char* data, unsigned length) {
  std::string_view& bytes = *static_cast<std::string_view*>(rest);
  if (bytes.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, bytes.data(), length);
  bytes.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;

/// Of a PNG file, as its head says; 0 where that is none.
std::uint64_t pixels_of(std::string_view png) {
  if (png.size() < 24 || !png.starts_with(kPngSignature)) return 0;
  const auto number = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return number(16) * number(20);
}

/// Whatever its format, in bytes of red, green, blue and opacity.
Image image_of(cairo_surface_t* png) {
  Image image{cairo_image_surface_get_width(png), cairo_image_surface_get_height(png)};
  const Surface plain(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  const Context context(cairo_create(plain.get()));
  cairo_set_source_surface(context.get(), png, 0, 0);
  cairo_paint(context.get());
  cairo_surface_flush(plain.get());
  const unsigned char* row = cairo_image_surface_get_data(plain.get());
  image.rgba.reserve(std::size_t{4} * static_cast<std::size_t>(image.width * image.height));
  for (int y = 0; y < image.height; ++y, row += cairo_image_surface_get_stride(plain.get()))
    for (int x = 0; x < image.width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, row + std::ptrdiff_t{4} * x, sizeof pixel);
      const std::uint32_t opacity = pixel >> 24;
      for (const int shift : {16, 8, 0}) {
        const std::uint32_t value = (pixel >> shift) & 255;
        image.rgba.push_back(static_cast<std::uint8_t>(
            opacity == 0 ? 0
                         : std::min<std::uint32_t>(255, (255 * value + opacity / 2) / opacity)));
      }
      image.rgba.push_back(static_cast<std::uint8_t>(opacity));
    }
  return image;
}

}  // namespace

bool cairo_available() { return true; }

Result<Image> cairo_decode_png(std::string_view bytes) {
  const std::uint64_t pixels = pixels_of(bytes);
  if (pixels == 0) return Error{"it is no PNG image", "convert it to PNG"};
  if (pixels > kMostPixels)
    return Error{"the image has more than 67 million pixels", "make it smaller"};
  const Surface png(cairo_image_surface_create_from_png_stream(take, &bytes));
  if (const cairo_status_t status = cairo_surface_status(png.get()))
    return Error{std::string("the image cannot be read: ") + cairo_status_to_string(status),
                 "is the file whole?"};
  return image_of(png.get());
}

Result<std::string> cairo_render(const Canvas& canvas, FigureFormat format) {
  const auto possible = [](double size) { return size > 0 && size <= kLargestPage; };
  if (!possible(canvas.width()) || !possible(canvas.height()))
    return render_error("its page is empty, or larger than 14400 points");
  std::string bytes;
  const Surface surface = make_surface(canvas, format, bytes);
  const Context context(cairo_create(surface.get()));
  use_unhinted_fonts(context.get());
  cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context.get(), CAIRO_LINE_JOIN_ROUND);
  if (format == FigureFormat::png) {
    set_colour(context.get(), grey(1));
    cairo_paint(context.get());
  }
  for (const DrawingOp& op : canvas.ops())
    std::visit([&](const auto& which) { draw(context.get(), which); }, op);
  if (const cairo_status_t status = cairo_status(context.get()))
    return render_error(cairo_status_to_string(status));
  if (format == FigureFormat::png)
    cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  else
    cairo_surface_finish(surface.get());
  if (const cairo_status_t status = cairo_surface_status(surface.get()))
    return render_error(cairo_status_to_string(status));
  return format == FigureFormat::svg ? renumber_surfaces(bytes) : bytes;
}

double cairo_text_width(std::string_view text, const TextStyle& style) {
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const Context context(cairo_create(surface.get()));
  use_unhinted_fonts(context.get());
  return width_of(context.get(), parse_rich_text(text), style);
}

#else

bool cairo_available() { return false; }

Result<Image> cairo_decode_png(std::string_view) {
  return Error{"this limn was built without cairo, so it reads no images"};
}

Result<std::string> cairo_render(const Canvas&, FigureFormat) {
  Error error;
  error.message = "this limn was built without cairo, so it draws no figures";
  error.hint = "install libcairo2-dev and build limn again with LIMN_FIGURES=ON";
  return error;
}

double cairo_text_width(std::string_view text, const TextStyle& style) {
  double width = 0;
  for (const TextRun& run : parse_rich_text(text))
    for (const char c : run.text)
      if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) width += 0.6 * run.scale * style.size;
  return width;
}

#endif

}  // namespace limn::figure
