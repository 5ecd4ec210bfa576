#include "limn/mesh/io/obj_attributes.h"

#include <algorithm>

namespace limn::io {
namespace {

/// By LabelKind.
constexpr std::array<std::string_view, 4> kLabelKeywords{"o", "g", "usemtl", "s"};

/// Names in the order in which statements change them.
std::size_t at(LabelKind kind) { return static_cast<std::size_t>(kind); }

}  // namespace

bool ObjAttributes::statement(std::string_view keyword, bool& taken) {
  taken = true;
  if (keyword == "vt") return point();
  for (const LabelKind kind : kLabelKinds) {
    if (keyword != kLabelKeywords.at(at(kind))) continue;
    name(kind);
    return true;
  }
  taken = keyword == "mtllib";
  if (taken)
    if (std::string files = in_.take_rest(is_obj_keyword); !files.empty())
      out_.material_files.push_back(std::move(files));
  return true;
}

bool ObjAttributes::point() {
  const Place place = in_.last_place();
  double numbers[3] = {};
  int count = 0;
  while (in_.line_has_more() && count < 3) {
    if (!in_.read_number(numbers[count], "a texture coordinate")) return false;
    ++count;
  }
  if (in_.line_has_more() || count == 0)
    return in_.fail(place, count == 0 ? "a texture point without coordinates, expected u v"
                                      : "a texture point of more than three numbers, expected u v");
  if (count == 3 && numbers[2] != 0)
    remarks_.left_out(place, "third texture coordinates", "texture points");
  if (out_.texture.points.size() == mesh::kMostElements)
    return in_.fail(place, "2^31 - 1 texture points or more");
  out_.texture.points.push_back({numbers[0], numbers[1]});
  return true;
}

void ObjAttributes::name(LabelKind kind) {
  std::string text = in_.take_rest(is_obj_keyword);
  Index& current = current_.at(at(kind));
  current = kNone;  // a keyword alone: no name
  if (text.empty()) return;
  FaceLabels& labels = out_.of(kind);
  const auto [found, fresh] =
      numbers_.at(at(kind)).try_emplace(text, static_cast<Index>(labels.names.size()));
  if (fresh) labels.names.push_back(std::move(text));
  current = found->second;
}

void ObjAttributes::add_colour(const double* colour, int count) {
  static constexpr std::array names{"red", "green", "blue", "alpha"};
  const std::size_t vertices = polygons_.positions.size();
  std::vector<VertexNumbers>& columns = out_.vertices;
  for (auto k = static_cast<int>(columns.size()); k < count; ++k)  // white, and opaque, until now
    columns.push_back({names.at(static_cast<std::size_t>(k)), NumberType::float64,
                       std::vector<double>(vertices - 1, 1.0)});
  if (count == 0 && uncoloured_++ == 0) first_uncoloured_ = in_.last_place();
  for (std::size_t k = 0; k < columns.size(); ++k)
    columns[k].values.push_back(static_cast<int>(k) < count ? colour[k] : 1.0);
}

bool ObjAttributes::corner(std::string_view word, std::string_view rest) {
  std::int64_t index = 0;
  const char* const end = rest.data() + rest.size();
  const bool stated =
      rest.size() > 1 && rest[1] != '/' && parse_integer(rest.data() + 1, end, index) != nullptr;
  std::vector<Index>& of_corner = out_.texture.of_corner;
  if (!stated) {
    if (!of_corner.empty()) of_corner.push_back(kNone);
    return true;
  }
  const auto points = static_cast<std::int64_t>(out_.texture.points.size());
  if (index == 0 || index < -points)
    return in_.fail(in_.last_place(),
                    "the corner " + in_quotes(word) + " names a texture point that is not there: " +
                        count_of(out_.texture.points.size(), "'vt' line", "'vt' lines") +
                        " before this line",
                    "mend the index, or leave attributes out by --attributes none");
  const std::int64_t point = index > 0 ? index - 1 : points + index;
  if (point > last_point_) {
    last_point_ = point;
    last_point_place_ = in_.last_place();
  }
  if (of_corner.empty()) of_corner.resize(polygons_.corners.size() - 1, kNone);
  of_corner.push_back(to_index(point));
  ++of_face_;
  return true;
}

bool ObjAttributes::end_face(Place place, std::size_t corners) {
  if (of_face_ != 0 && of_face_ != corners)
    return in_.fail(place,
                    count_of(of_face_, "corner", "corners") + " of the face " +
                        (of_face_ == 1 ? "has" : "have") + " texture coordinates, of " +
                        std::to_string(corners),
                    "give all corners of a face some, or none; or leave attributes out by "
                    "--attributes none");
  of_face_ = 0;
  const auto faces = static_cast<std::size_t>(polygons_.face_count());
  for (const LabelKind kind : kLabelKinds) {
    FaceLabels& labels = out_.of(kind);
    if (labels.names.empty()) continue;
    labels.of_face.resize(faces - 1, kNone);
    labels.of_face.push_back(current_.at(at(kind)));
  }
  return true;
}

bool ObjAttributes::finish() {
  const auto points = static_cast<std::int64_t>(out_.texture.points.size());
  if (last_point_ >= points)
    return in_.fail(last_point_place_,
                    "the texture point " + std::to_string(last_point_ + 1) +
                        " is not there: the file has " +
                        count_of(out_.texture.points.size(), "'vt' line", "'vt' lines"),
                    "mend the index, or leave attributes out by --attributes none");
  if (out_.texture.of_corner.empty()) out_.texture.points.clear();
  for (FaceLabels& labels : out_.labels)  // named behind the last face
    if (labels.of_face.empty()) labels.names.clear();
  if (!out_.vertices.empty() && uncoloured_ > 0)
    remarks_.warn(first_uncoloured_, count_of(uncoloured_, "vertex has", "vertices have") +
                                         " no colour, while others have: taken as white");
  return true;
}

std::string obj_head_lines(const MeshAttributes& attributes) {
  std::string lines;
  for (const std::string& files : attributes.material_files) lines += "mtllib " + files + '\n';
  return lines;
}

void append_obj_names(std::string& out, const MeshAttributes& attributes, Index before,
                      Index face) {
  for (const LabelKind kind : kLabelKinds) {
    const FaceLabels& labels = attributes.of(kind);
    if (labels.empty()) continue;
    const Index old = before == kNone ? kNone : labels.of_face[static_cast<std::size_t>(before)];
    const Index name = labels.of_face[static_cast<std::size_t>(face)];
    if (name == old) continue;
    out += kLabelKeywords.at(at(kind));
    if (name != kNone) out += ' ' + labels.names[static_cast<std::size_t>(name)];
    out += '\n';
  }
}

}  // namespace limn::io
