#include "limn/report/mesh_check_faults.h"

#include <memory>

#include <fmt/core.h>

namespace limn::report {
namespace {

using Kind = mesh::MeshFault::Kind;

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::offsets: return "offsets";
    case Kind::few_corners: return "few_corners";
    case Kind::out_of_range: return "missing_vertex";
    case Kind::repeated_corner: return "repeated_corner";
    case Kind::repeated_face: return "duplicate_face";
    case Kind::crowded_edge: return "non_manifold_edge";
    case Kind::flipped_edge: return "flipped_edge";
    case Kind::several_fans: break;
  }
  return "non_manifold_vertex";
}

class Lister {
 public:
  explicit Lister(const MeshCheck& check) : check_(check), survey_(check.survey) {}

  std::vector<CheckedKind> list() {
    add_connectivity();
    add_vertices("not_finite", true, true, survey_.not_finite,
                 "has a coordinate that is no finite number",
                 "have coordinates that are no finite numbers", "write numbers");
    add_degenerate();
    add_coincident();
    add_vertices("isolated_vertex", true, false, survey_.isolated, "belongs to no face",
                 "belong to no face", "refinement keeps such where they are");
    add_remarks();
    return std::move(kinds_);
  }

 private:
  [[nodiscard]] std::string vertex(Index v) const {
    std::string text = std::to_string(check_.source.file_vertex(v) + check_.source.first);
    if (const int line = check_.source.vertex_line(v); line > 0)
      text += fmt::format(" (line {})", line);
    return text;
  }
  [[nodiscard]] std::string face(Index f) const {
    std::string text = std::to_string(check_.source.file_face(f) + check_.source.first);
    if (const int line = check_.source.face_line(f); line > 0)
      text += fmt::format(" (line {})", line);
    return text;
  }

  void add_connectivity() {
    const auto& list = survey_.faults.list;
    for (std::size_t first = 0; first < list.size();) {
      const Kind kind = list[first].kind;
      std::size_t last = first;
      while (last < list.size() && list[last].kind == kind) ++last;
      CheckedKind& group = add(name_of(kind), true, true, last - first);
      group.title = mesh::count_of(kind, group.count);
      group.remedy = mesh::remedy_of(survey_.faults, kind, check_.polygons, check_.source);
      group.fault = [this, first](std::size_t k) { return connectivity(first + k); };
      first = last;
    }
  }
  [[nodiscard]] CheckedFault connectivity(std::size_t k) const {
    const mesh::MeshFault& fault = survey_.faults.list[k];
    CheckedFault one;
    for (const Index v : fault.vertices)
      if (v != kNone) one.vertices.push_back(v);
    one.faces = fault.faces;
    one.faces.insert(one.faces.end(), fault.others.begin(), fault.others.end());
    one.message = mesh::sentence_of(fault, check_.polygons, check_.source);
    return one;
  }

  void add_degenerate() {
    const std::size_t here = survey_.degenerate.size(), dropped = check_.dropped.size();
    if (here + dropped == 0) return;
    CheckedKind& group = add("degenerate_face", true, false, here + dropped);
    group.title = fmt::format("{} {} no area, or {} a vertex twice", group.count,
                              group.count == 1 ? "face has" : "faces have",
                              group.count == 1 ? "meets" : "meet");
    group.remedy = here == 0 ? "reading has dropped such facets" : "--repair drops such faces";
    group.fault = [this, here](std::size_t k) {
      CheckedFault one;
      if (k < here) {
        const Index f = survey_.degenerate[k];
        one.faces = {f};
        one.message = "face " + face(f);
        return one;
      }
      const Index number = check_.dropped[k - here];
      one.file_faces = {number};
      one.message = fmt::format("facet {}, dropped", number + check_.source.first);
      return one;
    };
  }

