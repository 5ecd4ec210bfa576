#include "limn/fast/limit/sqrt3_limit_site.h"

namespace limn::fast {
using Form = LinearForm<double>;

Result<std::optional<std::vector<LimitForms>>> LimitSite::read(
    LimitReader& reader, const std::vector<SectorPoint>& points) const {
  using Found = std::optional<std::vector<LimitForms>>;
  std::vector<Index> vertices;
  vertices.reserve(points.size());
  for (const SectorPoint& point : points) vertices.push_back(site_.vertex(point));
  const int steps_made = step_ == Sqrt3Step::centroids ? 0 : 1;
  auto read = reader.read(site_.mesh(step_), steps_made, !open_, vertices);
  if (!read) return read.error();
  Found forms(std::in_place);
  for (std::optional<LimitForms>& limit : *read) {
    if (!limit) return Found();
    for (Form& form : *limit) {
      drop_rounding(form);
      for (const auto& [vertex, weight] : form.terms)
        if (ring(vertex) > kEdge * (rings_ - kRim)) return Found();
    }
    forms->push_back(std::move(*limit));
  }
  return forms;
}

LimitStencils LimitSite::on_plane_from(const LimitForms& forms, Offset point) const {
  LimitStencils sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    std::vector<Offset> places;
    std::vector<double> weights;
    for (const auto& [vertex, weight] : forms[i].terms) {
      const Offset at = on_plane(Lattice::triangle, site_.place(vertex));
      places.push_back({at.a - point.a, at.b - point.b});
      weights.push_back(weight);
    }
    sums[i] = rounded_stencil(places, std::move(weights));
  }
  return sums;
}

std::optional<LimitForms> LimitSite::shifted(const LimitStencils& sums, const SectorPoint& point,
                                             SideRow row) const {
  LimitForms forms;
  for (std::size_t i = 0; i < forms.size(); ++i)
    for (const auto& [step, weight] : sums[i]) {
      // a fan's last spoke is the end of a side, which leads to the middle
      const Offset turned = row == SideRow::last ? Offset{step.b, -step.a - step.b} : step;
      const auto at = beyond({point.sector, point.x + turned.a, point.y + turned.b}, row);
      if (!at) return std::nullopt;
      add_scaled(forms[i], weight, Form::unit(site_.vertex(*at)));
    }
  return forms;
}

/// A place in a sector's frame, in the sector that it is in: as SidePoints and
/// TriangleLayout::point_beyond.
std::optional<SectorPoint> LimitSite::beyond(SectorPoint place, SideRow row) const {
  auto& [sector, x, y] = place;
  if (row == SideRow::first && x < 0 && y == 0) return SectorPoint{sectors_ - 1, 0, -x};
  if (row == SideRow::last && x == 0 && y < 0) return SectorPoint{0, -y, 0};
  const Index turn = x < 0 ? 1 : y < 0 ? -1 : 0;
  if (turn != 0) {
    place = {sector + turn, turn > 0 ? x + y : -y, turn > 0 ? -x : x + y};
    if (open_ && (sector < 0 || sector >= sectors_)) return std::nullopt;
    sector = (sector + sectors_) % sectors_;
  }
  if (x < 0 || y < 0) return std::nullopt;
  return place;
}

}  // namespace limn::fast
