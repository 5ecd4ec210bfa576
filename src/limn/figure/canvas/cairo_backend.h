#pragma once
/// The one place that knows cairo; canvas.h is its public face. Without cairo (LIMN_FIGURES off, or
/// not found) rendering is an error and widths are estimates.

#include <string>
#include <string_view>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

[[nodiscard]] bool cairo_available();

/// The bytes of a file that shows the canvas.
[[nodiscard]] Result<std::string> cairo_render(const Canvas& canvas, FigureFormat format);

/// The image in the bytes of a .png file.
[[nodiscard]] Result<Image> cairo_decode_png(std::string_view bytes);

/// Width in points of the text (in the markup of rich_text.h) set in one line.
[[nodiscard]] double cairo_text_width(std::string_view text, const TextStyle& style);

}  // namespace limn::figure
