#include "limn/report/page/page_record.h"

#include <numeric>

#include <nlohmann/json.hpp>

#include "limn/certify/certificate/certificate_json.h"
#include "limn/certify/certify.h"
#include "limn/report/compare/record_json.h"
#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/report/scheme_report.h"
#include "limn/scheme/lattice_schemes.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json scheme_json(const std::string& label, const Scheme& scheme) {
  Json texts = Json::array(), parameters = Json::object();
  for (const SourceText& text : scheme.texts)
    texts.push_back({{"name", text.name}, {"text", text.text}});
  for (const std::string& assignment : certify::set_parameters_of(scheme)) {
    const std::size_t equals = assignment.find('=');
    parameters[assignment.substr(0, equals)] = assignment.substr(equals + 1);
  }
  return {{"name", scheme.name},
          {"label", label},
          {"texts", std::move(texts)},
          {"parameters", std::move(parameters)}};
}

Json formulas_json(const Scheme& scheme, const std::set<std::string>& given) {
  Json json{{"eigen", nullptr}, {"reason", ""}, {"lattice_latex", nullptr}};
  const Result<EigenFormulas> formulas = eigen_formulas(scheme, given, 0);
  if (formulas)
    json["eigen"] = eigen_formulas_json(scheme.name, *formulas);
  else
    json["reason"] = formulas.error().message;
  if (const Result<std::string> latex = describe_latex(scheme)) json["lattice_latex"] = *latex;
  return json;
}

void add_certificate(const Scheme& scheme, const PageRecordOptions& options, Json& json) {
  std::vector<int> valences(
      static_cast<std::size_t>(options.last_valence - options.first_valence + 1));
  std::iota(valences.begin(), valences.end(), options.first_valence);
  certify::CertifyOptions wanted;
  wanted.leave_out = true;
  wanted.time = TimeBudget(options.seconds);
  const Result<certify::Certificate> certificate = certify::certify(scheme, valences, wanted);
  json["certificate"] = certificate ? certify::answers_json(*certificate) : Json();
  json["certificate_reason"] = certificate ? "" : certificate.error().message;
}

Json facts_json(const Scheme& scheme) {
  Json list = Json::array();
  for (const Fact& fact : scheme.facts) {
    Json values = Json::object();
    for (const auto& [key, formula] : fact.values) values[key] = formula.expression.text();
    list.push_back({{"valences", {fact.first, fact.last}},
                    {"source", fact.source},
                    {"values", std::move(values)}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json page_record_json(const std::string& label, const Scheme& scheme,
                                        const PageRecordOptions& options) {
  const auto say = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  study::RecordOptions record;
  record.first_valence = options.first_valence;
  record.last_valence = options.last_valence;
  record.regularity.seconds = options.seconds;
  record.progress = options.progress;
  Json json{{"scheme", scheme_json(label, scheme)}, {"show", describe_json(scheme)}};
  const std::vector<Scheme> lattices = scheme::lattice_schemes(scheme);
  for (const Scheme& one : lattices) {
    Json found;
    found["record"] =
        record_json(study::approx_record(scheme::label_on_lattice(label, one), one, record));
    say("formulas");
    found["formulas"] = formulas_json(one, options.given);
    say("proofs");
    add_certificate(one, options, found);
    found["facts"] = facts_json(one);
    if (lattices.size() == 1) {
      json.update(found);
      break;
    }
    json["lattices"].push_back({{"lattice", scheme::lattice_name(one.split->lattice)}});
    json["lattices"].back().update(found);
  }
  return json;
}

}  // namespace limn::report
