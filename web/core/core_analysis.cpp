#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/limit/characteristic_map.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/report/lattice/regularity_report.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/least_valence.h"
#include "page_state.h"

namespace limn::page {
namespace {

constexpr int kMostMapSteps = 5;
constexpr double kMostMapPoints = 3e5;
constexpr double kMostSeconds = 600;

Status check_valence(const Scheme& scheme, int valence, int least) {
  if (valence >= least && valence <= kMostValence) return Done{};
  return Error{fmt::format("valence {} is not between {} and {}", valence, least, kMostValence),
               scheme.split->is_dual() ? "of a face with so many corners" : ""};
}

/// Pairs of vertices, an edge each.
std::vector<std::uint32_t> edges_of(const Mesh& mesh) {
  std::vector<std::uint32_t> pairs;
  pairs.reserve(2 * static_cast<std::size_t>(mesh.edge_count()));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    pairs.push_back(static_cast<std::uint32_t>(mesh.origin(h)));
    pairs.push_back(static_cast<std::uint32_t>(mesh.target(h)));
  }
  return pairs;
}

Json net_json(const CharacteristicMap& map) {
  Json points = Json::array(), lines = Json::array();
  for (const Point3& point : map.net_points) points.push_back({point.x, point.y});
  const std::vector<std::uint32_t> edges = edges_of(map.net);
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) lines.push_back({edges[i], edges[i + 1]});
  return {{"points", std::move(points)}, {"lines", std::move(lines)}};
}

Status check_map(const Scheme& scheme, int valence, int steps) {
  if (Status status = check_valence(scheme, valence, 3); !status) return status;
  if (steps < 0 || steps > kMostMapSteps)
    return Error{fmt::format("{} steps are not between 0 and {}", steps, kMostMapSteps)};
  if (valence * std::pow(scheme.split->dilation.growth(), steps) > kMostMapPoints)
    return Error{fmt::format("{} steps make too many points at valence {}", steps, valence),
                 "take fewer steps"};
  return Done{};
}

}  // namespace

std::string PageCore::eigen(int scheme, int valence, bool quick) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    const Scheme& of = (*loaded)->scheme;
    if (Status status = check_valence(of, valence, spectrum::least_valence(*of.split)); !status)
      return status.error();
    if (!(*loaded)->frequencies) (*loaded)->frequencies.emplace(of);
    const Result<FrequencyBlocks> blocks = (*loaded)->frequencies->blocks(valence);
    if (!blocks) return blocks.error();
    const RegularPart regular = quick ? RegularPart{} : find_regular_part(of);
    Json json{{"regular_part", report::regular_part_json(regular)}};
    json.update(report::eigen_json(*blocks, approx_eigencomponents(*blocks, regular)));
    return json;
  });
}

MapAnswer PageCore::characteristic_map(int scheme, int valence, int steps) {
  MapAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    const Scheme& of = (*loaded)->scheme;
    if (Status status = check_map(of, valence, steps); !status) return status.error();
    const Result<CharacteristicMap> map = approx_characteristic_map(of, valence, steps);
    if (!map) return map.error();
    for (const Point3& point : map->image.positions) {
      made.points.push_back(static_cast<float>(point.x));
      made.points.push_back(static_cast<float>(point.y));
    }
    made.lines = edges_of(map->image.mesh);
    return Json{{"valence", map->valence},
                {"eigenvalue", map->eigenvalue},
                {"regular", to_string(map->regular)},
                {"reason", map->reason},
                {"turned_over", map->turned_over},
                {"net", net_json(*map)}};
  });
  return made;
}

std::string PageCore::regularity(int scheme, double seconds) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    if (!(seconds > 0 && seconds <= kMostSeconds))
      return Error{fmt::format("the time is not between 0 and {} seconds", kMostSeconds)};
    const Result<Mask> mask = regular_mask((*loaded)->scheme);
    if (!mask) return mask.error();
    RegularityOptions options;
    options.seconds = seconds;
    const Result<Regularity> found = enclose_regularity(*mask, options);
    if (!found) return found.error();
    return report::regularity_json((*loaded)->scheme.name, *found);
  });
}

}  // namespace limn::page
