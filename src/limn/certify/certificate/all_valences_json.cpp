#include "limn/certify/certificate/all_valences_json.h"

#include "limn/certify/certificate/certificate_words.h"

namespace limn::certify {
namespace {

Json interval_json(const ValenceInterval& one) {
  Json parts = Json::array();
  for (const auto& cell : one.parts) parts.push_back(parts_text(cell));
  Json json{{"begin", to_string(one.begin)},
            {"end", to_string(one.end)},
            {"eigenvalue", one.eigenvalue},
            {"eigenvector", one.eigenvector},
            {"squarings", one.squarings},
            {"special", one.special},
            {"parts", parts}};
  if (one.constant_squarings >= 0)
    json["constant_squarings"] = one.constant_squarings;
  else
    json["closing"] = {{"cup", one.cup},
                       {"cup_vector", one.cup_vector},
                       {"cup_squarings", one.cup_squarings},
                       {"odd_squarings", one.odd_squarings}};
  return json;
}

Json turn_json(const TurnInterval& one) {
  Json json{
      {"begin", to_string(one.begin)}, {"end", to_string(one.end)}, {"squarings", one.squarings}};
  if (!one.right.empty())
    json["falling"] = {{"eigenvalue", one.eigenvalue}, {"right", one.right}, {"left", one.left}};
  return json;
}

Rational rational(JsonReader& reader, const char* key) {
  const std::string text = reader.text(key);
  const std::size_t slash = text.find('/');
  const auto whole = [](const std::string& digits) {
    return !digits.empty() && digits.size() < 400 && (digits == "0" || digits[0] != '0') &&
           digits.find_first_not_of("0123456789") == std::string::npos;
  };
  if (whole(text)) return Rational(text);
  if (slash != std::string::npos && whole(text.substr(0, slash)) && whole(text.substr(slash + 1)) &&
      text.find_first_not_of('0', slash + 1) != std::string::npos)
    return Rational(text);
  reader.fail(fmt::format("'{}' is to be a fraction", key));
  return 0;
}

ValenceInterval read_interval(const Json& json, const std::string& place,
                              std::optional<Error>& fault) {
  JsonReader reader(json, place);
  ValenceInterval one;
  one.begin = rational(reader, "begin");
  one.end = rational(reader, "end");
  one.eigenvalue = reader.number("eigenvalue");
  one.eigenvector = reader.numbers("eigenvector");
  one.squarings = reader.whole("squarings");
  one.special = reader.wholes("special");
  if (reader.has("closing")) {
    JsonReader closing(reader.get("closing"), reader.at("closing"));
    one.constant_squarings = -1;
    one.cup = closing.number("cup");
    one.cup_vector = closing.numbers("cup_vector");
    one.cup_squarings = closing.whole("cup_squarings");
    one.odd_squarings = closing.whole("odd_squarings");
    closing.end();
    reader.take(closing.fault());
  } else {
    one.constant_squarings = reader.whole("constant_squarings");
    if (one.constant_squarings < 0) reader.fail("'constant_squarings' is to be 0 or more");
  }
  for (const Json& cell : reader.list("parts")) {
    if (!cell.is_string()) reader.fail("'parts' is to be a list of texts");
    if (cell.is_string()) one.parts.push_back(read_parts(reader, cell.get<std::string>()));
  }
  reader.end();
  if (!fault) fault = reader.fault();
  return one;
}

TurnInterval read_turn(const Json& json, const std::string& place, std::optional<Error>& fault) {
  JsonReader reader(json, place);
  TurnInterval one;
  one.begin = rational(reader, "begin");
  one.end = rational(reader, "end");
  one.squarings = reader.whole("squarings");
  if (reader.has("falling")) {
    JsonReader falling(reader.get("falling"), reader.at("falling"));
    one.eigenvalue = falling.number("eigenvalue");
    one.right = falling.numbers("right");
    one.left = falling.numbers("left");
    falling.end();
    reader.take(falling.fault());
  }
  reader.end();
  if (!fault) fault = reader.fault();
  return one;
}

}  // namespace

Json all_answer_json(const AllClaim& claim) {
  Json json{{"from", claim.from}, {"c1", to_string(claim.c1)}, {"exceptions", Json::array()}};
  for (const AllClaim::Exception& one : claim.exceptions)
    json["exceptions"].push_back({{"valence", one.valence}, {"c1", to_string(one.c1)}});
  json["reason"] = claim.reason;
  return json;
}

Json all_valences_json(const AllClaim& claim) {
  Json json = all_answer_json(claim);
  if (claim.c1 != Answer::proved) return json;
  json["together_from"] = claim.proof.from;
  json["intervals"] = Json::array();
  for (const ValenceInterval& one : claim.proof.intervals)
    json["intervals"].push_back(interval_json(one));
  json["turns"] = Json::array();
  for (const TurnInterval& one : claim.proof.turns) json["turns"].push_back(turn_json(one));
  return json;
}

AllClaim read_all_valences(const Json& json, const std::string& place,
                           std::optional<Error>& fault) {
  JsonReader reader(json, place);
  AllClaim claim;
  claim.from = reader.whole("from");
  claim.c1 = read_answer(reader, "c1");
  claim.reason = reader.text("reason");
  std::optional<Error> inside;
  for (const Json& one : reader.list("exceptions")) {
    JsonReader exception(one, reader.at("exceptions"));
    claim.exceptions.push_back({exception.whole("valence"), read_answer(exception, "c1")});
    exception.end();
    if (!inside) inside = exception.fault();
  }
  if (claim.c1 == Answer::proved) {
    claim.proof.from = reader.whole("together_from");
    claim.proof.c1 = Truth::yes;
    for (const Json& one : reader.list("intervals"))
      claim.proof.intervals.push_back(read_interval(one, reader.at("intervals"), inside));
    for (const Json& one : reader.list("turns"))
      claim.proof.turns.push_back(read_turn(one, reader.at("turns"), inside));
  }
  reader.take(inside);
  reader.end();
  if (!fault) fault = reader.fault();
  return claim;
}

}  // namespace limn::certify
