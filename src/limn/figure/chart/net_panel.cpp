#include "limn/figure/chart/net_panel.h"

#include <algorithm>
#include <cmath>

#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/chart/axes.h"
#include "limn/figure/chart/label_places.h"

namespace limn::figure {
namespace {

constexpr double kNetMargin = 10;     // also for labels at the border
constexpr double kPlacedMargin = 16;  // where they are free to go outwards
constexpr double kLabelText = 7.5;
constexpr double kHead = 5;  // of an arrow

double margin_of(const NetPanel& panel) { return panel.place_labels ? kPlacedMargin : kNetMargin; }

ViewFrame frame(const NetPanel& panel) {
  std::vector<SpaceVector> points;
  for (const NetPanel::Net& net : panel.nets)
    for (const PagePoint& p : net.vertices) points.push_back({p[0], p[1], 0});
  for (const NetPanel::Arrow& arrow : panel.arrows)
    for (const PagePoint& p : {arrow.from, arrow.to}) points.push_back({p[0], p[1], 0});
  return frame_of(points);
}

void draw_arrow(Canvas& canvas, PagePoint from, PagePoint to, Colour colour) {
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  if (!(length > 0)) return;
  const PagePoint along{(to[0] - from[0]) / length, (to[1] - from[1]) / length};
  const auto at = [&](double back, double aside) {
    return PagePoint{to[0] - back * along[0] - aside * along[1],
                     to[1] - back * along[1] + aside * along[0]};
  };
  canvas.stroke(Path::segment(from, at(0.8 * kHead, 0)), colour, {.width = 1});
  canvas.fill(Path().polyline({to, at(kHead, 0.36 * kHead), at(kHead, -0.36 * kHead)}, true),
              colour);
}

/// Where the labels' middles go: beside lines, dots and one another.
template <class PageOf>
std::vector<PagePoint> middles_of_labels(const NetPanel& panel, const PageOf& page,
                                         const Box& within) {
  LabelSurroundings around{.within = within};
  for (const NetPanel::Net& net : panel.nets) {
    for (const auto& [a, b] : net.edges)
      around.lines.push_back({page(net.vertices[static_cast<std::size_t>(a)]),
                              page(net.vertices[static_cast<std::size_t>(b)])});
    for (const PagePoint& p : net.vertices) around.dots.push_back({page(p), net.dot});
  }
  for (const NetPanel::Arrow& arrow : panel.arrows)
    around.lines.push_back({page(arrow.from), page(arrow.to)});
  std::vector<LabelWish> wishes;
  wishes.reserve(panel.labels.size());
  for (const NetPanel::Label& label : panel.labels)
    wishes.push_back({page(label.at), text_width(label.text, {.size = kLabelText}), kLabelText});
  return label_places(wishes, around);
}

}  // namespace

double NetPanel::height(double width) const {
  const double margin = margin_of(*this);
  const double inner = std::max(width - 2 * margin, 1.0) * frame(*this).aspect();
  return title_height(title) + std::min(inner, 1.3 * width) + 2 * margin;
}

void NetPanel::draw(Canvas& canvas, const Box& box) const {
  const double top = title_height(title), margin = margin_of(*this);
  const FramePlacement place(
      frame(*this), {box.x + margin, box.y + top + margin, std::max(box.width - 2 * margin, 1.0),
                     std::max(box.height - top - 2 * margin, 1.0)});
  const auto page = [&](const PagePoint& p) { return place.page({p[0], p[1], 0}); };
  draw_title(canvas, title, box.x, box.right(), box.y);
  for (const Net& net : nets) {
    Path lines;
    for (const auto& [a, b] : net.edges)
      lines.move_to(page(net.vertices[static_cast<std::size_t>(a)]))
          .line_to(page(net.vertices[static_cast<std::size_t>(b)]));
    canvas.stroke(lines, net.colour, net.stroke);
    if (net.dot > 0)
      for (const PagePoint& p : net.vertices) canvas.fill(Path::disk(page(p), net.dot), net.colour);
  }
  for (const Arrow& arrow : arrows)
    draw_arrow(canvas, page(arrow.from), page(arrow.to), arrow.colour);
  std::vector<PagePoint> middles;
  if (place_labels)
    middles = middles_of_labels(*this, page, {box.x, box.y + top, box.width, box.height - top});
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const PagePoint at = page(labels[i].at);
    const PagePoint& shift = labels[i].shift;
    canvas.text(place_labels ? middles[i] : PagePoint{at[0] + shift[0], at[1] - shift[1]},
                labels[i].text,
                {.size = kLabelText,
                 .align = Align::centre,
                 .vertical = VerticalAlign::middle,
                 .colour = labels[i].colour});
  }
}

}  // namespace limn::figure
