#include "limn/refine/fast/sqrt3_limit_site.h"

#include <algorithm>
#include <cmath>

namespace limn::fast {
namespace {

using Form = LinearForm<double>;

/// Less of a weight comes from the rounding of eigenvectors.
double unit_of(const Form& form) {
  double largest = 0;
  for (const auto& [vertex, weight] : form.terms) largest = std::max(largest, std::abs(weight));
  return std::ldexp(largest, -42);
}

void clean_form(Form& form) {
  const double unit = unit_of(form);
  std::erase_if(form.terms, [&](const auto& term) { return std::abs(term.second) <= unit; });
}

double product(const Form& a, const Form& b) {
  double sum = 0;
  for (const auto& [vertex, weight] : a.terms) sum += weight * b.coefficient(vertex);
  return sum;
}

/// That a sum is x·u + y·v but for rounding.
bool is_combination(Form sum, double x, const Form& u, double y, const Form& v) {
  const double size = product(sum, sum);
  add_scaled(sum, -x, u);
  add_scaled(sum, -y, v);
  return product(sum, sum) <= 1e-20 * size;
}

}  // namespace

bool same_limit_forms(const LimitForms& p, const LimitForms& q) {
  if (!is_combination(p[0], 1, q[0], 0, q[0])) return false;
  const double uu = product(q[1], q[1]), uv = product(q[1], q[2]), vv = product(q[2], q[2]);
  const double area = uu * vv - uv * uv;
  if (area <= 1e-12 * uu * vv) return false;
  std::array<std::array<double, 2>, 2> turn{};
  for (std::size_t i = 0; i < 2; ++i) {
    const double u = product(p[i + 1], q[1]), v = product(p[i + 1], q[2]);
    turn[i] = {(u * vv - v * uv) / area, (v * uu - u * uv) / area};
    if (!is_combination(p[i + 1], turn[i][0], q[1], turn[i][1], q[2])) return false;
  }
  return turn[0][0] * turn[1][1] - turn[0][1] * turn[1][0] > 0;
}

void clean(LimitForms& forms) {
  for (Form& form : forms) clean_form(form);
}

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
    clean(*limit);
    for (const Form& form : *limit)
      for (const auto& [vertex, weight] : form.terms)
        if (ring(vertex) > kEdge * (rings_ - kRim)) return Found();
    forms->push_back(std::move(*limit));
  }
  return forms;
}

LimitSums LimitSite::on_plane_from(const LimitForms& forms, Offset point) const {
  LimitSums sums;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double unit = unit_of(forms[i]);
    for (const auto& [vertex, weight] : forms[i].terms) {
      const Offset at = on_plane(Lattice::triangle, site_.place(vertex));
      sums[i].push_back({{at.a - point.a, at.b - point.b}, unit * std::round(weight / unit)});
    }
  }
  return sums;
}

std::optional<LimitForms> LimitSite::shifted(const LimitSums& sums, const SectorPoint& point,
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
