// Faults of a mesh in words: the numbers and lines are those of its file.

#include <algorithm>
#include <limits>

#include "limn/mesh/mesh_faults.h"

namespace limn::mesh {
namespace {

using Kind = MeshFault::Kind;

constexpr std::size_t kListed = 5;  // faults of a kind, and faces of a fault, before "and N more"

struct KindWords {
  Kind kind;
  const char *one, *many;  ///< what so many are, for a list of faults
  const char* remedy;
};

constexpr KindWords kWords[] = {
    {Kind::offsets, "list of face offsets is wrong", "",
     "face_begin holds one offset more than there are faces"},
    {Kind::few_corners, "face has less than 3 corners", "faces have less than 3 corners",
     "remove such faces: --repair does"},
    {Kind::out_of_range, "corner is no vertex", "corners are no vertices",
     "let faces use vertices that there are"},
    {Kind::repeated_corner, "face meets a vertex twice", "times a face meets a vertex twice",
     "remove the repeated corner, or cut the face in two there: --repair does"},
    {Kind::repeated_face, "face is repeated", "faces are repeated",
     "remove the repeated faces: --repair does"},
    {Kind::crowded_edge, "edge lies in more than 2 faces", "edges lie in more than 2 faces",
     "remove the extra faces, or give each sheet its own copies of the two vertices: --cut does"},
    {Kind::flipped_edge, "edge is run through in the same direction by both its faces",
     "edges are run through in the same direction by both their faces", ""},
    {Kind::several_fans, "vertex has faces that form more than one fan",
     "vertices have faces that form more than one fan",
     "give each fan its own copy of the vertex: --cut does"},
};

const KindWords& words_of(Kind kind) {
  return *std::find_if(std::begin(kWords), std::end(kWords),
                       [&](const KindWords& words) { return words.kind == kind; });
}

}  // namespace

std::string count_of(Kind kind, std::size_t count) {
  const KindWords& words = words_of(kind);
  return std::to_string(count) + " " + (count == 1 ? words.one : words.many);
}

namespace {

class Words {
 public:
  Words(const MeshFaults& faults, const Polygons& polygons, const MeshSource& source)
      : faults_(faults), polygons_(polygons), source_(source) {}

  [[nodiscard]] Error error() const {
    Error error;
    error.file = source_.file;
    const auto& list = faults_.list;
    if (list.size() == 1) {
      error.message = sentence(list.front(), false);
      error.line = first_line(list.front());
      error.hint = remedy(list.begin(), list.end()) + counting();
      return error;
    }
    error.line = first_line(list.front());
    error.message = std::to_string(list.size()) + " faults keep the mesh from being a surface:";
    for (auto first = list.begin(); first != list.end();) {
      const auto last = std::find_if(
          first, list.end(), [&](const MeshFault& fault) { return fault.kind != first->kind; });
      error.message += group(first, last);
      first = last;
    }
    error.message += "\n ";
    error.hint = counting().substr(2);
    return error;
  }

  using Iterator = std::vector<MeshFault>::const_iterator;

  [[nodiscard]] std::string remedy(Iterator first, Iterator last) const {
    if (first->kind != Kind::flipped_edge) return words_of(first->kind).remedy;
    const bool some_one_sided = std::any_of(first, last, [](const auto& f) { return f.one_sided; });
    const bool all_one_sided = std::all_of(first, last, [](const auto& f) { return f.one_sided; });
    std::string text;
    if (!all_one_sided)
      text = "reverse the corners of " + face_list(faults_.to_reverse) + ": --orient does";
    if (some_one_sided) {
      if (!text.empty()) text += "; ";
      text += "a one-sided surface, like a Möbius band, must be cut open: --cut does";
    }
    return text;
  }

  [[nodiscard]] std::string sentence(const MeshFault& fault, bool lines) const {
    const Index v = fault.vertices[0], w = fault.vertices[1];
    const auto named = [&](std::size_t k) { return face(fault.faces[k], lines); };
    switch (fault.kind) {
      case Kind::offsets: return "the face offsets do not run from 0 to the number of corners";
      case Kind::few_corners:
        return "face " + named(0) + " has " + std::to_string(polygons_.degree(fault.faces[0])) +
               " corners, but a face needs at least 3";
      case Kind::out_of_range: return out_of_range(fault, named(0));
      case Kind::repeated_corner:
        return "face " + named(0) + " meets vertex " + vertex(v) + " twice";
      case Kind::repeated_face:
        return "face " + named(1) + " is face " + named(0) + " once more" +
               (fault.turned_over ? ", turned over" : "");
      case Kind::crowded_edge:
        return "the edge between vertices " + vertex(v) + " and " + vertex(w) + " lies in " +
               std::to_string(fault.faces.size()) + " faces (" + plain_list(fault.faces, lines) +
               "), but on a surface it lies in at most 2";
      case Kind::flipped_edge:
        return "faces " + named(0) + " and " + named(1) + " both run from vertex " + vertex(v) +
               " to vertex " + vertex(w) +
               (fault.one_sided ? ": the surface is one-sided, neither can just be flipped"
                                : ": one of them is flipped");
      case Kind::several_fans: break;
    }
    return "the faces round vertex " + vertex(v) + " form more than one fan (faces " +
           plain_list(fault.faces, lines) + " apart from " + plain_list(fault.others, lines) +
           "): the surface only touches itself there";
  }

