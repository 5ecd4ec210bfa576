#include "limn/certify/certificate/certificate_json.h"

#include "limn/certify/certificate/all_valences_json.h"
#include "limn/certify/certificate/certificate_words.h"

namespace limn::certify {
namespace {

constexpr const char* kFormat = "limn certificate";
constexpr int kVersion = 1;

Json cell_json(LatticeVector cell) { return Json::array({cell[0], cell[1]}); }

Json curvature_json(const CurvatureClaim& claim) {
  Json json{{"reason", claim.reason}};
  if (claim.large)
    json["larger"] = {{"frequency", claim.large->frequency},
                      {"rows", claim.large->rows},
                      {"value", claim.large->value}};
  if (claim.jordan)
    json["jordan"] = {{"frequency", claim.jordan->frequency},
                      {"multiplicity", claim.jordan->multiplicity}};
  if (claim.squarings.empty()) return json;
  json["equal"] = Json::array();
  for (const SquareEigenvalue& one : claim.equal)
    json["equal"].push_back({{"frequency", one.frequency}, {"multiplicity", one.multiplicity}});
  json["squarings"] = claim.squarings;
  return json;
}

Json answer_json(const ValenceClaim& claim) {
  return {{"valence", claim.valence},
          {"c1", to_string(claim.c1)},
          {"curvature", to_string(claim.curvature.answer)},
          {"bits", claim.bits},
          {"reason", claim.reason}};
}

Json valence_json(const ValenceClaim& claim) {
  Json json = answer_json(claim);
  json["curvature_proof"] = curvature_json(claim.curvature);
  if (claim.c1 == Answer::undecided) return json;
  json["frequency"] = claim.frequency;
  json["eigenvalue"] = claim.eigenvalue;
  json["eigenvector"] = claim.eigenvector;
  json["squarings"] = claim.squarings;
  json["inner"] = claim.inner;
  json["ring"] = Json::array();
  for (const CellClaim& cell : claim.ring)
    json["ring"].push_back({{"cell", cell_json(cell.cell)}, {"parts", parts_text(cell.parts)}});
  if (claim.fold)
    for (const PartPlace& place : *claim.fold)
      json["fold"].push_back(
          {{"cell", cell_json(place.cell)}, {"parts", parts_text({place.part})}});
  return json;
}

Json tree_json(const TreeClaim& claim) {
  return {{"leaf_norm", claim.leaf_norm}, {"products", claim.products}, {"longest", claim.longest}};
}

Json regular_json(const RegularClaim& claim) {
  Json json{{"c1", to_string(claim.c1)}, {"reason", claim.reason}};
  if (claim.c1 != Answer::proved) return json;
  json["neighbours"] = tree_json(claim.neighbours);
  json["cells"] = tree_json(claim.cells);
  return json;
}

LatticeVector read_cell(JsonReader& reader) {
  const std::vector<int> cell = reader.wholes("cell");
  if (cell.size() == 2) return {cell[0], cell[1]};
  reader.fail("'cell' is to be two whole numbers");
  return {};
}

CellClaim read_cell_claim(const Json& json, const std::string& place, std::optional<Error>& fault) {
  JsonReader reader(json, place);
  CellClaim claim{read_cell(reader), read_parts(reader, reader.text("parts"))};
  reader.end();
  if (!fault) fault = reader.fault();
  return claim;
}

CurvatureClaim read_curvature(JsonReader& outer) {
  CurvatureClaim claim;
  claim.answer = read_word(outer, "curvature",
                           {CurvatureAnswer::undecided, CurvatureAnswer::bounded,
                            CurvatureAnswer::unbounded, CurvatureAnswer::flat});
  JsonReader reader(outer.get("curvature_proof"), outer.at("curvature_proof"));
  claim.reason = reader.text("reason");
  if (reader.has("larger")) {
    JsonReader larger(reader.get("larger"), reader.at("larger"));
    claim.large = {larger.whole("frequency"), larger.wholes("rows"), larger.number("value")};
    larger.end();
    reader.take(larger.fault());
  }
  if (reader.has("jordan")) {
    JsonReader jordan(reader.get("jordan"), reader.at("jordan"));
    claim.jordan = {jordan.whole("frequency"), jordan.whole("multiplicity")};
    jordan.end();
    reader.take(jordan.fault());
  }
  if (reader.has("squarings")) {
    claim.squarings = reader.wholes("squarings");
    for (const Json& json : reader.list("equal")) {
      JsonReader equal(json, reader.at("equal"));
      claim.equal.push_back({equal.whole("frequency"), equal.whole("multiplicity")});
      equal.end();
      reader.take(equal.fault());
    }
  }
  reader.end();
  outer.take(reader.fault());
  return claim;
}

ValenceClaim read_valence(const Json& json, const std::string& place, std::optional<Error>& fault) {
  JsonReader reader(json, place);
  ValenceClaim claim;
  claim.valence = reader.whole("valence");
  claim.c1 = read_answer(reader, "c1");
  claim.reason = reader.text("reason");
  claim.bits = reader.whole("bits");
  claim.curvature = read_curvature(reader);
  if (claim.c1 != Answer::undecided) {
    claim.frequency = reader.whole("frequency");
    claim.eigenvalue = reader.number("eigenvalue");
    claim.eigenvector = reader.numbers("eigenvector");
    claim.squarings = reader.wholes("squarings");
    claim.inner = reader.whole("inner");
    std::optional<Error> inside;
    for (const Json& cell : reader.list("ring"))
      claim.ring.push_back(read_cell_claim(cell, reader.at("ring"), inside));
    if (reader.has("fold")) {
      const Json& fold = reader.list("fold");
      if (fold.size() != 2) reader.fail("'fold' is to be two parts of cells");
      std::array<PartPlace, 2> places;
      for (std::size_t i = 0; i < 2 && i < fold.size(); ++i) {
        const CellClaim one = read_cell_claim(fold[i], reader.at("fold"), inside);
        if (one.parts.size() != 1) reader.fail("'fold' is to hold one part of each cell");
        places[i] = {one.cell, one.parts.front()};
      }
      claim.fold = places;
    }
    reader.take(inside);
  }
  reader.end({"seconds", "time"});
  if (!fault) fault = reader.fault();
  return claim;
}

TreeClaim read_tree(JsonReader& outer, const char* key) {
  JsonReader reader(outer.get(key), outer.at(key));
  const TreeClaim claim{reader.number("leaf_norm"), reader.whole("products"),
                        reader.whole("longest")};
  reader.end();
  outer.take(reader.fault());
  return claim;
}

RegularClaim read_regular(JsonReader& outer) {
  JsonReader reader(outer.get("regular"), outer.at("regular"));
  RegularClaim claim;
  claim.c1 = read_answer(reader, "c1");
  claim.reason = reader.text("reason");
  if (claim.c1 == Answer::proved) {
    claim.neighbours = read_tree(reader, "neighbours");
    claim.cells = read_tree(reader, "cells");
  }
  reader.end();
  outer.take(reader.fault());
  return claim;
}

Certificate read_certificate(JsonReader& reader) {
  Certificate certificate;
  if (reader.text("format") != kFormat) reader.fail("it is no certificate of limn's");
  certificate.scheme = reader.text("scheme");
  for (const Json& json : reader.list("texts")) {
    JsonReader text(json, reader.at("texts"));
    certificate.texts.push_back({text.text("name"), text.text("text")});
    text.end();
    reader.take(text.fault());
  }
  for (const Json& json : reader.list("parameters")) {
    if (!json.is_string()) reader.fail("'parameters' is to be a list of texts");
    if (json.is_string()) certificate.parameters.push_back(json.get<std::string>());
  }
  certificate.regular = read_regular(reader);
  std::optional<Error> inside;
  std::size_t number = 0;
  for (const Json& json : reader.list("valences"))
    certificate.valences.push_back(
        read_valence(json, fmt::format("{}/{}", reader.at("valences"), number++), inside));
  reader.take(inside);
  if (reader.has("all"))
    certificate.all = read_all_valences(reader.get("all"), reader.at("all"), inside);
  reader.take(inside);
  reader.end({"version", "limn", "seconds", "time"});
  return certificate;
}

}  // namespace

Json certificate_json(const Certificate& certificate) {
  Json json{{"format", kFormat}, {"version", kVersion}, {"scheme", certificate.scheme}};
  json["texts"] = Json::array();
  for (const SourceText& text : certificate.texts)
    json["texts"].push_back({{"name", text.name}, {"text", text.text}});
  json["parameters"] = certificate.parameters;
  json["regular"] = regular_json(certificate.regular);
  json["valences"] = Json::array();
  for (const ValenceClaim& claim : certificate.valences)
    json["valences"].push_back(valence_json(claim));
  if (certificate.all) json["all"] = all_valences_json(*certificate.all);
  return json;
}

Json answers_json(const Certificate& certificate) {
  Json json{{"scheme", certificate.scheme},
            {"regular",
             {{"c1", to_string(certificate.regular.c1)}, {"reason", certificate.regular.reason}}}};
  json["valences"] = Json::array();
  for (const ValenceClaim& claim : certificate.valences) {
    Json one = answer_json(claim);
    one["curvature_reason"] = claim.curvature.reason;
    json["valences"].push_back(one);
  }
  if (certificate.all) json["all"] = all_answer_json(*certificate.all);
  return json;
}

Result<Certificate> parse_certificate(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return Error{"it is no JSON"};
  JsonReader reader(json, "");
  Certificate certificate = read_certificate(reader);
  if (reader.fault()) {
    Error fault = *reader.fault();
    if (fault.message.starts_with(": ")) fault.message.erase(0, 2);
    return fault;
  }
  return certificate;
}

}  // namespace limn::certify
