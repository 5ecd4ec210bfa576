#include "limn/search/study_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "limn/base/near_word.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/scope.h"
#include "limn/search/quantity.h"
#include "limn/tune/freed_scheme.h"

namespace limn::search {
namespace {

constexpr int kLeastValence = 3;
constexpr std::size_t kMostValences = 200, kMostCoordinates = 200;
constexpr int kEndBits = 40;  // of ends that are no fractions

/// Of a formula at a valence: exactly, or else the fraction of few digits next to the double.
Result<Rational> rational_value(const Scheme& scheme, const Formula& formula,
                                std::optional<int> n) {
  const Result<number::Exact> exact =
      scheme::Scope<number::Exact>(scheme, n, std::nullopt)(formula);
  if (exact && exact->is_rational()) return exact->rational();
  const Result<double> value = scheme::Scope<double>(scheme, n, std::nullopt)(formula);
  if (!value) return value.error();
  const double scale = std::ldexp(1.0, kEndBits);
  if (!(std::abs(*value) < 1e6)) return Rational(*value);
  return Rational(Integer(std::llround(*value * scale)), Integer(1LL << kEndBits));
}

bool read_int(std::string_view text, int& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

const toml::node* entry(const toml::table& table, std::string_view key) { return table.get(key); }

}  // namespace

StudyReader::StudyReader(std::string path, base::Faults& faults) : in_(path, faults) {
  study_.folder = std::filesystem::path(path).parent_path().string();
  study_.file = std::move(path);
}

void StudyReader::fail_in(const toml::node& node, const Error& error) {
  Place at = in_.place(node);
  if (!error.file.empty() && error.line > 0)  // in another file
    return in_.fail(node, error.text(), error.hint);
  if (error.column > 0 && node.is_string()) at.column += error.column;
  in_.fail(Error{error.message, error.hint, at.file, at.line, at.column});
}

std::optional<long long> StudyReader::read_whole(const toml::node& node, std::string_view what,
                                                 long long least, long long most) {
  const std::optional<std::int64_t> number = node.value_exact<std::int64_t>();
  if (number && *number >= least && *number <= most) return *number;
  in_.fail(node, fmt::format("{} is a whole number from {} to {}", what, least, most));
  return std::nullopt;
}

// -------------------------------------------------------------------------------- the scheme

std::optional<Scheme> StudyReader::scheme_named(const toml::node* name,
                                                const toml::node* parameters) {
  const std::size_t before = in_.faults();
  const std::string text = in_.text(*name, "scheme");
  std::vector<std::string> assignments;
  if (parameters != nullptr)
    in_.each(*parameters, "parameters", [&](const toml::key& key, const toml::node& value) {
      const Formula formula = in_.formula(value, "a parameter");
      assignments.push_back(std::string(key.str()) + "=" + formula.expression.text());
    });
  if (!in_.unharmed_since(before)) return std::nullopt;
  const std::vector<std::string> shipped = shipped_schemes();
  const bool is_shipped = std::find(shipped.begin(), shipped.end(), text) != shipped.end();
  const std::filesystem::path path(text);
  const bool from_folder = !is_shipped && !study_.folder.empty() && !path.is_absolute();
  Result<Scheme> scheme =
      find_scheme(from_folder ? (std::filesystem::path(study_.folder) / path).string() : text);
  if (!scheme) {
    fail_in(*name, Error{scheme.error().line > 0 ? scheme.error().text() : scheme.error().message,
                         scheme.error().hint});
    return std::nullopt;
  }
  if (const Status status = set_parameters(*scheme, assignments); !status) {
    in_.fail(*parameters, status.error().message, status.error().hint);
    return std::nullopt;
  }
  return *std::move(scheme);
}

void StudyReader::read_scheme_of(const toml::table& file) {
  const toml::node* name = entry(file, "scheme");
  if (name == nullptr)
    return in_.fail(file, "the study names no scheme", "add scheme = \"NAME or PATH\"");
  std::optional<Scheme> scheme = scheme_named(name, entry(file, "parameters"));
  if (!scheme) return;
  study_.scheme_name = *name->value<std::string>();
  study_.scheme = std::move(*scheme);
  has_scheme_ = true;
}

std::vector<int> StudyReader::read_valences(const toml::node& node) {
  const std::size_t before = in_.faults();
  const std::string text = in_.text(node, "valences");
  if (!in_.unharmed_since(before)) return {};
  std::vector<int> list;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view part = std::string_view(text).substr(begin, end - begin);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    const std::size_t dots = part.find("..");
    int first = 0, last = 0;
    const bool read = read_int(part.substr(0, dots), first) &&
                      read_int(dots == part.npos ? part : part.substr(dots + 2), last);
    if (!read || first > last || first < kLeastValence || last > kLargestValence) {
      in_.fail(node,
               fmt::format("'{}' is no valence or range of {} to {}", part, kLeastValence,
                           kLargestValence),
               "write \"3..12\" or \"3, 5, 7..9\"");
      return {};
    }
    for (int n = first; n <= last; ++n) list.push_back(n);
    begin = end + 1;
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  if (list.size() > kMostValences) {
    in_.fail(node, fmt::format("{} valences are more than {}", list.size(), kMostValences));
    return {};
  }
  return list;
}

// --------------------------------------------------------------------------- what is moved

std::optional<Rational> StudyReader::end_value(const Formula& formula, std::optional<int> n) {
  const Result<Rational> value = rational_value(study_.scheme, formula, n);
  if (value) return *value;
  Error error = value.error();
  if (error.file.empty()) error.file = in_.file();
  in_.fail(std::move(error));
  return std::nullopt;
}

void StudyReader::add_coordinate(const toml::node& node, const Formula& low, const Formula& high,
                                 const Coordinate& form) {
  const std::optional<Rational> from = end_value(low, form.valence);
  const std::optional<Rational> to = end_value(high, form.valence);
  if (!from || !to) return;
  Coordinate coordinate = form;
  coordinate.low = *from;
  coordinate.high = *to;
  if (!(coordinate.low < coordinate.high))
    return in_.fail(node, fmt::format("the range of '{}' is empty: {} to {}", coordinate.label(),
                                      to_string(coordinate.low), to_string(coordinate.high)));
  const Result<Rational> own = rational_value(
      study_.scheme, *scheme::find_definition(study_.scheme, coordinate.name), coordinate.valence);
  if (own && *own >= coordinate.low && *own <= coordinate.high) coordinate.own = *own;
  for (const Coordinate& other : study_.coordinates)
    if (other.name == coordinate.name && other.valence == coordinate.valence)
      return in_.fail(node, fmt::format("'{}' is free twice", coordinate.label()));
  if (study_.coordinates.size() == kMostCoordinates)
    return in_.fail(node, fmt::format("more than {} free numbers", kMostCoordinates));
  study_.coordinates.push_back(std::move(coordinate));
}

void StudyReader::read_free(const toml::node& node) {
  const std::size_t before = in_.faults();
  Coordinate form;
  std::optional<Formula> low, high;
  std::vector<int> valences;
  in_.each(node, "[[free]]", [&](const toml::key& key, const toml::node& value) {
    if (key == "name")
      form.name = in_.text(value, "name");
    else if (key == "low")
      low = in_.formula(value, "low");
    else if (key == "high")
      high = in_.formula(value, "high");
    else if (key == "valences")
      valences = read_valences(value);
    else if (key == "steps")
      form.steps = static_cast<int>(read_whole(value, "steps", 2, 1'000'000).value_or(0));
    else
      in_.unknown_key(key, "[[free]]", {"name", "low", "high", "valences", "steps"});
  });
  if (!in_.unharmed_since(before)) return;
  if (form.name.empty() || !low || !high)
    return in_.fail(node, "[[free]] needs name, low and high");
  if (!has_scheme_) return;
  const std::vector<std::string> known = freeable_names(study_.scheme);
  if (std::find(known.begin(), known.end(), form.name) == known.end()) {
    const Result<FreedScheme> freed = FreedScheme::make(study_.scheme, form.name);
    return in_.fail(node, freed ? "it cannot be freed" : freed.error().message,
                    freed ? "" : freed.error().hint);
  }
  if (valences.empty()) return add_coordinate(node, *low, *high, form);
  for (const int n : valences) {
    form.valence = n;
    add_coordinate(node, *low, *high, form);
  }
}

// --------------------------------------------------------------------------- what is asked

std::optional<Quantity> StudyReader::read_quantity(const toml::node& node) {
  const std::size_t before = in_.faults();
  const std::string text = in_.text(node, "value");
  if (!in_.unharmed_since(before)) return std::nullopt;
  Result<Quantity> quantity = Quantity::parse(text, study_.folder);
  if (quantity) return *std::move(quantity);
  fail_in(node, quantity.error());
  return std::nullopt;
}

void StudyReader::read_objective(const toml::node& node) {
  std::optional<Quantity> value;
  std::string goal;
  const std::size_t before = in_.faults();
  in_.each(node, "[[objective]]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "value")
      value = read_quantity(entry);
    else if (key == "goal") {
      goal = in_.text(entry, "goal");
      if (goal != "min" && goal != "max")
        in_.fail(entry, fmt::format("unknown goal '{}', expected min or max", goal));
    } else {
      in_.unknown_key(key, "[[objective]]", {"value", "goal"});
    }
  });
  if (!in_.unharmed_since(before)) return;
  if (!value || goal.empty())
    return in_.fail(node, "[[objective]] needs value and goal",
                    "as value = \"holder_lower()\" and goal = \"max\"");
  study_.objectives.push_back({std::move(*value), goal == "max"});
}

std::optional<double> StudyReader::read_bound(const toml::node& node) {
  if (node.is_number())
    if (const auto number = node.value<double>(); number && std::isfinite(*number)) return number;
  const std::size_t before = in_.faults();
  const Formula formula = in_.formula(node, "a bound");
  if (!in_.unharmed_since(before)) return std::nullopt;
  const Result<double> value =
      scheme::evaluate<double>(formula.expression, [](const std::string& name) -> Result<double> {
        return Error{fmt::format("a bound is a number, without names as '{}'", name)};
      });
  if (value) return *value;
  fail_in(node, value.error());
  return std::nullopt;
}

void StudyReader::read_demand(const toml::node& node) {
  const std::size_t before = in_.faults();
  Demand demand;
  bool has_that = false;
  in_.each(node, "[[require]]", [&](const toml::key& key, const toml::node& entry) {
    if (key == "that") {
      has_that = true;
      demand.text = in_.text(entry, "that");
      if (!has_scheme_ || !in_.unharmed_since(before)) return;
      Result<Requirement> read = Requirement::parse(demand.text, study_.scheme);
      if (read)
        demand.at_vertices = *std::move(read);
      else
        in_.fail(entry, read.error().message, read.error().hint);
    } else if (key == "certified") {
      const std::optional<bool> flag = entry.value_exact<bool>();
      if (!flag) in_.fail(entry, "certified is true or false");
      demand.certified = flag.value_or(false);
    } else if (key == "value") {
      demand.value = read_quantity(entry);
    } else if (key == "at_least") {
      demand.at_least = read_bound(entry);
    } else if (key == "at_most") {
      demand.at_most = read_bound(entry);
    } else {
      in_.unknown_key(key, "[[require]]", {"that", "certified", "value", "at_least", "at_most"});
    }
  });
  if (in_.unharmed_since(before)) finish_demand(node, std::move(demand), has_that);
}

void StudyReader::finish_demand(const toml::node& node, Demand demand, bool has_that) {
  const bool has_bound = demand.at_least || demand.at_most;
  if (has_that == demand.value.has_value())
    return in_.fail(node, "[[require]] needs either that or value",
                    "as that = \"c1\", or value = \"cup(3)\" with at_least or at_most");
  if (has_that && has_bound)
    return in_.fail(node, "at_least and at_most belong to value, not to that");
  if (!has_that && !has_bound) return in_.fail(node, "value needs at_least or at_most, or both");
  const bool provable =
      demand.at_vertices && (demand.at_vertices->relation == Relation::c1 ||
                             demand.at_vertices->relation == Relation::bounded_curvature);
  if (demand.certified && has_scheme_ && !provable)
    return in_.fail(node, "only c1 and bounded-curvature can be certified",
                    "leave out certified, or require c1");
  if (demand.value) {
    demand.text = demand.value->text();
    if (demand.at_least) demand.text += fmt::format(" >= {}", *demand.at_least);
    if (demand.at_most) demand.text += fmt::format(" <= {}", *demand.at_most);
  }
  if (has_that && !has_scheme_) return;
  study_.demands.push_back(std::move(demand));
}

Study StudyReader::run(std::string_view text) {
  const toml::table file = in_.parse(text);
  if (in_.faults() > 0) return {};
  read_scheme_of(file);
  study_.text = text;
  const toml::node* method = nullptr;
  const auto list = [this](const toml::node& node, const char* what,
                           void (StudyReader::*one)(const toml::node&)) {
    in_.each_element(node, what, [&](const toml::node& element) { (this->*one)(element); });
  };
  in_.each(file, "a study", [&](const toml::key& key, const toml::node& node) {
    if (key == "title")
      study_.title = in_.text(node, "title");
    else if (key == "scheme" || key == "parameters")
      return;
    else if (key == "valences")
      study_.valences = read_valences(node);
    else if (key == "free")
      list(node, "[[free]]", &StudyReader::read_free);
    else if (key == "objective")
      list(node, "[[objective]]", &StudyReader::read_objective);
    else if (key == "require")
      list(node, "[[require]]", &StudyReader::read_demand);
    else if (key == "compare")
      list(node, "[[compare]]", &StudyReader::read_landmark);
    else if (key == "effort")
      read_effort(node);
    else if (key == "method")
      read_method(*(method = &node));
    else
      in_.unknown_key(key, "a study",
                      {"title", "scheme", "parameters", "valences", "free", "objective", "require",
                       "compare", "effort", "method"});
  });
  if (study_.valences.empty())
    for (int n = kLeastValence; n <= 12; ++n) study_.valences.push_back(n);
  if (in_.faults() == 0) check_method(file, method);
  return std::move(study_);
}

Result<Study> parse_study(std::string_view text, const std::string& path) {
  base::Faults faults;
  Study study = StudyReader(path, faults).run(text);
  if (!faults.none()) return faults.joined();
  return study;
}

}  // namespace limn::search
