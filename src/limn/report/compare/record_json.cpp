#include "limn/report/compare/record_json.h"

#include <nlohmann/json.hpp>

#include "limn/report/eigen/eigen_report.h"
#include "limn/report/json_number.h"
#include "limn/report/lattice/artifact_report.h"
#include "limn/report/lattice/regularity_report.h"
#include "limn/scheme/lattice_schemes.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json wave_json(const study::WaveArtifacts& wave) {
  return {{"edges_per_wavelength", wave.edges_per_wavelength},
          {"worst_percent", finite(wave.worst)},
          {"worst_direction_degrees", wave.worst_direction},
          {"best_percent", finite(wave.best)},
          {"best_direction_degrees", wave.best_direction}};
}

template <class T, class Make>
Json json_of(const Result<T>& result, Make make) {
  return result ? Json(make(*result)) : Json();
}

}  // namespace

nlohmann::ordered_json record_json(const study::SchemeRecord& record) {
  Json json{{"scheme", record.label}, {"split", record.split}};
  if (record.lattice) json["lattice"] = scheme::lattice_name(*record.lattice);
  json["interpolating"] = json_of(record.interpolating, [](bool yes) { return yes; });
  json["regularity"] = json_of(record.regularity, [&](const Regularity& regularity) {
    return regularity_json(record.label, regularity);
  });
  json["regular_part"] = regular_part_json(record.regular_part);
  json["artifacts"] = json_of(record.artifacts, [](const std::vector<study::WaveArtifacts>& waves) {
    Json list = Json::array();
    for (const study::WaveArtifacts& wave : waves) list.push_back(wave_json(wave));
    return list;
  });
  json["sampling"] = {{"total_energy", json_of(record.sampling, density_json)},
                      {"mean_energy", json_of(record.mean_sampling, density_json)}};
  json["valences"] = Json::array();
  for (const study::ValenceRecord& one : record.valences) {
    json["valences"].push_back(one.components
                                   ? eigen_json(*one.components)
                                   : Json{{"valence", one.valence}, {"components", nullptr}});
    json["valences"].back()["c1"] = certify::to_string(one.c1);
  }
  json["missing"] = study::missing_parts(record);
  return json;
}

}  // namespace limn::report
