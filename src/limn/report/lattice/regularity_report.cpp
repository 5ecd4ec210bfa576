#include "limn/report/lattice/regularity_report.h"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/outward.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

std::string orders_text(const PolynomialOrders& orders) {
  std::string text = fmt::format("sum rules of order {}", orders.sum_rules);
  if (orders.reproduction >= 0)
    text += fmt::format("; polynomials up to degree {} are reproduced", orders.reproduction);
  return text;
}

std::string smoothness_text(int r, const Smoothness& smoothness) {
  std::string text =
      fmt::format("C{}  {:<9}  {}", r, to_string(smoothness.verdict), smoothness.reason);
  if (smoothness.power > 0)
    text += fmt::format(
        "; {} of the differences of order {} {} norm ≤ {}",
        smoothness.power == 1 ? "one step" : fmt::format("{} steps", smoothness.power), r + 1,
        smoothness.power == 1 ? "has" : "have", base::rounded_up(smoothness.norm));
  return text + "\n";
}

/// The growth of the leading product: "1/4", "(49/576)^(1/2)".
std::string growth_text(const JointSpectralRadius& radius) {
  if (!radius.eigenvalue) return "0";
  const std::string size = to_string(Rational(abs(*radius.eigenvalue)));
  return radius.product.size() == 1 ? size
                                    : fmt::format("({})^(1/{})", size, radius.product.size());
}

std::string radius_text(const HolderBracket& bracket) {
  const JointSpectralRadius& radius = bracket.radius;
  std::string text =
      radius.exact ? fmt::format("joint spectral radius {} exactly", growth_text(radius))
                   : fmt::format("joint spectral radius [{}, {}]", base::rounded_down(radius.lower),
                                 base::rounded_up(radius.upper));
  if (!bracket.digits.empty()) {
    text += radius.exact ? "; a product that has it: digits"
                         : "; the product that has the lower: digits";
    for (const LatticeVector digit : bracket.digits)
      text += fmt::format(" ({}, {})", digit[0], digit[1]);
  }
  if (radius.eigenvalue) text += fmt::format("; eigenvalue {}", to_string(*radius.eigenvalue));
  text += '\n';
  int single = 0;
  for (const JointSpectralRadius::Block& block : radius.blocks) single += block.size == 1 ? 1 : 0;
  if (single > 0)
    text += fmt::format("  {} {} of 1 row\n", single, single == 1 ? "block" : "blocks");
  for (const JointSpectralRadius::Block& block : radius.blocks) {
    if (block.size == 1) continue;
    text += fmt::format(
        "  {}a block of {} rows, ≤ {}", block.irreducible ? "" : "perhaps reducible: ", block.size,
        block.bounded && !block.below ? growth_text(radius) : base::rounded_up(block.upper));
    if (block.vertices > 0) text += fmt::format(" by a polytope of {} vertices", block.vertices);
    text += '\n';
  }
  return text;
}

std::string superscript(int n) {
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char digit : std::to_string(n)) text += kDigits[digit - '0'];
  return text;
}

std::string differences_text(int order) {
  constexpr const char* kOrdinals[] = {"first", "second", "third", "fourth", "fifth"};
  if (order >= 1 && order <= 5) return fmt::format("{} differences", kOrdinals[order - 1]);
  return fmt::format("differences of order {}", order);
}

/// |h|², |h|^log2(3)
std::string power_text(const HolderBracket& bracket) {
  const bool whole = bracket.exact == std::to_string(bracket.attained.order);
  if (bracket.exact == "1") return "|h|";
  return "|h|" + (whole ? superscript(bracket.attained.order) : "^" + bracket.exact);
}

std::string attainment_text(const HolderBracket& bracket) {
  const Attainment& attained = bracket.attained;
  const std::string differences = differences_text(attained.order);
  switch (attained.verdict) {
    case Truth::yes:
      return fmt::format("attained: {} are at most a constant times {}\n  ({})", differences,
                         power_text(bracket), attained.reason);
    case Truth::no: {
      const std::string power = attained.logarithm == 1 ? "" : superscript(attained.logarithm);
      return fmt::format("not attained: {} grow {} {} log{}(1/|h|)\n  ({})", differences,
                         attained.sharp ? "like" : "at least like", power_text(bracket), power,
                         attained.reason);
    }
    case Truth::undecided: break;
  }
  return fmt::format("whether it is attained is not decided\n  ({})", attained.reason);
}

