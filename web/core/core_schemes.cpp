#include <algorithm>
#include <cmath>
#include <string_view>

#include "limn/regular/regular_mask.h"
#include "limn/report/scheme_report.h"
#include "limn/scheme/file/shipped_files.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/scheme_size.h"
#include "limn/scheme/scope.h"
#include "limn/scheme/shipped_scheme.h"
#include "limn/spectrum/least_valence.h"
#include "page_state.h"

namespace limn::page {
namespace {

constexpr std::size_t kTextsKept = 4;
constexpr double kLargestParameter = 1e9;

const char* lattice_word(const Split& split) {
  return split.lattice == Lattice::triangle ? "triangles" : "quads";
}

/// The text that a shipped file states for a key at its head. Reading a scheme takes a tenth of a
/// second in a browser, nearly all of it for its rules, so that the list of all is made without.
std::string stated(std::string_view text, std::string_view key) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t open = line.find(" = \""), close = line.rfind('"');
    if (open != std::string_view::npos && line.substr(0, line.find(' ')) == key)
      return std::string(line.substr(open + 4, close - open - 4));
  }
  return {};
}

/// The split of a shipped file: as it states it, or, where it follows from other things (from the
/// parity of a staged scheme's averagings), as the scheme's reader finds it.
const Split* split_of(const scheme::ShippedFile& file) {
  if (const Split* const split = find_split(stated(file.text, "split"))) return split;
  const Result<Scheme> scheme = find_scheme(std::string(file.name));
  return scheme ? scheme->split : nullptr;
}

Json parsed(const std::string& text) { return Json::parse(text, nullptr, false); }

/// A number as an expression, which has no decimals: to twelve of them, as a fraction.
std::string fraction_text(double value) {
  std::string digits = fmt::format("{:.12f}", value);
  while (digits.back() == '0') digits.pop_back();
  const std::size_t point = digits.find('.');
  const std::size_t decimals = digits.size() - point - 1;
  digits.erase(point, 1);
  return decimals == 0 ? digits : digits + "/1" + std::string(decimals, '0');
}

Result<std::vector<std::string>> assignments_of(const std::string& text) {
  std::vector<std::string> assignments;
  if (text.empty()) return assignments;
  const Json json = parsed(text);
  if (!json.is_object()) return Error{"parameters are no JSON object", R"(as {"a": "1/8"})"};
  for (const auto& [name, value] : json.items()) {
    if (value.is_string()) {
      assignments.push_back(name + "=" + value.get<std::string>());
      continue;
    }
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::abs(number) <= kLargestParameter))
      return Error{fmt::format("parameter '{}' is no number", name), "a number or an expression"};
    assignments.push_back(name + "=" + fraction_text(number));
  }
  return assignments;
}

std::optional<double> number_of(const Scheme& scheme, const Formula& formula) {
  scheme::Scope<double> scope(scheme, std::nullopt, std::nullopt);
  const Result<double> value = scope(formula);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return *value;
}

Json number_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// Whether a value between whole numbers is refused.
bool takes_integers_alone(scheme::ParameterSetter& setter, const Parameter& parameter) {
  const Scheme& scheme = setter.scheme();
  const std::optional<double> value = number_of(scheme, parameter.value);
  if (!value || *value != std::floor(*value) || !parameter.low) return false;
  const std::optional<double> low = number_of(scheme, *parameter.low);
  const std::optional<double> high = number_of(scheme, *parameter.high);
  if (!low || !high || *high - *low < 1 || *low != std::floor(*low)) return false;
  const double between = (*value < *high ? *value : *low) + 0.5;
  return !setter.with({parameter.name + "=" + fraction_text(between)});
}

/// What can be asked of the scheme, whatever its parameters are, and why the rest cannot.
void find_features(ReadText& read) {
  const Scheme& scheme = read.setter.scheme();
  const auto& rules = scheme.rules;
  const bool has_rules =
      std::any_of(rules.begin(), rules.end(), [](const auto& rule) { return rule.has_value(); });
  const bool staged = scheme.stages.has_value();
  const bool has_boundary = scheme.rule(RuleKind::boundary_vertex).has_value() ||
                            scheme.rule(RuleKind::boundary_edge).has_value() ||
                            scheme.split->is_dual() || staged;
  read.features = read.reasons = Json::object();
  const auto add = [&](const char* name, bool has, const std::string& reason) {
    read.features[name] = has;
    if (!has) read.reasons[name] = reason;
  };
  const std::string none = "the scheme has no rules for meshes, only a mask";
  const bool by_rules = has_rules && !scheme.mask && !scheme.factors;
  const Status one_lattice = scheme::check_one_lattice(scheme);
  add("eigen", (by_rules || staged) && one_lattice.ok(),
      one_lattice ? none : one_lattice.error().message);
  add("refine", has_rules || staged, none);
  add("boundary", has_boundary, "the scheme has no boundary rules");
  add("sharpness",
      has_boundary && !scheme.split->is_dual() && !scheme.split->births.thirds && !staged,
      staged ? "averagings go on across sharp edges"
             : "sharp edges need boundary rules, and a split that cuts edges in two");
}

