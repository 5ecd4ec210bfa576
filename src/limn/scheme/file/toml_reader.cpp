#include "limn/scheme/file/toml_reader.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "limn/base/near_word.h"
#include "limn/base/printable.h"
#include "limn/base/utf8.h"
#include "limn/base/wide_text.h"
#include "limn/scheme/scheme_size.h"

namespace limn::scheme {
namespace {

constexpr int kMostDots = 1024;
constexpr std::string_view kAdmit =
    "; a table of decimals is admitted by weights = \"decimal\" at the head of the file";

std::string_view type_name(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a decimal";
  if (node.is_boolean()) return "a boolean";
  return "a date or time";
}

/// The byte of the dot that is one too many, or npos. toml++ makes a table of each part of a key
/// a.b.c…, one within the other, and takes as many nested calls to free them; telling keys from
/// text would take a parser, so every dot between words counts.
std::size_t find_dot_too_many(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  const auto joins = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '"' ||
           c == '\'';
  };
  int dots = 0;
  for (std::size_t at = text.find('.'); at != std::string_view::npos; at = text.find('.', at + 1)) {
    std::size_t before = at;
    while (before > 0 && is_blank(text[before - 1])) --before;
    std::size_t after = at + 1;
    while (after < text.size() && is_blank(text[after])) ++after;
    if (before == 0 || after == text.size() || !joins(text[before - 1]) || !joins(text[after]))
      continue;
    if (++dots > kMostDots) return at;
  }
  return std::string_view::npos;
}

/// The first byte that begins no UTF-8 character, or npos. (toml++ says so too, elsewhere.)
std::size_t find_no_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = base::utf8_length(text.substr(at));
    if (length == 0) return at;
    at += length;
  }
  return std::string_view::npos;
}

}  // namespace

void TomlReader::fail_at(std::size_t byte, std::string message, std::string hint) {
  const auto line = std::upper_bound(line_begins_.begin(), line_begins_.end(), byte) - 1;
  fail(Error{std::move(message), std::move(hint), file_,
             static_cast<int>(line - line_begins_.begin()) + 1,
             static_cast<int>(byte - *line) + 1});
}

toml::table TomlReader::parse(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  text_ = text;
  if (text.size() > kMostSchemeBytes) {
    fail(Error{fmt::format("the scheme file is larger than {} KiB", kMostSchemeBytes / 1024), {}, file_, 0, 0});
    return {};
  }
  line_begins_ = {0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') line_begins_.push_back(i + 1);
  if (const std::size_t dot = find_dot_too_many(text); dot != std::string_view::npos) {
    fail_at(dot, fmt::format("the file has more than {} dotted keys or sentences", kMostDots));
    return {};
  }
  if (const std::string wide = base::wide_encoding(text); !wide.empty()) {
    fail_at(0, base::wide_text_fault(wide), base::wide_text_remedy(wide));
    return {};
  }
  if (const std::size_t bad = find_no_utf8(text); bad != std::string_view::npos) {
    fail_at(bad, "the file is not UTF-8 text", "save it as UTF-8");
    return {};
  }
  toml::parse_result parsed = toml::parse(text, std::string_view(file_));
  if (parsed) return std::move(parsed).table();
  const Place at = place(parsed.error().source().begin);
  std::string message(parsed.error().description());
  const std::size_t byte = byte_of(at);
  const bool in_string = message.find("parsing string") != std::string::npos;
  if (in_string && byte < text.size() && (text[byte] == '\n' || text[byte] == '\r'))
    message = "the string does not end on its line";
  fail(Error{std::move(message), "the file is not valid TOML", file_, at.line, at.column});
  return {};
}

void TomlReader::fail(Error error) {
  error.message = base::printable(error.message);
  error.hint = base::printable(error.hint);
  ++found_;
  faults_.add(std::move(error));
}

void TomlReader::fail(const toml::node& at, std::string message, std::string hint) {
  const Place where = place(at);
  fail(Error{std::move(message), std::move(hint), where.file, where.line, where.column});
}

/// toml++ counts characters; a column of ours is a byte.
Place TomlReader::place(toml::source_position position) const {
  const int line = static_cast<int>(position.line);
  const int column = static_cast<int>(position.column);
  const auto index = static_cast<std::size_t>(line) - 1;
  if (line < 1 || column < 1 || index >= line_begins_.size()) return {file_, line, column};
  const auto [entry, fresh] = columns_.try_emplace(line);
  std::vector<int>& columns = entry->second;
  if (fresh) {
    const std::size_t begin = line_begins_[index];
    const std::size_t end = std::min(text_.find('\n', begin), text_.size());
    const std::string_view text = text_.substr(begin, end - begin);
    for (std::size_t i = 0; i < text.size(); ++i)
      if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U)
        columns.push_back(static_cast<int>(i) + 1);
    columns.push_back(static_cast<int>(text.size()) + 1);
  }
  return {file_, line, columns[std::min(static_cast<std::size_t>(column), columns.size()) - 1]};
}

