#pragma once
/// One study file into one Study; private to search/.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/scheme/file/toml_reader.h"
#include "limn/search/study.h"

namespace limn::search {

/// Reads what it can; all faults are added.
class StudyReader {
 public:
  StudyReader(std::string path, base::Faults& faults);
  [[nodiscard]] Study run(std::string_view text);

 private:
  void read_scheme_of(const toml::table& file);
  [[nodiscard]] std::optional<Scheme> scheme_named(const toml::node* name,
                                                   const toml::node* parameters);
  [[nodiscard]] std::vector<int> read_valences(const toml::node& node);
  void read_free(const toml::node& node);
  void add_coordinate(const toml::node& node, const Formula& low, const Formula& high,
                      const Coordinate& form);
  [[nodiscard]] std::optional<Rational> end_value(const Formula& formula, std::optional<int> n);
  void read_objective(const toml::node& node);
  void read_demand(const toml::node& node);
  void finish_demand(const toml::node& node, Demand demand, bool has_that);
  [[nodiscard]] std::optional<Quantity> read_quantity(const toml::node& node);
  [[nodiscard]] std::optional<double> read_bound(const toml::node& node);
  void read_method(const toml::node& node);
  void read_effort(const toml::node& node);
  void read_landmark(const toml::node& node);
  void check_method(const toml::node& file, const toml::node* method);
  [[nodiscard]] std::optional<long long> read_whole(const toml::node& node, std::string_view what,
                                                    long long least, long long most);
  /// Fails at the text of a string, `column` bytes (from 1) into it.
  void fail_in(const toml::node& node, const Error& error);

  scheme::TomlReader in_;
  Study study_;
  bool has_scheme_ = false;
};

}  // namespace limn::search