  void add_coincident() {
    const std::size_t count = survey_.coincident.size();
    if (count == 0) return;
    CheckedKind& group = add("coincident_vertex", true, false, count);
    group.title = count == 1 ? "1 vertex lies where an earlier one lies"
                             : fmt::format("{} vertices lie where earlier ones lie", count);
    if (survey_.seams.edges > 0)
      group.remedy = fmt::format(
          "the mesh looks unwelded: joining them closes {} of its {} boundary edges in pairs "
          "(--weld)",
          2 * survey_.seams.edges, survey_.boundary_edges);
    else
      group.remedy =
          "--weld joins them; where sheets or parts touch, that makes the mesh non-manifold";
    group.fault = [this](std::size_t k) {
      const Index v = survey_.coincident[k], first = survey_.coincident_with[k];
      CheckedFault one;
      one.vertices = {first, v};
      one.message = "vertex " + vertex(v) + " lies where vertex " + vertex(first) + " lies";
      return one;
    };
  }

  void add_remarks() {
    add_vertices("near_vertex", false, false, survey_.near,
                 "lies within 1e-6 of the mesh's diagonal from another one",
                 "lie within 1e-6 of the mesh's diagonal from others",
                 "if they are to be one, --weld joins them");
    add_vertices("valence_two", false, false, survey_.valence_two,
                 "amid the surface has two edges only", "amid the surface have two edges only",
                 "they refine, but the surface is seldom fair there");
    add_faces("concave_face", survey_.concave, "is concave", "are concave",
              "--triangulate cuts them rightly");
    add_faces("bent_face", survey_.bent,
              fmt::format("is not plane, by {:.2g} of its size", survey_.most_bent),
              fmt::format("are not plane, by up to {:.2g} of their size", survey_.most_bent), "");
    add_vertices("enormous", false, false, survey_.enormous,
                 "has coordinates beyond 3.4e38, which STL and GLB cannot hold",
                 "have coordinates beyond 3.4e38, which STL and GLB cannot hold",
                 "write obj, off or ply, or scale the mesh down");
  }

  void add_vertices(const char* kind, bool is_fault, bool blocks, const std::vector<Index>& list,
                    const char* one, const char* many, const char* remedy) {
    if (list.empty()) return;
    CheckedKind& group = add(kind, is_fault, blocks, list.size());
    group.title = list.size() == 1 ? fmt::format("1 vertex {}", one)
                                   : fmt::format("{} vertices {}", list.size(), many);
    group.remedy = remedy;
    group.fault = [this, &list](std::size_t k) {
      CheckedFault fault;
      fault.vertices = {list[k]};
      fault.message = "vertex " + vertex(list[k]);
      return fault;
    };
  }
  void add_faces(const char* kind, const std::vector<Index>& list, const std::string& one,
                 const std::string& many, const char* remedy) {
    if (list.empty()) return;
    CheckedKind& group = add(kind, false, false, list.size());
    group.title =
        list.size() == 1 ? "1 face " + one : fmt::format("{} faces {}", list.size(), many);
    group.remedy = remedy;
    group.fault = [this, &list](std::size_t k) {
      CheckedFault fault;
      fault.faces = {list[k]};
      fault.message = "face " + face(list[k]);
      return fault;
    };
  }

  CheckedKind& add(const char* kind, bool is_fault, bool blocks, std::size_t count) {
    CheckedKind& group = kinds_.emplace_back();
    group.kind = kind;
    group.is_fault = is_fault;
    group.blocks = blocks;
    group.count = count;
    return group;
  }

  const MeshCheck& check_;
  const mesh::MeshSurvey& survey_;
  std::vector<CheckedKind> kinds_;
};

}  // namespace

std::vector<CheckedKind> kinds_of(const MeshCheck& check) {
  // the functions that tell single faults keep it
  const auto lister = std::make_shared<Lister>(check);
  std::vector<CheckedKind> kinds = lister->list();
  for (CheckedKind& kind : kinds)
    kind.fault = [lister, tell = std::move(kind.fault)](std::size_t k) { return tell(k); };
  return kinds;
}

}  // namespace limn::report
