#pragma once
/// What is seen at sample points of pixels, by scan conversion with a depth buffer: the pictures'
/// way to visibility, many times as fast as rays (visibility.h), which lines are cut by.
///
/// A pixel has `kPixelSamples` samples, no two of them in one row or column, so that edges of any
/// slope are smooth. A row of samples of a row of pixels is a scan line: it crosses an edge at one
/// place, computed alike for both triangles of the edge, so that triangles leave no gaps. Nothing
/// depends on the number of threads.
///
/// Where there are several surfaces, depths are those of quadratic patches with the normals at the
/// corners of a triangle: flat triangles lie off a smooth surface by more than two surfaces may be
/// apart, and which is in front would follow the triangles.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

inline constexpr int kPixelSamples = 16;

/// Where sample k of a pixel is, from the pixel's left or upper side, in pixels.
[[nodiscard]] constexpr double sample_right(int k) {
  return (13 * k % kPixelSamples + 0.5) / kPixelSamples;
}
[[nodiscard]] constexpr double sample_down(int k) { return (k + 0.5) / kPixelSamples; }

/// Pixels over a box of the page, and what they show of the viewer's plane.
class PixelGrid {
 public:
  /// Precondition: width and height in [1, 32767]; the box has an area.
  PixelGrid(const FramePlacement& place, const Box& box, int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// In pixels, from the left and from above, and back.
  [[nodiscard]] double column(double x) const { return (x - left_) / pixel_width_; }
  [[nodiscard]] double row(double y) const { return (top_ - y) / pixel_height_; }
  [[nodiscard]] double x(double column) const { return left_ + column * pixel_width_; }
  [[nodiscard]] double y(double row) const { return top_ - row * pixel_height_; }
  [[nodiscard]] double pixel_width() const { return pixel_width_; }
  [[nodiscard]] double pixel_height() const { return pixel_height_; }

 private:
  int width_, height_;
  double left_, top_, pixel_width_, pixel_height_;
};

/// Surfaces to be scanned. Keeps a reference to them.
class SampleRaster {
 public:
  /// Precondition: fewer than 32767 surfaces. O(vertices + triangles + rows of pixels that they
  /// meet).
  SampleRaster(const std::vector<SeenSurface>& surfaces, const PixelGrid& grid);

  /// What a sample sees. Of several surfaces at one place (`kEqualDepth`), the earliest one.
  struct Sight {
    int surface = -1;  ///< none: nothing is there
    int triangle = -1;
    /// How far the next surface is before or behind this one, in sizes of what is drawn; infinite
    /// if there is none.
    float gap = std::numeric_limits<float>::infinity();
  };

  /// A few rows of pixels; kept from one to the next by the thread that works on them.
  class Band {
   public:
    [[nodiscard]] Sight at(int row, int column, int sample) const {
      const std::size_t i = pixel(row, column) + static_cast<std::size_t>(sample);
      return {owners_[i] - 1, triangles_[i], gaps_[i]};
    }
    /// Whether all samples of the pixel see the same surface, or all nothing.
    [[nodiscard]] bool uniform(int row, int column) const;

   private:
    friend class SampleRaster;
    [[nodiscard]] std::size_t pixel(int row, int column) const {
      return static_cast<std::size_t>(kPixelSamples) *
             (static_cast<std::size_t>(row - first_row_) * width_ +
              static_cast<std::size_t>(column));
    }
    void take_first(std::size_t surface);  // what was scanned is of this one
    void merge(std::size_t surface);       // what was scanned apart is of this one
    int first_row_ = 0;
    std::size_t width_ = 0;
    // the samples of a pixel after another's
    std::vector<float> depths_, other_depths_, gaps_;
    std::vector<std::int32_t> triangles_, other_triangles_;
    std::vector<std::uint16_t> owners_;  // 1 + surface; 0: nothing
  };

  [[nodiscard]] int band_count() const;
  [[nodiscard]] int first_row(int band) const;  ///< of band_count(): the height

  /// Fills the band; `fill` of several bands may run at the same time.
  void fill(int band, Band& into) const;

 private:
  struct Corner {
    double x, down, depth;           // pixels, scan lines, and sizes of the scene
    double along = 0, downward = 0;  // how the depth changes with the first two, by the normal
    double trust = 0;                // in these, in [0, 1]; 0 where the surface turns away
  };
  struct Layer {
    std::vector<Corner> corners;
    std::vector<std::size_t> begins;      // of each band's triangles; and the end
    std::vector<std::int32_t> triangles;  // of band after band
  };
  struct Scene;
  class Scan;
  [[nodiscard]] Layer layer_of(const SeenSurface& surface, const Scene& scene) const;

  const std::vector<SeenSurface>& surfaces_;
  PixelGrid grid_;
  std::vector<Layer> layers_;
};

}  // namespace limn::figure
