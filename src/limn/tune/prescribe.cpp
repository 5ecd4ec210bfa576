#include "limn/tune/prescribe.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/core.h>

#include "limn/scheme/check.h"
#include "limn/scheme/evaluate.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn::tune {
namespace {

Error refusal(std::string message, std::string hint = {}) {
  return {std::move(message), std::move(hint)};
}

const Weight* weight(const RuleCase& rule_case, std::string_view role) {
  for (const Weight& one : rule_case.weights)
    if (one.role == role) return &one;
  return nullptr;
}

bool has_only(const RuleCase& rule_case, std::string_view first, std::string_view second) {
  return std::all_of(rule_case.weights.begin(), rule_case.weights.end(),
                     [&](const Weight& one) { return one.role == first || one.role == second; });
}

/// The weight of an end in the rule for regular edges, as text.
Result<std::string> regular_end(const Scheme& base) {
  const auto& edge = base.rule(RuleKind::edge);
  const auto& vertex = base.rule(RuleKind::vertex);
  const bool near = base.split->lattice == Lattice::triangle && base.split->births.edges && edge &&
                    edge->size() == 1 && has_only(edge->front(), "end", "wing") && vertex &&
                    std::all_of(vertex->begin(), vertex->end(),
                                [](const RuleCase& one) { return has_only(one, "self", "ring"); });
  const Weight* end = near ? weight(edge->front(), "end") : nullptr;
  if (end == nullptr)
    return refusal(
        fmt::format(
            "the first ring of scheme '{}' cannot be prescribed: its rules are not those of "
            "a vertex and an edge of triangles with the roles self, ring, end and wing",
            base.name),
        "take a scheme such as loop");
  return end->value.expression.text();
}

Status check(const Prescription& prescription, const std::string& name) {
  const int n = prescription.valence;
  if (n < scheme::kSmallestValence)
    return refusal(fmt::format("valence {} is below {}", n, scheme::kSmallestValence));
  if (n == 6)
    return refusal("valence 6 is the regular one: every edge would end at such a vertex",
                   "choose an extraordinary valence");
  const std::size_t wanted = static_cast<std::size_t>(n) / 2;
  if (prescription.eigenvalues.size() != wanted)
    return refusal(
        fmt::format("valence {} has frequencies 1 to {}: {} eigenvalues were given for them", n,
                    wanted, prescription.eigenvalues.size()),
        "give the cup's and then one for each frequency, as 1/4,1/2,1/4,1/8 at valence 7");
  std::vector<std::string> all = prescription.eigenvalues;
  all.push_back(prescription.cup);
  for (const std::string& text : all) {
    const Result<Expression> parsed = Expression::parse(text);
    if (!parsed) return refusal(fmt::format("'{}': {}", text, parsed.error().message));
    for (const std::string& used : parsed->names())
      if (used != "n")
        return refusal(fmt::format("'{}' uses '{}': an eigenvalue may use n alone", text, used));
  }
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  if (!plain)
    return refusal(fmt::format("'{}' is no name for a scheme", name), "letters, digits, - and _");
  return Done{};
}

/// Σ over all n frequencies but 0 of eigenvalue · e^{2πiωk/n}.
std::string wave_sum(const Prescription& prescription) {
  std::string sum;
  for (std::size_t i = 0; i < prescription.eigenvalues.size(); ++i) {
    const auto frequency = static_cast<int>(i) + 1;
    const bool alone = 2 * frequency == prescription.valence;  // its own conjugate
    sum += fmt::format(" + {}({})*cos({}*pi*k/n)", alone ? "" : "2*", prescription.eigenvalues[i],
                       2 * frequency);
  }
  return sum;
}

std::string rule_cases(const Scheme& scheme, RuleKind kind, std::string_view table) {
  std::string text;
  if (!scheme.rule(kind)) return text;
  for (const RuleCase& one : *scheme.rule(kind)) {
    text += fmt::format("\n[[{}]]\n", table);
    if (one.when) text += fmt::format("when = \"{}\"\n", one.when->expression.text());
    for (const Weight& w : one.weights)
      text += fmt::format("{} = \"{}\"\n", w.role, w.value.expression.text());
  }
  return text;
}

/// An eigenvalue's text at the valence, where it has one.
std::optional<double> value_at(const std::string& text, int n) {
  const Result<Expression> parsed = Expression::parse(text);
  if (!parsed) return std::nullopt;
  const Result<double> value =
      scheme::evaluate<double>(*parsed, [&](const std::string&) { return Result<double>(n); });
  return value ? std::optional<double>(*value) : std::nullopt;
}

/// Appends the facts that hold of the scheme as it was read, and lists what does not.
Status add_facts(const Scheme& made, const Prescription& prescription, Prescribed& result) {
  constexpr double kEqual = 1e-9;
  const int n = prescription.valence;
  const Result<FrequencyBlocks> blocks = FrequencyAnalysis(made).blocks(n);
  if (!blocks) return blocks.error();
  const Eigencomponents found = approx_eigencomponents(*blocks, {});
  std::string facts;
  const auto add = [&](const char* name, const std::string& text, std::optional<double> leads) {
    const std::optional<double> wanted = value_at(text, n);
    if (wanted && leads && std::abs(*wanted - *leads) < kEqual)
      facts += fmt::format("{:7} = \"{}\"\n", name, text);
    else if (leads)
      result.unmet.push_back(
          {fmt::format("the {} is {:.6g}, not {}: another eigenvalue of its frequency is larger",
                       name, *leads, text)});
    else
      result.unmet.push_back(
          {fmt::format("there is no {} {}: no real eigenvalue leads its frequency", name, text)});
  };
  add("tangent", prescription.eigenvalues.front(), found.tangent);
  add("cup", prescription.cup, found.cup);
  if (n > 3) add("saddle", prescription.eigenvalues[1], found.saddle);
  if (!facts.empty())
    result.text += fmt::format("\n[[facts]]\nvalence = {}\n{}source  = \"prescribed\"\n", n, facts);
  return Done{};
}

}  // namespace

