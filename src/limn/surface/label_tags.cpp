#include "limn/surface/label_tags.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "limn/mesh/index.h"

namespace limn::surface {
namespace {

using mesh::at;

bool has_word(std::string_view label, std::string_view word) {
  for (std::size_t from = 0; from <= label.size();) {
    const std::size_t end = std::min(label.find_first_of(" \t", from), label.size());
    if (label.substr(from, end - from) == word) return true;
    from = end + 1;
  }
  return false;
}

std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += (i > 0 ? ", '" : "'") + names[i] + "'";
  return names.size() > most ? text + ", …" : text;
}

class Applier {
 public:
  Applier(const Mesh& mesh, const MeshAttributes& attributes, Sharpness& sharpness)
      : mesh_(mesh), attributes_(attributes), sharpness_(sharpness) {}

  Status apply(const LabelTags::Statement& statement) {
    std::vector<std::vector<bool>> sets;
    for (const auto& [kind, name] : statement.names) {
      const FaceLabels& labels = attributes_.of(kind);
      std::vector<bool> faces = faces_of(labels, name);
      if (std::find(faces.begin(), faces.end(), true) == faces.end()) return unknown(kind, name);
      sets.push_back(std::move(faces));
    }
    switch (statement.kind) {
      case LabelTags::Kind::crease: sharpen_edges(sets, statement.sharpness); break;
      case LabelTags::Kind::corner: sharpen_vertices(sets, statement.sharpness); break;
      case LabelTags::Kind::hole: cut_holes(sets); break;
    }
    return Done{};
  }

 private:
  [[nodiscard]] std::vector<bool> faces_of(const FaceLabels& labels,
                                           const std::string& name) const {
    std::vector<bool> named(labels.names.size());
    for (std::size_t i = 0; i < named.size(); ++i)
      named[i] = labels.names[i] == name || has_word(labels.names[i], name);
    std::vector<bool> faces(at(mesh_.face_count()), false);
    for (std::size_t f = 0; f < labels.of_face.size(); ++f)
      if (labels.of_face[f] != kNone) faces[f] = named[at(labels.of_face[f])];
    return faces;
  }

  [[nodiscard]] Error unknown(LabelKind kind, const std::string& name) const {
    const FaceLabels& labels = attributes_.of(kind);
    if (labels.empty())
      return {fmt::format("the mesh has no {}, '{}' is none of them", words_of(kind), name),
              "only obj files have names of faces; --attributes none leaves them out"};
    return {fmt::format("no face has the name '{}' among the {}", name, words_of(kind)),
            "there are " + listed(labels.names)};
  }

  void sharpen_edges(const std::vector<std::vector<bool>>& sets, double value) {
    sharpness_.edges.resize(at(mesh_.edge_count()), 0);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.halfedge_of_edge(e), t = mesh_.twin(h);
      if (t == kNone) continue;
      const std::size_t f = at(mesh_.face(h)), g = at(mesh_.face(t));
      bool sharp = sets.size() == 1 && sets[0][f] != sets[0][g];
      for (std::size_t i = 0; i < sets.size() && !sharp; ++i)
        for (std::size_t k = 0; k < sets.size() && !sharp; ++k)
          sharp = i != k && sets[i][f] && sets[k][g] && !(sets[i][g] && sets[k][f]);
      if (sharp) sharpness_.edges[at(e)] = value;
    }
  }

  void sharpen_vertices(const std::vector<std::vector<bool>>& sets, double value) {
    sharpness_.vertices.resize(at(mesh_.vertex_count()), 0);
    std::vector<std::size_t> count(sharpness_.vertices.size(), 0);
    for (const std::vector<bool>& set : sets) {
      std::vector<bool> has(count.size(), false);
      for (Index h = 0; h < mesh_.halfedge_count(); ++h)
        if (set[at(mesh_.face(h))]) has[at(mesh_.origin(h))] = true;
      for (std::size_t v = 0; v < count.size(); ++v) count[v] += has[v] ? 1 : 0;
    }
    for (std::size_t v = 0; v < count.size(); ++v)
      if (count[v] == sets.size()) sharpness_.vertices[v] = value;
  }

  void cut_holes(const std::vector<std::vector<bool>>& sets) {
    sharpness_.holes.resize(at(mesh_.face_count()), false);
    for (const std::vector<bool>& set : sets)
      for (std::size_t f = 0; f < set.size(); ++f)
        if (set[f]) sharpness_.holes[f] = true;
  }

  const Mesh& mesh_;
  const MeshAttributes& attributes_;
  Sharpness& sharpness_;
};

}  // namespace

Status apply_label_tags(const Mesh& mesh, const MeshAttributes& attributes, const LabelTags& tags,
                        Sharpness& sharpness) {
  Applier applier(mesh, attributes, sharpness);
  for (const LabelTags::Statement& statement : tags.statements) {
    Status status = applier.apply(statement);
    if (status) continue;
    status.error().file = tags.file;
    status.error().line = statement.line;
    return status;
  }
  return Done{};
}

}  // namespace limn::surface
