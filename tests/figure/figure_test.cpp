#include "limn/figure/figure.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "limn/base/files/file.h"
#include "sample_fields.h"
#include "support/temporary_folder.h"

namespace limn::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr figure::FigureFormat kFormats[] = {figure::FigureFormat::pdf, figure::FigureFormat::svg,
                                             figure::FigureFormat::png};

/// One panel of each kind.
figure::Figure sample_figure(int size = 12) {
  const figure::TriangleGrid grid = rectangle_grid(size, size, 1);
  const auto wave =
      sampled(grid, [](double x, double y) { return std::sin(x / 2) * std::cos(y / 3); });
  const auto slope = sampled(grid, [](double x, double y) { return x * y * 1e-7; });
  const auto hill = sampled(grid, [](double x, double y) { return std::exp(-x * x - y * y); });
  figure::SurfacePanel surface = figure::height_field(grid, wave);
  surface.net_vertices = {{0, 0, 2}, {6, 0, 2}, {6, 6, 3}};
  surface.net_edges = {{0, 1}, {1, 2}, {2, 0}};
  figure::Figure figure(3);
  figure.title("All panels, /{α}");
  figure.add(figure::MapPanel{.grid = grid,
                              .values = wave,
                              .title = "wave",
                              .value_label = "Y₁",
                              .contour_labels = true},
             "A map with a caption that takes several lines.");
  figure.add(figure::MapPanel{.grid = grid, .values = slope, .low = 1e-6, .high = 8e-6});
  figure.add(
      figure::OverlayPanel{.grid = grid, .layers = {{"a", wave}, {"b", slope}, {"c", hill}}});
  figure.add(figure::ChartPanel{.series = {{"one", {1, 2, 3}, {1, 0.1, 0.01}, true},
                                           {"two", {1, 3}, {1, 2}}},
                                .log_y = true},
             "f_{x}");
  figure.add(surface);
  return figure;
}

std::string rendered(const figure::Figure& figure, figure::FigureFormat format) {
  const Result<std::string> bytes = figure.canvas().render(format);
  EXPECT_TRUE(bytes.ok()) << (bytes.ok() ? "" : bytes.error().text());
  return bytes.ok() ? *bytes : std::string();
}

std::size_t occurrences(const std::string& text, std::string_view word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

class FigureFile : public testing::Test {
 protected:
  void SetUp() override {
    if (!figure::figures_available()) GTEST_SKIP() << "built without cairo";
  }
  [[nodiscard]] std::string path(const std::string& name) const { return temporary_ / name; }

  test::TemporaryFolder temporary_;
  const std::filesystem::path& folder_ = temporary_.path();
};

TEST_F(FigureFile, IsTheSameTwice) {
  for (const figure::FigureFormat format : kFormats) {
    const std::string first = rendered(sample_figure(), format);
    EXPECT_GT(first.size(), 1000u);
    EXPECT_TRUE(first == rendered(sample_figure(), format)) << static_cast<int>(format);
  }
}

/// Neither the place of objects in memory nor surfaces made before may matter.
TEST_F(FigureFile, IsTheSameInALaterPlaceAndLocale) {
  const std::string svg = rendered(sample_figure(), figure::FigureFormat::svg);
  const std::string pdf = rendered(sample_figure(), figure::FigureFormat::pdf);
  std::vector<std::string> others;
  for (int i = 0; i < 12; ++i) others.push_back(rendered(sample_figure(2 + i), kFormats[i % 3]));
  for (const char* locale : {"de_DE.UTF-8", "C.UTF-8", "C"}) {
    std::setlocale(LC_ALL, locale);
    EXPECT_TRUE(svg == rendered(sample_figure(), figure::FigureFormat::svg)) << locale;
    EXPECT_TRUE(pdf == rendered(sample_figure(), figure::FigureFormat::pdf)) << locale;
  }
}

TEST_F(FigureFile, PdfHasItsFontsAndNoRaster) {
  const std::string pdf = rendered(sample_figure(), figure::FigureFormat::pdf);
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_GE(occurrences(pdf, "/FontFile"), 2u);
  EXPECT_EQ(occurrences(pdf, "/Subtype /Image"), 0u);
  EXPECT_EQ(occurrences(pdf, "/Image"), 0u);
  EXPECT_EQ(occurrences(pdf, "20000101000000"), 1u);
}

/// Tags balance, attributes are quoted, ids are unique and all that is referred to is there.
TEST_F(FigureFile, SvgIsWellFormedAndHasNoRaster) {
  const std::string svg = rendered(sample_figure(), figure::FigureFormat::svg);
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_EQ(occurrences(svg, "<image"), 0u);
  EXPECT_EQ(occurrences(svg, "base64"), 0u);
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (std::size_t at = svg.find('<'); at != svg.npos; at = svg.find('<', at)) {
    const std::size_t end = svg.find('>', at);
    ASSERT_NE(end, svg.npos);
    const std::string tag = svg.substr(at + 1, end - at - 1);
    ASSERT_EQ(tag.find('<'), tag.npos);
    ASSERT_EQ(occurrences(tag, "\"") % 2, 0u) << tag;
    at = end;
    ++tags;
    if (tag[0] == '?' || tag[0] == '!' || tag.back() == '/') continue;
    if (tag[0] != '/') {
      open.push_back(tag.substr(0, tag.find(' ')));
      continue;
    }
    ASSERT_FALSE(open.empty());
    EXPECT_EQ(open.back(), tag.substr(1));
    open.pop_back();
  }
  EXPECT_TRUE(open.empty());
  EXPECT_GT(tags, 100u);
  for (std::size_t at = svg.find("href=\"#"); at != svg.npos; at = svg.find("href=\"#", at + 1)) {
    const std::string id = svg.substr(at + 7, svg.find('"', at + 7) - at - 7);
    ASSERT_EQ(occurrences(svg, "id=\"" + id + "\""), 1u);
  }
}

/// Opaque red and green over half-transparent blue and nothing.
figure::Canvas canvas_with_images() {
  const figure::Image image = {2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 128, 9, 9, 9, 0}};
  figure::Canvas canvas(60, 40);
  canvas.image(image, {0, 0, 40, 40});
  canvas.image(image, {42, 4, 8, 16});
  canvas.image({}, {0, 0, 1, 1});
  canvas.image(image, {0, 0, 0, 1});
  return canvas;
}