Result<Prescribed> prescribed_scheme(const Scheme& base, const std::string& base_name,
                                     const std::string& path, const Prescription& prescription) {
  const std::string name = std::filesystem::path(path).stem().string();
  if (Status status = check(prescription, name); !status) return status.error();
  const Result<std::string> end = regular_end(base);
  if (!end) return end.error();
  const int n = prescription.valence;
  Prescribed result;
  std::string& text = result.text;
  text = fmt::format("name    = \"{}\"\nsplit   = \"{}\"\nextends = {}\n", name, base.split->name,
                     scheme::toml_string(base_name));
  text += scheme::weights_toml(base);
  text += fmt::format(
      "source  = \"first-ring weights by the inverse DFT of a prescribed spectrum at valence {}\"\n"
      "\n[[vertex]]\nwhen = \"n == {}\"\nself = \"{} + ({})\"\nring = \"(1 - ({}) - ({}))/n\"\n",
      n, n, *end, prescription.cup, *end, prescription.cup);
  text += rule_cases(base, RuleKind::vertex, "vertex");
  text +=
      fmt::format("\n[[edge-end]]\nwhen = \"n == {}\"\nself = \"{}\"\nring = \"(1 - ({}){})/n\"\n",
                  n, *end, *end, wave_sum(prescription));
  text += rule_cases(base, RuleKind::edge_end, "edge-end");
  text += scheme::definitions_toml(base);
  const Result<Scheme> read = parse_scheme(text, path);
  if (!read) {
    // without its place, which is in a file that nobody will see
    const std::string& message = read.error().message;
    return refusal("the prescribed rules are no scheme: " + message.substr(0, message.find('\n')),
                   read.error().hint);
  }
  if (Status status = add_facts(*read, prescription, result); !status) return status.error();
  return result;
}

}  // namespace limn::tune
