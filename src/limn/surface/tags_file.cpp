#include "limn/surface/tags_file.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "limn/base/files/file.h"
#include "limn/scheme/file/toml_reader.h"

namespace limn::surface {
namespace {

/// A name of a closed list.
template <class Value>
std::optional<Value> named(scheme::TomlReader& in, const toml::node& node, std::string_view what,
                           const std::vector<std::pair<std::string, Value>>& known) {
  const std::size_t before = in.faults();
  const std::string name = in.text(node, what);
  if (!in.unharmed_since(before)) return std::nullopt;
  std::string expected;
  for (const auto& [word, value] : known) {
    if (word == name) return value;
    expected += (expected.empty() ? "" : ", ") + word;
  }
  in.fail(node, fmt::format("unknown {} '{}', expected one of {}", what, name, expected));
  return std::nullopt;
}

class TagsReader {
 public:
  TagsReader(const std::string& path, Index first, LabelTags* labels, base::Faults& faults)
      : in_(path, faults), labels_(labels) {
    if (labels != nullptr) labels->file = path;
    tags_.file = path;
    tags_.first = first;
  }

  SharpnessTags run(std::string_view text) {
    const toml::table file = in_.parse(text);
    if (in_.faults() > 0) return {};
    in_.each(file, "the file", [&](const toml::key& key, const toml::node& node) {
      if (key == "boundary")
        tags_.boundary = named(in_, node, "boundary", boundary_modes());
      else if (key == "creases")
        tags_.method = named(in_, node, "creases", crease_methods());
      else if (key == "triangles")
        tags_.smooth_triangles =
            named<bool>(in_, node, "triangles", {{"catmullClark", false}, {"smooth", true}});
      else if (key == "crease" || key == "corner" || key == "hole")
        read_list(std::string(key.str()), node);
      else
        in_.unknown_key(key, "the file",
                        {"boundary", "creases", "triangles", "crease", "corner", "hole"});
    });
    return std::move(tags_);
  }

 private:
  /// One entry of a list.
  struct Entry {
    std::vector<Index> numbers;
    std::vector<double> sharpness;
    std::vector<std::pair<LabelKind, std::string>> names;
  };

  void read_list(const std::string& kind, const toml::node& list) {
    in_.each_element(list, "[[" + kind + "]]", [&](const toml::node& node) {
      const std::size_t before = in_.faults();
      const Entry entry = read_entry(kind, node);
      if (!in_.unharmed_since(before)) return;
      const int line = in_.place(node).line;
      if (!entry.names.empty()) {
        const LabelTags::Kind what = kind == "crease"   ? LabelTags::Kind::crease
                                     : kind == "corner" ? LabelTags::Kind::corner
                                                        : LabelTags::Kind::hole;
        const double sharpness = entry.sharpness.empty() ? 0 : entry.sharpness[0];
        labels_->statements.push_back({what, entry.names, sharpness, line});
      } else if (kind == "crease") {
        tags_.creases.push_back({entry.numbers, entry.sharpness, line});
      } else if (kind == "corner") {
        for (std::size_t i = 0; i < entry.numbers.size(); ++i)
          tags_.corners.push_back(
              {entry.numbers[i], entry.sharpness[entry.sharpness.size() == 1 ? 0 : i], line});
      } else {
        for (const Index f : entry.numbers) tags_.holes.push_back({f, line});
      }
    });
  }

  Entry read_entry(const std::string& kind, const toml::node& node) {
    const std::string what = "[[" + kind + "]]";
    const std::string numbers = kind == "hole" ? "faces" : "vertices";
    const std::size_t before = in_.faults();
    Entry entry;
    in_.each(node, what, [&](const toml::key& key, const toml::node& value) {
      if (key == numbers)
        entry.numbers = read_numbers(value, numbers);
      else if (const std::optional<LabelKind> label = label_kind(key.str()); label)
        read_names(*label, value, entry);
      else if (key == "sharpness" && kind != "hole")
        entry.sharpness = read_sharpness(value);
      else if (kind == "hole")
        in_.unknown_key(key, what, {numbers, "groups", "objects", "materials"});
      else
        in_.unknown_key(key, what, {numbers, "groups", "objects", "materials", "sharpness"});
    });
    if (in_.unharmed_since(before)) check(kind, numbers, entry, node);
    return entry;
  }

