#pragma once
/// Sharpness in a file of its own, for mesh formats that hold none:
///
///     boundary  = "edgeAndCorner"     # or none, edgeOnly
///     creases   = "chaikin"           # or uniform
///     triangles = "smooth"            # or catmullClark
///
///     [[crease]]
///     vertices  = [1, 2, 3]           # a chain of edges, by the mesh file's numbers
///     sharpness = 2.5                 # or "infinite", or a list: one for each edge
///
///     [[corner]]
///     vertices  = [4, 7]
///     sharpness = "infinite"          # or a list: one for each vertex
///
///     [[hole]]
///     faces     = [5]
///
/// In place of numbers stand names of faces, as obj files have them (label_tags.h):
///
///     [[crease]]
///     groups    = ["lid"]             # the border of these faces
///     sharpness = 3
///
///     [[corner]]
///     materials = ["steel", "glass"]  # vertices that faces of both have; objects likewise
///     sharpness = "infinite"

#include <string>

#include "limn/mesh/sharpness/sharpness.h"
#include "limn/surface/label_tags.h"

namespace limn::surface {

/// Reads such a file. `first` is the number that the mesh file gives its first vertex and face: 1
/// in OBJ, else 0. What is stated by names goes into `labels`; without it that is a fault. Every
/// fault (TOML syntax, unknown key, wrong type, a number below `first`, a
/// sharpness below 0, a list of another length) is an error with file, line and column.
[[nodiscard]] Result<SharpnessTags> read_tags_file(const std::string& path, Index first,
                                                   LabelTags* labels = nullptr);
/// The same of a text; `path` is for messages.
[[nodiscard]] Result<SharpnessTags> parse_tags(std::string_view text, const std::string& path,
                                               Index first, LabelTags* labels = nullptr);

}  // namespace limn::surface
