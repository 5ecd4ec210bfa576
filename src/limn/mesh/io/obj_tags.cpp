#include "limn/mesh/io/obj_tags.h"

#include <algorithm>
#include <array>
#include <limits>

#include "limn/mesh/io/text_writer.h"

namespace limn::io {
namespace {

/// One statement.
struct Tag {
  Place place;
  std::string name;
  std::vector<Index> integers;
  std::vector<double> decimals;
  std::vector<std::string> words;
};

/// The numbers of integers, decimals and words.
bool read_counts(TextScanner& in, std::array<std::int64_t, 3>& counts) {
  const std::string_view word = in.line_has_more() ? in.take_word() : std::string_view();
  const char* p = word.data();
  const char* const end = p + word.size();
  constexpr std::int64_t most = std::numeric_limits<Index>::max();
  for (std::size_t k = 0; k < counts.size() && p != nullptr; ++k) {
    if (k > 0) p = p != end && *p == '/' ? p + 1 : nullptr;
    if (p != nullptr) p = parse_integer(p, end, counts[k]);
    if (p != nullptr && (counts[k] < 0 || counts[k] > most)) p = nullptr;
  }
  if (p == end && !word.empty()) return true;
  return in.fail(word.empty() ? in.place() : in.last_place(),
                 "expected the numbers of integers, decimals and words of the tag, as 2/1/0" +
                     (word.empty() ? std::string() : ", found " + in_quotes(word)));
}

bool read_tag(TextScanner& in, Tag& tag) {
  std::array<std::int64_t, 3> counts{};
  if (!read_counts(in, counts)) return false;
  for (std::int64_t k = 0; k < counts[0]; ++k) {
    std::int64_t value = 0;
    if (!in.read_integer(value, "an integer of the tag")) return false;
    if (value < 0 || value > std::numeric_limits<Index>::max())
      return in.fail(in.last_place(),
                     "expected a number of 0 or more, found " + in_quotes(in.last_word()));
    tag.integers.push_back(static_cast<Index>(value));
  }
  for (std::int64_t k = 0; k < counts[1]; ++k) {
    double value = 0;
    if (!in.read_number(value, "a decimal of the tag")) return false;
    tag.decimals.push_back(value);
  }
  for (std::int64_t k = 0; k < counts[2]; ++k) {
    if (!in.line_has_more()) return in.fail(in.place(), "expected a word of the tag");
    tag.words.emplace_back(in.take_word());
  }
  if (!in.line_has_more()) return true;
  in.take_word();
  return in.fail(in.last_place(), "the tag has more than its " + std::to_string(counts[0]) + "/" +
                                      std::to_string(counts[1]) + "/" + std::to_string(counts[2]) +
                                      " arguments");
}

/// That there is one sharpness, or as many as there are to be sharpened, of 0 or more.
bool check_sharpness(TextScanner& in, const Tag& tag, std::size_t count) {
  if (tag.decimals.size() != 1 && tag.decimals.size() != count)
    return in.fail(tag.place, "the tag has " + std::to_string(tag.decimals.size()) +
                                  " decimals, expected one sharpness" +
                                  (count > 1 ? " or " + std::to_string(count) : ""));
  const auto bad =
      std::find_if(tag.decimals.begin(), tag.decimals.end(), [](double s) { return s < 0; });
  if (bad == tag.decimals.end()) return true;
  std::string text;
  append(text, *bad);
  return in.fail(tag.place, "a sharpness of " + text + ", expected 0 or more");
}

bool take_crease(TextScanner& in, const Tag& tag, SharpnessTags& tags) {
  if (tag.integers.size() < 2)
    return in.fail(tag.place, "a crease of " + std::to_string(tag.integers.size()) +
                                  " vertices, expected two or more");
  if (!check_sharpness(in, tag, tag.integers.size() - 1)) return false;
  tags.creases.push_back({tag.integers, tag.decimals, tag.place.line});
  return true;
}

bool take_corner(TextScanner& in, const Tag& tag, SharpnessTags& tags) {
  if (!check_sharpness(in, tag, tag.integers.size())) return false;
  for (std::size_t i = 0; i < tag.integers.size(); ++i)
    tags.corners.push_back({tag.integers[i],
                            tag.decimals.size() == 1 ? tag.decimals[0] : tag.decimals[i],
                            tag.place.line});
  return true;
}

bool take_hole(TextScanner&, const Tag& tag, SharpnessTags& tags) {
  for (const Index f : tag.integers) tags.holes.push_back({f, tag.place.line});
  return true;
}

constexpr std::array kBoundaryModes{BoundaryMode::none, BoundaryMode::edge_and_corner,
                                    BoundaryMode::edge_only};

bool take_boundary(TextScanner& in, const Tag& tag, SharpnessTags& tags) {
  if (tag.integers.size() != 1 || tag.integers[0] >= static_cast<Index>(kBoundaryModes.size()))
    return in.fail(tag.place,
                   "expected 0 (none), 1 (edges and corners) or 2 (edges) for interpolateboundary");
  tags.boundary = kBoundaryModes.at(static_cast<std::size_t>(tag.integers[0]));
  return true;
}

bool take_method(TextScanner& in, const Tag& tag, SharpnessTags& tags) {
  const std::string word = tag.words.size() == 1 ? tag.words[0] : "";
  if (word != "normal" && word != "chaikin")
    return in.fail(tag.place, "expected normal or chaikin for creasemethod");
  tags.method = word == "chaikin" ? CreaseMethod::chaikin : CreaseMethod::uniform;
  return true;
}

bool take_triangles(TextScanner& in, const Tag& tag, SharpnessTags& tags) {
  const std::string word = tag.words.size() == 1 ? tag.words[0] : "";
  if (word != "catmark" && word != "smooth")
    return in.fail(tag.place, "expected catmark or smooth for smoothtriangles");
  tags.smooth_triangles = word == "smooth";
  return true;
}

struct Reader {
  std::string_view name;
  bool (*take)(TextScanner&, const Tag&, SharpnessTags&);
};
constexpr std::array<Reader, 6> kReaders{{{"crease", take_crease},
                                          {"corner", take_corner},
                                          {"hole", take_hole},
                                          {"interpolateboundary", take_boundary},
                                          {"creasemethod", take_method},
                                          {"smoothtriangles", take_triangles}}};

template <class Numbers>
void append_tag(std::string& out, std::string_view name, const Numbers& integers,
                const std::vector<double>& decimals) {
  out += "t ";
  out += name;
  out += ' ' + std::to_string(integers.size()) + '/' + std::to_string(decimals.size()) + "/0";
  for (const Index i : integers) {
    out += ' ';
    append(out, i);
  }
  for (const double d : decimals) {
    out += ' ';
    append(out, d);
  }
  out += '\n';
}

}  // namespace

bool read_obj_tag(TextScanner& in, SharpnessTags& tags, std::string& name) {
  Tag tag;
  tag.place = in.last_place();
  if (!in.line_has_more()) return in.fail(in.place(), "expected the name of a tag");
  tag.name = in.take_word();
  const auto reader = std::find_if(kReaders.begin(), kReaders.end(),
                                   [&](const Reader& one) { return one.name == tag.name; });
  if (reader == kReaders.end()) {
    name = tag.name;
    return true;
  }
  if (tags.statements++ == 0) {
    tags.line = tag.place.line;
    tags.column = tag.place.column;
  }
  return read_tag(in, tag) && reader->take(in, tag, tags);
}

std::string obj_tag_lines(const SharpnessTags& tags) {
  std::string out;
  using One = std::array<Index, 1>;
  if (tags.boundary) {
    const auto mode = std::find(kBoundaryModes.begin(), kBoundaryModes.end(), *tags.boundary);
    append_tag(out, "interpolateboundary", One{static_cast<Index>(mode - kBoundaryModes.begin())},
               {});
  }
  if (tags.method)
    out += std::string("t creasemethod 0/0/1 ") +
           (*tags.method == CreaseMethod::chaikin ? "chaikin\n" : "normal\n");
  if (tags.smooth_triangles)
    out += std::string("t smoothtriangles 0/0/1 ") +
           (*tags.smooth_triangles ? "smooth\n" : "catmark\n");
  for (const SharpnessTags::Crease& crease : tags.creases)
    append_tag(out, "crease", crease.vertices, crease.sharpness);
  for (const SharpnessTags::Corner& corner : tags.corners)
    append_tag(out, "corner", One{corner.vertex}, {corner.sharpness});
  for (const SharpnessTags::Hole& hole : tags.holes) append_tag(out, "hole", One{hole.face}, {});
  return out;
}

}  // namespace limn::io