  void check(const std::string& kind, const std::string& numbers, const Entry& entry,
             const toml::node& node) {
    if (!entry.names.empty()) return check_named(kind, numbers, entry, node);
    const std::size_t least = kind == "crease" ? 2 : 1;
    if (entry.numbers.size() < least)
      return in_.fail(node,
                      fmt::format("[[{}]] needs {} with {} or more numbers", kind, numbers, least));
    if (kind == "hole") return;
    const std::size_t count = entry.numbers.size() - (least - 1);
    if (entry.sharpness.size() == 1 || entry.sharpness.size() == count) return;
    in_.fail(node, fmt::format("[[{}]] needs a sharpness: a number, \"infinite\", or a list of {}",
                               kind, count));
  }

  static std::optional<LabelKind> label_kind(std::string_view key) {
    if (key == "groups") return LabelKind::group;
    if (key == "objects") return LabelKind::object;
    if (key == "materials") return LabelKind::material;
    return std::nullopt;
  }

  void read_names(LabelKind kind, const toml::node& node, Entry& entry) {
    if (labels_ == nullptr) return in_.fail(node, "names of faces are not known here");
    in_.each_element(node, "names", [&](const toml::node& one) {
      const std::size_t before = in_.faults();
      std::string name = in_.text(one, "name");
      if (in_.unharmed_since(before)) entry.names.emplace_back(kind, std::move(name));
    });
  }

  void check_named(const std::string& kind, const std::string& numbers, const Entry& entry,
                   const toml::node& node) {
    if (!entry.numbers.empty())
      return in_.fail(node,
                      fmt::format("[[{}]] has {} or names of faces, not both", kind, numbers));
    if (kind != "hole" && entry.sharpness.size() != 1)
      in_.fail(node, fmt::format("[[{}]] needs one sharpness: a number or \"infinite\"", kind));
  }

  std::vector<Index> read_numbers(const toml::node& node, const std::string& what) {
    std::vector<Index> numbers;
    in_.each_element(node, what, [&](const toml::node& one) {
      const std::optional<std::int64_t> number = one.value_exact<std::int64_t>();
      if (number && *number >= tags_.first && *number < std::numeric_limits<Index>::max())
        return numbers.push_back(static_cast<Index>(*number - tags_.first));
      in_.fail(one, fmt::format("expected a number of the mesh file's {}, {} or more", what,
                                tags_.first));
    });
    return numbers;
  }

  std::vector<double> read_sharpness(const toml::node& node) {
    std::vector<double> values;
    const auto read = [&](const toml::node& one) {
      const std::optional<double> number = one.value<double>();
      if (one.is_number() && number && *number >= 0) return values.push_back(*number);
      if (one.value_exact<std::string>() == "infinite") return values.push_back(kInfinitelySharp);
      in_.fail(one, "expected a sharpness: a number of 0 or more, or \"infinite\"");
    };
    if (node.is_array())
      in_.each_element(node, "sharpness", read);
    else
      read(node);
    return values;
  }

  scheme::TomlReader in_;
  LabelTags* labels_;
  SharpnessTags tags_;
};

}  // namespace

Result<SharpnessTags> parse_tags(std::string_view text, const std::string& path, Index first,
                                 LabelTags* labels) {
  base::Faults faults;
  SharpnessTags tags = TagsReader(path, first, labels, faults).run(text);
  if (!faults.none()) return faults.joined();
  return tags;
}

Result<SharpnessTags> read_tags_file(const std::string& path, Index first, LabelTags* labels) {
  const Result<std::string> text = base::read_file(path);
  if (!text) return text.error();
  return parse_tags(*text, path, first, labels);
}

}  // namespace limn::surface