Result<Scheme> read_text(const std::string& text) {
  for (const scheme::ShippedFile& file : scheme::shipped_files())
    if (file.text == text) return scheme::shipped_scheme(std::string(file.name));
  return parse_scheme(text, "scheme.toml");
}

Result<std::shared_ptr<ReadText>> read_kept(const std::string& text,
                                            std::deque<std::shared_ptr<ReadText>>& kept) {
  const auto same =
      std::find_if(kept.begin(), kept.end(), [&](const auto& one) { return one->text == text; });
  if (same != kept.end()) {
    std::rotate(kept.begin(), same, same + 1);
    return kept.front();
  }
  if (text.size() > scheme::kMostSchemeBytes)
    return Error{fmt::format("the text has more than {} bytes", scheme::kMostSchemeBytes)};
  Result<Scheme> scheme = read_text(text);
  if (!scheme) return scheme.error();
  ReadText read{text, scheme::ParameterSetter(std::move(*scheme)), {}, {}, {}};
  for (const Parameter& parameter : read.setter.scheme().parameters)
    read.integers.push_back(takes_integers_alone(read.setter, parameter));
  find_features(read);
  kept.push_front(std::make_shared<ReadText>(std::move(read)));
  if (kept.size() > kTextsKept) kept.pop_back();
  return kept.front();
}

Json parameters_json(const ReadText& read, const Scheme& scheme) {
  Json list = Json::array();
  for (std::size_t i = 0; i < scheme.parameters.size(); ++i) {
    const Parameter& parameter = scheme.parameters[i];
    Json low, high;
    if (parameter.low && parameter.high) {
      low = number_json(number_of(scheme, *parameter.low));
      high = number_json(number_of(scheme, *parameter.high));
    }
    list.push_back({{"name", parameter.name},
                    {"meaning", parameter.meaning},
                    {"value", parameter.value.expression.text()},
                    {"number", number_json(number_of(scheme, parameter.value))},
                    {"default", read.setter.scheme().parameters[i].value.expression.text()},
                    {"min", low},
                    {"max", high},
                    {"integer", static_cast<bool>(read.integers[i])}});
  }
  return list;
}

}  // namespace

Result<const study::NamedAnalysis*> lattice_of(LoadedScheme& loaded) {
  if (!loaded.lattice) {
    const Result<Mask> mask = regular_mask(loaded.scheme);
    if (!mask) return mask.error();
    Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
    if (!analysis) return analysis.error();
    loaded.lattice.emplace(study::NamedAnalysis{loaded.scheme.name, *std::move(analysis)});
  }
  return &*loaded.lattice;
}

PageCore::PageCore() : state_(std::make_unique<State>()) {}
PageCore::~PageCore() = default;
PageCore::PageCore(PageCore&&) noexcept = default;
PageCore& PageCore::operator=(PageCore&&) noexcept = default;

std::string PageCore::version() const {
  return answer([]() -> Result<Json> { return Json{{"version", LIMN_VERSION}}; });
}

std::string PageCore::schemes() const {
  return answer([]() -> Result<Json> {
    Json list = Json::array();
    for (const scheme::ShippedFile& file : scheme::shipped_files()) {
      const Split* const split = split_of(file);
      list.push_back({{"name", file.name},
                      {"title", stated(file.text, "title")},
                      {"split", split == nullptr ? "" : split->name},
                      {"lattice", split == nullptr ? "" : lattice_word(*split)},
                      {"source", stated(file.text, "source")},
                      {"text", file.text}});
    }
    return Json{{"schemes", std::move(list)}};
  });
}

std::string PageCore::load(const std::string& text, const std::string& parameters) {
  return answer([&]() -> Result<Json> {
    const Result<std::vector<std::string>> assignments = assignments_of(parameters);
    if (!assignments) return assignments.error();
    const Result<std::shared_ptr<ReadText>> read = read_kept(text, state_->read);
    if (!read) return read.error();
    auto loaded = std::make_shared<LoadedScheme>();
    if (assignments->empty()) {
      loaded->scheme = (*read)->setter.scheme();
    } else {
      Result<Scheme> set = (*read)->setter.with(*assignments);
      if (!set) return set.error();
      loaded->scheme = std::move(*set);
    }
    const Scheme& scheme = loaded->scheme;
    Json json{{"id", state_->schemes.add(loaded)},
              {"name", scheme.name},
              {"title", scheme.title},
              {"split", scheme.split->name},
              {"lattice", lattice_word(*scheme.split)},
              {"dual", scheme.split->is_dual()},
              {"source", scheme.source},
              {"notes", scheme.notes},
              {"file", scheme.file},
              {"parameters", parameters_json(**read, scheme)},
              {"valences",
               {{"regular", scheme.split->lattice == Lattice::triangle ? 6 : 4},
                {"least", spectrum::least_valence(*scheme.split)},
                {"most", kMostValence}}}};
    json["features"] = (*read)->features;
    json["reasons"] = (*read)->reasons;
    return json;
  });
}

void PageCore::unload(int scheme) { state_->schemes.remove(scheme); }

std::string PageCore::show(int scheme) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    return report::describe_json((*loaded)->scheme);
  });
}

}  // namespace limn::page
