#include "limn/scheme/toml_reader.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace limn {
namespace {

std::string_view type_name(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "an integer";
  if (node.is_floating_point()) return "a decimal";
  if (node.is_boolean()) return "a boolean";
  return "a date or time";
}

int as_int(toml::source_index i) { return static_cast<int>(i); }

}  // namespace

void TomlReader::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

void TomlReader::fail(const toml::node& at, std::string message, std::string hint) {
  const Place where = place(at);
  fail(Error{std::move(message), std::move(hint), where.file, where.line, where.column});
}

Place TomlReader::place(const toml::node& node) const {
  const toml::source_position begin = node.source().begin;
  return {file_, as_int(begin.line), as_int(begin.column)};
}

Place TomlReader::place(const toml::key& key) const {
  const toml::source_position begin = key.source().begin;
  return {file_, as_int(begin.line), as_int(begin.column)};
}

std::string TomlReader::text(const toml::node& node, std::string_view what) {
  if (const auto* string = node.as_string()) return string->get();
  fail(node, fmt::format("{} is {}, expected a string", what, type_name(node)));
  return {};
}

Formula TomlReader::formula(const toml::node& node, std::string_view what) {
  const Place where = place(node);
  if (const auto* integer = node.as_integer())
    return {Expression::constant(Rational(integer->get())), where};
  if (node.is_floating_point()) {
    fail(node, fmt::format("{} is a decimal, which stands for a fraction", what),
         "write the fraction itself in quotes, as \"3/8\"");
    return {};
  }
  if (!node.is_string()) {
    fail(node, fmt::format("{} is {}, expected an expression in quotes", what, type_name(node)));
    return {};
  }
  Result<Expression> expression = Expression::parse(node.as_string()->get());
  if (!expression) {
    Error error = expression.error();
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
  for (const auto& [key, value] : entries) {
    if (!ok()) return;
    visit(*key, *value);
  }
}

void TomlReader::each_element(const toml::node& node, std::string_view what,
                              const std::function<void(const toml::node&)>& visit) {
  const toml::array* array = node.as_array();
  if (array == nullptr) {
    fail(node, fmt::format("{} is {}, expected an array", what, type_name(node)));
    return;
  }
  for (const toml::node& element : *array) {
    if (!ok()) return;
    visit(element);
  }
}

void TomlReader::unknown_key(const toml::key& key, std::string_view what,
                             const std::string& known) {
  const Place where = place(key);
  fail(Error{fmt::format("unknown key '{}' in {}", key.str(), what), "expected " + known,
             where.file, where.line, where.column});
}

}  // namespace limn