 private:
  [[nodiscard]] std::string group(Iterator first, Iterator last) const {
    const auto count = static_cast<std::size_t>(last - first);
    std::string text = "\n  " + count_of(first->kind, count) + ": " + remedy(first, last);
    for (std::size_t k = 0; k < std::min(count, kListed); ++k)
      text += "\n    " + sentence(first[static_cast<std::ptrdiff_t>(k)], true);
    if (count > kListed) text += "\n    and " + std::to_string(count - kListed) + " more";
    return text;
  }

  [[nodiscard]] std::string out_of_range(const MeshFault& fault, const std::string& named) const {
    const Index count = polygons_.vertex_count(), v = fault.vertices[0];
    std::string text =
        "corner " + std::to_string(fault.corner + source_.first) + " of face " + named;
    // Of numbers that no Index holds, and of those counted backwards, the file's own is not known.
    constexpr Index kLeast = std::numeric_limits<Index>::min();
    constexpr Index kMost = std::numeric_limits<Index>::max();
    if (v == kLeast || (v < 0 && source_.first != 0))
      text += " is no vertex, but ";
    else if (v == kMost)
      text += " is a vertex beyond " + vertex(v - 1) + ", but ";
    else
      text += " is vertex " + vertex(v) + ", but ";
    if (count == 0) return text + "there are no vertices";
    return text + "the vertices are " + vertex(0) + " to " + vertex(count - 1);
  }

  // in 64 bits: the vertex may be no vertex
  [[nodiscard]] std::string vertex(Index v) const {
    return std::to_string(std::int64_t{source_.file_vertex(v)} + source_.first);
  }
  [[nodiscard]] int line_of(Index f) const { return source_.face_line(f); }
  [[nodiscard]] std::string face(Index f, bool with_line) const {
    std::string text = std::to_string(source_.file_face(f) + source_.first);
    if (const int line = line_of(f); with_line && line > 0)
      text += " (line " + std::to_string(line) + ")";
    return text;
  }

  /// "0, 2 and 5"; long lists are cut
  [[nodiscard]] std::string plain_list(const std::vector<Index>& faces, bool lines) const {
    std::string text;
    const std::size_t shown = std::min(faces.size(), kListed + 1);
    for (std::size_t i = 0; i < shown; ++i) {
      if (i > 0) text += i + 1 == faces.size() ? " and " : ", ";
      text += face(faces[i], lines);
    }
    if (shown < faces.size()) text += " and " + std::to_string(faces.size() - shown) + " more";
    return text;
  }
  [[nodiscard]] std::string face_list(const std::vector<Index>& faces) const {
    if (faces.size() == 1) return "face " + face(faces[0], true);
    return std::to_string(faces.size()) + " faces: " + plain_list(faces, true);
  }

  /// The line of the fault: of the face that is too much, where one is.
  [[nodiscard]] int first_line(const MeshFault& fault) const {
    if (fault.faces.empty()) return 0;
    return line_of(fault.kind == Kind::repeated_face ? fault.faces[1] : fault.faces[0]);
  }
  [[nodiscard]] std::string counting() const {
    return "; vertices, faces and corners count from " + std::to_string(source_.first) +
           (source_.file.empty() ? " here" : ", as in the file");
  }

  const MeshFaults& faults_;
  const Polygons& polygons_;
  const MeshSource& source_;
};

}  // namespace

std::string sentence_of(const MeshFault& fault, const Polygons& polygons,
                        const MeshSource& source) {
  return Words({}, polygons, source).sentence(fault, true);
}

std::string remedy_of(const MeshFaults& faults, Kind kind, const Polygons& polygons,
                      const MeshSource& source) {
  const auto is_kind = [kind](const MeshFault& fault) { return fault.kind == kind; };
  const auto first = std::find_if(faults.list.begin(), faults.list.end(), is_kind);
  const auto last = std::find_if_not(first, faults.list.end(), is_kind);
  return first == last ? "" : Words(faults, polygons, source).remedy(first, last);
}

Error error_of(const MeshFaults& faults, const Polygons& polygons, const MeshSource& source) {
  return Words(faults, polygons, source).error();
}

}  // namespace limn::mesh
