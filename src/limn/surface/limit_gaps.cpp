#include "limn/surface/refine_surface.h"

#include <cstddef>
#include <map>
#include <utility>

namespace limn {

std::vector<Index> without_normal(const std::vector<Point3>& normals) {
  std::vector<Index> found;
  for (std::size_t v = 0; v < normals.size(); ++v)
    if (normals[v] == Point3{}) found.push_back(static_cast<Index>(v));
  return found;
}

std::vector<Index> without_normal(const std::vector<Point3>& normals, const Mesh& mesh,
                                  const SideNormals& sides) {
  std::vector<Index> found = without_normal(normals);
  if (sides.empty()) return found;
  std::vector<bool> has(normals.size(), false), lacks(normals.size(), false);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    const Index side = sides.of_corner[static_cast<std::size_t>(h)];
    const auto v = static_cast<std::size_t>(mesh.origin(h));
    const bool known =
        side != kNone && !(sides.normals[static_cast<std::size_t>(side)] == Point3{});
    (known ? has : lacks)[v] = true;
  }
  std::erase_if(found, [&](Index v) {
    return has[static_cast<std::size_t>(v)] && !lacks[static_cast<std::size_t>(v)];
  });
  return found;
}

std::vector<LimitGaps::Curvatures> without_curvature(const std::vector<NoCurvature>& reasons) {
  std::map<NoCurvature, std::vector<Index>> found;
  for (std::size_t v = 0; v < reasons.size(); ++v)
    if (reasons[v] != NoCurvature::none) found[reasons[v]].push_back(static_cast<Index>(v));
  std::vector<LimitGaps::Curvatures> gaps;
  gaps.reserve(found.size());
  for (auto& [reason, vertices] : found) gaps.push_back({reason, std::move(vertices)});
  return gaps;
}

}  // namespace limn
