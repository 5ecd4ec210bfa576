#pragma once
/// What scheme_reader.cpp needs of toml++: typed access in which every fault is an Error with its
/// place. The first fault is kept; later calls return defaults, so reading code stays linear.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "limn/scheme/scheme.h"
#include "limn/scheme/toml_library.h"

namespace limn {

class TomlReader {
 public:
  explicit TomlReader(std::string file) : file_(std::move(file)) {}

  /// The file as a table; fails on what is no TOML, is too large or is nested too deeply.
  /// `text` must outlive the reader.
  toml::table parse(std::string_view text);

  [[nodiscard]] bool ok() const { return !error_; }
  [[nodiscard]] Error take_error() { return std::move(*error_); }

  void fail(const toml::node& at, std::string message, std::string hint = {});
  void fail(Error error);
  [[nodiscard]] Place place(const toml::node& node) const;
  [[nodiscard]] Place place(const toml::key& key) const;
  [[nodiscard]] const std::string& file() const { return file_; }

  /// The text of a string; fails on any other type.
  std::string text(const toml::node& node, std::string_view what);
  /// An expression, from a string or an integer; a float is refused as a decimal.
  Formula formula(const toml::node& node, std::string_view what);
  /// Calls `visit(key, node)` for each entry, in the file's order; fails if the node is no table.
  void each(const toml::node& node, std::string_view what,
            const std::function<void(const toml::key&, const toml::node&)>& visit);
  /// The same for the elements of an array.
  void each_element(const toml::node& node, std::string_view what,
                    const std::function<void(const toml::node&)>& visit);

  /// "unknown key 'x' in WHAT", with the known ones.
  void unknown_key(const toml::key& key, std::string_view what, const std::string& known);

 private:
  [[nodiscard]] Place place(toml::source_position position) const;
  void fail_at(std::size_t byte, std::string message, std::string hint = {});
  [[nodiscard]] std::size_t byte_of(const Place& place) const;
  [[nodiscard]] Place place_of_expression(const toml::node& node) const;

  std::string file_;
  std::string_view text_;
  std::vector<std::size_t> line_begins_;
  // of each line that has been asked for: the byte that each of its characters begins at
  mutable std::map<int, std::vector<int>> columns_;
  std::optional<Error> error_;
};

}  // namespace limn