Place TomlReader::place(const toml::node& node) const { return place(node.source().begin); }

Place TomlReader::place(const toml::key& key) const { return place(key.source().begin); }

std::size_t TomlReader::byte_of(const Place& place) const {
  const auto index = static_cast<std::size_t>(place.line) - 1;
  return place.line < 1 || index >= line_begins_.size()
             ? text_.size()
             : std::min(line_begins_[index] + static_cast<std::size_t>(place.column) - 1,
                        text_.size());
}

/// Where the byte before the text of a string stands, so that a column in the text can be added.
Place TomlReader::place_of_expression(const toml::node& node) const {
  Place result = place(node);
  const std::string_view source = text_.substr(byte_of(result));
  if (!source.starts_with("\"\"\"") && !source.starts_with("'''")) return result;
  const std::string_view rest = source.substr(3);
  if (rest.starts_with('\n') || rest.starts_with("\r\n")) return {file_, result.line + 1, 0};
  result.column += 2;
  return result;
}

std::string TomlReader::text(const toml::node& node, std::string_view what) {
  if (const auto* string = node.as_string()) return string->get();
  fail(node, fmt::format("{} is {}, expected a string", what, type_name(node)));
  return {};
}

Formula TomlReader::formula(const toml::node& node, std::string_view what) {
  const Place where = place_of_expression(node);
  if (const auto* integer = node.as_integer())
    return {Expression::constant(Rational(integer->get())), where};
  if (node.is_floating_point() && decimals_ == Decimals::admitted) {
    fail(node, fmt::format("{} is a number without quotes, of which not every digit is kept", what),
         "write the decimal in quotes, as \"0.375\"");
    return {};
  }
  if (node.is_floating_point()) {
    fail(node, fmt::format("{} is a decimal, which stands for a fraction", what),
         std::string("write the fraction itself in quotes, as \"3/8\"") + std::string(kAdmit));
    return {};
  }
  if (!node.is_string()) {
    fail(node, fmt::format("{} is {}, expected an expression in quotes", what, type_name(node)));
    return {};
  }
  Result<Expression> expression = Expression::parse(node.as_string()->get(), decimals_);
  if (!expression) {
    Error error = expression.error();
    if (error.message == kDecimalRefused) error.hint += kAdmit;
    error.message = fmt::format("{}: {}", what, error.message);
    error.file = where.file;
    error.line = where.line;
    error.column += where.column;  // the quote stands one before the text
    fail(std::move(error));
    return {};
  }
  return {std::move(*expression), where};
}

void TomlReader::each(const toml::node& node, std::string_view what,
                      const std::function<void(const toml::key&, const toml::node&)>& visit) {
  const toml::table* table = node.as_table();
  if (table == nullptr) {
    fail(node, fmt::format("{} is {}, expected a table", what, type_name(node)));
    return;
  }
  // a toml::table is sorted by key; people mean the order they wrote
  std::vector<std::pair<const toml::key*, const toml::node*>> entries;
  for (const auto& [key, value] : *table) entries.emplace_back(&key, &value);
  std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    const toml::source_position p = a.first->source().begin;
    const toml::source_position q = b.first->source().begin;
    return p.line != q.line ? p.line < q.line : p.column < q.column;
  });
  for (const auto& [key, value] : entries) visit(*key, *value);
}

void TomlReader::each_element(const toml::node& node, std::string_view what,
                              const std::function<void(const toml::node&)>& visit) {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    fail(node, fmt::format("{} is {}, expected an array", what, type_name(node)));
    return;
  }
  for (const toml::node& element : *array) visit(element);
}

void TomlReader::unknown_key(const toml::key& key, std::string_view what,
                             const std::vector<std::string>& known, const std::string& last) {
  std::string expected = "expected ";
  const std::size_t all = known.size() + (last.empty() ? 0 : 1);
  for (std::size_t i = 0; i < all; ++i) {
    if (i > 0) expected += i + 1 == all ? (last.empty() ? " or " : ", or ") : ", ";
    expected += i < known.size() ? known[i] : last;
  }
  const Place where = place(key);
  fail(Error{fmt::format("unknown key '{}' in {}", key.str(), what),
             base::did_you_mean(key.str(), known, expected), where.file, where.line, where.column});
}

}  // namespace limn::scheme
