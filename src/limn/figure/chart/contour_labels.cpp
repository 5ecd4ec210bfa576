#include "limn/figure/chart/contour_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace limn::figure {
namespace {

constexpr double kSize = 5.5;
constexpr double kHeight = 0.95 * kSize;
constexpr double kLeastDistance = 12;  // between labels
constexpr int kCandidates = 48;        // places that are tried on a line
constexpr double kFlatness = 1.3;      // points that a line may bend away within a label

double distance(PagePoint a, PagePoint b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

/// A place for a label: its middle and the angle of the line there, in (−90°, 90°].
struct Place {
  PagePoint at;
  double angle;
};

/// The point at the length `along` from the line's beginning.
PagePoint point_at(const std::vector<PagePoint>& line, double along) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (along <= step && step > 0) {
      const double t = std::max(0.0, along / step);
      return {line[i - 1][0] + t * (line[i][0] - line[i - 1][0]),
              line[i - 1][1] + t * (line[i][1] - line[i - 1][1])};
    }
    along -= step;
  }
  return line.back();
}

bool inside(const Box& box, PagePoint at, double margin) {
  return at[0] >= box.x + margin && at[0] <= box.right() - margin && at[1] >= box.y + margin &&
         at[1] <= box.bottom() - margin;
}

/// Distance of the nearest point of the other lines.
double clearance(const std::vector<ContourLine>& lines, std::size_t own, PagePoint at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i == own) continue;
    for (const PagePoint& point : lines[i].points) nearest = std::min(nearest, distance(point, at));
  }
  return nearest;
}

double distance_to_labels(const std::vector<Place>& placed, PagePoint at) {
  double nearest = 1e6;
  for (const Place& place : placed) nearest = std::min(nearest, distance(place.at, at));
  return nearest;
}

/// The place with the largest distance to the earlier labels among those that are possible.
std::optional<Place> best_place(const std::vector<ContourLine>& lines, std::size_t own,
                                double width, const Box& within, const std::vector<Place>& placed) {
  const std::vector<PagePoint>& line = lines[own].points;
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  std::optional<Place> best;
  double best_distance = kLeastDistance;
  for (int k = 0; length > 2.5 * width && k <= kCandidates; ++k) {
    const double along = width / 2 + (length - width) * k / kCandidates;
    const PagePoint at = point_at(line, along);
    const PagePoint a = point_at(line, along - width / 2), b = point_at(line, along + width / 2);
    const PagePoint chord = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    if (distance(at, chord) > kFlatness || distance(a, b) < 0.8 * width) continue;
    if (!inside(within, at, width / 2)) continue;
    const double far = distance_to_labels(placed, at);
    if (far <= best_distance || clearance(lines, own, at) < kHeight) continue;
    double angle = std::atan2(a[1] - b[1], b[0] - a[0]) * 180 / std::numbers::pi;
    if (angle > 90) angle -= 180;
    if (angle <= -90) angle += 180;
    best_distance = far;
    best = Place{at, angle};
  }
  return best;
}

Path turned_rectangle(const Place& place, double width, double height) {
  const double c = std::cos(place.angle * std::numbers::pi / 180);
  const double s = std::sin(place.angle * std::numbers::pi / 180);
  std::vector<PagePoint> corners;
  for (const auto& [u, v] : {PagePoint{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const double x = u * width / 2, y = v * height / 2;
    corners.push_back({place.at[0] + c * x + s * y, place.at[1] - s * x + c * y});
  }
  return Path().polyline(corners, true);
}

}  // namespace

void label_contours(Canvas& canvas, const std::vector<ContourLine>& lines, const Box& within) {
  std::vector<Place> placed;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ContourLine& line = lines[i];
    if (line.points.size() < 2) continue;
    const double width = text_width(line.label, {.size = kSize}) + 2;
    const std::optional<Place> place = best_place(lines, i, width, within, placed);
    if (!place) continue;
    placed.push_back(*place);
    const Colour& back = line.background;
    const bool dark = 0.3 * back.red + 0.59 * back.green + 0.11 * back.blue < 0.4;
    canvas.fill(turned_rectangle(*place, width, kHeight), back);
    canvas.text(place->at, line.label,
                {.size = kSize,
                 .align = Align::centre,
                 .vertical = VerticalAlign::middle,
                 .angle = place->angle,
                 .colour = grey(dark ? 1 : 0)});
  }
}

}  // namespace limn::figure