TEST_F(FigureFile, HoldsImages) {
  const figure::Canvas canvas = canvas_with_images();
  EXPECT_EQ(canvas.ops().size(), 2u);
  const std::string pdf = *canvas.render(figure::FigureFormat::pdf);
  EXPECT_GE(occurrences(pdf, "/Subtype /Image"), 2u);
  const std::string svg = *canvas.render(figure::FigureFormat::svg);
  EXPECT_EQ(occurrences(svg, "<image"), 2u);
  EXPECT_EQ(occurrences(svg, "data:image/png;base64,"), 2u);
  for (const char* id : {"image1", "image2", "surface3"})
    EXPECT_EQ(occurrences(svg, std::string("id=\"") + id + "\""), 1u) << id << svg;
  EXPECT_EQ(occurrences(svg, "xlink:href=\"#image1\""), 1u);
  EXPECT_EQ(occurrences(svg, "xlink:href=\"#image2\""), 1u);
  for (const figure::FigureFormat format : kFormats)
    EXPECT_TRUE(*canvas.render(format) == *canvas_with_images().render(format));
}

/// At 2 pixels a point, an image of pixels is what squares of half a point are.
TEST_F(FigureFile, PixelsOfAnImageAreSquares) {
  constexpr int width = 14, height = 10;
  figure::Image image{width, height, {}};
  figure::Canvas squares(20, 20), pixels(20, 20);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const int red = 17 * column, green = 25 * row, blue = (column + row) % 2 == 0 ? 255 : 51;
      for (const int channel : {red, green, blue, 255})
        image.rgba.push_back(static_cast<std::uint8_t>(channel));
      squares.fill(figure::Path::rectangle({3 + column / 2.0, 4 + row / 2.0, 0.5, 0.5}),
                   {red / 255.0, green / 255.0, blue / 255.0});
    }
  }
  pixels.image(image, {3, 4, width / 2.0, height / 2.0});
  const std::string expected = *squares.render(figure::FigureFormat::png);
  EXPECT_TRUE(*pixels.render(figure::FigureFormat::png) == expected);
  EXPECT_FALSE(*figure::Canvas(20, 20).render(figure::FigureFormat::png) == expected);
}

TEST_F(FigureFile, IsWrittenByItsExtension) {
  const std::pair<const char*, const char*> beginnings[] = {
      {"a.pdf", "%PDF"}, {"b.SVG", "<?xml"}, {"c.png", "\x89PNG"}};
  for (const auto& [name, beginning] : beginnings) {
    const Status written = sample_figure().write(path(name));
    ASSERT_TRUE(written.ok()) << written.error().text();
    EXPECT_TRUE(base::read_file(path(name)).value().starts_with(beginning));
  }
}

