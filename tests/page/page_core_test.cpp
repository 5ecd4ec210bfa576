#include "core/page_core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "command_json.h"
#include "limn/limit/limit_points.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "limn/scheme/file/shipped_files.h"
#include "limn/scheme/scheme.h"

namespace limn::test {
namespace {

using nlohmann::json;
using page::PageCore;

json parsed(const std::string& text) { return json::parse(text); }

std::string text_of(const std::string& scheme) {
  for (const scheme::ShippedFile& file : scheme::shipped_files())
    if (file.name == scheme) return std::string(file.text);
  return {};
}

int load(PageCore& core, const std::string& scheme, const std::string& parameters = {}) {
  const json loaded = parsed(core.load(text_of(scheme), parameters));
  EXPECT_TRUE(loaded.at("ok")) << loaded;
  return loaded.value("id", 0);
}

/// `answer` without "ok".
json without_ok(const std::string& answer) {
  json value = parsed(answer);
  EXPECT_TRUE(value.at("ok")) << value;
  value.erase("ok");
  return value;
}

TEST(PageCore, ListsEveryShippedSchemeWithItsText) {
  const json list = parsed(PageCore().schemes()).at("schemes");
  ASSERT_EQ(list.size(), scheme::shipped_files().size());
  for (const json& one : list) {
    EXPECT_EQ(one.at("text"), text_of(one.at("name")));
    const Scheme scheme = find_scheme(one.at("name")).value();
    EXPECT_EQ(one.at("title"), scheme.title);
    EXPECT_EQ(one.at("source"), scheme.source);
    EXPECT_EQ(one.at("split"), scheme.split->name);
  }
}

TEST(PageCore, EigenvaluesAreTheCommands) {
  for (const scheme::ShippedFile& file : scheme::shipped_files()) {
    const std::string name(file.name);
    const json command = command_json("eigen " + name);
    PageCore core;
    const int id = load(core, name);
    // a scheme without rules there: both refuse; the page shows one lattice alone
    if (command.is_discarded() || command.contains("lattices")) {
      EXPECT_FALSE(parsed(core.eigen(id, 3, true)).at("ok")) << name;
      continue;
    }
    for (const json& valence : command.at("valences")) {
      json expected = valence;
      expected["regular_part"] = command.at("regular_part");
      EXPECT_EQ(without_ok(core.eigen(id, valence.at("valence"), false)), expected) << name;
    }
  }
}

TEST(PageCore, ShowArtifactsAndSamplingAreTheCommands) {
  for (const char* name : {"loop", "sqrt3", "doo-sabin", "butterfly", "four-eight"}) {
    PageCore core;
    const int id = load(core, name);
    EXPECT_EQ(without_ok(core.show(id)), command_json("show " + std::string(name)));
    EXPECT_EQ(without_ok(core.artifacts(id, 0.2, 0.1)),
              command_json("artifacts -f 0.2,0.1 " + std::string(name)));
    EXPECT_EQ(without_ok(core.sampling(id, 1)),
              command_json("artifacts --tolerance 1 " + std::string(name)));
  }
}

TEST(PageCore, RegularityIsTheCommands) {
  PageCore core;
  EXPECT_EQ(without_ok(core.regularity(load(core, "butterfly"), 600)),
            command_json("regularity --time 0 butterfly"));
}

TEST(PageCore, ParametersAreSetAsTextOrNumber) {
  PageCore core;
  const json by_text =
      without_ok(core.eigen(load(core, "laplacian-loop", R"({"a": "1/8"})"), 7, true));
  const json by_number =
      without_ok(core.eigen(load(core, "laplacian-loop", R"({"a": 0.125})"), 7, true));
  EXPECT_EQ(by_text, by_number);
  const json command =
      command_json("eigen laplacian-loop -p a=1/8 --valence 7").at("valences").at(0);
  EXPECT_EQ(by_text.at("components"), command.at("components"));
  EXPECT_NE(by_text.at("components"),
            without_ok(core.eigen(load(core, "laplacian-loop"), 7, true)).at("components"));
}

TEST(PageCore, SaysWhichParametersAreWholeNumbers) {
  PageCore core;
  const json box = parsed(core.load(text_of("box-spline-triangle"), ""));
  EXPECT_TRUE(box.at("parameters").at(0).at("integer"));
  const json loop = parsed(core.load(text_of("laplacian-loop"), ""));
  EXPECT_FALSE(loop.at("parameters").at(0).at("integer"));
}

TEST(PageCore, FaultsOfATextHaveTheirLines) {
  PageCore core;
  const json two =
      parsed(core.load("name = \"x\"\nsplit = \"no\"\nvertex = { self = \"1+\" }\n", ""));
  ASSERT_FALSE(two.at("ok"));
  const json& errors = two.at("errors");
  ASSERT_GE(errors.size(), 1U) << two;
  EXPECT_EQ(errors.at(0).at("line"), 2);
  const json sum = parsed(core.load(
      "name = \"x\"\nsplit = \"triangle-dyadic\"\nvertex = { self = \"1/2\", ring = \"1/n\" }\n"
      "edge = { end = \"1/2\", wing = \"1/8\" }\n",
      ""));
  ASSERT_FALSE(sum.at("ok"));
  ASSERT_EQ(sum.at("errors").size(), 2U) << sum;
  EXPECT_EQ(sum.at("errors").at(0).at("line"), 3);
  EXPECT_EQ(sum.at("errors").at(1).at("line"), 4) << sum;
}

TEST(PageCore, WavesAreTheLimitAtPointsOfTheRefinedLattice) {
  PageCore core;
  const page::WaveAnswer wave = core.wave(load(core, "loop"), 0.25, 0, 1);
  const json about = without_ok(wave.json);
  const auto size = about.at("size").get<std::size_t>();
  ASSERT_EQ(wave.positions.size(), 3 * size * size);
  const auto analysis = ArtifactAnalysis::of(regular_mask(*find_scheme("loop")).value()).value();
  const Components limit = analysis.in_limit({0.25, 0});
  const double all = limit.signal + limit.sum();  // at 0 all waves have phase 0
  const std::size_t middle = (size / 2) * size + size / 2;
  EXPECT_NEAR(wave.positions[3 * middle + 2], all, 1e-3);
  EXPECT_NEAR(wave.positions[3 * middle + 2] - wave.errors[middle],
              about.at("signal").get<double>(), 1e-6);
}

TEST(PageCore, ArtifactMapsHaveTheValuesOfArtifacts) {
  PageCore core;
  const int id = load(core, "butterfly");
  for (const auto& [measure, key] : std::map<std::string, std::string>{
           {"mean_energy", "percent_of_signal"}, {"total_energy", "total_energy_percent"}}) {
    const page::FieldAnswer map = core.artifact_map(id, 16, measure);
    const json about = without_ok(map.json);
    const json& extent = about.at("extent");
    const double width = (extent[2].get<double>() - extent[0].get<double>()) / 16;
    const double height = (extent[3].get<double>() - extent[1].get<double>()) / 16;
    const double fx = extent[0].get<double>() + 9.5 * width;
    const double fy = extent[1].get<double>() + 6.5 * height;
    const double expected = parsed(core.artifacts(id, fx, fy)).at(key);
    EXPECT_NEAR(map.values[6 * 16 + 9], expected, 1e-5 * expected);
    EXPECT_TRUE(std::isnan(map.values[0]));
  }
}

TEST(PageCore, CharacteristicMapsHaveTheTangentEigenvalue) {
  PageCore core;
  const int id = load(core, "loop");
  const page::MapAnswer map = core.characteristic_map(id, 5, 3);
  const json about = without_ok(map.json);
  EXPECT_NEAR(about.at("eigenvalue"), 3.0 / 8 + std::cos(2 * std::acos(-1.0) / 5) / 4, 1e-12);
  EXPECT_EQ(about.at("regular"), "yes");
  ASSERT_FALSE(map.lines.empty());
  for (const std::uint32_t point : map.lines) ASSERT_LT(2 * point + 1, map.points.size());
}

}  // namespace
}  // namespace limn::test
