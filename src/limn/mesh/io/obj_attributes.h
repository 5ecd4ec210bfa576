#pragma once
/// What OBJ files say of vertices, corners and faces beside positions: colours behind the
/// coordinates of 'v', texture coordinates 'vt', and the names in 'o', 'g', 'usemtl', 's',
/// 'mtllib'.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/text_scanner.h"

namespace limn::io {

/// Takes them up, statement by statement.
class ObjAttributes {
 public:
  ObjAttributes(TextScanner& in, Remarks& remarks, MeshFile& file)
      : in_(in), remarks_(remarks), polygons_(file.polygons), out_(file.attributes) {}

  /// Reads a statement; false where it is at fault (the scanner knows why). `taken`: it was one.
  [[nodiscard]] bool statement(std::string_view keyword, bool& taken);
  /// The colour of the vertex that was added last: `count` numbers, 0, 3 or 4.
  void add_colour(const double* colour, int count);
  /// What a corner, written as `word`, names behind its vertex: "/2", "/2/3", "//3" or nothing. Its
  /// place is the scanner's last one.
  [[nodiscard]] bool corner(std::string_view word, std::string_view rest);
  /// Of the face whose corners were read.
  [[nodiscard]] bool end_face(Place place, std::size_t corners);
  /// At the end of the file.
  [[nodiscard]] bool finish();

 private:
  [[nodiscard]] bool point();
  void name(LabelKind kind);

  TextScanner& in_;
  Remarks& remarks_;
  const Polygons& polygons_;
  MeshAttributes& out_;
  std::array<Index, 4> current_{kNone, kNone, kNone, kNone};
  std::array<std::map<std::string, Index, std::less<>>, 4> numbers_;
  std::size_t of_face_ = 0;       ///< corners of this face that have a point
  std::int64_t last_point_ = -1;  ///< the largest that a corner names
  Place last_point_place_;
  std::size_t uncoloured_ = 0;
  Place first_uncoloured_;
};

/// The statements in front of the faces: mtllib.
[[nodiscard]] std::string obj_head_lines(const MeshAttributes& attributes);
/// The statements that change names before a face, where they are others than those of the face
/// before it (kNone: the first).
void append_obj_names(std::string& out, const MeshAttributes& attributes, Index before, Index face);

}  // namespace limn::io
