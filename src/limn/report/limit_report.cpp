#include "limn/report/limit_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace limn {
namespace {

constexpr std::size_t kNamed = 10;

std::vector<Index> first_few(const std::vector<Index>& vertices) {
  return {vertices.begin(),
          vertices.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, vertices.size()))};
}

/// "3 vertices: 4, 7, 9", "vertex 4", "20 vertices: 0, 1, …, 9 and 10 more".
std::string vertices_text(const std::vector<Index>& vertices) {
  if (vertices.size() == 1) return fmt::format("vertex {}", vertices.front());
  std::string text =
      fmt::format("{} vertices: {}", vertices.size(), fmt::join(first_few(vertices), ", "));
  if (vertices.size() > kNamed) text += fmt::format(" and {} more", vertices.size() - kNamed);
  return text;
}

nlohmann::ordered_json gap_json(const std::vector<Index>& vertices) {
  return {{"count", vertices.size()}, {"vertices", first_few(vertices)}};
}

template <class Value, class Missing>
std::vector<Index> places(const std::vector<Value>& values, Missing missing) {
  std::vector<Index> found;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (missing(values[v])) found.push_back(static_cast<Index>(v));
  return found;
}

}  // namespace

std::vector<Index> without_normal(const std::vector<Point3>& normals) {
  return places(normals, [](const Point3& normal) { return normal == Point3{}; });
}

std::vector<Index> without_curvature(const std::vector<LimitPoints::Curvatures>& curvatures) {
  return places(curvatures, [](const LimitPoints::Curvatures& one) {
    return std::isnan(one.largest) || std::isnan(one.smallest);
  });
}

std::vector<std::string> gaps_text(const LimitGaps& gaps, const std::string& normal) {
  std::vector<std::string> sentences;
  std::map<std::string, std::vector<Index>> by_reason;
  for (const LimitPoints::Refused& one : gaps.limits) by_reason[one.reason].push_back(one.vertex);
  for (const auto& [reason, vertices] : by_reason)
    sentences.push_back(fmt::format("no limit point at {} (counted from 0): {}; left where {} was",
                                    vertices_text(vertices), reason,
                                    vertices.size() == 1 ? "it" : "each"));
  if (!gaps.normals.empty())
    sentences.push_back(fmt::format("no normal at {} (counted from 0): written as {}",
                                    vertices_text(gaps.normals), normal));
  if (!gaps.curvatures.empty())
    sentences.push_back(fmt::format(
        "no curvature at {} (counted from 0): on the boundary, not bounded, or not known there",
        vertices_text(gaps.curvatures)));
  return sentences;
}

nlohmann::ordered_json gaps_json(const LimitGaps& gaps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  std::vector<Index> limits;
  for (const LimitPoints::Refused& one : gaps.limits) limits.push_back(one.vertex);
  if (!limits.empty()) json["limits"] = gap_json(limits);
  if (!gaps.normals.empty()) json["normals"] = gap_json(gaps.normals);
  if (!gaps.curvatures.empty()) json["curvatures"] = gap_json(gaps.curvatures);
  return json;
}

}  // namespace limn
