#include "limn/report/figure/net_panel.h"

#include <algorithm>

#include "limn/report/figure/axes.h"
#include "limn/report/figure/parallel_view.h"

namespace limn {
namespace {

constexpr double kMargin = 10;  // also for labels at the rim

ViewFrame frame(const NetPanel& panel) {
  std::vector<SpaceVector> points;
  for (const NetPanel::Net& net : panel.nets)
    for (const PagePoint& p : net.vertices) points.push_back({p[0], p[1], 0});
  return frame_of(points);
}

}  // namespace

double NetPanel::height(double width) const {
  const double inner = std::max(width - 2 * kMargin, 1.0) * frame(*this).aspect();
  return title_height(title) + std::min(inner, 1.3 * width) + 2 * kMargin;
}

void NetPanel::draw(Canvas& canvas, const Box& box) const {
  const double top = title_height(title);
  const FramePlacement place(
      frame(*this), {box.x + kMargin, box.y + top + kMargin, std::max(box.width - 2 * kMargin, 1.0),
                     std::max(box.height - top - 2 * kMargin, 1.0)});
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
  for (const Label& label : labels) {
    const PagePoint at = page(label.at);
    canvas.text({at[0] + label.shift[0], at[1] - label.shift[1]}, label.text,
                {.size = 7.5,
                 .align = Align::centre,
                 .vertical = VerticalAlign::middle,
                 .colour = label.colour});
  }
}

}  // namespace limn
