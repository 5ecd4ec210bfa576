#pragma once
/// Sharpness stated by the names that faces have: groups, objects, materials.

#include <string>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::surface {

/// Statements about all edges, vertices or faces between or of named faces.
struct LabelTags {
  /// What a statement makes of the faces that it names.
  enum class Kind : std::uint8_t {
    crease,  ///< of one name: the border of its faces; of several: edges where two of them meet
    corner,  ///< the vertices that faces of all names have
    hole     ///< the faces
  };
  /// One of them.
  struct Statement {
    Kind kind = Kind::crease;
    std::vector<std::pair<LabelKind, std::string>> names;  ///< one or more
    double sharpness = 0;                                  ///< not of holes
    int line = 0;                                          ///< of the file; 0: none is known
  };
  std::string file;                   ///< for messages
  std::vector<Statement> statements;  ///< in the order of the file
};

/// Adds to `sharpness` what the statements say, the later ones counting. A face has a name where
/// its label is that name, or has it among its words (OBJ's `g left wing` are two groups). Fails,
/// with the line, where no face has a name. Cost O(mesh) for each statement.
[[nodiscard]] Status apply_label_tags(const Mesh& mesh, const MeshAttributes& attributes,
                                      const LabelTags& tags, Sharpness& sharpness);

}  // namespace limn::surface
