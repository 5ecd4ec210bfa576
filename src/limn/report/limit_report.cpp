#include "limn/report/limit_report.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace limn::report {
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

using Reasons = std::map<std::string, std::vector<Index>>;

Reasons by_reason(const std::vector<LimitPoints::Refused>& refused) {
  Reasons reasons;
  for (const LimitPoints::Refused& one : refused) reasons[one.reason].push_back(one.vertex);
  return reasons;
}

Reasons by_reason(const std::vector<LimitGaps::Curvatures>& gaps) {
  Reasons reasons;
  for (const LimitGaps::Curvatures& gap : gaps)
    reasons[std::string(to_string(gap.reason))] = gap.vertices;
  return reasons;
}

nlohmann::ordered_json gap_json(std::vector<Index> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return {{"count", vertices.size()}, {"vertices", std::move(vertices)}};
}

nlohmann::ordered_json gap_json(const Reasons& reasons) {
  std::vector<Index> all;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [reason, vertices] : reasons) {
    all.insert(all.end(), vertices.begin(), vertices.end());
    list.push_back({{"reason", reason}, {"vertices", vertices}});
  }
  nlohmann::ordered_json json = gap_json(std::move(all));
  json["reasons"] = std::move(list);
  return json;
}

}  // namespace

Warnings gaps_text(const LimitGaps& gaps, const GapPlaces& places) {
  Warnings sentences;
  const auto say = [&](const std::string& file, std::string sentence) {
    sentences.push_back({std::move(sentence), {}, file, 0, 0});
  };
  for (const auto& [reason, vertices] : by_reason(gaps.limits))
    say(places.mesh,
        fmt::format("no limit point at {} (counted from 0): {}; left where {} was",
                    vertices_text(vertices), reason, vertices.size() == 1 ? "it" : "each"));
  if (!gaps.normals.empty())
    say(places.mesh, fmt::format("no normal at {} (counted from 0): {}",
                                 vertices_text(gaps.normals), places.normal));
  for (const auto& [reason, vertices] : by_reason(gaps.curvatures))
    say(places.curvatures,
        fmt::format("no curvature at {} (counted from 0): {}", vertices_text(vertices), reason));
  return sentences;
}

nlohmann::ordered_json gaps_json(const LimitGaps& gaps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!gaps.limits.empty()) json["limits"] = gap_json(by_reason(gaps.limits));
  if (!gaps.normals.empty()) json["normals"] = gap_json(gaps.normals);
  if (!gaps.curvatures.empty()) json["curvatures"] = gap_json(by_reason(gaps.curvatures));
  return json;
}

}  // namespace limn::report