/// The line of the exponent.
std::string holder_text(const HolderBracket& bracket) {
  if (bracket.exact.empty()) return fmt::format("Hölder exponent {}\n", to_string(bracket));
  if (!bracket.exact_reason.empty())
    return fmt::format("Hölder exponent {} exactly: {}\n", to_string(bracket),
                       bracket.exact_reason);
  return fmt::format("Hölder exponent {} exactly, {}\n", to_string(bracket),
                     attainment_text(bracket));
}

Json holder_json(const HolderBracket& bracket) {
  const Attainment& attained = bracket.attained;
  const bool decided = attained.verdict != Truth::undecided;
  return {{"lower", bracket.lower},
          {"upper", bracket.upper ? Json(*bracket.upper) : Json()},
          {"exact", bracket.exact.empty() ? Json() : Json(bracket.exact)},
          {"exact_reason", bracket.exact_reason.empty() ? Json() : Json(bracket.exact_reason)},
          {"attained", decided ? Json(attained.verdict == Truth::yes) : Json()},
          {"attained_reason", attained.reason},
          {"logarithm", decided ? Json(attained.logarithm) : Json()},
          {"logarithm_sharp", attained.verdict == Truth::no ? Json(attained.sharp) : Json()}};
}

Json proof_json(const Smoothness& smoothness) {
  Json json{{"reason", smoothness.reason}, {"power", Json()}, {"norm", Json()}};
  if (smoothness.power > 0) {
    json["power"] = smoothness.power;
    json["norm"] = smoothness.norm;
  }
  return json;
}

Json radius_json(const HolderBracket& bracket) {
  const JointSpectralRadius& radius = bracket.radius;
  Json blocks = Json::array();
  for (const JointSpectralRadius::Block& block : radius.blocks)
    blocks.push_back({{"size", block.size},
                      {"lower", block.lower},
                      {"upper", block.upper},
                      {"vertices", block.vertices},
                      {"irreducible", block.irreducible},
                      {"bounded", block.bounded},
                      {"below", block.below}});
  return {{"lower", radius.lower},
          {"upper", radius.upper},
          {"exact", radius.exact},
          {"product", bracket.digits},
          {"eigenvalue", radius.eigenvalue ? Json(to_string(*radius.eigenvalue)) : Json()},
          {"blocks", std::move(blocks)}};
}

}  // namespace

std::string to_string(const HolderBracket& bracket) {
  if (!bracket.exact.empty() && bracket.upper && *bracket.upper != bracket.lower)
    return fmt::format("{} = {:.6f}", bracket.exact, bracket.lower);
  if (!bracket.exact.empty()) return bracket.exact;
  if (!bracket.upper) return "at least " + base::rounded_down(bracket.lower);
  if (*bracket.upper == bracket.lower) return fmt::format("{:.17g}", bracket.lower);
  return fmt::format("[{}, {}]", base::rounded_down(bracket.lower),
                     base::rounded_up(*bracket.upper));
}

Json regularity_json(const std::string& name, const Regularity& regularity) {
  const HolderBracket& holder = regularity.holder;
  const auto& smoothness = regularity.smoothness;
  Json verdicts = Json::array();
  Json proofs;
  for (std::size_t r = 0; r < smoothness.size(); ++r) {
    verdicts.push_back(to_string(smoothness[r].verdict));
    proofs[fmt::format("c{}", r)] = proof_json(smoothness[r]);
  }
  return {{"scheme", name},
          {"holder", holder_json(holder)},
          {"c0", to_string(smoothness[0].verdict)},
          {"c1", to_string(smoothness[1].verdict)},
          {"c2", to_string(smoothness[2].verdict)},
          {"smoothness", std::move(verdicts)},
          {"sum_rules", regularity.orders.sum_rules},
          {"reproduction", regularity.orders.reproduction},
          {"stable",
           {{"verdict", to_string(regularity.stable)}, {"reason", regularity.stability_reason}}},
          {"proofs", std::move(proofs)},
          {"time_ended", regularity.time_ended},
          {"joint_spectral_radius", radius_json(holder)}};
}

std::string regularity_text(const std::string& name, const Regularity& regularity) {
  std::string text = fmt::format("{}\n{}\n{}", name, orders_text(regularity.orders),
                                 holder_text(regularity.holder));
  for (std::size_t r = 0; r < regularity.smoothness.size(); ++r)
    text += smoothness_text(static_cast<int>(r), regularity.smoothness[r]);
  text += fmt::format("stable shifts: {} ({})\n", to_string(regularity.stable),
                      regularity.stability_reason);
  if (regularity.time_ended)
    text += "the time ended before the bracket was as narrow as was asked: more time tells more\n";
  return text + radius_text(regularity.holder);
}

}  // namespace limn::report
