#include "limn/mesh/repair/repair.h"

#include <algorithm>
#include <numeric>

#include "limn/base/interrupt.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/mesh/repair/steps.h"

namespace limn::mesh {
namespace detail {

void note(RepairWork& work, const char* what, Index count, const char* one, const char* many,
          const std::string& rest) {
  if (count == 0) return;
  for (RepairStep& step : work.done) {
    if (step.what != what) continue;
    count += step.count;  // done again, after another step
    step = {what, count, std::to_string(count) + " " + (count == 1 ? one : many) + rest};
    return;
  }
  work.done.push_back(
      {what, count, std::to_string(count) + " " + (count == 1 ? one : many) + rest});
}

std::vector<char> faulty_faces(const MeshFaults& faults, Index face_count, bool copies) {
  using Kind = MeshFault::Kind;
  std::vector<char> faulty(static_cast<std::size_t>(face_count), 0);
  for (const MeshFault& fault : faults.list) {
    if (fault.kind == Kind::repeated_face && copies) faulty[fault.faces[1]] = 1;
    const bool own = fault.kind == Kind::few_corners || fault.kind == Kind::out_of_range ||
                     fault.kind == Kind::repeated_corner;
    if (own) faulty[fault.faces[0]] = 1;
  }
  return faulty;
}

namespace {

constexpr int kMostRounds = 16;

std::vector<Index> numbers(std::size_t count) {
  std::vector<Index> list(count);
  std::iota(list.begin(), list.end(), 0);
  return list;
}

RepairWork start(const Polygons& polygons) {
  RepairWork work;
  work.polygons = polygons;
  work.vertex_of = numbers(polygons.positions.size());
  work.joined_with = work.vertex_of;
  work.face_of = numbers(static_cast<std::size_t>(polygons.face_count()));
  work.corner_of = numbers(polygons.corners.size());
  return work;
}

std::vector<char> used_vertices(const Polygons& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Index v : mesh.corners)
    if (v >= 0 && v < mesh.vertex_count()) used[v] = 1;
  return used;
}

/// Takes vertices away that are joined with others, or have lost all their faces.
void compact(RepairWork& work, const std::vector<char>& used_before,
             const std::vector<char>& joined) {
  Polygons& mesh = work.polygons;
  const std::vector<char> used = used_vertices(mesh);
  std::vector<Index> number(used.size(), kNone);
  std::vector<Point3> positions;
  std::vector<Index> vertex_of;
  Index lost = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto at = static_cast<std::size_t>(v);
    const bool is_joined = at < joined.size() && joined[at] != 0;
    const bool isolated_before = at < used_before.size() && used_before[at] == 0;
    if (is_joined || (used[at] == 0 && !isolated_before)) {
      lost += is_joined ? 0 : 1;
      continue;
    }
    number[at] = static_cast<Index>(positions.size());
    positions.push_back(mesh.positions[at]);
    vertex_of.push_back(work.vertex_of[at]);
  }
  const std::size_t gone = mesh.positions.size() - positions.size();
  if (gone == 0) return;
  for (Index& v : mesh.corners)
    if (v >= 0 && v < mesh.vertex_count()) v = number[v];
  for (Index& v : work.sharp_vertices) v = number[v];
  for (auto& edge : work.sharp_edges)
    for (Index& v : edge) v = number[v];
  mesh.positions = std::move(positions);
  work.vertex_of = std::move(vertex_of);
  note(work, "vertices_dropped", lost, "vertex", "vertices", " without a face any more dropped");
}

}  // namespace
}  // namespace detail

Result<Repaired> repair(const Polygons& polygons, const RepairOptions& options) {
  const MeshFaults faults = find_mesh_faults(polygons);
  if (!faults.list.empty() && faults.list.front().kind == MeshFault::Kind::offsets)
    return error_of(faults, polygons, {});
  base::check_interrupt();
  detail::RepairWork work = detail::start(polygons);
  if (options.weld || options.drop) {
    std::vector<char> joined;
    const std::vector<char> used_before = detail::used_vertices(polygons);
    if (options.weld) detail::weld_vertices(work, *options.weld, joined);
    base::check_interrupt();
    if (options.drop) {
      detail::split_repeated_corners(work, nullptr);
      detail::drop_repeated_faces(work);
      // what is cut beside a flat face may be flat or repeated again
      for (int k = 0; k < detail::kMostRounds && detail::drop_flat_faces(work); ++k) {
        base::check_interrupt();
        detail::drop_repeated_faces(work);
      }
    }
    detail::compact(work, used_before, joined);
  }
  base::check_interrupt();
  if (options.cut) detail::cut_sheets(work);
  base::check_interrupt();
  if (options.orient) detail::orient_faces(work);
  base::check_interrupt();
  if (options.cut) detail::cut_one_sided(work);
  if (work.polygons.face_count() == 0 && polygons.face_count() > 0)
    return Error{"no face is left of the mesh: none has three different corners",
                 "is this the file that was meant?"};
  if (auto fault = too_many(work.polygons.positions.size(), work.polygons.face_begin.size(),
                            work.polygons.corners.size()))
    return *std::move(fault);
  return work;
}

MeshSource source_of(const Repaired& repaired, const MeshSource& source) {
  MeshSource result = source;
  result.file_faces.clear();
  result.file_vertices.clear();
  for (const Index f : repaired.face_of) result.file_faces.push_back(source.file_face(f));
  for (const Index v : repaired.vertex_of) result.file_vertices.push_back(source.file_vertex(v));
  // what was repaired before no longer has the vertices that are gone
  result.joined_with = source.file_vertices.empty() ? repaired.joined_with : source.joined_with;
  return result;
}

}  // namespace limn::mesh
