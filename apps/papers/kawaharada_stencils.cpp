#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/core.h>
#include <Eigen/Dense>

#include "limn/number/exact.h"
#include "limn/refine/refine.h"
#include "limn/refine/subdivision_matrix.h"
#include "limn/scheme/scope.h"
#include "papers/kawaharada_parts.h"

namespace limn::ks {
namespace {

constexpr int kSteps = 60;  // until differences are their limit's direction to rounding

/// Vectors in the plane, a column each.
using Vectors = Eigen::Matrix2Xd;

/// The vertices round the centre after many steps, as vectors from it, scaled to mean length 1.
Result<Vectors> limit_differences(const Scheme& scheme, const Vectors& ring) {
  const int n = static_cast<int>(ring.cols());
  const Result<refine::SubdivisionMatrix<double>> matrix =
      refine::subdivision_matrix<double>(scheme, n, 1);
  if (!matrix) return matrix.error();
  Eigen::MatrixXd step(n + 1, n + 1);
  for (int row = 0; row <= n; ++row)
    for (int column = 0; column <= n; ++column) step(row, column) = (*matrix)(row, column);
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(n + 1, 2);
  points.bottomRows(n) = ring.transpose();
  for (int i = 0; i < kSteps; ++i) {
    points = step * points;
    points.rowwise() -= Eigen::RowVector2d(points.row(0));
    points /= points.rowwise().norm().sum() / n;
  }
  return Vectors(points.bottomRows(n).transpose());
}

Vectors regular_polygon(int n) {
  Vectors polygon(2, n);
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    polygon.col(k) = Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return polygon;
}

/// A regular polygon whose corners are moved, each on its own, by up to 1 in either coordinate.
Vectors random_vectors(int n) {
  std::mt19937 random(static_cast<unsigned>(n));
  Vectors vectors = regular_polygon(n);
  for (double& x : vectors.reshaped()) x += static_cast<double>(random()) / 2147483648.0 - 1;
  return vectors;
}

/// By the linear map that takes the regular polygon nearest to the vectors.
DifferenceFit fit(const Vectors& vectors) {
  const int n = static_cast<int>(vectors.cols());
  const Vectors polygon = regular_polygon(n);
  const Eigen::Matrix2d map = vectors * polygon.transpose() * 2 / n;
  const Eigen::Vector2d half_axes = map.jacobiSvd().singularValues();
  return {(vectors - map * polygon).colwise().norm().maxCoeff(), half_axes[0] / half_axes[1]};
}

figure::NetPanel panel_of(const Vectors& vectors) {
  figure::NetPanel panel;
  figure::NetPanel::Net net;
  net.vertices.push_back({0, 0});
  const int n = static_cast<int>(vectors.cols());
  for (int k = 0; k < n; ++k) {
    net.vertices.push_back({vectors(0, k), vectors(1, k)});
    net.edges.push_back({0, k + 1});
    net.edges.push_back({k + 1, (k + 1) % n + 1});
  }
  panel.nets.push_back(std::move(net));
  return panel;
}

/// The weight of a role in the rule of new vertices at regular edges.
Result<std::string> edge_weight(const Member& member, const std::string& role) {
  const Result<Scheme> scheme = member.load();
  if (!scheme) return scheme.error();
  for (const Weight& weight : scheme->rule(RuleKind::edge)->front().weights) {
    if (weight.role != role) continue;
    const Result<number::Exact> value =
        scheme::Scope<number::Exact>(*scheme, std::nullopt, std::nullopt)(weight.value);
    if (!value) return value.error();
    return to_string(value->rational());
  }
  return std::string("0");
}

/// A place of the butterfly's edge stencil and its role.
struct StencilPlace {
  figure::PagePoint at;
  const char* role;
};
std::vector<StencilPlace> stencil_places() {
  const double h = std::sqrt(3.0) / 2;
  return {{{-0.5, 0}, "end"},      {{0.5, 0}, "end"},     {{0, h}, "wing"},    {{0, -h}, "wing"},
          {{-1, h}, "outer"},      {{1, h}, "outer"},     {{-1, -h}, "outer"}, {{1, -h}, "outer"},
          {{-1.5, 0}, "opposite"}, {{1.5, 0}, "opposite"}};
}

/// The stencil's net with a text at each place; the new vertex in red.
figure::NetPanel stencil_panel(const std::string& title, const std::vector<std::string>& texts) {
  figure::NetPanel panel;
  panel.title = title;
  panel.place_labels = true;
  figure::NetPanel::Net net{.colour = figure::grey(0.45), .stroke = {.width = 0.5}, .dot = 1.6};
  const std::vector<StencilPlace> places = stencil_places();
  for (std::size_t i = 0; i < places.size(); ++i) {
    net.vertices.push_back(places[i].at);
    for (std::size_t j = 0; j < i; ++j)
      if (std::hypot(places[i].at[0] - places[j].at[0], places[i].at[1] - places[j].at[1]) < 1.01)
        net.edges.push_back({static_cast<int>(i), static_cast<int>(j)});
    if (texts[i] != "0") panel.labels.push_back({places[i].at, texts[i]});
  }
  panel.nets = {std::move(net), {.vertices = {{0, 0}}, .colour = {0.8, 0.1, 0.1, 1}, .dot = 1.8}};
  return panel;
}

/// Fig. 18: the low pass's vertex rule at one end of the edge, at k = 6.
Result<std::vector<std::string>> one_end_texts(const Member& low) {
  const Result<Scheme> scheme = low.load();
  if (!scheme) return scheme.error();
  std::string self, ring;
  for (const Weight& weight : scheme->rule(RuleKind::vertex)->front().weights) {
    const Result<number::Exact> value =
        scheme::Scope<number::Exact>(*scheme, 6, std::nullopt)(weight.value);
    if (!value) return value.error();
    (weight.role == "self" ? self : ring) = to_string(value->rational());
  }
  std::vector<std::string> texts;
  for (const StencilPlace& place : stencil_places()) {
    const double apart = std::hypot(place.at[0] + 0.5, place.at[1]);  // from the left end
    texts.push_back(apart < 0.01 ? self : apart < 1.01 ? ring : "0");
  }
  return texts;
}

Status add_stencil_figure(PaperPage& page, const Members& members, const Member& whole) {
  figure::Figure figure(2);
  report::DescribedTable numbers{{{"figure", "of the paper"},
                                  {"x", "place of the old vertex, the new one at 0 [edges]"},
                                  {"y", "place of the old vertex, the new one at 0 [edges]"},
                                  {"weight", "of the old vertex in the new one"}},
                                 {}};
  const auto add = [&](const std::string& title, const std::vector<std::string>& texts) {
    figure.add(stencil_panel(title, texts));
    const std::vector<StencilPlace> places = stencil_places();
    for (std::size_t i = 0; i < places.size(); ++i)
      numbers.rows.push_back(
          {title.substr(0, title.find(':')), places[i].at[0], places[i].at[1], texts[i]});
  };
  const auto add_member = [&](const std::string& title, const Member& member) -> Status {
    std::vector<std::string> texts;
    for (const StencilPlace& place : stencil_places()) {
      const Result<std::string> weight = edge_weight(member, place.role);
      if (!weight) return weight.error();
      texts.push_back(*weight);
    }
    add(title, texts);
    return Done{};
  };
  if (Status status = add_member("Fig. 17: butterfly", members.butterfly); !status) return status;
  const Result<std::vector<std::string>> one_end = one_end_texts(members.low);
  if (!one_end) return one_end.error();
  add("Fig. 18: not symmetric", *one_end);
  for (const auto& [title, member] : {std::pair{"Fig. 19: symmetric, b = 1", &whole},
                                      {"Fig. 20: b = 1/4", &members.quarter},
                                      {"Fig. 21: b = 1/8", &members.eighth},
                                      {"Fig. 22: b = 3/16", &members.sixteenths}})
    if (Status status = add_member(title, *member); !status) return status;
  return page.add_figure(
      {"Figures 17 to 22", "fig17-22"}, figure, numbers,
      "stencils of new vertices: butterfly, the operator on one end, its symmetric form, and their "
      "convex combinations.",
      "weights 0 are left out. Figure 18 is the low pass's vertex rule at the left end; Figure 19 "
      "is reconstructed, see below.");
}

/// Fig. 16: what the operators do to one step from the raised vertex, in section.
Status add_operators(PaperPage& page, const Members& members, const Member& whole) {
  const Control raised = raised_control();
  figure::Figure figure(2);
  report::DescribedTable numbers{{{"scheme", "whose step it is"},
                                  {"x", "along a line of edges [control edges]"},
                                  {"z", "height after one step"}},
                                 {}};
  for (const auto& pair : {std::pair{&members.loop, &members.low}, {&members.butterfly, &whole}}) {
    figure::ChartPanel panel{.x_label = "edges of the control mesh"};
    for (const Member* member : {pair.first, pair.second}) {
      const Result<Scheme> scheme = member->load();
      if (!scheme) return scheme.error();
      const auto fine = refine::refine(*scheme, raised.mesh, raised.points, 1);
      if (!fine) return fine.error();
      std::vector<std::pair<double, double>> points;
      for (const Point3& p : fine->values)
        if (std::abs(p.y) < 1e-9 && std::abs(p.x) < 2.01) points.emplace_back(p.x, p.z);
      std::sort(points.begin(), points.end());
      figure::ChartPanel::Series series{.name = member->words, .markers = true};
      for (const auto& [x, z] : points) {
        series.x.push_back(x);
        series.y.push_back(z);
        numbers.rows.push_back({member->words, x, z});
      }
      panel.series.push_back(std::move(series));
    }
    figure.add(std::move(panel), pair.first == &members.loop
                                     ? "L on all vertices, a < 0"
                                     : "the operator on new vertices alone");
  }
  return page.add_figure(
      {"Figure 16", "fig16"}, figure, numbers,
      "the effect of L with a < 0 (left), and of the operator that moves new vertices alone "
      "(right).",
      "one step from the raised vertex of Figure 23, in section: the low pass moves the old vertex "
      "down, the operator for interpolating schemes leaves it where it is.");
}

}  // namespace

Status add_stencils(PaperPage& page, const Members& members) {
  page.add_heading("§4.1 The stencils of the low pass Laplacian butterfly");
  const Member whole{"butterfly, b = 1", "laplacian-butterfly", {"b=1"}};
  if (Status status = add_operators(page, members, whole); !status) return status;
  if (Status status = add_stencil_figure(page, members, whole); !status) return status;
  std::vector<std::vector<std::string>> rows{{"role (positions)", "Fig. 17: butterfly",
                                              "Fig. 19: b = 1", "Fig. 20: b = 1/4",
                                              "Fig. 21: b = 1/8", "Fig. 22: b = 3/16"}};
  report::DescribedTable numbers{{{"role", "of the old vertices, and how many there are"},
                                  {"butterfly", "weight of each in the new vertex (Fig. 17)"},
                                  {"b_1", "weight at b = 1 (Fig. 19)"},
                                  {"b_1_4", "weight at b = 1/4 (Fig. 20)"},
                                  {"b_1_8", "weight at b = 1/8 (Fig. 21)"},
                                  {"b_3_16", "weight at b = 3/16 (Fig. 22)"}},
                                 {}};
  for (const auto& [role, words] : {std::pair{"end", "end (2)"},
                                    {"wing", "wing (2)"},
                                    {"outer", "outer (4)"},
                                    {"opposite", "straight beyond an end (2)"}}) {
    rows.push_back({words});
    numbers.rows.push_back({words});
    for (const Member* member :
         {&members.butterfly, &whole, &members.quarter, &members.eighth, &members.sixteenths}) {
      const Result<std::string> weight = edge_weight(*member, role);
      if (!weight) return weight.error();
      rows.back().push_back(*weight);
      numbers.rows.back().emplace_back(to_double(Rational(*weight)));
    }
  }
  return page.add_table(
      {"Figures 17, 19 to 22 as a table", "stencils"}, rows, numbers,
      "The figures are lost from the text that limn was written from. Its stencil for b = 1 is the "
      "mean of (1/2, 1/12, …) at both ends, a reconstruction: it is the symmetric candidate with "
      "which the smoothness is lost at b = 1/4 exactly, as the paper says (see the claims below).");
}

Result<DifferenceFit> difference_fit(const Members& members, int k) {
  const Result<Scheme> scheme = members.optimal.load();
  if (!scheme) return scheme.error();
  const Result<Vectors> limit = limit_differences(*scheme, random_vectors(k));
  if (!limit) return limit.error();
  return fit(*limit);
}

Status add_differences(PaperPage& page, const Members& members) {
  page.add_heading("§5.1 Difference vectors in the limit");
  const Result<Scheme> scheme = members.optimal.load();
  if (!scheme) return scheme.error();
  figure::Figure figure(4);
  report::DescribedTable numbers{{{"panel", "of the figure, and what it starts from"},
                                  {"k", "number of the difference vector"},
                                  {"x", "of it [mean lengths of the vectors]"},
                                  {"y", "of it [mean lengths of the vectors]"}},
                                 {}};
  const auto add = [&](const Vectors& start, const std::string& words) -> Status {
    const Result<Vectors> limit = limit_differences(*scheme, start);
    if (!limit) return limit.error();
    figure.add(panel_of(*limit), words);
    for (int k = 0; k < limit->cols(); ++k)
      numbers.rows.push_back({words, static_cast<double>(k), (*limit)(0, k), (*limit)(1, k)});
    return Done{};
  };
  if (Status status = add(regular_polygon(6), "k = 6, from a regular hexagon"); !status)
    return status;
  for (const int n : {6, 5, 7})
    if (Status status = add(random_vectors(n), fmt::format("k = {}, from random vectors", n));
        !status)
      return status;
  double worst = 0;
  std::string axes;
  for (int n = 5; n <= 20; ++n) {
    const Result<DifferenceFit> found = difference_fit(members, n);
    if (!found) return found.error();
    worst = std::max(worst, found->distance);
    if (n % 2 == 1 && n < 10)
      axes += fmt::format("{}{:.2f} at k = {}", axes.empty() ? "" : ", ", found->axes, n);
  }
  return page.add_figure(
      {"Figure 36", "fig36"}, figure, numbers,
      "difference vectors at the limit: a regular k-gon or its expansion in one direction where k "
      "is "
      "even, a regular k-gon where k is odd.",
      fmt::format(
          "an affine image of the regular k-gon for every k, even or odd: the tangent pair's "
          "two eigenvectors have independent coefficients. From random vectors at k = 5 … 20 "
          "the limit is such an image to {:.0e}, and the half-axes of the ellipse through it "
          "have the ratios {}.",
          worst, axes));
}

}  // namespace limn::ks
