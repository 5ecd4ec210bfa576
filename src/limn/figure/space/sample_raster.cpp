#include "limn/figure/space/sample_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace limn::figure {
namespace {

constexpr int kBandRows = 4;
constexpr double kFarOff = 1e12;  // pixels; what is farther is moved there, so that sums are finite
constexpr float kNothing = -std::numeric_limits<float>::infinity();

double near_page(double pixels) { return std::clamp(pixels, -kFarOff, kFarOff); }

/// The first whole number that is not below, within [0, limit].
int first_from(double value, int limit) {
  return static_cast<int>(std::ceil(std::clamp(value, 0.0, static_cast<double>(limit))));
}

/// In slopes by a normal; they grow without bounds where the surface turns away.
double trust_in(const SpaceVector& normal) {
  constexpr double least = 0.1, enough = 0.3;
  const double t = std::clamp((std::abs(normal[2]) - least) / (enough - least), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

PixelGrid::PixelGrid(const FramePlacement& place, const Box& box, int width, int height)
    : width_(width), height_(height) {
  const auto [left, top] = place.seen({box.x, box.y});
  const auto [right, bottom] = place.seen({box.right(), box.bottom()});
  left_ = left;
  top_ = top;
  pixel_width_ = (right - left) / width;
  pixel_height_ = (top - bottom) / height;
}

/// The cube that holds all that is drawn.
struct SampleRaster::Scene {
  double centre = 0;  // its depth
  double size = 1;

  explicit Scene(const std::vector<SeenSurface>& surfaces) {
    const std::optional<SeenBox> box = seen_box(surfaces);
    if (!box) return;
    centre = box->low[2] + (box->high[2] - box->low[2]) / 2;
    if (box->longest > 0) size = box->longest;
  }
};

SampleRaster::SampleRaster(const std::vector<SeenSurface>& surfaces, const PixelGrid& grid)
    : surfaces_(surfaces), grid_(grid) {
  const Scene scene(surfaces);
  layers_.reserve(surfaces.size());
  for (const SeenSurface& surface : surfaces) layers_.push_back(layer_of(surface, scene));
}

int SampleRaster::band_count() const { return (grid_.height() + kBandRows - 1) / kBandRows; }

int SampleRaster::first_row(int band) const { return std::min(band * kBandRows, grid_.height()); }

SampleRaster::Layer SampleRaster::layer_of(const SeenSurface& surface, const Scene& scene) const {
  Layer layer;
  layer.corners.reserve(surface.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const SpaceVector &at = surface.vertices[v], &normal = surface.normals[v];
    Corner corner{.x = near_page(grid_.column(at[0])),
                  .down = near_page(kPixelSamples * grid_.row(at[1]) - 0.5),
                  .depth = (at[2] - scene.centre) / scene.size};
    if (surfaces_.size() > 1) corner.trust = trust_in(normal);
    if (corner.trust > 0) {
      corner.along = -normal[0] / normal[2] * grid_.pixel_width() / scene.size;
      corner.downward = normal[1] / normal[2] * grid_.pixel_height() / kPixelSamples / scene.size;
    }
    layer.corners.push_back(corner);
  }
  const int lines = kPixelSamples * grid_.height(), band_lines = kPixelSamples * kBandRows;
  // bands that the triangle's scan lines are in: [first, second)
  const auto bands = [&](const std::array<int, 3>& triangle) {
    const auto [low, high] =
        std::minmax({layer.corners[triangle[0]].down, layer.corners[triangle[1]].down,
                     layer.corners[triangle[2]].down});
    const int first = first_from(low, lines), end = first_from(high, lines);
    return end > first ? std::array{first / band_lines, (end - 1) / band_lines + 1}
                       : std::array{0, 0};
  };
  layer.begins.assign(static_cast<std::size_t>(band_count()) + 1, 0);
  for (const std::array<int, 3>& triangle : surface.triangles) {
    const auto [first, end] = bands(triangle);
    for (int band = first; band < end; ++band) ++layer.begins[static_cast<std::size_t>(band) + 1];
  }
  for (std::size_t band = 1; band < layer.begins.size(); ++band)
    layer.begins[band] += layer.begins[band - 1];
  layer.triangles.resize(layer.begins.back());
  std::vector<std::size_t> next(layer.begins.begin(), layer.begins.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto [first, end] = bands(surface.triangles[t]);
    for (int band = first; band < end; ++band)
      layer.triangles[next[static_cast<std::size_t>(band)]++] = static_cast<std::int32_t>(t);
  }
  return layer;
}

/// Draws triangles into the depth buffer of a band.
class SampleRaster::Scan {
 public:
  Scan(int first_line, int end_line, int width, std::vector<float>& depths,
       std::vector<std::int32_t>& triangles)
      : first_(first_line),
        end_(end_line),
        width_(width),
        depths_(depths.data()),
        triangles_(triangles.data()) {}

  void draw(std::int32_t triangle, const Corner* a, const Corner* b, const Corner* c) const {
    if (b->down < a->down) std::swap(a, b);
    if (c->down < b->down) std::swap(b, c);
    if (b->down < a->down) std::swap(a, b);
    const Patch patch(*a, *b, *c);
    if (!patch.seen()) return;
    const Edge whole(*a, *c), upper(*a, *b), lower(*b, *c);
    const int from = std::max(first_from(a->down, end_), first_);
    const int end = first_from(c->down, end_);
    for (int line = from; line < end; ++line) {
      const double one = whole.at(line), other = line < b->down ? upper.at(line) : lower.at(line);
      const double right = sample_right(line % kPixelSamples);
      const int left_column = first_from(std::min(one, other) - right, width_);
      const int end_column = first_from(std::max(one, other) - right, width_);
      if (left_column >= end_column) continue;
      const Parabola depth = patch.depth(left_column + right, line);
      std::size_t at = place(line, left_column);
      for (int i = 0; i < end_column - left_column; ++i, at += kPixelSamples) {
        const float here = depth.at(static_cast<float>(i));
        if (!(here > depths_[at])) continue;
        depths_[at] = here;
        triangles_[at] = triangle;
      }
    }
  }

 private:
  /// Depths from left to right, within bounds.
  struct Parabola {
    float start, slope, bend, least, most;
    [[nodiscard]] float at(float i) const {
      return std::clamp(start + i * (slope + i * bend), least, most);
    }
  };

  /// The depth over a triangle: Σ w_i z_i + ½ Σ w_i w_j (s_i − s_j) over its edges, with weights w
  /// and slopes s along the edge, which has the depths and slopes of a quadratic at the corners.
  class Patch {
   public:
    Patch(const Corner& a, const Corner& b, const Corner& c) : corners_{&a, &b, &c} {
      const double det = (b.x - a.x) * (c.down - a.down) - (c.x - a.x) * (b.down - a.down);
      seen_ = det != 0 && std::isfinite(det);
      if (!seen_) return;  // edge-on
      along_ = {(b.down - c.down) / det, (c.down - a.down) / det, (a.down - b.down) / det};
      down_ = {(c.x - b.x) / det, (a.x - c.x) / det, (b.x - a.x) / det};
      const auto [low, high] = std::minmax({a.depth, b.depth, c.depth});
      const double trust = std::min({a.trust, b.trust, c.trust});
      double bulge = 0;
      for (std::size_t i = 0; trust > 0 && i < 3; ++i) {
        const Corner &p = *corners_[(i + 1) % 3], &q = *corners_[(i + 2) % 3];
        const double right = q.x - p.x, down = q.down - p.down;
        bends_[i] = trust / 2 * ((p.along - q.along) * right + (p.downward - q.downward) * down);
        bulge += std::abs(bends_[i]) / 4;
      }
      bent_ = bulge > 0;
      least_ = static_cast<float>(low - bulge);
      most_ = static_cast<float>(high + bulge);
    }

    [[nodiscard]] bool seen() const { return seen_; }

    [[nodiscard]] Parabola depth(double x, double line) const {
      const Corner& a = *corners_[0];
      std::array<double, 3> w{};
      for (std::size_t i = 0; i < 3; ++i)
        w[i] = along_[i] * (x - a.x) + down_[i] * (line - a.down) + (i == 0 ? 1 : 0);
      double start = 0, slope = 0, bend = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        start += w[i] * corners_[i]->depth;
        slope += along_[i] * corners_[i]->depth;
      }
      for (std::size_t i = 0; bent_ && i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        start += bends_[i] * w[j] * w[k];
        slope += bends_[i] * (w[j] * along_[k] + along_[j] * w[k]);
        bend += bends_[i] * along_[j] * along_[k];
      }
      return {static_cast<float>(start), static_cast<float>(slope), static_cast<float>(bend),
              least_, most_};
    }

   private:
    std::array<const Corner*, 3> corners_;
    bool seen_ = false, bent_ = false;
    std::array<double, 3> along_{}, down_{};  // of the weights
    std::array<double, 3> bends_{};           // of the edges opposite to the corners
    float least_ = 0, most_ = 0;
  };

  /// Where a scan line crosses; the same for both triangles of an edge, whose upper end is first.
  struct Edge {
    double x, from, slope;
    Edge(const Corner& a, const Corner& b)
        : x(a.x), from(a.down), slope(b.down > a.down ? (b.x - a.x) / (b.down - a.down) : 0) {}
    [[nodiscard]] double at(int line) const { return x + slope * (line - from); }
  };

  [[nodiscard]] std::size_t place(int line, int column) const {
    const int row = (line - first_) / kPixelSamples;
    return kPixelSamples * (static_cast<std::size_t>(row) * width_ + column) + line % kPixelSamples;
  }

  int first_, end_;
  int width_;
  float* depths_;
  std::int32_t* triangles_;
};

void SampleRaster::fill(int band, Band& into) const {
  const int first = first_row(band), end = first_row(band + 1);
  into.first_row_ = first;
  into.width_ = static_cast<std::size_t>(grid_.width());
  const std::size_t size = into.width_ * static_cast<std::size_t>((end - first) * kPixelSamples);
  into.depths_.assign(size, kNothing);
  into.triangles_.resize(size);
  into.owners_.assign(size, 0);
  into.gaps_.assign(size, -kNothing);
  bool empty = true;
  for (std::size_t s = 0; s < layers_.size(); ++s) {
    const Layer& layer = layers_[s];
    const std::size_t begin = layer.begins[static_cast<std::size_t>(band)];
    const std::size_t last = layer.begins[static_cast<std::size_t>(band) + 1];
    if (begin == last) continue;
    if (!empty) into.other_depths_.assign(size, kNothing), into.other_triangles_.resize(size);
    const Scan scan(first * kPixelSamples, end * kPixelSamples, grid_.width(),
                    empty ? into.depths_ : into.other_depths_,
                    empty ? into.triangles_ : into.other_triangles_);
    for (std::size_t i = begin; i < last; ++i) {
      const std::int32_t t = layer.triangles[i];
      const auto& [a, b, c] = surfaces_[s].triangles[static_cast<std::size_t>(t)];
      scan.draw(t, &layer.corners[a], &layer.corners[b], &layer.corners[c]);
    }
    if (empty)
      into.take_first(s);
    else
      into.merge(s);
    empty = false;
  }
}

void SampleRaster::Band::take_first(std::size_t surface) {
  const auto owner = static_cast<std::uint16_t>(surface + 1);
  for (std::size_t i = 0; i < depths_.size(); ++i) owners_[i] = depths_[i] == kNothing ? 0 : owner;
}

void SampleRaster::Band::merge(std::size_t surface) {
  const auto owner = static_cast<std::uint16_t>(surface + 1);
  for (std::size_t i = 0; i < depths_.size(); ++i) {
    const float before = depths_[i], here = other_depths_[i];
    if (here == kNothing) continue;
    const float ahead = here - before;
    if (ahead > static_cast<float>(kEqualDepth)) {
      depths_[i] = here;
      triangles_[i] = other_triangles_[i];
      owners_[i] = owner;
      gaps_[i] = ahead;
    } else {
      gaps_[i] = std::min(gaps_[i], std::abs(ahead));
    }
  }
}

bool SampleRaster::Band::uniform(int row, int column) const {
  const std::uint16_t* const owners = &owners_[pixel(row, column)];
  return std::all_of(owners + 1, owners + kPixelSamples,
                     [&](std::uint16_t owner) { return owner == owners[0]; });
}

}  // namespace limn::figure
