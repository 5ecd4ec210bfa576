#pragma once
/// What scheme_reader.cpp needs of toml++: typed access in which every fault is an Error with its
/// place. Faults are gathered, and what could not be read is a default, so reading code stays
/// linear; what a default would spoil is left out where `unharmed_since` says so.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/faults.h"
#include "limn/scheme/file/toml_library.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

class TomlReader {
 public:
  /// `faults` must outlive the reader.
  TomlReader(std::string file, base::Faults& faults) : file_(std::move(file)), faults_(faults) {}

  /// The file as a table; fails on what is no TOML, is too large or is nested too deeply.
  /// `text` must outlive the reader.
  toml::table parse(std::string_view text);

  /// How many faults were found so far.
  [[nodiscard]] std::size_t faults() const { return found_; }
  /// Whether none was found since there were so many.
  [[nodiscard]] bool unharmed_since(std::size_t faults) const { return found_ == faults; }

  void fail(const toml::node& at, std::string message, std::string hint = {});
  void fail(Error error);
  [[nodiscard]] Place place(const toml::node& node) const;
  [[nodiscard]] Place place(const toml::key& key) const;
  [[nodiscard]] const std::string& file() const { return file_; }

  /// The text of a string; fails on any other type.
  std::string text(const toml::node& node, std::string_view what);
  /// From now on decimals in expressions are the fractions that they spell.
  void admit_decimals() { decimals_ = Decimals::admitted; }
  /// An expression, from a string or an integer; a float is refused as a decimal unless these are
  /// admitted.
  Formula formula(const toml::node& node, std::string_view what);
  /// Calls `visit(key, node)` for each entry, in the file's order; fails if the node is no table.
  void each(const toml::node& node, std::string_view what,
            const std::function<void(const toml::key&, const toml::node&)>& visit);
  /// The same for the elements of an array.
  void each_element(const toml::node& node, std::string_view what,
                    const std::function<void(const toml::node&)>& visit);

  /// "unknown key 'x' in WHAT", with the near ones of those that are known, and "expected a, b or
  /// c". `last` takes the place of the last one in the latter: what cannot be listed.
  void unknown_key(const toml::key& key, std::string_view what,
                   const std::vector<std::string>& known, const std::string& last = {});

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
  Decimals decimals_ = Decimals::refused;
  base::Faults& faults_;
  std::size_t found_ = 0;
};

}  // namespace limn::scheme
