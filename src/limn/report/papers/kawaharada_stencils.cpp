#include <cmath>
#include <numbers>
#include <random>

#include <fmt/core.h>
#include <Eigen/Dense>

#include "limn/number/exact.h"
#include "limn/refine/subdivision_matrix.h"
#include "limn/report/papers/kawaharada_parts.h"

namespace limn::ks {
namespace {

constexpr int kSteps = 60;  // until differences are their limit's direction to rounding

/// Vectors in the plane, a column each.
using Vectors = Eigen::Matrix2Xd;

/// The vertices round the centre after many steps, as vectors from it, scaled to mean length 1.
Result<Vectors> limit_differences(const Scheme& scheme, const Vectors& ring) {
  const int n = static_cast<int>(ring.cols());
  const Result<SubdivisionMatrix<double>> matrix = subdivision_matrix<double>(scheme, n, 1);
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

/// The linear map that takes the regular polygon nearest to the vectors, and how far it then is.
struct AffineFit {
  double distance;
  double axes;  ///< longer over shorter half-axis of the ellipse through the vectors: 1 if regular
};
AffineFit fit(const Vectors& vectors) {
  const int n = static_cast<int>(vectors.cols());
  const Vectors polygon = regular_polygon(n);
  const Eigen::Matrix2d map = vectors * polygon.transpose() * 2 / n;
  const Eigen::Vector2d half_axes = map.jacobiSvd().singularValues();
  return {(vectors - map * polygon).colwise().norm().maxCoeff(), half_axes[0] / half_axes[1]};
}

NetPanel panel_of(const Vectors& vectors) {
  NetPanel panel;
  NetPanel::Net net;
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
    const Result<Exact> value = Scope<Exact>(*scheme, std::nullopt, std::nullopt)(weight.value);
    if (!value) return value.error();
    return to_string(value->rational());
  }
  return std::string("0");
}

}  // namespace

Status add_stencils(PaperPage& page, const Members& members) {
  page.add_heading("§4.1 The stencils of the low pass Laplacian butterfly");
  const Member whole{"b = 1", "laplacian-butterfly", {"b=1"}};
  std::vector<std::vector<std::string>> rows{{"role (positions)", "Fig. 17: butterfly",
                                              "Fig. 19: b = 1", "Fig. 20: b = 1/4",
                                              "Fig. 21: b = 1/8", "Fig. 22: b = 3/16"}};
  DataTable numbers{{"role", "butterfly", "b_1", "b_1_4", "b_1_8", "b_3_16"}, {}};
  for (const auto& [role, words] : {std::pair{"end", "end (2)"},
                                    {"wing", "wing (2)"},
                                    {"outer", "outer (4)"},
                                    {"opposite", "straight beyond an end (2)"}}) {
    rows.push_back({words});
    numbers.rows.push_back({static_cast<double>(numbers.rows.size() + 1)});
    for (const Member* member :
         {&members.butterfly, &whole, &members.quarter, &members.eighth, &members.sixteenths}) {
      const Result<std::string> weight = edge_weight(*member, role);
      if (!weight) return weight.error();
      rows.back().push_back(*weight);
      numbers.rows.back().push_back(to_double(Rational(*weight)));
    }
  }
  return page.add_table(
      {"Figures 16 to 22", "stencils"}, rows, numbers,
      "The figures are lost from the text that limn was written from. Its stencil for b = 1 is the "
      "mean of (1/2, 1/12, …) at both ends, a reconstruction: it is the symmetric candidate with "
      "which the smoothness is lost at b = 1/4 exactly, as the paper says (see the claims below).");
}

Status add_differences(PaperPage& page, const Members& members) {
  page.add_heading("§5.1 Difference vectors in the limit");
  const Result<Scheme> scheme = members.optimal.load();
  if (!scheme) return scheme.error();
  Figure figure(4);
  DataTable numbers{{"panel", "k", "x", "y"}, {}};
  const auto add = [&](const Vectors& start, const std::string& words) -> Status {
    const Result<Vectors> limit = limit_differences(*scheme, start);
    if (!limit) return limit.error();
    figure.add(panel_of(*limit), words);
    const double panel = numbers.rows.empty() ? 1 : numbers.rows.back()[0] + 1;
    for (int k = 0; k < limit->cols(); ++k)
      numbers.rows.push_back({panel, static_cast<double>(k), (*limit)(0, k), (*limit)(1, k)});
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
    const Result<Vectors> limit = limit_differences(*scheme, random_vectors(n));
    if (!limit) return limit.error();
    const AffineFit found = fit(*limit);
    worst = std::max(worst, found.distance);
    if (n % 2 == 1 && n < 10)
      axes += fmt::format("{}{:.2f} at k = {}", axes.empty() ? "" : ", ", found.axes, n);
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