TEST_F(FigureFile, BadPathsAreErrors) {
  for (const std::string name : {"a.jpeg", "noextension", ".pdf.", "dir.svg/x"}) {
    const Status written = sample_figure().write(path(name));
    ASSERT_FALSE(written.ok()) << name;
    EXPECT_NE(written.error().text().find(".pdf, .svg, .png"), std::string::npos);
    EXPECT_NE(written.error().text().find(name), std::string::npos);
  }
  const Status nowhere = sample_figure().write(path("missing/a.pdf"));
  ASSERT_FALSE(nowhere.ok());
  EXPECT_NE(nowhere.error().text().find("missing/a.pdf"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(FigureFile, DegenerateInputIsDrawn) {
  const figure::TriangleGrid grid = rectangle_grid(3, 3);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0, 1.0, -1e300, 1e-300, kNan, infinity, -infinity}) {
    const std::vector<double> values(grid.nodes.size(), value);
    figure::Figure figure(2);
    figure.add(figure::MapPanel{.grid = grid, .values = values, .contour_labels = true});
    figure.add(figure::MapPanel{.grid = grid, .values = values, .low = value, .high = value});
    figure.add(
        figure::MapPanel{.grid = grid, .values = values, .low = 3.0, .high = 1.0, .contours = 0});
    figure.add(figure::OverlayPanel{.grid = grid, .layers = {{"", values}, {"x", values}}});
    figure.add(
        figure::ChartPanel{.series = {{"a", values, values}, {"b", {}, {}}, {"c", {1, 2}, {1}}}});
    figure.add(figure::ChartPanel{.series = {{"a", values, values}}, .log_x = true, .log_y = true});
    figure.add(figure::height_field(grid, values));
    for (const figure::FigureFormat format : kFormats)
      EXPECT_FALSE(rendered(figure, format).empty());
  }
  figure::Figure empty(2);
  empty.add(figure::MapPanel{})
      .add(figure::OverlayPanel{})
      .add(figure::ChartPanel{})
      .add(figure::SurfacePanel{});
  for (const figure::FigureFormat format : kFormats) EXPECT_FALSE(rendered(empty, format).empty());
}

TEST_F(FigureFile, PagesOfNoSizeAreErrors) {
  for (const double size : {0.0, -1.0, 1e6, kNan})
    for (const figure::FigureFormat format : kFormats)
      EXPECT_FALSE(figure::Canvas(size, 10).render(format).ok());
}

TEST(Png, IsReadAsItWasWritten) {
  if (!figure::figures_available()) GTEST_SKIP() << "built without cairo";
  const TemporaryFolder folder;
  figure::Canvas canvas(2, 1, figure::kPngDensity);  // 4 × 2 pixels
  figure::Image image{4, 2};
  for (int i = 0; i < 8; ++i)
    for (const int value : {30 * i, 255 - 20 * i, 7 * i, 255})
      image.rgba.push_back(static_cast<std::uint8_t>(value));
  canvas.image(image, {0, 0, 2, 1});
  const std::string path = folder / "image.png";
  ASSERT_TRUE(canvas.write(path).ok());
  const Result<figure::Image> read = figure::read_png(path);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->width, 4);
  EXPECT_EQ(read->height, 2);
  EXPECT_EQ(read->rgba, image.rgba);
}

TEST(Png, ThatIsNoneIsAnError) {
  if (!figure::figures_available()) GTEST_SKIP() << "built without cairo";
  const TemporaryFolder folder;
  const std::string path = folder / "image.png";
  const auto message = [&](const std::string& content) {
    EXPECT_TRUE(base::write_file(path, content).ok());
    const Result<figure::Image> read = figure::read_png(path);
    return read ? std::string() : read.error().text();
  };
  const std::string head("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  EXPECT_NE(message("").find("no PNG image"), std::string::npos);
  EXPECT_NE(message("\xff\xd8\xff a photograph").find("no PNG image"), std::string::npos);
  EXPECT_NE(message(head).find("no PNG image"), std::string::npos);
  EXPECT_NE(message(head + std::string("\0\1\0\0\0\1\0\0", 8)).find("67 million"),
            std::string::npos);
  EXPECT_NE(message(head + std::string("\0\0\0\2\0\0\0\2", 8)).find("cannot be read"),
            std::string::npos);
  EXPECT_NE(figure::read_png(folder / "none.png").error().text().find("none.png"),
            std::string::npos);
}

TEST(Figure, WithoutCairoSaysSo) {
  if (figure::figures_available()) GTEST_SKIP() << "built with cairo";
  const Status written = sample_figure().write("figure.pdf");
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().text().find("without cairo"), std::string::npos);
}

/// Refused before a panel is drawn.
TEST(Figure, ThatIsTooLargeIsNotDrawn) {
  struct Slow {
    bool* drawn;
    [[nodiscard]] double height(double) const { return 5000; }
    void draw(figure::Canvas&, const figure::Box&) const { *drawn = true; }
  };
  bool drawn = false;
  figure::Figure figure(1);
  figure.add(Slow{&drawn}).add(Slow{&drawn});
  EXPECT_TRUE(figure.check().ok());
  figure.add(Slow{&drawn});
  const Status written = figure.write("never.pdf");
  ASSERT_FALSE(written.ok());
  EXPECT_FALSE(drawn);
  EXPECT_NE(written.error().message.find("3 panels"), std::string::npos) << written.error().text();
  EXPECT_FALSE(std::filesystem::exists("never.pdf"));
}

TEST(Figure, CaptionsAreBrokenOutsideMarkup) {
  const figure::TextStyle style = {.size = 8};
  for (const double width : {10.0, 60.0, 120.0, 1000.0}) {
    std::string joined;
    for (const std::string& line :
         figure::broken_lines("one two *{three four} five", width, style)) {
      EXPECT_TRUE(figure::text_width(line, style) <= width || line.find(' ') == line.npos ||
                  line == "*{three four}");
      joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, "one two *{three four} five");
  }
}

}  // namespace
}  // namespace limn::test
